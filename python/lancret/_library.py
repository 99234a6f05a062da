"""Finds and loads liblancret_procedural.so, once, when something is first asked of it."""

from __future__ import annotations

import ctypes
import functools
import os
from collections.abc import Callable
from pathlib import Path
from typing import NoReturn

from . import _abi
from .errors import LibraryNotFound

NAME = "liblancret_procedural.so"


def candidates() -> list[str]:
    """Where the library may be, best first: $LANCRET_LIBRARY alone where it is said; else
    beside this package, in the tree's build folders, and where the system looks."""
    said = os.environ.get("LANCRET_LIBRARY")
    if said:
        return [said]
    package = Path(__file__).resolve().parent
    build = package.parent.parent / "build"
    files = [package / NAME]
    files += [build / preset / NAME for preset in ("release", "ci")]
    return [str(file) for file in files if file.is_file()] + [f"{NAME}.1", NAME]


def _missing(place: str, name: str) -> Callable[..., NoReturn]:
    """Stands in for a function that an older library has not, until it is called."""

    def refuse(*_arguments: object) -> NoReturn:
        raise LibraryNotFound(f"{place}: has no {name}: an older version?")

    return refuse


@functools.cache
def library() -> ctypes.CDLL:
    """The library, its functions declared. Raises LibraryNotFound."""
    faults = []
    for place in candidates():
        try:
            found = ctypes.CDLL(place)
            break
        except OSError as fault:
            faults.append(f"{place}: {fault}")
    else:
        raise LibraryNotFound(
            f"no {NAME}; build Lancret, or say where it is by LANCRET_LIBRARY. Tried:\n  "
            + "\n  ".join(faults)
        )
    for name, (result, arguments) in _abi.FUNCTIONS.items():
        try:
            function = getattr(found, name)
        except AttributeError:
            setattr(found, name, _missing(place, name))
            continue
        function.restype, function.argtypes = result, arguments
    version = found.lancret_abi_version()
    if version != _abi.ABI_VERSION:
        raise LibraryNotFound(
            f"{place}: is of ABI version {version}; this package needs {_abi.ABI_VERSION}"
        )
    return found


def version() -> str:
    """The library's version, such as "0.1.0"."""
    said: bytes = library().lancret_version()
    return said.decode()
