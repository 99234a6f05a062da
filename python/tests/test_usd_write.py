"""Writing strands as BasisCurves, and reading them back."""

import os
import unittest

import numpy as np

import lancret

from .shapes import lawn, square
from .support import DATA, HAS_USD, SMALL, WithFolder, command, needs_data, needs_usd

if HAS_USD:
    from pxr import Usd, UsdGeom

    from lancret import usd


def read_back(path, prim="/Hair/strands", time=None):
    """The contents of a file, read with usd-core, as arrays."""
    stage = Usd.Stage.Open(str(path))
    curves = UsdGeom.BasisCurves(stage.GetPrimAtPath(prim))
    code = Usd.TimeCode.Default() if time is None else Usd.TimeCode(time)
    primvars = UsdGeom.PrimvarsAPI(curves)

    def primvar(name):
        found = primvars.GetPrimvar(name)
        return np.array(found.Get()) if found else None

    return {
        "stage": stage,
        "curves": curves,
        "counts": np.array(curves.GetCurveVertexCountsAttr().Get(code)),
        "points": np.array(curves.GetPointsAttr().Get(code)),
        "widths": np.array(curves.GetWidthsAttr().Get(code)),
        "extent": np.array(curves.GetExtentAttr().Get(code)),
        "id": primvar("id"),
        "st": primvar("st"),
        "hairLength": primvar("hairLength"),
        "hairRandom": primvar("hairRandom"),
        "normals": np.array(curves.GetNormalsAttr().Get(code)),
    }


