"""Chunks that are bound, by their C handles."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from ctypes import byref, c_float, c_uint, c_void_p

import numpy as np

from . import _abi
from ._library import library
from ._options import chunk_index
from ._source import pointer_to
from .context import Context
from .curves import pieces_of_curves
from .errors import CallError
from .figures import ChunkInfo
from .geometry import Counts, Floats

#: Values a strand, where they are not one: at each end of its segments, or in each.
_MORE = {"orthogonality": 1, "curvature": 0, "torsion": 0}


@contextlib.contextmanager
def bound(
    context: Context, groom: int, number: int, asked: _abi.Options
) -> Iterator[int]:
    """A chunk's handle, closed at the end."""
    pointer = c_void_p()
    status = library().lancret_chunk_open(
        groom, chunk_index(number), byref(asked), byref(pointer)
    )
    try:
        context.raise_for(status)
        yield pointer.value or 0
    finally:
        if pointer.value:
            library().lancret_chunk_close(pointer.value)


def sizes_of(context: Context, chunk: int) -> _abi.Curves:
    sizes = _abi.Curves()
    context.raise_for(library().lancret_chunk_get_sizes(chunk, byref(sizes)))
    return sizes


def counts_of(context: Context, chunk: int, sizes: _abi.Curves) -> Counts:
    """[strands] points of each, and nothing else of the chunk."""
    counts = np.empty(sizes.strands, dtype=np.uint32)
    sizes.counts = pointer_to(counts, c_uint)
    context.raise_for(library().lancret_chunk_write(chunk, byref(sizes)))
    return counts


def figures_of(context: Context, chunk: int, figure: str) -> Floats:
    """A figure of the chunk's strands at the first of its times."""
    if figure not in _abi.FIGURES:
        raise CallError(f"figure {figure!r}: is none of {', '.join(_abi.FIGURES)}")
    sizes = sizes_of(context, chunk)
    room = int(sizes.strands)
    if figure in _MORE:
        counts = counts_of(context, chunk, sizes)
        pieces = pieces_of_curves(counts, _abi.BASIS_NAMES[sizes.basis])
        room = int((pieces + _MORE[figure]).sum())
    values = np.empty(room, dtype=np.float32)
    context.raise_for(
        library().lancret_chunk_get_figures(
            chunk, _abi.FIGURES[figure], 0, pointer_to(values, c_float)
        )
    )
    return values


def info_of(context: Context, chunk: int) -> ChunkInfo:
    struct = _abi.ChunkInfo()
    context.raise_for(library().lancret_chunk_get_info(chunk, byref(struct)))
    return ChunkInfo(
        **{name: getattr(struct, name) for name, *_ in _abi.ChunkInfo._fields_[1:]}
    )
