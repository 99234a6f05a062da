"""Copies the shared library, if it has been built, beside the package; the rest is in
pyproject.toml. Without a copy the package looks for the library when it is first used."""

import os
import shutil
from pathlib import Path

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

NAME = "liblancret_procedural.so"


def built_library() -> Path | None:
    """$LANCRET_LIBRARY, or the library in the build folders; None if there is none."""
    root = Path(__file__).resolve().parent.parent
    path = os.environ.get("LANCRET_LIBRARY")
    places = [Path(path)] if path else []
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
    def has_ext_modules(self) -> bool:  # so that the wheel is for this platform
        return built_library() is not None


setup(cmdclass={"build_py": BuildWithLibrary}, distclass=WithLibrary)
