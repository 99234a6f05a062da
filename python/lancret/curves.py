"""What a chunk becomes: arrays that the library writes to without a copy between."""

from __future__ import annotations

import ctypes
import dataclasses
import functools
from collections.abc import Collection
from ctypes import POINTER, c_float, c_uint
from typing import Any, Literal, get_args

import numpy as np
import numpy.typing as npt

from . import _abi, cubic
from ._source import pointer_to
from .errors import CallError
from .geometry import Counts, Floats, starts_of

Basis = Literal["linear", "bspline", "catmull-rom", "bezier", "hermite"]
Attribute = Literal[
    "tangents",
    "normals",
    "ids",
    "root_uv",
    "lengths",
    "guides",
    "arc_lengths",
    "random",
]
#: Every attribute, for `expand(attributes=lancret.ALL)`.
ALL: tuple[Attribute, ...] = get_args(Attribute)
IDS: tuple[Attribute, ...] = ("ids",)

_ALIGNMENT = 16


def aligned(shape: tuple[int, ...], dtype: type[np.generic] = np.float32) -> Any:
    """An array, not set, whose memory begins at a multiple of 16 bytes."""
    wanted = int(np.prod(shape, dtype=np.int64)) * np.dtype(dtype).itemsize
    memory = np.empty(wanted + _ALIGNMENT, dtype=np.uint8)
    start = -memory.ctypes.data % _ALIGNMENT
    return memory[start : start + wanted].view(dtype).reshape(shape)


@dataclasses.dataclass(eq=False)
class Curves:
    """Strands as control points; an array that was not asked for is None.

    Control points are those of uniform cubic curves that begin and end inside of theirs
    ("bspline", "catmull-rom": without the outermost), or in pieces of three ("bezier"),
    or points with derivatives ("hermite"), or the corners of a polyline ("linear").

    Strands have as many points as they need, and stand by that in their chunk, not by
    their ids: their order and counts may be others for another basis or max_error, and
    are the same at all times.
    """

    basis: Basis
    times: tuple[float, ...]  #: frames; () where none was asked for
    counts: Counts  #: [strands] points of each
    positions: Floats  #: [times][points][4]: x y z radius
    tangents: Floats | None = None  #: [times][points][4]; see the header
    normals: Floats | None = None  #: [times][points][4]
    ids: Counts | None = None  #: [strands]
    root_uv: Floats | None = None  #: [strands][2]
    lengths: Floats | None = None  #: [strands]
    guides: Counts | None = None  #: [strands][neighbours]
    weights: Floats | None = None  #: [strands][neighbours]
    arc_lengths: Floats | None = None  #: [points]
    random: Floats | None = None  #: [strands], [0, 1)

    def __len__(self) -> int:
        return len(self.counts)

    @property
    def points(self) -> Floats:
        """[points][3] at the first time, a view."""
        return self.positions[0, :, :3]

    @property
    def radii(self) -> Floats:
        """[points] at the first time, a view."""
        return self.positions[0, :, 3]

    @functools.cached_property
    def first(self) -> npt.NDArray[np.int64]:
        """[strands + 1] first point of each strand, then the end."""
        return starts_of(self.counts)

    @property
    def pieces(self) -> npt.NDArray[np.int64]:
        """[strands] curve segments of each."""
        return pieces_of_curves(self.counts, self.basis)

    def some(self, strands: npt.ArrayLike) -> Curves:
        """Copies of some strands, by their numbers here, in that order."""
        chosen = np.asarray(strands, dtype=np.int64)
        counts = self.counts[chosen]
        ends = starts_of(counts)
        points = np.arange(ends[-1]) + np.repeat(self.first[chosen] - ends[:-1], counts)
        return _part(self, chosen, points)

    def strand(self, index: int, time: int = 0) -> Floats:
        """[points of it][4] of one strand, a view."""
        first = self.first
        return self.positions[time, first[index] : first[index + 1]]

    def places(
        self, a_piece: int = 4, time: int = 0
    ) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int64]]:
        """Places on the curves: [places][4], x y z radius, `a_piece` steps each piece of
        a cubic; and the first of each strand, then the end."""
        values, counts, basis = self.positions[time], self.counts, self.basis
        if basis == "hermite":
            if self.tangents is None:
                raise CallError("hermite curves without tangents have no places")
            places, made = cubic.sample(
                *cubic.hermite_as_bezier(values, self.tangents[time], counts),
                "bezier",
                a_piece,
            )
        else:
            places, made = cubic.sample(values, counts, basis, a_piece)
        return places, starts_of(made)


