"""Runs the tests inside Blender:

    blender -b --factory-startup --python-exit-code 1 --python run.py -- [names of tests]

or in a Python with the module `bpy` (scripts/bpy-python):

    python run.py [-- names of tests]
"""

import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]
sys.dont_write_bytecode = True
arguments = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
if arguments:
    suite = unittest.defaultTestLoader.loadTestsFromNames(arguments)
else:
    suite = unittest.defaultTestLoader.discover(str(HERE))
result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(suite)
sys.stdout.flush()
if not result.wasSuccessful() or not result.testsRun:
    raise SystemExit(1)