@needs_usd
class Writing(WithFolder):
    def test_the_file_has_the_arrays_of_expand(self):
        for name in ("hair.usda", "hair.usdc"):
            for basis in ("bspline", "linear", "bezier", "catmull-rom"):
                with self.subTest(name=name, basis=basis), lancret.open(SMALL) as groom:
                    path = self.folder / f"{basis}.{name}"
                    options = {
                        "basis": basis,
                        "attributes": (
                            "ids",
                            "root_uv",
                            "lengths",
                            "random",
                            "normals",
                        ),
                    }
                    usd.write(path, groom, **options)
                    hair, back = groom.expand(**options), read_back(path)
                np.testing.assert_array_equal(back["counts"], hair.counts)
                np.testing.assert_array_equal(back["points"], hair.points)
                np.testing.assert_array_equal(back["widths"], 2 * hair.radii)
                np.testing.assert_array_equal(back["id"], hair.ids)
                np.testing.assert_array_equal(back["st"], hair.root_uv)
                np.testing.assert_array_equal(back["hairLength"], hair.lengths)
                np.testing.assert_array_equal(back["hairRandom"], hair.random)
                np.testing.assert_array_equal(back["normals"], hair.normals[0, :, :3])

    def test_usdchecker_has_no_complaints(self):
        path = self.folder / "hair.usda"
        with lancret.open(SMALL) as groom:
            usd.write(path, groom)
        self.assertEqual(usd.complaints(path), [])
        broken = self.folder / "broken.usda"
        broken.write_text('#usda 1.0\ndef Xform "Hair" {}\n')
        self.assertNotEqual(usd.complaints(broken), [])

    def test_interpolations_and_types_are_valid_usd(self):
        path = self.folder / "hair.usdc"
        with lancret.open(SMALL) as groom:
            usd.write(path, groom)
        back = read_back(path)  # keeps the stage alive
        curves = back["curves"]
        time = Usd.TimeCode.Default()
        widths = len(curves.GetWidthsAttr().Get())
        self.assertEqual(curves.ComputeInterpolationForSize(widths, time), "vertex")
        self.assertEqual(curves.ComputeUniformDataSize(time), 300)
        self.assertEqual(
            (curves.GetBasisAttr().Get(), curves.GetWrapAttr().Get()),
            ("bspline", "nonperiodic"),
        )
        primvar = UsdGeom.PrimvarsAPI(curves).GetPrimvar("st")
        self.assertEqual(str(primvar.GetTypeName()), "texCoord2f[]")
        self.assertEqual(primvar.GetInterpolation(), "uniform")

    def test_units_and_axis_are_the_grooms_or_as_requested(self):
        path = self.folder / "hair.usda"
        with lancret.open(SMALL, parameters={"scene.up": "Z"}) as groom:
            usd.write(path, groom, metres_per_unit=1)
            hair, back = groom.expand(unit=100), read_back(path)
        self.assertEqual(UsdGeom.GetStageMetersPerUnit(back["stage"]), 1)
        self.assertEqual(UsdGeom.GetStageUpAxis(back["stage"]), "Z")
        np.testing.assert_array_equal(back["points"], hair.points)
        with lancret.open(SMALL, parameters={"scene.up": "X"}) as groom:
            with self.assertRaisesRegex(lancret.InputError, "supports only Y and Z"):
                usd.write(path, groom)
        with lancret.open(SMALL, parameters={"scene.metres_per_unit": 0.001}) as groom:
            usd.write(self.folder / "millimetres.usda", groom)
        back = read_back(self.folder / "millimetres.usda")
        self.assertEqual(UsdGeom.GetStageMetersPerUnit(back["stage"]), 0.001)

    def test_the_extent_contains_every_point_with_its_width(self):
        path = self.folder / "hair.usda"
        with lancret.open(SMALL) as groom:
            usd.write(path, groom)
            back, hair = read_back(path), groom.expand()
        low, high = back["extent"]
        self.assertTrue((low <= (hair.points - hair.radii[:, None]).min(axis=0)).all())
        self.assertTrue((high >= (hair.points + hair.radii[:, None]).max(axis=0)).all())

    def test_one_prim_per_chunk_is_the_same_hair(self):
        path = self.folder / "hair.usdc"
        with lancret.open(SMALL, chunk_strands=100) as groom:
            usd.write(path, groom, prim_per_chunk=True)
            for chunk in groom.chunks:
                np.testing.assert_array_equal(
                    read_back(path, f"/Hair/chunk_{chunk:05}")["points"],
                    groom.expand(chunk).points,
                )
            self.assertEqual(usd.complaints(path), [])

    def test_what_cannot_be_written_is_refused_and_leaves_nothing(self):
        with lancret.open(SMALL) as groom:
            for name, options, message in (
                ("hair.obj", {}, "extension must be one of .usd, .usda, .usdc"),
                ("hair.usda", {"basis": "hermite"}, "USD supports linear"),
                ("hair.usda", {"prim": "/a/b"}, "must be a root prim"),
                ("hair.usda", {"prim": "hair"}, "must be a root prim"),
                ("nowhere/hair.usda", {}, "nowhere: no such folder"),
                ("hair.usda", {"times": []}, "times: must not be empty"),
                ("hair.usda", {"attributes": ("tangents",)}, "tangents: cannot be wr"),
            ):
                with self.assertRaisesRegex(lancret.InputError, message):
                    usd.write(self.folder / name, groom, **options)
            with self.assertRaises(lancret.CallError):
                usd.write(self.folder / "hair.usda", groom, density=-1)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_after_a_failure_the_next_may_succeed(self):
        path, kept = self.folder / "hair.usda", []
        with lancret.open(SMALL) as groom:
            try:
                usd.write(path, groom, density=-1)
            except lancret.CallError as fault:
                kept.append(fault)  # a notebook does so, which keeps its locals alive
            usd.write(path, groom)
        names = [path.name for path in self.folder.iterdir()]
        self.assertEqual(names, ["hair.usda"])
        self.assertEqual(len(kept), 1)

    def test_stages_that_are_open_see_the_new_file(self):
        for name in ("hair.usda", "hair.usdc"):
            path = self.folder / name
            with lancret.open(SMALL) as groom:
                usd.write(path, groom)
            before = os.getcwd()
            self.addCleanup(os.chdir, before)
            os.chdir(self.folder)
            kept = Usd.Stage.Open(name)
            with lancret.open(SMALL, parameters={"strands.count": 50}) as groom:
                usd.write(path, groom)
            self.assertEqual((len(usd.read(path)), len(usd.read(kept))), (50, 50))

    def test_other_strands_at_the_same_path_are_refused(self):
        stage = Usd.Stage.CreateInMemory()

        def curve(points, time, number=0):
            return lancret.Curves(
                basis="linear",
                times=(time,),
                counts=np.array([points], np.uint32),
                positions=np.random.default_rng(1).random((1, points, 4), np.float32),
                ids=np.array([number], np.uint32),
            )

        usd.add_curves(stage, "/hair", curve(4, 1.0))
        usd.add_curves(stage, "/hair", curve(4, 2.0))
        for other in (curve(6, 3.0), curve(4, 3.0, number=1)):
            with self.assertRaisesRegex(
                lancret.InputError, "/hair: has curves with different"
            ):
                usd.add_curves(stage, "/hair", other)
        found = UsdGeom.BasisCurves(stage.GetPrimAtPath("/hair"))
        self.assertEqual(found.GetPointsAttr().GetTimeSamples(), [1, 2])

    def test_one_time_need_not_be_a_list(self):
        path = self.folder / "hair.usda"
        with lancret.open(SMALL) as groom:
            usd.write(path, groom, times=3)
        self.assertEqual(
            len(read_back(path, time=3)["points"]), len(usd.read(path).points)
        )

    @unittest.skipUnless(command(), "the program `lancret` is not built")
    def test_frames_become_time_samples(self):
        import subprocess

        toml = self.file(
            "groom.toml",
            SMALL + "[motion]\nkeys = [{ frame = 1 }, "
            "{ frame = 3, turn = [0, 20, 0] }]\n",
        )
        cache = self.folder / "cache.h5"
        subprocess.run(
            [command(), "simulate", toml, "--frames", "1-3", "-o", cache],
            check=True,
            capture_output=True,
        )
        path = self.folder / "hair.usdc"
        times = [1, 1.5, 2, 3]
        with lancret.open(cache) as groom:
            usd.write(path, groom, times=times)
            hair = groom.expand(times=times)
        stage = read_back(path, time=1)["stage"]
        self.assertEqual((stage.GetStartTimeCode(), stage.GetEndTimeCode()), (1, 3))
        for i, time in enumerate(times):
            back = read_back(path, time=time)
            np.testing.assert_array_equal(back["points"], hair.positions[i, :, :3])
            np.testing.assert_array_equal(back["counts"], hair.counts)
        self.assertFalse(np.array_equal(hair.positions[0], hair.positions[3]))
        self.assertEqual(usd.complaints(path), [])


