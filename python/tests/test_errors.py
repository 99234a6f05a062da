"""Validation of arguments in Python, and how the library is found."""

import dataclasses
import os
import subprocess
import sys
import unittest
import unittest.mock

import numpy as np

import lancret
from lancret import _abi
from lancret._library import NAME, candidates
from lancret._source import Source, flat

from .support import ROOT


class Input(unittest.TestCase):
    def test_tables_of_parameters_are_names_with_dots(self):
        nested = {"strands": {"count": 5, "blend": "detail"}, "width.root": 0.01}
        self.assertEqual(
            list(flat(nested)),
            [("strands.count", 5), ("strands.blend", "detail"), ("width.root", 0.01)],
        )

    def test_values_are_text_or_numbers(self):
        source = Source(None, parameters={"a": "x", "b": True, "c": 0.5})
        values = [source.struct.parameters[i] for i in range(3)]
        self.assertEqual([value.text for value in values], [b"x", None, None])
        self.assertEqual([value.number for value in values], [0, 1, 0.5])
        with self.assertRaisesRegex(
            lancret.InputError, r"scene.up: \[0, 1\] is neither"
        ):
            Source(None, parameters={"scene": {"up": [0, 1]}})

    def test_a_source_with_line_breaks_is_the_text_of_a_toml(self):
        source = Source("[guides]\n")
        self.assertEqual(
            (source.struct.text, source.struct.path), (b"[guides]\n", None)
        )
        source = Source("head.toml", text="")
        self.assertEqual((source.struct.text, source.struct.path), (b"", b"head.toml"))

    def test_unit_axis_and_widths_of_strands_override_the_toml(self):
        strands = lancret.Strands(
            points=np.zeros((4, 3)),
            counts=[2, 2],
            widths=[0.5, 0.25, 0.5, 0.25],
            metres_per_unit=0.001,
            up="Z",
        )
        source = Source(None, strands=strands, parameters={"width": {"tip": 7}})
        count = source.struct.parameter_count
        values = {p.name: p.text or p.number for p in source.struct.parameters[:count]}
        self.assertEqual(values[b"scene.up"], b"Z")
        self.assertEqual(values[b"scene.metres_per_unit"], 0.001)
        self.assertAlmostEqual(values[b"width.root"], 0.05)
        self.assertEqual(values[b"width.tip"], 7)

    def widths_given(self, text=None, parameters=None, **scene):
        strands = lancret.Strands(
            np.zeros((4, 3)), counts=[2, 2], widths=[0.5, 0.25] * 2, **scene
        )
        source = Source(None, text=text, strands=strands, parameters=parameters)
        count = source.struct.parameter_count
        values = {p.name: p.number for p in source.struct.parameters[:count]}
        return values.get(b"width.root"), values.get(b"width.tip")

    def test_widths_are_in_the_unit_in_effect(self):
        toml = "[scene]\nmetres_per_unit = 1\n"
        unit = {"scene.metres_per_unit": 0.5}
        self.assertEqual(self.widths_given(), (0.5, 0.25))
        self.assertEqual(self.widths_given(metres_per_unit=1.0), (50, 25))
        self.assertEqual(self.widths_given(toml, unit), (25, 12.5))
        self.assertEqual(
            self.widths_given(toml, unit, metres_per_unit=0.001), (25, 12.5)
        )
        with self.assertRaisesRegex(lancret.InputError, "widths: unknown unit"):
            self.widths_given(toml)
        cm = {"width": {"root": 3, "tip": 2}}
        self.assertEqual(self.widths_given(toml, cm), (3, 2))

    def test_values_that_c_cannot_represent_are_refused(self):
        for parameters, message in (
            ({"strands.seed": 2**53 + 1}, "strands.seed: 9007199254740993 is above"),
            ({"strands.blend": "detail\0xx"}, "zero byte"),
            ({"strands.blend\0xx": "detail"}, "zero byte"),
        ):
            with self.assertRaisesRegex(lancret.InputError, message):
                Source(None, parameters=parameters)
        Source(None, parameters={"strands.seed": 2**53, "strands.count": np.int64(3)})

    def test_strands_are_immutable_and_validated_when_replaced(self):
        strands = lancret.Strands(np.zeros((4, 3)), counts=[4])
        with self.assertRaises(dataclasses.FrozenInstanceError):
            strands.points = np.zeros((2, 3))
        with self.assertRaisesRegex(lancret.InputError, "there are 2"):
            dataclasses.replace(strands, points=np.zeros((2, 3)))
        turned = dataclasses.replace(strands, points=strands.points[:, [0, 2, 1]])
        self.assertTrue(turned.points.flags.c_contiguous)

    def test_arrays_of_the_right_type_are_not_copied(self):
        points = np.zeros((4, 3), np.float32)
        counts = np.array([4], np.uint32)
        strands = lancret.Strands(points, counts)
        source = Source(None, strands=strands)
        struct = source.struct.strands.contents
        address = np.ctypeslib.as_array(struct.points, (4, 3)).ctypes.data
        self.assertEqual(address, points.ctypes.data)
        self.assertIs(strands.counts, counts)

    def test_arrays_of_wrong_shape_or_range_are_refused(self):
        for points, counts, message in (
            (np.zeros((4, 2)), [4], "shape"),
            (np.zeros((4, 3)), [3], "sum is 3, but there are 4 points"),
            (np.zeros((4, 3)), [-1, 5], "from 0 to"),
            (np.zeros((4, 3)), [1, 3], "a strand has 1 points"),
            (np.zeros((4, 3)), [4.0], "whole numbers"),
        ):
            with self.assertRaisesRegex(lancret.InputError, message):
                lancret.Strands(points, counts)
        with self.assertRaisesRegex(
            lancret.InputError, "bspline strand needs 4 or more"
        ):
            lancret.Strands(np.zeros((3, 3)), [3], basis="bspline")
        with self.assertRaisesRegex(lancret.InputError, "uvs: shape is"):
            lancret.Mesh(np.zeros((3, 3)), [[0, 1, 2]], uvs=np.zeros((3, 2)))


class Library(unittest.TestCase):
    def run_python(self, code, **environment):
        return subprocess.run(
            [sys.executable, "-c", code],
            cwd=ROOT / "python",
            env=os.environ | environment,
            capture_output=True,
            text=True,
        )

    def test_the_package_can_be_imported_without_the_library(self):
        result = self.run_python(
            "import lancret\ntry: lancret.version()\n"
            "except lancret.LibraryNotFound as fault: print(fault)",
            LANCRET_LIBRARY="/nowhere/lib.so",
        )
        self.assertIn("/nowhere/lib.so: ", result.stdout, result.stderr)

    def test_the_system_is_searched_for_this_abi_version(self):
        with unittest.mock.patch.dict(os.environ):
            os.environ.pop("LANCRET_LIBRARY", None)
            self.assertIn(f"{NAME}.{_abi.ABI_VERSION}", candidates())

    def test_usd_and_matplotlib_are_imported_on_demand(self):
        result = self.run_python(
            "import lancret, lancret.notebook, sys\n"
            "print([name for name in ('pxr', 'matplotlib') if name in sys.modules])"
        )
        self.assertEqual(result.stdout, "[]\n", result.stderr)
