import re
from pathlib import Path

import bpy
import numpy as np
import test_guides
from support import GROOM, InBlender, assert_same, evaluated, of_the_abi, simulate

from lancret_blender import grow, render_state
from lancret_blender.package import lancret

MOTION = """
[motion]
pivot = [0, -8, -2]
keys = [{ frame = 1 }, { frame = 4, turn = [0, 30, 0] }]
"""


def alpha_of(path):
    picture = bpy.data.images.load(str(path))
    alpha = np.array(picture.pixels[:])[3::4]
    bpy.data.images.remove(picture)
    return alpha


class Render(InBlender):
    def seen(self):
        """A list that each render appends to, per frame: the frame and the strands."""
        found = []

        def look(scene, *_):
            for obj in scene.objects:
                if obj.type == "CURVES":
                    found.append((scene.frame_current, *self.drawn(obj)))

        bpy.app.handlers.render_post.append(look)
        self.addCleanup(bpy.app.handlers.render_post.remove, look)
        return found

    def drawn(self, obj):
        mesh = obj.lancret.points.data
        points = np.empty((len(mesh.vertices), 3), np.float32)
        mesh.vertices.foreach_get("co", points.ravel())
        radii = np.empty(len(points), np.float32)
        if len(points):
            mesh.attributes["radius"].data.foreach_get("value", radii)
        edges = np.empty((len(mesh.edges), 2), np.int32)
        mesh.edges.foreach_get("vertices", edges.ravel())
        return points, radii, edges

    def assert_whole(self, found, expected):
        points, radii, edges = found
        assert_same(self, (points, radii, expected[2]), expected)
        starts = np.cumsum(expected[2]) - expected[2]
        each = [np.arange(n - 1) + start for n, start in zip(expected[2], starts)]
        first = np.concatenate(each)
        self.assertTrue(np.array_equal(edges, np.stack([first, first + 1], -1)))

    def test_has_all_strands_and_restores_the_viewport(self):
        obj = self.add()
        before = evaluated(obj)
        meshes = len(bpy.data.meshes)
        self.small_render()
        seen = self.seen()
        bpy.ops.render.render()
        self.assertEqual(len(seen), 1)
        self.assert_whole(seen[0][1:], of_the_abi(self.groom))
        assert_same(self, evaluated(obj), before)
        self.assertEqual(len(bpy.data.meshes), meshes)
        self.assertFalse(render_state.rendering())

    def test_draws_strands_that_the_viewport_does_not_show(self):
        obj = self.add()
        obj.lancret.viewport = 0.0025
        obj.lancret.root_width = obj.lancret.tip_width = 0.4
        self.update(obj)
        self.assertLess(obj.lancret.strands, 10)
        self.view_from_the_front()
        every = self.covered()
        self.assertGreater(every, 0.02)
        obj.lancret.count = 20
        few = self.covered()
        self.assertTrue(0 < few < every / 4, (few, every))
        obj.lancret.count, obj.lancret.viewport = 0, 1
        self.update(obj)
        self.assertEqual(self.covered(), every)

    def view_from_the_front(self):
        self.small_render()
        self.scene.render.resolution_x = self.scene.render.resolution_y = 64
        self.scene.render.film_transparent = True
        self.scene.cycles.samples = 4
        self.scene.camera.location = (0, -1.5, 0)
        self.scene.camera.rotation_euler = (np.pi / 2, 0, 0)

    def covered(self):
        """Renders and returns the fraction of the picture that hair covers."""
        bpy.ops.render.render(write_still=True)
        return float(alpha_of(self.scene.render.filepath).mean())

    def test_has_no_hair_if_the_groom_has_an_error(self):
        obj = self.add()
        before = evaluated(obj)
        self.groom.write_text("[strands]\ncount = 'many'\n")
        self.small_render()
        seen = self.seen()
        bpy.ops.render.render()
        self.assertEqual(len(seen[0][1]), 0)
        self.assertRegex(obj.lancret.render_error, "^frame 1: .*groom.toml:2")
        assert_same(self, evaluated(obj), before)

    def animate(self, first, last):
        self.small_render()
        self.scene.frame_start, self.scene.frame_end = first, last
        self.scene.render.filepath = str(self.folder / "frame")
        seen = self.seen()
        bpy.ops.render.render(animation=True)
        return seen

    def test_keeps_the_error_of_a_frame_until_an_update(self):
        obj = self.add()
        text = self.groom.read_text()

        def spoil(scene, *_):
            bad = text.replace("400", "-4") if scene.frame_current == 2 else text
            self.groom.write_text(bad)

        bpy.app.handlers.render_pre.insert(0, spoil)
        try:
            seen = self.animate(1, 3)
        finally:
            bpy.app.handlers.render_pre.remove(spoil)
        self.assertEqual([len(points) > 0 for _, points, *_ in seen], [True, False, True])
        self.assertRegex(obj.lancret.render_error, "^frame 2: .*count")
        self.update(obj)
        self.assertEqual(obj.lancret.render_error, "")

    def test_restores_the_viewport_of_a_copy_and_of_its_original(self):
        first = self.add()
        before = evaluated(first)
        bpy.ops.object.duplicate()
        second = bpy.context.object
        self.small_render()
        seen = self.seen()
        bpy.ops.render.render()
        self.assertEqual(len(seen), 2)
        for obj in (first, second):
            assert_same(self, evaluated(obj), before)
        for _, *found in seen:
            self.assert_whole(found, of_the_abi(self.groom))
        self.assertNotEqual(first.lancret.points, second.lancret.points)

    def test_restores_the_viewport_of_a_copied_scene(self):
        first = self.add()
        before = evaluated(first)
        bpy.ops.scene.new(type="FULL_COPY")
        self.scene = bpy.context.scene
        self.small_render()
        bpy.ops.render.render(scene=self.scene.name)
        copy = next(obj for obj in self.scene.objects if obj.type == "CURVES")
        self.assertEqual(evaluated(copy)[2].tolist(), before[2].tolist())
        self.assertEqual(
            len(first.lancret.points.data.vertices),
            len(copy.lancret.points.data.vertices),
        )

    def test_fills_the_viewport_if_its_points_were_deleted(self):
        obj = self.add()
        before = evaluated(obj)
        bpy.data.objects.remove(obj.lancret.points)
        self.small_render()
        bpy.ops.render.render()
        assert_same(self, evaluated(obj), before)

    def test_has_all_strands_of_instanced_collections(self):
        obj = self.add()
        collection = bpy.data.collections.new("hair")
        collection.objects.link(obj)
        self.scene.collection.objects.unlink(obj)
        place = bpy.data.objects.new("place", None)
        place.instance_type, place.instance_collection = "COLLECTION", collection
        self.scene.collection.objects.link(place)
        self.small_render()
        found = []

        def look(*_):
            found.append(self.drawn(obj))

        bpy.app.handlers.render_post.append(look)
        try:
            bpy.ops.render.render()
            place.hide_render = True
            bpy.ops.render.render()
        finally:
            bpy.app.handlers.render_post.remove(look)
        self.assert_whole(found[0], of_the_abi(self.groom))
        # A hidden object is not regrown.
        self.assertEqual(len(found[1][0]), len(evaluated(obj)[0]))

    def test_does_not_regrow_hidden_collections(self):
        obj = self.add()
        collection = bpy.data.collections.new("hidden")
        self.scene.collection.children.link(collection)
        collection.objects.link(obj)
        self.scene.collection.objects.unlink(obj)
        collection.hide_render = True
        self.small_render()
        seen = self.seen()
        bpy.ops.render.render()
        self.assertEqual(len(seen[0][1]), len(evaluated(obj)[0]))

    def add_between_curves(self):
        curves = test_guides.legacy_curve("fur", "POLY", test_guides.fur())
        test_guides.select(curves)
        bpy.ops.object.lancret_add()
        obj = bpy.context.object
        obj.parent = None
        return obj, curves

    def test_uses_a_changed_unit_at_once(self):
        obj, _ = self.add_between_curves()
        self.small_render()
        self.scene.unit_settings.scale_length = 0.01
        seen = self.seen()
        bpy.ops.render.render()
        # The guides reach from z = 0 to 0.1 in any unit; helices fit them within 1 %.
        hair = [points for _, points, *_ in seen if len(points)]
        self.assertEqual(obj.lancret.render_error, "")
        self.assertAlmostEqual(float(np.ptp(hair[0][:, 2])), 0.1, delta=0.001)

    def test_uses_the_position_of_guides_in_each_frame(self):
        obj, curves = self.add_between_curves()
        for frame, z in ((1, 0), (3, 0.5)):
            curves.location.z = z
            curves.keyframe_insert("location", frame=frame)
        places = []
        for frame in (1, 2, 3, 4):
            self.scene.frame_set(frame)
            places.append(curves.location.z)
        self.assertEqual(len(set(places)), 3, places)
        self.scene.frame_set(1)
        seen = [frame for frame in self.animate(1, 4) if len(frame[1])]
        lowest = [float(points[:, 2].min()) for _, points, *_ in seen]
        self.assertEqual([frame for frame, *_ in seen], [1, 2, 3, 4])
        for found, expected in zip(lowest, places):
            # Children have the guides' roots, in float.
            self.assertAlmostEqual(found, expected, delta=2**-23)


