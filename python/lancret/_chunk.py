"""Queries of an open chunk, by its C handle."""

from __future__ import annotations

import contextlib
import dataclasses
from collections.abc import Iterator
from ctypes import byref, c_float, c_uint, c_void_p

import numpy as np

from . import _abi
from ._library import library
from ._options import chunk_index
from ._source import pointer_to
from .context import Context
from .curves import segments_of_curves
from .errors import CallError
from .figures import ChunkInfo
from .geometry import Counts, Floats

#: Values per strand, less its number of curve segments, of figures that have more than
#: one value per strand: one per end of a segment, or one per segment.
_EXTRA_VALUES = {"orthogonality": 1, "curvature": 0, "torsion": 0}


@contextlib.contextmanager
def opened(
    context: Context, groom: int, number: int, options: _abi.Options
) -> Iterator[int]:
    """A chunk's handle; leaving the context closes it."""
    pointer = c_void_p()
    status = library().lancret_chunk_open(
        groom, chunk_index(number), byref(options), byref(pointer)
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
    """[strands] number of points of each; writes no other array."""
    counts = np.empty(sizes.strands, dtype=np.uint32)
    sizes.counts = pointer_to(counts, c_uint)
    context.raise_for(library().lancret_chunk_write(chunk, byref(sizes)))
    return counts


def figures_of(context: Context, chunk: int, figure: str) -> Floats:
    """A figure of the chunk's strands at the chunk's first time."""
    if figure not in _abi.FIGURES:
        raise CallError(f"figure {figure!r}: must be one of {', '.join(_abi.FIGURES)}")
    sizes = sizes_of(context, chunk)
    size = int(sizes.strands)
    if figure in _EXTRA_VALUES:
        counts = counts_of(context, chunk, sizes)
        segments = segments_of_curves(counts, _abi.BASIS_NAMES[sizes.basis])
        size = int((segments + _EXTRA_VALUES[figure]).sum())
    values = np.empty(size, dtype=np.float32)
    context.raise_for(
        library().lancret_chunk_get_figures(
            chunk, _abi.FIGURES[figure], 0, pointer_to(values, c_float)
        )
    )
    return values


def info_of(context: Context, chunk: int) -> ChunkInfo:
    struct = _abi.ChunkInfo()
    context.raise_for(library().lancret_chunk_get_info(chunk, byref(struct)))
    names = [field.name for field in dataclasses.fields(ChunkInfo)]
    return ChunkInfo(**{name: getattr(struct, name) for name in names})
