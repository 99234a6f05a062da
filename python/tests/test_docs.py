"""The examples of docs/python.md run unchanged."""

import contextlib
import io
import os
import re

import lancret

from .shapes import lawn, square
from .support import HAS_USD, ROOT, WithFolder, needs_plots, needs_usd

PAGE = ROOT / "docs" / "python.md"


def examples():
    """Yields the title of each section and its Python code."""
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
                with contextlib.redirect_stdout(io.StringIO()) as output:
                    exec(compile(code, f"{PAGE}: {title}", "exec"), names)  # noqa: S102
                ran[title] = output.getvalue()
        self.assertEqual(len(ran), len(chosen), ran.keys())
        return names, ran

    def test_grooms(self):
        names, output = self.run_examples(ROOT, "Open", "Strands", "Several")
        self.assertIn(
            "Check(strands=5000, failed=0, outside=0", "".join(output.values())
        )
        self.assertIsInstance(names["hair"], lancret.Curves)
        self.assertEqual(len(names["guides"]), 10)

    @needs_plots
    def test_notebooks(self):
        self.run_examples(ROOT, "Open", "Pictures")

    @needs_usd
    def test_usd(self):
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
        _, output = self.run_examples(self.folder, "USD")
        self.assertEqual(output["USD"], "[]\n")
        self.assertTrue(HAS_USD and len(usd.read(self.folder / "hair.usdc")) == 50_000)
