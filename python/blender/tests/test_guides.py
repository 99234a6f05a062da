import itertools
from pathlib import Path

import bpy
import numpy as np
from support import InBlender, assert_same, evaluated, same_bits

from lancret_blender import scene_guides, scene_source, strands
from lancret_blender.package import lancret

EXAMPLES = Path(__file__).resolve().parents[3] / "examples"


def legacy_curve(name, kind, strands_of_points):
    data = bpy.data.curves.new(name, "CURVE")
    data.dimensions = "3D"
    for points in strands_of_points:
        spline = data.splines.new(kind)
        places = spline.bezier_points if kind == "BEZIER" else spline.points
        places.add(len(points) - len(places))
        for place, point in zip(places, points):
            place.co = point if kind == "BEZIER" else (*point, 1)
    obj = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(obj)
    return obj


def fur(side=5, points=6, length=0.1):
    """Bent strands on a square in the plane z = 0."""
    along = np.linspace(0, 1, points)
    bent = np.stack([0.3 * along**2, 0 * along, along], -1) * length
    return [
        (bent + [x, y, 0]).astype(np.float32)
        for x in np.linspace(-0.1, 0.1, side)
        for y in np.linspace(-0.1, 0.1, side)
    ]


def plane():
    bpy.ops.mesh.primitive_plane_add(size=0.24)
    return bpy.context.object


def graph():
    return bpy.context.evaluated_depsgraph_get()


def select(active, *others):
    for obj in bpy.context.selected_objects:
        obj.select_set(False)
    for obj in (active, *others):
        obj.select_set(True)
    bpy.context.view_layer.objects.active = active
    bpy.context.view_layer.update()


class Guides(InBlender):
    def test_of_polylines_are_their_points(self):
        expected = fur()
        points, counts = scene_guides.read(legacy_curve("fur", "POLY", expected), graph())
        self.assertTrue(same_bits(points, np.concatenate(expected)))
        self.assertEqual(counts.tolist(), [6] * 25)

    def test_of_hair_curves_are_their_points(self):
        obj = self.add()
        self.update(obj)
        evaluated_obj = obj.evaluated_get(bpy.context.evaluated_depsgraph_get())
        points, counts = scene_guides.read(evaluated_obj, graph())
        expected, _, sizes = evaluated(obj)
        self.assertTrue(same_bits(points, expected))
        self.assertTrue(np.array_equal(counts, sizes))

    def test_of_bezier_curves_lie_on_them(self):
        obj = legacy_curve("arc", "BEZIER", [[(0, 0, 0), (1, 0, 1)]])
        first, second = obj.data.splines[0].bezier_points
        first.handle_right, second.handle_left = (0, 0, 1), (0, 0, 1)
        points, counts = scene_guides.read(obj, graph())
        self.assertEqual(counts.tolist(), [len(points)])
        t = np.linspace(0, 1, len(points))
        self.assertLess(np.abs(points[:, 0] - t**3).max(), 1e-6)
        self.assertLess(np.abs(points[:, 2] - (1 - (1 - t) ** 3)).max(), 1e-6)

    def test_of_nurbs_are_where_blender_draws_them(self):
        control_points = [
            (0, 0, 0),
            (0, 0, 1),
            (1, 0, 2),
            (1, 1, 3),
            (2, 1, 3),
            (2, 3, 3),
            (3, 3, 2),
        ]
        for ends, bezier, order, count in itertools.product(
            (False, True), (False, True), (3, 4, 5), (5, 6, 7)
        ):
            obj = legacy_curve("nurbs", "NURBS", [control_points[:count]])
            spline = obj.data.splines[0]
            spline.use_endpoint_u, spline.use_bezier_u = ends, bezier
            spline.order_u = order
            spline.points[2].co[3] = 2
            points, _ = scene_guides.read(obj, graph())
            mesh = obj.to_mesh()
            drawn = np.array([vertex.co for vertex in mesh.vertices])
            if (ends, bezier, order, count) == (
                False,
                True,
                5,
                5,
            ):  # no span of positive length
                self.assertEqual(len(points), 0)
                continue
            middle = (drawn[1:] + drawn[:-1]) / 2
            near = np.concatenate([drawn, middle])
            off = np.linalg.norm(points[:, None] - near, axis=-1).min(axis=1)
            step = np.linalg.norm(np.diff(drawn, axis=0), axis=1).max()
            with self.subTest(ends=ends, bezier=bezier, order=order, count=count):
                self.assertLess(off.max(), step / 3)
                self.assertLess(np.abs(points[[0, -1]] - drawn[[0, -1]]).max(), 1e-5)
            obj.to_mesh_clear()

    def test_that_are_cyclic_or_have_one_point_are_skipped(self):
        obj = legacy_curve("some", "POLY", [fur()[0], fur()[1], fur()[2][:1]])
        obj.data.splines[1].use_cyclic_u = True
        self.assertEqual(scene_guides.read(obj, graph())[1].tolist(), [6])

    def test_of_hair_particles_begin_on_the_mesh(self):
        mesh = plane()
        mesh.modifiers.new("hair", "PARTICLE_SYSTEM")
        system = mesh.particle_systems[0].settings
        system.type, system.count, system.hair_length = "HAIR", 20, 0.1
        points, counts = scene_guides.read(mesh, graph())
        self.assertEqual(len(counts), 20)
        roots = points[np.cumsum(counts) - counts]
        tips = points[np.cumsum(counts) - 1]
        self.assertLess(np.abs(roots[:, 2]).max(), 1e-5)
        self.assertLess(np.abs(tips[:, 2] - 0.1).max(), 0.01)

    def test_and_scalp_are_taken_from_the_selection(self):
        guides, scalp = legacy_curve("fur", "POLY", fur()), plane()
        scalp.location = guides.location = (1, 2, 3)
        select(scalp, guides)
        bpy.ops.object.lancret_add()
        obj = bpy.context.object
        settings = obj.lancret
        self.assertEqual(settings.error, "")
        self.assertEqual((settings.source, settings.scalp), ("SCENE", scalp))
        self.assertEqual(obj.parent, scalp)
        settings.count, settings.viewport = 300, 1
        self.update(obj)
        points, _, counts = evaluated(obj)
        self.assertEqual(len(counts), 300)
        roots = points[np.cumsum(counts) - counts]
        tips = points[np.cumsum(counts) - 1]
        self.assertLess(np.abs(roots[:, 2]).max(), 1e-5)
        self.assertLess(np.abs(roots[:, :2]).max(), 0.121)
        # Guides are 0.1 high and lean by 0.03; fitted helices are within 10 % of that.
        self.assertLess(np.abs(tips - roots - [0.03, 0, 0.1]).max(), 0.01)
        place = np.array(obj.matrix_world.translation)
        self.assertLess(np.abs(place - (1, 2, 3)).max(), 1e-6)

    def test_have_the_transform_of_their_object(self):
        guides = legacy_curve("fur", "POLY", fur())
        guides.location, guides.rotation_euler = (0, 0, 0.5), (0, 0, np.pi / 2)
        obj = self.add()
        settings = obj.lancret
        settings.source = "SCENE"
        settings.guides.add().object = guides
        bpy.context.view_layer.update()
        source = scene_source.source_of(obj, self.scene)
        turned = np.concatenate(fur())[:, [1, 0, 2]] * [-1, 1, 1] + [0, 0, 0.5]
        self.assertLess(np.abs(source.strands.points - turned).max(), 1e-6)
        self.assertEqual((source.strands.up, source.strands.metres_per_unit), ("Z", 1))

    def test_whose_nodes_or_modifier_were_deleted_are_drawn_after_an_update(self):
        obj = self.add()
        before = evaluated(obj)
        obj.modifiers.clear()
        self.update(obj)
        assert_same(self, evaluated(obj), before)
        obj.lancret.nodes.nodes["Set Material"].name = "x"
        self.update(obj)
        self.assertEqual(obj.lancret.error, "")
        obj.lancret.nodes.nodes.clear()
        self.update(obj)
        assert_same(self, evaluated(obj), before)