def pieces_of_curves(counts: Counts, basis: str) -> npt.NDArray[np.int64]:
    """[strands] curve segments of each; hermite curves have as many as polylines."""
    pieces = np.zeros(len(counts), dtype=np.int64)
    for count, strands in cubic.groups(counts):
        pieces[strands] = cubic.pieces_of(
            count, "linear" if basis == "hermite" else basis
        )
    return pieces


def attribute_bits(attributes: Collection[Attribute]) -> int:
    bits = 0
    for name in attributes:
        if name not in _abi.ATTRIBUTES:
            raise CallError(f"attribute {name!r}: is none of {', '.join(ALL)}")
        bits |= _abi.ATTRIBUTES[name]
    return bits


def empty_curves(
    basis: Basis,
    times: tuple[float, ...],
    attributes: Collection[Attribute],
    *,
    strands: int,
    points: int,
    neighbours: int,
) -> Curves:
    """Room for what was asked for, not set."""
    samples = max(1, len(times))
    wanted = set(attributes) | ({"tangents"} if basis == "hermite" else set())

    def room(name: str, *shape: int, dtype: type[np.generic] = np.float32) -> Any:
        return aligned(shape, dtype) if name in wanted else None

    return Curves(
        basis=basis,
        times=times,
        counts=np.empty(strands, dtype=np.uint32),
        positions=aligned((samples, points, 4)),
        tangents=room("tangents", samples, points, 4),
        normals=room("normals", samples, points, 4),
        ids=room("ids", strands, dtype=np.uint32),
        root_uv=room("root_uv", strands, 2),
        lengths=room("lengths", strands),
        guides=room("guides", strands, neighbours, dtype=np.uint32),
        weights=room("guides", strands, neighbours),
        arc_lengths=room("arc_lengths", points),
        random=room("random", strands),
    )


def part(whole: Curves, strands: slice, points: slice) -> Curves:
    """Views of some strands and of their points."""
    return _part(whole, strands, points)


def _part(whole: Curves, strands: Any, points: Any) -> Curves:
    def of(array: Any, rows: Any) -> Any:
        return None if array is None else array[rows]

    def of_times(array: Any) -> Any:
        return None if array is None else array[:, points]

    return Curves(
        basis=whole.basis,
        times=whole.times,
        counts=whole.counts[strands],
        positions=whole.positions[:, points],
        tangents=of_times(whole.tangents),
        normals=of_times(whole.normals),
        ids=of(whole.ids, strands),
        root_uv=of(whole.root_uv, strands),
        lengths=of(whole.lengths, strands),
        guides=of(whole.guides, strands),
        weights=of(whole.weights, strands),
        arc_lengths=of(whole.arc_lengths, points),
        random=of(whole.random, strands),
    )


def _time_pointers(array: Floats | None) -> Any:
    """float *const * to each time's rows, which lie together."""
    if array is None:
        return None
    rows = (POINTER(c_float) * len(array))(
        *(pointer_to(rows_of_time, c_float) for rows_of_time in array)
    )
    return ctypes.cast(rows, _abi.FloatRows)  # keeps `rows`


def buffers_of(curves: Curves) -> _abi.Curves:
    """The struct that lancret_chunk_write writes through. `curves` must outlive it."""
    return _abi.Curves(
        basis=_abi.BASES[curves.basis],
        strands=len(curves.counts),
        points=curves.positions.shape[1],
        times=len(curves.positions),
        neighbours=0 if curves.guides is None else curves.guides.shape[1],
        counts=pointer_to(curves.counts, c_uint),
        positions=_time_pointers(curves.positions),
        tangents=_time_pointers(curves.tangents),
        normals=_time_pointers(curves.normals),
        ids=pointer_to(curves.ids, c_uint),
        root_uv=pointer_to(curves.root_uv, c_float),
        lengths=pointer_to(curves.lengths, c_float),
        guides=pointer_to(curves.guides, c_uint),
        weights=pointer_to(curves.weights, c_float),
        arc_lengths=pointer_to(curves.arc_lengths, c_float),
        random=pointer_to(curves.random, c_float),
    )
