"""The examples of docs/python.md run as they stand."""

import contextlib
import io
import os
import re

import lancret

from .shapes import lawn, square
from .support import HAS_USD, ROOT, WithFolder, needs_plots, needs_usd

PAGE = ROOT / "docs" / "python.md"


def examples():
    """Each section's title and the Python in it."""
    for section in re.split(r"^## ", PAGE.read_text(), flags=re.M)[1:]:
        code = re.findall(r"^```python\n(.*?)^```", section, flags=re.M | re.S)
        if code:
            yield section.split("\n")[0], "".join(code)


class Docs(WithFolder):
    def run_examples(self, folder, *chosen):
        names, ran = {}, {}
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(folder)
        for title, code in examples():
            if any(title.startswith(start) for start in chosen):
                with contextlib.redirect_stdout(io.StringIO()) as said:
                    exec(compile(code, f"{PAGE}: {title}", "exec"), names)  # noqa: S102
                ran[title] = said.getvalue()
        self.assertEqual(len(ran), len(chosen), ran.keys())
        return names, ran

    def test_those_of_grooms(self):
        names, said = self.run_examples(ROOT, "Open", "Strands", "Many")
        self.assertIn("Check(strands=5000, failed=0, outside=0", "".join(said.values()))
        self.assertIsInstance(names["hair"], lancret.Curves)
        self.assertEqual(len(names["guides"]), 10)

    @needs_plots
    def test_those_of_notebooks(self):
        self.run_examples(ROOT, "Open", "Pictures")

    @needs_usd
    def test_those_of_usd(self):
        from pxr import Usd, UsdGeom

        from lancret import usd

        strands, mesh = lawn(), square()
        stage = Usd.Stage.CreateNew(str(self.folder / "guides.usda"))
        UsdGeom.SetStageMetersPerUnit(stage, 0.01)
        curves = UsdGeom.BasisCurves.Define(stage, "/hair")
        curves.CreateTypeAttr("linear")
        curves.CreateCurveVertexCountsAttr(strands.counts.tolist())
        curves.CreatePointsAttr([tuple(map(float, p)) for p in strands.points])
        plane = UsdGeom.Mesh.Define(stage, "/plane")
        plane.CreatePointsAttr([tuple(map(float, p)) for p in mesh.positions])
        plane.CreateFaceVertexCountsAttr([3, 3])
        plane.CreateFaceVertexIndicesAttr(mesh.corners.ravel().tolist())
        stage.Save()
        _, said = self.run_examples(self.folder, "USD")
        self.assertEqual(said["USD"], "[]\n")
        self.assertTrue(HAS_USD and len(usd.read(self.folder / "hair.usdc")) == 50_000)