class Scalp(InBlender):
    def test_of_a_file_is_not_taken_from_the_selection(self):
        select(plane())
        obj = self.add()
        self.assertIsNone(obj.lancret.scalp)
        self.assertIsNone(obj.parent)
        self.assertEqual(obj.lancret.error, "")

    def test_of_a_file_is_in_the_files_axes_and_units(self):
        for mirror in (1, -1):
            self.check_scalp(mirror)

    def check_scalp(self, mirror):
        obj, scalp = self.add(), plane()
        scalp.location, scalp.scale = (0, 0, 0.2), (mirror, 1, 1)
        obj.lancret.scalp = scalp
        scene_source.update_scene_objects([obj], self.scene)
        mesh = scene_source.source_of(obj, self.scene).scalp
        self.assertEqual(len(mesh.corners), 2)
        self.assertLess(np.abs(mesh.positions[:, 1] - 20).max(), 1e-4)
        self.assertLess(np.abs(np.abs(mesh.positions[:, [0, 2]]) - 12).max(), 1e-4)
        self.assertEqual(mesh.uvs.shape, (2, 3, 2))
        corners = mesh.positions[mesh.corners[0]]
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        self.assertGreater(normal[1], 0)
        # The texture coordinates go from corner to corner of the square.
        expected = mesh.positions[mesh.corners][..., [0, 2]] / 24 * [mirror, -1] + 0.5
        self.assertLess(np.abs(mesh.uvs - expected).max(), 1e-6)


class Ends(InBlender):
    def test_are_within_the_tolerance(self):
        """The made groom has curls as tight as real hair."""
        obj = self.add(EXAMPLES / "made_groom.toml")
        obj.lancret.viewport, obj.lancret.count = 1, 2000
        self.update(obj)
        self.assertIn("tolerance = 0.06 ", (EXAMPLES / "made_groom.toml").read_text())
        self.assertTrue(0 < obj.lancret.end_error < 0.06, obj.lancret.end_error)

    def test_differ_from_the_curves_by_at_most_the_reported_error(self):
        with lancret().open(self.groom) as groom:
            curves = groom.expand(basis=strands.BASIS, unit=1)
        drawn = strands.drawn(curves, "Y", (), 24)
        self.assertGreater(drawn.end_error, 0)
        t = np.linspace(0, 1, 33)[:, None]
        worst = 0.0
        for number in range(len(curves)):
            p = curves.strand(number)[:4, :3].astype(np.float64)
            doubled = p.copy()
            doubled[0] = p[1]
            ours, cycles = catmull_rom(p, t), catmull_rom(doubled, t)
            along = (p[2] - p[1]) / np.linalg.norm(p[2] - p[1])
            off = cycles - ours
            off -= np.outer(off @ along, along)
            worst = max(worst, np.linalg.norm(off, axis=1).max())
        self.assertLessEqual(worst, drawn.end_error)


def catmull_rom(p, t):
    return (
        p[1]
        + t * (p[2] - p[0]) / 2
        + t**2 * (p[0] - 2.5 * p[1] + 2 * p[2] - p[3] / 2)
        + t**3 * (-p[0] + 3 * p[1] - 3 * p[2] + p[3]) / 2
    )
