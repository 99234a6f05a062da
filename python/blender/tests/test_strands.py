import unittest.mock

import bpy
import numpy as np
from support import GROOM, InBlender, assert_same, evaluated, of_the_abi

from lancret_blender import grow, groom_cache, strands
from lancret_blender.package import lancret


class StrandsInBlender(InBlender):
    def test_equal_those_of_the_abi_bit_for_bit(self):
        obj = self.add()
        obj.lancret.viewport = 1
        self.update(obj)
        self.assertEqual(obj.lancret.error, "")
        found = evaluated(obj)
        self.assertEqual(len(found[2]), 400)
        assert_same(self, found, of_the_abi(self.groom, density=1))

    def test_are_in_the_scenes_units(self):
        self.scene.unit_settings.scale_length = 0.01
        obj = self.add()
        obj.lancret.viewport = 1
        self.update(obj)
        assert_same(self, evaluated(obj), of_the_abi(self.groom, density=1, unit=1))

    def test_use_the_settings_of_the_panel(self):
        obj = self.add()
        settings = obj.lancret
        settings.viewport, settings.count, settings.blend, settings.seed = (
            1,
            150,
            "nearest",
            7,
        )
        settings.neighbours, settings.root_width, settings.tip_width = 2, 0.05, 0.01
        settings.chunk, settings.max_error = 64, 0.2
        self.update(obj)
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
                "width.root": settings.root_width,
                "width.tip": settings.tip_width,
            },
        )
        self.assertEqual(len(expected[2]), 150)
        assert_same(self, evaluated(obj), expected)

    def test_in_the_viewport_are_a_subset(self):
        obj = self.add()
        obj.lancret.viewport = 0.2
        self.update(obj)
        points, _, counts = evaluated(obj)
        self.assertEqual(obj.lancret.strands, len(counts))
        self.assertEqual(obj.lancret.all_strands, 400)
        self.assertTrue(40 <= len(counts) <= 120, len(counts))
        every, _, every_count = of_the_abi(self.groom, density=1)
        whole = {p.tobytes() for p in np.split(every, np.cumsum(every_count)[:-1])}
        for strand in np.split(points, np.cumsum(counts)[:-1]):
            self.assertIn(np.ascontiguousarray(strand).tobytes(), whole)

    def test_keep_one_groom_open_per_object(self):
        first = self.add()
        for seed in range(3):
            first.lancret.seed = seed
            grow.in_viewport(first, self.scene)
            self.assertEqual(set(groom_cache._grooms), {first.name})
        groom = groom_cache._grooms[first.name][1]
        first.lancret.viewport = 1
        grow.in_viewport(first, self.scene)
        self.assertIs(groom_cache._grooms[first.name][1], groom)
        bpy.data.objects.remove(first)
        second = self.add()
        self.assertEqual(
            set(groom_cache._grooms), {second.name}
        )  # the deleted object's was closed
        self.assertTrue(groom.closed)

    def test_have_the_material_of_the_panel(self):
        obj = self.add()
        other = bpy.data.materials.new("other")
        obj.lancret.material = other
        self.update(obj)
        curves = obj.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
        self.assertEqual([material.name for material in curves.materials], ["other"])

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

    def test_survive_saving_and_loading(self):
        obj = self.add()
        settings = obj.lancret
        settings.count, settings.blend, settings.seed, settings.viewport = (
            300,
            "bishop",
            3,
            0.5,
        )
        self.update(obj)
        before, name = evaluated(obj), obj.name
        blend = str(self.folder / "kept.blend")
        bpy.ops.wm.save_as_mainfile(filepath=blend)
        bpy.ops.wm.read_factory_settings(use_empty=True)
        self.assertNotIn(name, bpy.data.objects)
        bpy.ops.wm.open_mainfile(filepath=blend)
        obj = bpy.data.objects[name]
        settings = obj.lancret
        self.assertEqual(settings.file, str(self.groom))
        self.assertEqual(
            (settings.count, settings.blend, settings.seed), (300, "bishop", 3)
        )
        assert_same(self, evaluated(obj), before)
        self.update(obj)
        assert_same(self, evaluated(obj), before)


class Axes(InBlender):
    def test_have_an_inverse(self):
        points = np.arange(6, dtype=np.float32).reshape(2, 3) + 1
        for up, axis in (("X", 0), ("Y", 1), ("Z", 2)):
            turned = strands.to_blender(points, up)
            self.assertTrue((turned[:, 2] == points[:, axis]).all())
            self.assertTrue((strands.from_blender(turned, up) == points).all())
            turn = strands.to_blender(np.eye(3, dtype=np.float32), up)
            self.assertEqual(np.linalg.det(turn), 1)


class Faults(InBlender):
    def test_appear_in_the_panel_until_corrected(self):
        obj = self.add()
        good = evaluated(obj)
        self.groom.write_text(GROOM.replace("count = 400", "count = -4"))
        self.update(obj)
        line = GROOM.split("\n").index("count = 400") + 1
        self.assertIn(f"groom.toml:{line}", obj.lancret.error)
        assert_same(self, evaluated(obj), good)
        self.groom.write_text(GROOM)
        self.update(obj)
        self.assertEqual(obj.lancret.error, "")

    def test_of_a_missing_file_name_it(self):
        obj = self.add(self.folder / "none.toml")
        self.assertIn("none.toml", obj.lancret.error)

    def test_of_missing_guides_explain_what_to_do(self):
        obj = self.add()
        obj.lancret.source = "SCENE"
        self.update(obj)
        self.assertIn("select curves", obj.lancret.error)

    def test_of_a_missing_library_do_not_blame_the_package(self):
        obj = self.add()

        def gone():
            raise lancret().LibraryNotFound("no library; tried: /nowhere")

        with unittest.mock.patch.object(lancret(), "open", lambda *_, **__: gone()):
            self.update(obj)
        self.assertEqual(obj.lancret.error, "no library; tried: /nowhere")

    def test_cancel_the_add_operator_without_guides_and_file(self):
        with self.assertRaisesRegex(RuntimeError, "Select curves"):
            bpy.ops.object.lancret_add()
