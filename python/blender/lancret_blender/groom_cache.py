"""Open grooms, one per object, so that a new frame or density does not load them again."""

from __future__ import annotations

import dataclasses
import hashlib
from pathlib import Path
from typing import Any

import bpy
import numpy as np

from .package import lancret
from .source import Source

_grooms: dict[str, tuple[str, Any]] = {}  # object name -> (key of its source, groom)
_units: dict[tuple[Any, ...], tuple[float, tuple[float, ...]]] = {}
_context: Any = None


def context() -> Any:
    """The lancret.Context that all grooms share, and with it their fitted guides."""
    global _context
    if _context is None:
        _context = lancret().Context()
    return _context


def groom(source: Source, owner: str) -> Any:
    """The lancret.Groom of a source, for the object with this full name. Raises
    lancret.Error."""
    key = _key(source)
    if owner in _grooms and _grooms[owner][0] == key:
        return _grooms[owner][1]
    opened = lancret().open(
        source.path,
        parameters=source.parameters,
        strands=source.strands,
        scalp=source.scalp,
        chunk_strands=source.chunk_strands,
        context=context(),
    )
    existing = {obj.name_full for obj in bpy.data.objects}
    for name in [name for name in _grooms if name == owner or name not in existing]:
        _grooms.pop(name)[1].close()
    _grooms[owner] = key, opened
    return opened


def units(path: str) -> tuple[float, tuple[float, ...]]:
    """The length unit of a file in cm, and its up axis. Raises lancret.Error."""
    key = (path, *_stamp(path))
    if key not in _units:
        one_strand = {"strands.count": 1}
        with lancret().open(path, parameters=one_strand, context=context()) as groom:
            _units[key] = (groom.info.cm_per_unit, groom.info.up)
    return _units[key]


def forget() -> None:
    """Closes all grooms; the context stays open."""
    _units.clear()
    while _grooms:
        _grooms.popitem()[1][1].close()


def close() -> None:
    """Closes all grooms and the context."""
    global _context
    forget()
    if _context is not None:
        _context.close()
        _context = None


def _key(source: Source) -> str:
    digest = hashlib.sha256(repr(_stamp(source.path)).encode())
    _update(digest, source)
    return digest.hexdigest()


def _update(digest: Any, value: Any) -> None:
    """Hashes every field of a dataclass and every number of an array."""
    if dataclasses.is_dataclass(value):
        for field in dataclasses.fields(value):
            digest.update(f"{field.name}=".encode())
            _update(digest, getattr(value, field.name))
    elif isinstance(value, np.ndarray):
        digest.update(f"{value.dtype}{value.shape}".encode())
        digest.update(np.ascontiguousarray(value).data)
    else:
        digest.update(f"{value!r};".encode())


def _stamp(path: str | None) -> tuple[int, ...]:
    """Changes whenever the file is rewritten; empty if there is no file."""
    if path is None or not Path(path).is_file():
        return ()
    status = Path(path).stat()
    return (status.st_mtime_ns, status.st_size)
