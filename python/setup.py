"""Puts the shared library beside the package where it has been built; pyproject.toml has
the rest. Without it the package looks for one when it is imported."""

import os
import shutil
from pathlib import Path

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

NAME = "liblancret_procedural.so"


def built_library() -> Path | None:
    """$LANCRET_LIBRARY, or what CMake left in the tree; none where nothing was built."""
    root = Path(__file__).resolve().parent.parent
    said = os.environ.get("LANCRET_LIBRARY")
    places = [Path(said)] if said else []
    places += [root / "build" / preset / NAME for preset in ("release", "ci")]
    return next((place for place in places if place.is_file()), None)


class BuildWithLibrary(build_py):
    def run(self) -> None:
        super().run()
        library = built_library()
        if library and not self.editable_mode:
            folder = Path(self.build_lib) / "lancret"
            folder.mkdir(parents=True, exist_ok=True)
            shutil.copy2(library, folder / NAME)


class WithLibrary(Distribution):
    def has_ext_modules(self) -> bool:  # the wheel is of this machine's kind
        return built_library() is not None


setup(cmdclass={"build_py": BuildWithLibrary}, distclass=WithLibrary)
