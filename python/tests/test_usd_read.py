"""Reading BasisCurves of every basis, wrap and width interpolation."""

import unittest

import numpy as np

from lancret import InputError, cubic

from .support import HAS_USD, needs_usd

if HAS_USD:
    from pxr import Gf, Sdf, Usd, UsdGeom, Vt

    from lancret import usd


def stage_with(points, counts, kind="cubic", basis="bspline", wrap="nonperiodic"):
    stage = Usd.Stage.CreateInMemory()
    curves = UsdGeom.BasisCurves.Define(stage, "/hair")
    curves.CreateTypeAttr(kind)
    curves.CreateBasisAttr(basis)
    curves.CreateWrapAttr(wrap)
    curves.CreateCurveVertexCountsAttr(counts)
    curves.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(np.float32(points)))
    return stage, curves


def some_points(n, seed=1):
    return np.random.default_rng(seed).normal(size=(n, 3)).astype(np.float32)


@needs_usd
class Bases(unittest.TestCase):
    def test_nonperiodic_bsplines_keep_their_control_points(self):
        points = some_points(9)
        stage, _ = stage_with(points, [4, 5])
        read = usd.read(stage)
        self.assertEqual(read.basis, "bspline")
        self.assertEqual(read.counts.tolist(), [4, 5])
        np.testing.assert_array_equal(read.points, points)

    def test_pinned_bsplines_begin_and_end_at_their_own_points(self):
        points = some_points(7)
        stage, _ = stage_with(points, [2, 5], wrap="pinned")
        read = usd.read(stage)
        self.assertEqual(read.counts.tolist(), [4, 7])
        places, _ = cubic.sample(read.points, read.counts, "bspline", 1)
        np.testing.assert_allclose(
            places[[0, 1, 2, 6]], points[[0, 1, 2, 6]], atol=1e-6
        )

    def test_the_basis_of_polylines_is_ignored(self):
        points = some_points(5)
        stage, _ = stage_with(points, [2, 3], kind="linear", basis="bezier")
        read = usd.read(stage)
        self.assertEqual((read.basis, read.counts.tolist()), ("linear", [2, 3]))
        np.testing.assert_array_equal(read.points, points)

    def test_bezier_and_catmull_rom_become_places_on_the_curve(self):
        for basis, wrap, ends in (
            ("bezier", "nonperiodic", (0, 6)),
            ("bezier", "pinned", (0, 6)),
            ("catmullRom", "nonperiodic", (1, 5)),
            ("catmullRom", "pinned", (0, 6)),
        ):
            with self.subTest(basis=basis, wrap=wrap):
                points = some_points(7)
                stage, _ = stage_with(points, [7], basis=basis, wrap=wrap)
                read = usd.read(stage)
                self.assertEqual(read.basis, "catmull-rom")
                np.testing.assert_allclose(
                    read.points[[0, -1]], points[list(ends)], atol=1e-6
                )
                segments = {"bezier": 2, "catmullRom": ends[1] - ends[0]}[basis]
                self.assertEqual(read.counts.tolist(), [8 * segments + 1])

    def test_closed_curves_are_refused_by_name(self):
        stage, _ = stage_with(some_points(5), [5], wrap="periodic")
        with self.assertRaisesRegex(InputError, r":/hair: wrap is periodic"):
            usd.read(stage)

    def test_bases_that_usd_no_longer_has_are_refused(self):
        stage, _ = stage_with(some_points(5), [5], basis="hermite")
        with self.assertRaisesRegex(InputError, "basis is hermite"):
            usd.read(stage)

    def test_counts_that_do_not_fit_are_refused(self):
        for counts, message in (
            ([4], "the sum 4"),
            ([1, 4], "the minimum is 1"),
            ([2, 3], "needs 4"),
        ):
            stage, _ = stage_with(some_points(5), counts)
            with self.assertRaisesRegex(InputError, f":/hair: .*{message}"):
                usd.read(stage)
        stage, _ = stage_with(some_points(5), [5], basis="bezier")
        with self.assertRaisesRegex(InputError, "bezier curve cannot have 5 points"):
            usd.read(stage)

    def test_points_that_are_not_finite_are_refused(self):
        points = some_points(4)
        points[2, 1] = np.nan
        stage, _ = stage_with(points, [4])
        with self.assertRaisesRegex(InputError, ":/hair: points contains a number"):
            usd.read(stage)

    def test_a_stage_without_curves_is_an_error(self):
        with self.assertRaisesRegex(InputError, "no BasisCurves"):
            usd.read(Usd.Stage.CreateInMemory())
        with self.assertRaisesRegex(InputError, "no such file"):
            usd.read("/nowhere/hair.usda")


