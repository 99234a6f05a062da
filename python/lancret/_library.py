"""Finds and loads liblancret_procedural.so, once, on the first call."""

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
    """Paths to try, in order: only $LANCRET_LIBRARY if it is set; else beside this
    package, in the build folders of the source tree, and in the system's search path."""
    path = os.environ.get("LANCRET_LIBRARY")
    if path:
        return [path]
    package = Path(__file__).resolve().parent
    build = package.parent.parent / "build"
    files = [package / NAME]
    files += [build / preset / NAME for preset in ("release", "ci")]
    return [str(file) for file in files if file.is_file()] + [
        f"{NAME}.{_abi.ABI_VERSION}",
        NAME,
    ]


def _missing(place: str, name: str) -> Callable[..., NoReturn]:
    """Replaces a function that the library lacks; raises when it is called."""

    def refuse(*_arguments: object) -> NoReturn:
        raise LibraryNotFound(
            f"{place}: has no function {name}; is it an older version?"
        )

    return refuse


@functools.cache
def library() -> ctypes.CDLL:
    """The library with its functions declared. Raises LibraryNotFound."""
    faults = []
    for place in candidates():
        try:
            loaded = ctypes.CDLL(place)
            break
        except OSError as fault:
            faults.append(f"{place}: {fault}")
    else:
        raise LibraryNotFound(
            f"{NAME} not found; build Lancret, or set LANCRET_LIBRARY to its path. Tried:\n  "
            + "\n  ".join(faults)
        )
    for name, (result, arguments) in _abi.FUNCTIONS.items():
        try:
            function = getattr(loaded, name)
        except AttributeError:
            setattr(loaded, name, _missing(place, name))
            continue
        function.restype, function.argtypes = result, arguments
    version = loaded.lancret_abi_version()
    if version != _abi.ABI_VERSION:
        raise LibraryNotFound(
            f"{place}: has ABI version {version}; this package needs {_abi.ABI_VERSION}"
        )
    return loaded


def version() -> str:
    """The library's version, such as "0.1.0"."""
    text: bytes = library().lancret_version()
    return text.decode()
