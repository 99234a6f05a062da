import os
import subprocess
import sys
import unittest
import zipfile
from pathlib import Path

from support import InBlender

HERE = Path(__file__).resolve().parent
LOAD = """
import importlib.util, sys
spec = importlib.util.spec_from_file_location("package", sys.argv[1])
package = importlib.util.module_from_spec(spec)
spec.loader.exec_module(package)
found = package.lancret()
print(found.__file__)
print(found.version())
"""


class Zip(InBlender):
    def test_contains_the_add_on_the_package_and_the_library(self):
        library = os.environ.get("LANCRET_LIBRARY")
        if not library:
            raise unittest.SkipTest("LANCRET_LIBRARY does not name the library")
        made = self.folder / "made.zip"
        subprocess.run(
            [sys.executable, HERE.parent / "build_zip.py", library, made], check=True
        )
        with zipfile.ZipFile(made) as archive:
            archive.extractall(self.folder / "addons")
        addon = self.folder / "addons" / "lancret_blender"
        for name in ("__init__.py", "blender_manifest.toml", "lancret/groom.py"):
            self.assertTrue((addon / name).is_file(), name)
        clean = {k: v for k, v in os.environ.items() if k != "LANCRET_LIBRARY"}
        clean.pop("PYTHONPATH", None)
        result = subprocess.run(
            [sys.executable, "-B", "-c", LOAD, addon / "package.py"],
            env=clean,
            cwd=self.folder,
            capture_output=True,
            text=True,
        )
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout.split()[0], str(addon / "lancret" / "__init__.py"))
