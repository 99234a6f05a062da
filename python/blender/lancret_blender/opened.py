"""Grooms that are open, one an object, so that neither a frame nor another density loads
them again."""

from __future__ import annotations

import dataclasses
import hashlib
from pathlib import Path
from typing import TYPE_CHECKING, Any

import bpy
import numpy as np

from .package import lancret

if TYPE_CHECKING:
    from .sources import Source

_grooms: dict[str, tuple[str, Any]] = {}  # by the object's name: what it is of, and it
_units: dict[tuple[Any, ...], tuple[float, tuple[float, ...]]] = {}
_context: Any = None


def context() -> Any:
    """That all grooms share, and with it guides that were fitted once."""
    global _context
    if _context is None:
        _context = lancret().Context()
    return _context


def groom(source: Source, owner: str) -> Any:
    """The lancret.Groom of a source, for the object of this full name. Raises
    lancret.Error."""
    key = _key(source)
    if owner in _grooms and _grooms[owner][0] == key:
        return _grooms[owner][1]
    found = lancret().open(
        source.path,
        parameters=source.parameters,
        strands=source.strands,
        scalp=source.scalp,
        chunk_strands=source.chunk_strands,
        context=context(),
    )
    there = {one.name_full for one in bpy.data.objects}
    for name in [name for name in _grooms if name == owner or name not in there]:
        _grooms.pop(name)[1].close()
    _grooms[owner] = key, found
    return found


def units(path: str) -> tuple[float, tuple[float, ...]]:
    """cm of a file's unit and which way is up in it. Raises lancret.Error."""
    key = (path, *_stamp(path))
    if key not in _units:
        one = {"strands.count": 1}
        with lancret().open(path, parameters=one, context=context()) as groom:
            _units[key] = (groom.info.cm_per_unit, groom.info.up)
    return _units[key]


def forget() -> None:
    _units.clear()
    while _grooms:
        _grooms.popitem()[1][1].close()


def close() -> None:
    global _context
    forget()
    if _context is not None:
        _context.close()
        _context = None


def _key(source: Source) -> str:
    told = hashlib.sha256(repr(_stamp(source.path)).encode())
    _tell(told, source)
    return told.hexdigest()


def _tell(told: Any, value: Any) -> None:
    """Hashes every field of a dataclass, every number of an array."""
    if dataclasses.is_dataclass(value):
        for field in dataclasses.fields(value):
            told.update(f"{field.name}=".encode())
            _tell(told, getattr(value, field.name))
    elif isinstance(value, np.ndarray):
        told.update(f"{value.dtype}{value.shape}".encode())
        told.update(np.ascontiguousarray(value).data)
    else:
        told.update(f"{value!r};".encode())


def _stamp(path: str | None) -> tuple[int, ...]:
    """What changes when a file is written anew."""
    if path is None or not Path(path).is_file():
        return ()
    found = Path(path).stat()
    return (found.st_mtime_ns, found.st_size)