@needs_usd
class Widths(unittest.TestCase):
    def test_sizes_of_every_interpolation_agree_with_usd(self):
        """UsdGeomBasisCurves computes the interpolation of a size; ours must agree."""
        for basis, wrap, counts in (
            ("bspline", "nonperiodic", [4, 6]),
            ("bspline", "pinned", [4, 6]),
            ("catmullRom", "nonperiodic", [4, 6]),
            ("catmullRom", "pinned", [4, 6]),
            ("bezier", "nonperiodic", [4, 7]),
            ("bezier", "pinned", [4, 7]),
        ):
            for kind in ("constant", "uniform", "varying", "vertex"):
                with self.subTest(basis=basis, wrap=wrap, kind=kind):
                    stage, curves = stage_with(
                        some_points(sum(counts)), counts, basis=basis, wrap=wrap
                    )
                    size = {
                        "constant": 1,
                        "uniform": 2,
                        "vertex": sum(counts),
                        "varying": (
                            curves.ComputeVaryingDataSize(Usd.TimeCode.Default())
                            if hasattr(curves, "ComputeVaryingDataSize")
                            else self.varying(curves, sum(counts))
                        ),
                    }[kind]
                    curves.CreateWidthsAttr([0.5] * size)
                    curves.SetWidthsInterpolation(kind)
                    read = usd.read(stage)
                    np.testing.assert_allclose(read.widths, 0.5, rtol=1e-6)

    @staticmethod
    def varying(curves, max_size):
        """The size up to `max_size` that USD considers varying; `max_size` if that is also
        the size of vertex."""
        time = Usd.TimeCode.Default()
        sizes = range(3, max_size + 1)
        kinds = {n: str(curves.ComputeInterpolationForSize(n, time)) for n in sizes}
        return next((n for n in sizes if kinds[n] == "varying"), max_size)

    def test_pinned_varying_widths_may_be_one_per_point(self):
        """A pinned curve has one segment fewer than points, so as many ends of segments."""
        stage, curves = stage_with(
            some_points(5), [5], basis="catmullRom", wrap="pinned"
        )
        curves.CreateWidthsAttr([1, 2, 4, 8, 16])
        curves.SetWidthsInterpolation("varying")
        np.testing.assert_allclose(usd.read(stage).widths[::8], [1, 2, 4, 8, 16])

    def test_vertex_widths_are_control_values_of_the_same_curve(self):
        stage, curves = stage_with(some_points(4), [4], basis="bezier")
        curves.CreateWidthsAttr([1, 2, 4, 8])
        curves.SetWidthsInterpolation("vertex")
        widths = usd.read(stage).widths
        self.assertEqual((widths[0], widths[-1]), (1, 8))
        self.assertAlmostEqual(float(widths[4]), (1 + 3 * 2 + 3 * 4 + 8) / 8, places=6)

    def test_varying_widths_are_linear_between_the_ends_of_segments(self):
        stage, curves = stage_with(some_points(7), [7], basis="bezier")
        curves.CreateWidthsAttr([1, 2, 4])
        curves.SetWidthsInterpolation("varying")
        expected = np.concatenate([np.linspace(1, 2, 9), np.linspace(2, 4, 9)[1:]])
        np.testing.assert_allclose(usd.read(stage).widths, expected, rtol=1e-6)

    def test_varying_widths_of_different_counts_stay_with_their_curves(self):
        stage, curves = stage_with(some_points(4 + 7 + 4), [4, 7, 4], basis="bezier")
        curves.CreateWidthsAttr([1, 2, 10, 20, 40, 5, 6])
        curves.SetWidthsInterpolation("varying")
        read = usd.read(stage)
        ends = [
            read.widths[[a, b - 1]].tolist() for a, b in zip(read.first, read.first[1:])
        ]
        self.assertEqual(ends, [[1, 2], [10, 40], [5, 6]])
        curves.SetWidthsInterpolation("faceVarying")  # the same for curves
        np.testing.assert_array_equal(usd.read(stage).widths, read.widths)

    def test_the_primvar_overrides_the_attribute(self):
        stage, curves = stage_with(some_points(4), [4])
        curves.CreateWidthsAttr([1.0] * 4)
        curves.SetWidthsInterpolation("vertex")
        primvars = UsdGeom.PrimvarsAPI(curves)
        floats = Sdf.ValueTypeNames.FloatArray
        primvars.CreatePrimvar("widths", floats, "constant").Set([0.25])
        self.assertEqual(usd.read(stage).widths.tolist(), [0.25] * 4)
        curves.GetWidthsAttr().Clear()
        self.assertEqual(usd.read(stage).widths.tolist(), [0.25] * 4)
        primvars.GetPrimvar("widths").Set([float("nan")])
        with self.assertRaisesRegex(
            InputError, ":/hair: primvars:widths contains a number"
        ):
            usd.read(stage)

    def test_may_be_inherited(self):
        stage = Usd.Stage.CreateInMemory()
        above = UsdGeom.Xform.Define(stage, "/above")
        floats = Sdf.ValueTypeNames.FloatArray
        UsdGeom.PrimvarsAPI(above).CreatePrimvar("widths", floats, "constant").Set(
            [0.5]
        )
        curves = UsdGeom.BasisCurves.Define(stage, "/above/hair")
        curves.CreateCurveVertexCountsAttr([4])
        curves.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(some_points(4)))
        self.assertEqual(set(usd.read(stage).widths), {0.5})

    def test_a_tapers_ends_are_those_of_the_curve(self):
        stage, curves = stage_with(some_points(5), [5], wrap="pinned")
        curves.CreateWidthsAttr([0.5, 0.4, 0.3, 0.2, 0.1])
        curves.SetWidthsInterpolation("vertex")
        UsdGeom.SetStageMetersPerUnit(stage, 1)
        np.testing.assert_allclose(usd.read(stage).taper(), (0.5, 0.1), rtol=1e-5)

    def test_a_wrong_number_of_widths_is_refused(self):
        stage, curves = stage_with(some_points(9), [4, 5])
        curves.CreateWidthsAttr([1, 2, 3, 4])
        curves.SetWidthsInterpolation("vertex")
        with self.assertRaisesRegex(
            InputError, "widths are vertex: expected 9 values, found 4"
        ):
            usd.read(stage)


