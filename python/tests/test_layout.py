"""The ctypes structs have the layout of the C header."""

import ctypes
import re
import shutil
import subprocess
import unittest

from lancret import _abi

from .support import ROOT, WithFolder

HEADER = ROOT / "procedural" / "lancret_procedural.h"
COMPILER = shutil.which("cc") or shutil.which("gcc")


@unittest.skipUnless(HEADER.is_file() and COMPILER, "no header or no C compiler")
class Layout(WithFolder):
    def test_every_struct_and_field_has_the_offset_that_c_gives_it(self):
        lines = []
        for name, struct in _abi.STRUCTS.items():
            lines.append(f'printf("{name} %d\\n", (int)sizeof({name}));')
            for field, *_ in struct._fields_:
                lines.append(
                    f'printf("{name}.{field} %d\\n", (int)offsetof({name}, {field}));'
                )
        program = self.file(
            "layout.c",
            f'#include <stdio.h>\n#include "{HEADER}"\nint main(void) {{\n'
            + "\n".join(lines)
            + "\nreturn 0; }\n",
        )
        binary = self.folder / "layout"
        subprocess.run([COMPILER, "-std=c89", program, "-o", binary], check=True)
        output = subprocess.run(
            [binary], check=True, capture_output=True, text=True
        ).stdout
        expected = []
        for name, struct in _abi.STRUCTS.items():
            expected.append(f"{name} {ctypes.sizeof(struct)}")
            for field, *_ in struct._fields_:
                expected.append(f"{name}.{field} {getattr(struct, field).offset}")
        self.assertEqual(output.split("\n")[:-1], expected)

    def test_no_struct_field_or_function_of_the_header_is_missing(self):
        text = re.sub(r"/\*.*?\*/", "", HEADER.read_text(), flags=re.S)
        structs = re.findall(r"typedef struct (\w+) \{(.*?)\} \1;", text, flags=re.S)
        self.assertEqual({name for name, _ in structs}, set(_abi.STRUCTS))
        for name, body in structs:
            fields = []
            for line in body.split(";"):
                pointer = re.search(r"\(\s*\*\s*(\w+)\s*\)", line)
                fields += (
                    [pointer[1]]
                    if pointer
                    else [
                        re.findall(r"\w+", part.split("[")[0])[-1]
                        for part in line.split(",")
                        if part.strip()
                    ]
                )
            self.assertEqual(fields, [f for f, *_ in _abi.STRUCTS[name]._fields_], name)
        functions = set(re.findall(r"LANCRET_API[^;]*?\b(lancret_\w+)\(", text))
        self.assertEqual(
            functions - set(_abi.FUNCTIONS), {"lancret_groom_expand_chunk"}
        )
        self.assertEqual(set(_abi.FUNCTIONS) - functions, set())

    def test_constants_are_those_of_the_header(self):
        text = HEADER.read_text()
        constants = dict(re.findall(r"LANCRET_(\w+) = (\d+)", text))
        for name, number in (_abi.BASES | _abi.ATTRIBUTES).items():
            self.assertEqual(
                int(constants[name.upper().replace("-", "_")]), number, name
            )
        for name, number in _abi.FIGURES.items():
            self.assertEqual(int(constants[name.upper()]), number, name)
        shapes = ("ANY_SHAPE", "FLAT", "ROUND", "RIBBON")
        self.assertEqual([int(constants[name]) for name in shapes], list(_abi.SHAPES))
        for number, name in _abi.LOG_LEVELS.items():
            self.assertEqual(int(constants[f"LOG_{name.upper()}"]), number)
        self.assertIn(f"#define LANCRET_ABI_VERSION {_abi.ABI_VERSION}\n", text)
