"""Runs the tests for CTest. Exits with 77 if there is no Python to run them with.

The interpreter is that of build/python (scripts/test-python makes it), else the one that runs this file.
"""

import importlib.util
import os
import sys
import unittest
from pathlib import Path

SKIPPED = 77
PYTHON = Path(__file__).resolve().parents[2] / "build" / "python" / "bin" / "python"


def main() -> int:
    if PYTHON.is_file() and Path(sys.prefix).resolve() != PYTHON.parents[1].resolve():
        os.execv(PYTHON, [str(PYTHON), "-B", __file__])
    if importlib.util.find_spec("numpy") is None:
        print(
            f"skipped: {sys.executable} has no numpy; scripts/test-python installs it"
        )
        return SKIPPED
    root = Path(__file__).resolve().parent.parent
    sys.path.insert(0, str(root))
    os.chdir(root)
    tests = unittest.defaultTestLoader.discover("tests", "test*.py", root)
    result = unittest.TextTestRunner().run(tests)
    for reason in sorted({reason for _, reason in result.skipped}):
        print(f"skipped: {reason}")
    return 0 if result.wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
