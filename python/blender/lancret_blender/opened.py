"""Grooms that are open, so that neither a frame nor another density loads them again."""

from __future__ import annotations

import collections
import hashlib
from pathlib import Path
from typing import Any

import numpy as np

from .package import lancret
from .sources import Source

_MOST = 8  # kept open
_grooms: collections.OrderedDict[str, Any] = collections.OrderedDict()
_context: Any = None


def context() -> Any:
    """That all grooms share, and with it guides that were fitted once."""
    global _context
    if _context is None:
        _context = lancret().Context()
    return _context


def groom(source: Source) -> Any:
    """The lancret.Groom of a source. Raises lancret.Error."""
    key = _key(source)
    if key in _grooms:
        _grooms.move_to_end(key)
        return _grooms[key]
    found = lancret().open(
        source.path,
        parameters=source.parameters,
        strands=source.strands,
        scalp=source.scalp,
        chunk_strands=source.chunk_strands,
        context=context(),
    )
    _grooms[key] = found
    while len(_grooms) > _MOST:
        _grooms.popitem(last=False)[1].close()
    return found


def forget() -> None:
    while _grooms:
        _grooms.popitem()[1].close()


def close() -> None:
    global _context
    forget()
    if _context is not None:
        _context.close()
        _context = None


def _key(source: Source) -> str:
    told = hashlib.sha256()
    arrays = []
    if source.strands is not None:
        arrays += [source.strands.points, source.strands.counts]
    if source.scalp is not None:
        arrays += [source.scalp.positions, source.scalp.corners, source.scalp.uvs]
    stamp = ()
    if source.path is not None:
        path = Path(source.path)
        stamp = (path.stat().st_mtime_ns, path.stat().st_size) if path.is_file() else ()
    told.update(
        repr((source.path, stamp, source.parameters, source.chunk_strands)).encode()
    )
    for array in arrays:
        told.update(repr(None if array is None else array.shape).encode())
        if array is not None:
            told.update(np.ascontiguousarray(array).data)
    return told.hexdigest()
