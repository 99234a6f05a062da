"""Helpers of several tests. Run the tests from python/: python3 -m unittest discover -s tests -t ."""

from __future__ import annotations

import importlib.util
import os
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DATA = ROOT.parent / "shared" / "data"  # real grooms, if present

HAS_USD = importlib.util.find_spec("pxr") is not None
HAS_PLOTS = importlib.util.find_spec("matplotlib") is not None
needs_usd = unittest.skipUnless(HAS_USD, "usd-core is not installed")
needs_plots = unittest.skipUnless(HAS_PLOTS, "matplotlib is not installed")
needs_data = unittest.skipUnless(DATA.is_dir(), f"{DATA} does not exist")

#: A head of 40 guides and 300 children, quick to open.
SMALL = """
[guides]
segments = 6
[guides.made]
strands = 40
[strands]
count = 300
"""


def command() -> str | None:
    """The command-line program to compare with; None if it is not built."""
    path = os.environ.get("LANCRET_COMMAND")
    places = [Path(path)] if path else []
    places += [
        ROOT / "build" / preset / "tools" / "lancret" for preset in ("release", "ci")
    ]
    return next((str(place) for place in places if place.is_file()), None)


class WithFolder(unittest.TestCase):
    """A test with a temporary folder."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory(prefix="lancret-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def file(self, name: str, text: str) -> Path:
        path = self.folder / name
        path.write_text(text)
        return path
