"""Finds the Python package `lancret`: in this folder (the zip), in the environment, or
beside `blender/` (the source tree)."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path
from types import ModuleType

_HERE = Path(__file__).resolve().parent


def lancret() -> ModuleType:
    """The package, imported on the first call. Raises ImportError."""
    loaded = sys.modules.get("lancret")
    if loaded is not None:
        return loaded
    if (_HERE / "lancret" / "__init__.py").is_file():
        return _from(_HERE)
    try:
        return importlib.import_module("lancret")
    except ModuleNotFoundError as fault:
        if fault.name != "lancret":
            raise
    return _from(_HERE.parent.parent)


def _from(folder: Path) -> ModuleType:
    sys.path.insert(0, str(folder))
    try:
        return importlib.import_module("lancret")
    finally:
        sys.path.remove(str(folder))
