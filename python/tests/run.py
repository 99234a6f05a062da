"""Runs the tests as CTest does; 77 says that there is nothing to run them with.

--with-usd: those of USD and the slow ones, with the Python that $LANCRET_USD_PYTHON names (scripts/usd-python makes one).
"""

import importlib.util
import os
import sys
import unittest
from pathlib import Path

SKIPPED = 77


def main() -> int:
    with_usd = "--with-usd" in sys.argv
    python = os.environ.pop("LANCRET_USD_PYTHON", "")
    if with_usd and python:
        os.execv(python, [python, __file__, "--with-usd"])
    needed = ["numpy", "pxr"] if with_usd else ["numpy"]
    missing = [name for name in needed if importlib.util.find_spec(name) is None]
    if missing:
        print(f"skipped: {sys.executable} has no {' and no '.join(missing)}")
        return SKIPPED
    root = Path(__file__).resolve().parent.parent
    sys.path.insert(0, str(root))
    os.chdir(root)
    tests = unittest.TestSuite(
        unittest.defaultTestLoader.discover("tests", pattern, root)
        for pattern in (["test_usd*.py", "slow_*.py"] if with_usd else ["test*.py"])
    )
    result = unittest.TextTestRunner().run(tests)
    for reason in sorted({reason for _, reason in result.skipped}):
        print(f"skipped: {reason}")
    return 0 if result.wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