@needs_usd
class Places(unittest.TestCase):
    def test_points_and_widths_are_in_world_space(self):
        stage, curves = stage_with([[1, 0, 0], [2, 0, 0]], [2], kind="linear")
        curves.CreateWidthsAttr([0.1])
        curves.SetWidthsInterpolation("constant")
        UsdGeom.Xformable(curves).AddTranslateOp().Set(Gf.Vec3d(0, 0, 5))
        UsdGeom.Xformable(curves).AddRotateZOp().Set(90)
        UsdGeom.Xformable(curves).AddScaleOp().Set(Gf.Vec3f(2, 2, 2))
        read = usd.read(stage)
        np.testing.assert_allclose(read.points, [[0, 2, 5], [0, 4, 5]], atol=1e-6)
        np.testing.assert_allclose(read.widths, [0.2, 0.2], rtol=1e-6)

    def test_units_and_axis_are_the_stages(self):
        stage, _ = stage_with(some_points(4), [4])
        self.assertEqual(
            (usd.read(stage).metres_per_unit, usd.read(stage).up),
            (UsdGeom.GetStageMetersPerUnit(stage), str(UsdGeom.GetStageUpAxis(stage))),
        )
        UsdGeom.SetStageMetersPerUnit(stage, 0.5)
        UsdGeom.SetStageUpAxis(stage, "Z")
        self.assertEqual(
            (usd.read(stage).metres_per_unit, usd.read(stage).up), (0.5, "Z")
        )

    def test_instances_are_read_where_they_stand(self):
        stage, _ = stage_with(some_points(4), [4])
        for i in range(2):
            place = UsdGeom.Xform.Define(stage, f"/place{i}")
            UsdGeom.Xform.Define(stage, "/proto")
            place.AddTranslateOp().Set(Gf.Vec3d(10 * i, 0, 0))
            place.GetPrim().GetReferences().AddInternalReference("/proto")
            place.GetPrim().SetInstanceable(True)
        Sdf.CopySpec(stage.GetRootLayer(), "/hair", stage.GetRootLayer(), "/proto/hair")
        stage.RemovePrim("/hair")
        self.assertEqual(len(usd.read(stage, "/place1")), 1)
        whole = usd.read(stage).points.reshape(-1, 4, 3)
        self.assertEqual(len(whole), 3)  # including the prototype
        np.testing.assert_allclose(
            sorted(whole[:, 0, 0] - whole[:, 0, 0].min()), [0, 0, 10], atol=1e-5
        )
        np.testing.assert_allclose(
            usd.read(stage, "/place1").points,
            usd.read(stage, "/place0").points + [10, 0, 0],
            atol=1e-5,
        )

    def test_several_prims_are_joined_in_a_common_basis(self):
        stage, _ = stage_with(some_points(4), [4])
        other = UsdGeom.BasisCurves.Define(stage, "/other")
        other.CreateTypeAttr("cubic")
        other.CreateBasisAttr("bezier")
        other.CreateCurveVertexCountsAttr([4])
        other.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(some_points(4)))
        read = usd.read(stage)
        self.assertEqual((read.basis, read.counts.tolist()), ("catmull-rom", [9, 9]))
        self.assertEqual(usd.read(stage, "/hair").basis, "bspline")
        other.CreateTypeAttr("linear")
        with self.assertRaisesRegex(InputError, "linear and cubic curves together"):
            usd.read(stage)

    def test_invisible_prims_are_not_read_unless_they_are_named(self):
        stage, _ = stage_with(some_points(4), [4])
        for name in ("invisible", "proxy", "guide", "render"):
            other = UsdGeom.BasisCurves.Define(stage, f"/{name}")
            other.CreateCurveVertexCountsAttr([4])
            other.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(some_points(4)))
            if name == "invisible":
                other.MakeInvisible()
            else:
                other.CreatePurposeAttr(name)
        self.assertEqual(len(usd.read(stage)), 2)
        self.assertEqual(len(usd.read(stage, purposes=("guide", "proxy"))), 2)
        for name in ("invisible", "guide"):
            self.assertEqual(len(usd.read(stage, f"/{name}")), 1)
        for name in ("hair", "render"):
            stage.RemovePrim(f"/{name}")
        with self.assertRaisesRegex(
            InputError, "3 BasisCurves, but none that is visible"
        ):
            usd.read(stage)

    def test_prims_of_a_point_instancer_are_refused(self):
        stage, _ = stage_with(some_points(4), [4])
        UsdGeom.PointInstancer.Define(stage, "/many")
        Sdf.CopySpec(stage.GetRootLayer(), "/hair", stage.GetRootLayer(), "/many/hair")
        with self.assertRaisesRegex(InputError, "/many/hair: is placed by .* /many"):
            usd.read(stage)
        self.assertEqual(len(usd.read(stage, "/many/hair")), 1)

    def test_a_prim_without_curves_is_ignored(self):
        for wrap in ("pinned", "nonperiodic"):
            stage, _ = stage_with(np.empty((0, 3)), [], wrap=wrap)
            self.assertEqual(len(usd.read(stage)), 0)
            other = UsdGeom.BasisCurves.Define(stage, "/other")
            other.CreateCurveVertexCountsAttr([4])
            other.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(some_points(4)))
            self.assertEqual(len(usd.read(stage)), 1)

    def test_attributes_of_only_some_prims_are_left_out_with_a_warning(self):
        stage, curves = stage_with(some_points(4), [4])
        curves.CreateWidthsAttr([1.0])
        curves.SetWidthsInterpolation("constant")
        other = UsdGeom.BasisCurves.Define(stage, "/other")
        other.CreateCurveVertexCountsAttr([4])
        other.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(some_points(4)))
        with self.assertLogs("lancret", "WARNING") as logs:
            self.assertIsNone(usd.read(stage).widths)
        self.assertEqual(len(logs.output), 1)
        self.assertRegex(logs.output[0], ":/other: has no widths")

    def test_a_prim_is_read_at_one_time(self):
        """The time of the first sample of the points, for transform and widths too, even
        if the points have a default."""
        stage, curves = stage_with(np.zeros((4, 3)), [4])
        curves.GetPointsAttr().Set(Vt.Vec3fArray.FromNumpy(np.ones((4, 3), "f4")), 10)
        place = UsdGeom.Xformable(curves).AddTranslateOp()
        place.Set(Gf.Vec3d(0, 0, 0), 1)
        place.Set(Gf.Vec3d(9, 0, 0), 10)
        widths = curves.CreateWidthsAttr()
        widths.Set([1.0], 1)
        widths.Set([3.0], 10)
        curves.SetWidthsInterpolation("constant")
        read = usd.read(stage)
        self.assertEqual(read.points[0].tolist(), [10, 1, 1])
        self.assertEqual(read.widths[0], 3)
        curves.GetPointsAttr().ClearAtTime(10)
        read = usd.read(stage)  # points have only a default: first samples of the rest
        self.assertEqual((read.points[0].tolist(), read.widths[0]), ([0, 0, 0], 1))

    def test_samples_are_read_at_their_times_and_the_first_by_default(self):
        stage, curves = stage_with(some_points(4), [4])
        curves.GetPointsAttr().Clear()
        for time in (3, 7):
            value = Vt.Vec3fArray.FromNumpy(np.full((4, 3), time, np.float32))
            curves.GetPointsAttr().Set(value, time)
        self.assertEqual(usd.read(stage).points[0, 0], 3)
        self.assertEqual(usd.read(stage, time=7).points[0, 0], 7)
        self.assertEqual(usd.read(stage, time=5).points[0, 0], 5)

    def test_roots_have_their_texture_coordinates_and_ids(self):
        stage, curves = stage_with(some_points(9), [4, 5])
        primvars = UsdGeom.PrimvarsAPI(curves)
        primvars.CreatePrimvar("st", Sdf.ValueTypeNames.TexCoord2fArray, "uniform").Set(
            [(0.25, 0.5), (0.75, 1)]
        )
        primvars.CreatePrimvar("id", Sdf.ValueTypeNames.IntArray, "uniform").Set([7, 3])
        read = usd.read(stage)
        self.assertEqual(read.root_uv.tolist(), [[0.25, 0.5], [0.75, 1]])
        self.assertEqual(read.ids.tolist(), [7, 3])
        primvars.RemovePrimvar("st")
        primvars.CreatePrimvar("st", Sdf.ValueTypeNames.TexCoord2fArray, "vertex").Set(
            [(i, 0) for i in range(9)]
        )
        self.assertEqual(usd.read(stage).root_uv.tolist(), [[0, 0], [4, 0]])