class Docs(InBlender):
    def test_the_script_of_the_page_runs(self):
        page = Path(__file__).resolve().parents[3] / "docs" / "blender.md"
        code = re.search(r"^```python\n(.*?)^```", page.read_text(), re.M | re.S)[1]
        enable = 'bpy.ops.preferences.addon_enable(module="lancret_blender")\n'
        self.assertIn(enable, code)  # removed, because the add-on is already enabled
        code = code.replace(enable, "").replace("/path/of/groom.toml", str(self.groom))
        self.small_render()
        bpy.context.scene.render.engine = "BLENDER_WORKBENCH"
        exec(compile(code, str(page), "exec"), {})  # noqa: S102
        self.assertEqual(bpy.context.object.lancret.all_strands, 20000)
        self.assertTrue(Path(self.scene.render.filepath).is_file())


class Cache(InBlender):
    def setUp(self):
        super().setUp()
        moving = self.folder / "moving.toml"
        moving.write_text(GROOM + MOTION)
        self.cache = self.folder / "moving.h5"
        simulate(moving, "1-4", self.cache)

    def test_is_regrown_when_the_frame_changes(self):
        self.scene.frame_set(1)
        obj = self.add(self.cache)
        obj.lancret.viewport = 1
        self.update(obj)
        self.assertEqual((obj.lancret.first_frame, obj.lancret.last_frame), (1, 4))
        places = []
        for frame in (1, 3, 4, 2):
            self.scene.frame_set(frame)
            places.append(evaluated(obj)[0])
            expected = of_the_abi(self.cache, density=1, times=frame)
            assert_same(self, evaluated(obj), expected)
        self.assertGreater(np.abs(places[0] - places[1]).max(), 0.01)
        self.scene.frame_set(2, subframe=0.5)
        expected = of_the_abi(self.cache, density=1, times=2.5)
        assert_same(self, evaluated(obj), expected)
        self.scene.frame_set(40)  # the last frame is held
        assert_same(self, evaluated(obj), of_the_abi(self.cache, density=1, times=4))

    def test_is_rendered_at_each_frame_of_an_animation(self):
        obj = self.add(self.cache)
        self.small_render()
        self.scene.frame_start, self.scene.frame_end = 2, 4
        self.scene.render.filepath = str(self.folder / "frame")
        seen = Render.seen(self)
        bpy.ops.render.render(animation=True)
        self.assertEqual([frame for frame, *_ in seen], [2, 3, 4])
        for frame, *found in seen:
            Render.assert_whole(self, found, of_the_abi(self.cache, times=frame))
        self.assertEqual(len(evaluated(obj)[2]), obj.lancret.strands)

    drawn = Render.drawn

    def test_of_an_instanced_collection_follows_the_frame(self):
        obj = self.add(self.cache)
        obj.lancret.viewport = 1
        self.update(obj)
        collection = bpy.data.collections.new("hair")
        collection.objects.link(obj)
        self.scene.collection.objects.unlink(obj)
        place = bpy.data.objects.new("place", None)
        place.instance_type, place.instance_collection = "COLLECTION", collection
        self.scene.collection.objects.link(place)
        self.scene.frame_set(3)
        found = self.drawn(obj)
        expected = of_the_abi(self.cache, density=1, times=3)
        assert_same(self, (*found[:2], expected[2]), expected)

    def test_uses_the_frame_of_the_scene_that_changed(self):
        obj = self.add(self.cache)
        obj.lancret.viewport = 1
        self.update(obj)
        other = bpy.data.scenes.new("other")
        other.collection.objects.link(obj)
        self.scene.frame_set(1)
        other.frame_set(4)
        found = self.drawn(obj)
        expected = of_the_abi(self.cache, density=1, times=4)
        assert_same(self, (*found[:2], expected[2]), expected)

    def test_is_blurred_around_the_middle_of_the_shutter(self):
        self.add(self.cache)
        self.scene.render.use_motion_blur = True
        self.scene.render.motion_blur_shutter = 0.5
        self.scene.frame_set(2)
        cycles = hasattr(self.scene.cycles, "motion_blur_position")
        settings = self.scene.cycles if cycles else self.scene.render
        with lancret().open(self.cache) as groom:
            for position, times in (
                ("CENTER", (1.75, 2, 2.25)),
                ("START", (2, 2.25, 2.5)),
                ("END", (1.5, 1.75, 2)),
            ):
                settings.motion_blur_position = position
                found = grow.times_of(groom.info, self.scene, True)
                self.assertEqual(found, times)

    def test_is_drawn_at_each_frame_of_an_animation(self):
        obj = self.add(self.cache)
        obj.lancret.root_width = obj.lancret.tip_width = 0.4
        Render.view_from_the_front(self)
        self.scene.frame_start, self.scene.frame_end = 2, 4
        self.scene.render.filepath = str(self.folder / "frame")
        bpy.ops.render.render(animation=True)
        second, last = (alpha_of(self.folder / f"frame000{n}.png") for n in (2, 4))
        self.scene.frame_set(4)
        self.scene.render.filepath = str(self.folder / "still.png")
        bpy.ops.render.render(write_still=True)
        self.assertGreater(np.abs(second - last).max(), 0.2)
        self.assertTrue(np.array_equal(last, alpha_of(self.folder / "still.png")))

    def test_is_blurred_by_velocities(self):
        obj = self.add(self.cache)
        self.scene.render.use_motion_blur = True
        self.scene.render.motion_blur_shutter = 0.5
        self.scene.frame_set(2)
        mesh = bpy.data.meshes.new("full")
        self.assertTrue(grow.for_render(obj, self.scene, mesh))
        rates = np.empty((len(mesh.vertices), 3), np.float32)
        mesh.attributes["velocity"].data.foreach_get("vector", rates.ravel())
        before, after = (of_the_abi(self.cache, times=t)[0] for t in (1.75, 2.25))
        moved = (after - before).astype(np.float64)
        # 24 frames per second, over half a frame. Floats of coordinates below 0.5 have an
        # error of 2^-26 each; a difference has two, and the rate rounds once more.
        exact = moved * 24 / 0.5
        self.assertLess(np.abs(rates - exact).max(), 48 * 4 * 2**-26)
        self.assertGreater(np.abs(rates).max(), 0.1)
