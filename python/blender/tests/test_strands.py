import unittest.mock

import bpy
import numpy as np
from support import GROOM, InBlender, assert_same, evaluated, of_the_abi

from lancret_blender import grow, opened, strands
from lancret_blender.package import lancret


class StrandsInBlender(InBlender):
    def test_are_the_abis_bit_for_bit(self):
        thing = self.add()
        thing.lancret.viewport = 1
        self.update(thing)
        self.assertEqual(thing.lancret.error, "")
        found = evaluated(thing)
        self.assertEqual(len(found[2]), 400)
        assert_same(self, found, of_the_abi(self.groom, density=1))

    def test_are_in_the_scenes_units(self):
        self.scene.unit_settings.scale_length = 0.01
        thing = self.add()
        thing.lancret.viewport = 1
        self.update(thing)
        assert_same(self, evaluated(thing), of_the_abi(self.groom, density=1, unit=1))

    def test_follow_the_panel(self):
        thing = self.add()
        told = thing.lancret
        told.viewport, told.count, told.blend, told.seed = 1, 150, "nearest", 7
        told.neighbours, told.root_width, told.tip_width = 2, 0.05, 0.01
        told.chunk, told.max_error = 64, 0.2
        self.update(thing)
        expected = of_the_abi(
            self.groom,
            density=1,
            chunk_strands=64,
            parameters={
                "strands.count": 150,
                "strands.blend": "nearest",
                "strands.seed": 7,
                "strands.neighbours": 2,
                "strands.tolerance": np.float64(np.float32(0.2)),
                "width.root": told.root_width,
                "width.tip": told.tip_width,
            },
        )
        self.assertEqual(len(expected[2]), 150)
        assert_same(self, evaluated(thing), expected)

    def test_in_the_viewport_are_some_of_all(self):
        thing = self.add()
        thing.lancret.viewport = 0.2
        self.update(thing)
        points, _, counts = evaluated(thing)
        self.assertEqual(thing.lancret.strands, len(counts))
        self.assertEqual(thing.lancret.all_strands, 400)
        self.assertTrue(40 <= len(counts) <= 120, len(counts))
        every, _, every_count = of_the_abi(self.groom, density=1)
        whole = {p.tobytes() for p in np.split(every, np.cumsum(every_count)[:-1])}
        for strand in np.split(points, np.cumsum(counts)[:-1]):
            self.assertIn(np.ascontiguousarray(strand).tobytes(), whole)

    def test_keep_one_groom_an_object_open(self):
        first = self.add()
        for seed in range(3):
            first.lancret.seed = seed
            grow.in_viewport(first, self.scene)
            self.assertEqual(set(opened._grooms), {first.name})
        groom = opened._grooms[first.name][1]
        first.lancret.viewport = 1
        grow.in_viewport(first, self.scene)
        self.assertIs(opened._grooms[first.name][1], groom)
        bpy.data.objects.remove(first)
        second = self.add()
        self.assertEqual(set(opened._grooms), {second.name})  # forgot what is not there
        self.assertTrue(groom.closed)

    def test_have_the_material_of_the_panel(self):
        thing = self.add()
        other = bpy.data.materials.new("other")
        thing.lancret.material = other
        self.update(thing)
        curves = thing.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
        self.assertEqual([one.name for one in curves.materials], ["other"])

    def test_of_a_copy_are_its_own(self):
        first = self.add()
        second = first.copy()
        self.scene.collection.objects.link(second)
        second.lancret.count = 100
        second.lancret.viewport = 1
        self.update(second)
        self.assertEqual(len(evaluated(second)[2]), 100)
        self.assertEqual(len(evaluated(first)[2]), first.lancret.strands)
        self.assertNotEqual(first.lancret.strands, 100)

    def test_stay_where_they_are_when_the_file_is_read_again(self):
        thing = self.add()
        told = thing.lancret
        told.count, told.blend, told.seed, told.viewport = 300, "bishop", 3, 0.5
        self.update(thing)
        before, name = evaluated(thing), thing.name
        blend = str(self.folder / "kept.blend")
        bpy.ops.wm.save_as_mainfile(filepath=blend)
        bpy.ops.wm.read_factory_settings(use_empty=True)
        self.assertNotIn(name, bpy.data.objects)
        bpy.ops.wm.open_mainfile(filepath=blend)
        thing = bpy.data.objects[name]
        told = thing.lancret
        self.assertEqual(told.file, str(self.groom))
        self.assertEqual((told.count, told.blend, told.seed), (300, "bishop", 3))
        assert_same(self, evaluated(thing), before)
        self.update(thing)
        assert_same(self, evaluated(thing), before)


class Axes(InBlender):
    def test_go_there_and_back(self):
        points = np.arange(6, dtype=np.float32).reshape(2, 3) + 1
        for up, axis in (("X", 0), ("Y", 1), ("Z", 2)):
            turned = strands.to_blender(points, up)
            self.assertTrue((turned[:, 2] == points[:, axis]).all())
            self.assertTrue((strands.from_blender(turned, up) == points).all())
            turn = strands.to_blender(np.eye(3, dtype=np.float32), up)
            self.assertEqual(np.linalg.det(turn), 1)


class Faults(InBlender):
    def test_come_to_the_panel_and_go(self):
        thing = self.add()
        good = evaluated(thing)
        self.groom.write_text(GROOM.replace("count = 400", "count = -4"))
        self.update(thing)
        line = GROOM.split("\n").index("count = 400") + 1
        self.assertIn(f"groom.toml:{line}", thing.lancret.error)
        assert_same(self, evaluated(thing), good)
        self.groom.write_text(GROOM)
        self.update(thing)
        self.assertEqual(thing.lancret.error, "")

    def test_of_a_file_that_is_not_there_name_it(self):
        thing = self.add(self.folder / "none.toml")
        self.assertIn("none.toml", thing.lancret.error)

    def test_of_no_guides_say_what_to_do(self):
        thing = self.add()
        thing.lancret.source = "SCENE"
        self.update(thing)
        self.assertIn("select curves", thing.lancret.error)

    def test_of_a_missing_library_are_not_of_the_package(self):
        thing = self.add()

        def gone():
            raise lancret().LibraryNotFound("no library; tried: /nowhere")

        with unittest.mock.patch.object(lancret(), "open", lambda *_, **__: gone()):
            self.update(thing)
        self.assertEqual(thing.lancret.error, "no library; tried: /nowhere")

    def test_stop_the_add_operator_without_guides_and_file(self):
        with self.assertRaisesRegex(RuntimeError, "Select curves"):
            bpy.ops.object.lancret_add()
