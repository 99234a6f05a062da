"""Expanded strands as arrays that the library writes to directly."""

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
    """An uninitialised array whose memory is aligned to 16 bytes."""
    size = int(np.prod(shape, dtype=np.int64)) * np.dtype(dtype).itemsize
    memory = np.empty(size + _ALIGNMENT, dtype=np.uint8)
    start = -memory.ctypes.data % _ALIGNMENT
    return memory[start : start + size].view(dtype).reshape(shape)


@dataclasses.dataclass(eq=False)
class Curves:
    """Strands as control points. Arrays that were not requested are None.

    Control points are those of uniform cubic curves. "bspline" and "catmull-rom" curves
    begin and end inside of the outermost points; "bezier" curves share every third point;
    "hermite" points come with derivatives. "linear" points are the corners of polylines.

    The number of points varies per strand, and the strands of a chunk are grouped by it,
    not by id. Order and counts depend on basis and max_error, but not on time.
    """

    basis: Basis
    times: tuple[float, ...]  #: frame numbers; () if none were requested
    counts: Counts  #: [strands] number of points
    positions: Floats  #: [times][points][4]: x y z radius
    tangents: Floats | None = None  #: [times][points][4]; see lancret_procedural.h
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
        """[strands + 1] index of the first point of each strand, then the end."""
        return starts_of(self.counts)

    @property
    def segments(self) -> npt.NDArray[np.int64]:
        """[strands] number of curve segments."""
        return segments_of_curves(self.counts, self.basis)

    def some(self, strands: npt.ArrayLike) -> Curves:
        """Copies of the strands with these indices, in this order."""
        chosen = np.asarray(strands, dtype=np.int64)
        counts = self.counts[chosen]
        ends = starts_of(counts)
        points = np.arange(ends[-1]) + np.repeat(self.first[chosen] - ends[:-1], counts)
        return _part(self, chosen, points)

    def strand(self, index: int, time: int = 0) -> Floats:
        """[points][4] of one strand, a view."""
        first = self.first
        return self.positions[time, first[index] : first[index + 1]]

    def places(
        self, per_segment: int = 4, time: int = 0
    ) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int64]]:
        """Samples the curves at `per_segment` steps in each cubic segment: places
        [places][4], x y z radius, and [strands + 1] the index of each strand's first
        place, then the end. `time` is an index into `times`."""
        values, counts, basis = self.positions[time], self.counts, self.basis
        if basis == "hermite":
            if self.tangents is None:
                raise CallError("hermite curves cannot be sampled without tangents")
            places, sizes = cubic.sample(
                *cubic.hermite_as_bezier(values, self.tangents[time], counts),
                "bezier",
                per_segment,
            )
        else:
            places, sizes = cubic.sample(values, counts, basis, per_segment)
        return places, starts_of(sizes)


def segments_of_curves(counts: Counts, basis: str) -> npt.NDArray[np.int64]:
    """[strands] number of curve segments; hermite curves have as many as polylines."""
    segments = np.zeros(len(counts), dtype=np.int64)
    for count, strands in cubic.groups(counts):
        segments[strands] = cubic.segments_of(
            count, "linear" if basis == "hermite" else basis
        )
    return segments


def attribute_bits(attributes: Collection[Attribute]) -> int:
    bits = 0
    for name in attributes:
        if name not in _abi.ATTRIBUTES:
            raise CallError(f"attribute {name!r}: must be one of {', '.join(ALL)}")
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
    """Curves whose requested arrays are allocated, but not initialised."""
    samples = max(1, len(times))
    requested = set(attributes) | ({"tangents"} if basis == "hermite" else set())

    def array(name: str, *shape: int, dtype: type[np.generic] = np.float32) -> Any:
        return aligned(shape, dtype) if name in requested else None

    return Curves(
        basis=basis,
        times=times,
        counts=np.empty(strands, dtype=np.uint32),
        positions=aligned((samples, points, 4)),
        tangents=array("tangents", samples, points, 4),
        normals=array("normals", samples, points, 4),
        ids=array("ids", strands, dtype=np.uint32),
        root_uv=array("root_uv", strands, 2),
        lengths=array("lengths", strands),
        guides=array("guides", strands, neighbours, dtype=np.uint32),
        weights=array("guides", strands, neighbours),
        arc_lengths=array("arc_lengths", points),
        random=array("random", strands),
    )


def part(whole: Curves, strands: slice, points: slice) -> Curves:
    """Views of a range of strands and of their points."""
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
    """float *const * with a pointer to the rows of each time."""
    if array is None:
        return None
    rows = (POINTER(c_float) * len(array))(
        *(pointer_to(rows_of_time, c_float) for rows_of_time in array)
    )
    return ctypes.cast(rows, _abi.FloatRows)  # keeps `rows` alive


def buffers_of(curves: Curves) -> _abi.Curves:
    """The struct for lancret_chunk_write. `curves` must outlive it."""
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