@needs_usd
class RoundTrips(WithFolder):
    def test_strands_written_and_read_are_the_same_groom(self):
        """Writes strands, reads them as guides, writes children and reads these."""
        with lancret.open(strands=lawn(), parameters={"strands.count": 25}) as groom:
            usd.write(self.folder / "guides.usdc", groom)
        guides = usd.read(self.folder / "guides.usdc")
        self.assertEqual((len(guides), guides.basis), (25, "bspline"))
        with lancret.open(
            strands=guides, scalp=square(), parameters={"strands.count": 200}
        ) as groom:
            self.assertEqual(groom.info.guides, 25)
            hair = groom.expand(attributes=("ids", "root_uv"))
            usd.write(self.folder / "hair.usda", groom)
        self.assertEqual(len(hair), 200)
        back = read_back(self.folder / "hair.usda")
        np.testing.assert_array_equal(back["points"], hair.points)
        np.testing.assert_array_equal(back["widths"], 2 * hair.radii)
        np.testing.assert_array_equal(back["st"], hair.root_uv)
        self.assertEqual(usd.complaints(self.folder / "hair.usda"), [])

    @needs_data
    def test_real_grooms_go_in_and_out(self):
        tuft = {"guides.count": 200, "strands.count": 1500}
        blender = {"transform": False, "wrap": "pinned"}
        for name, up, guides, parameters, options in (
            ("tuft_bspline.usda", "Y", 200, tuft, {}),
            ("wavy_blender.usda", "Z", 72, {"strands.count": 400}, blender),
        ):
            with self.subTest(name=name):
                path = self.folder / f"out_{name}"
                with lancret.open(
                    strands=usd.read(DATA / name, **options),
                    scalp=usd.read_mesh(DATA / name),
                    parameters=parameters,
                ) as groom:
                    self.assertEqual(groom.info.guides, guides)
                    usd.write(path, groom)
                    metres = groom.info.cm_per_unit / 100
                    hair = groom.expand(
                        attributes=("ids", "root_uv"), unit=groom.info.cm_per_unit
                    )
                back = read_back(path)
                self.assertEqual(UsdGeom.GetStageMetersPerUnit(back["stage"]), metres)
                self.assertEqual(UsdGeom.GetStageUpAxis(back["stage"]), up)
                self.assertEqual(len(back["counts"]), parameters["strands.count"])
                np.testing.assert_array_equal(back["points"], hair.points)
                np.testing.assert_array_equal(back["widths"], 2 * hair.radii)
                np.testing.assert_array_equal(back["id"], hair.ids)
                np.testing.assert_array_equal(back["st"], hair.root_uv)
                again = usd.read(path)
                np.testing.assert_array_equal(again.points, hair.points)
                np.testing.assert_array_equal(again.widths, 2 * hair.radii)
                self.assertEqual(usd.complaints(path), [])
