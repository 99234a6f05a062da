"""Uniform curves of every basis: number of curve segments, sampling, conversion."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt

from .errors import InputError

Array = npt.NDArray[np.floating]

#: Rows: powers 1, t, t^2, t^3. Columns: the four control points of a segment.
MATRICES: dict[str, npt.NDArray[np.float64]] = {
    "bspline": np.array([[1, 4, 1, 0], [-3, 0, 3, 0], [3, -6, 3, 0], [-1, 3, -3, 1]])
    / 6,
    "catmull-rom": np.array(
        [[0, 2, 0, 0], [-1, 0, 1, 0], [2, -5, 4, -1], [-1, 3, -3, 1]]
    )
    / 2,
    "bezier": np.array([[1.0, 0, 0, 0], [-3, 3, 0, 0], [3, -6, 3, 0], [-1, 3, -3, 1]]),
}
#: Number of control points from one segment to the next.
STEPS = {"bspline": 1, "catmull-rom": 1, "bezier": 3, "linear": 1}


def segments_of(count: int, basis: str) -> int:
    """Number of segments of a curve of `count` control points. Raises InputError if a
    curve of the basis cannot have that many."""
    if basis == "linear":
        segments = count - 1
    elif count < 4 or (count - 4) % STEPS[basis]:
        segments = 0
    else:
        segments = (count - 4) // STEPS[basis] + 1
    if segments < 1:
        raise InputError(
            f"a {basis} curve cannot have {count} points; it needs "
            + {"linear": "2 or more", "bezier": "4, 7, 10, ..."}.get(basis, "4 or more")
        )
    return segments


def groups(
    counts: npt.NDArray[np.integer],
) -> Iterator[tuple[int, npt.NDArray[np.integer]]]:
    """Yields each distinct number of points and the strands that have it."""
    for count in np.unique(counts):
        yield int(count), np.flatnonzero(counts == count)


def sample(
    points: Array, counts: npt.NDArray[np.integer], basis: str, per_segment: int
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.uint32]]:
    """Samples curves at `per_segment` equal steps of the parameter in each segment, ends
    included: places [sum of counts][k] and counts [strands]. Returns polylines as they
    are."""
    points, starts = np.asarray(points, dtype=np.float64), _starts(counts)
    steps = 1 if basis == "linear" else per_segment
    segments = np.zeros(len(counts), dtype=np.int64)
    for count, strands in groups(counts):
        segments[strands] = segments_of(count, basis)
    sizes = segments * steps + 1
    out = np.empty((int(sizes.sum()), points.shape[1]))
    out_starts = _starts(sizes)
    for count, strands in groups(counts):
        rows = points[starts[strands][:, None] + np.arange(count)]
        places = rows if basis == "linear" else _cubic_places(rows, basis, steps)
        out[out_starts[strands][:, None] + np.arange(places.shape[1])] = places
    return out, sizes.astype(np.uint32)


def _starts(counts: npt.NDArray[np.integer]) -> npt.NDArray[np.int64]:
    sizes = np.asarray(counts, dtype=np.int64)
    return np.cumsum(sizes) - sizes


def _cubic_places(rows: Array, basis: str, steps: int) -> npt.NDArray[np.float64]:
    """[strands][control points][k] to [strands][segments * steps + 1][k]."""
    strands, count, width = rows.shape
    segments = segments_of(count, basis)
    of_segment = STEPS[basis] * np.arange(segments)[:, None] + np.arange(4)
    t = np.arange(steps) / steps
    weights = t[:, None] ** np.arange(4) @ MATRICES[basis]  # [steps][4]
    places = np.einsum("tc,spck->sptk", weights, rows[:, of_segment])
    last = np.einsum("c,sck->sk", MATRICES[basis].sum(axis=0), rows[:, of_segment[-1]])
    return np.concatenate(
        [places.reshape(strands, segments * steps, width), last[:, None]], axis=1
    )


def hermite_as_bezier(
    points: Array, tangents: Array, counts: npt.NDArray[np.integer]
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.uint32]]:
    """Converts Hermite points and derivatives to Bezier control points."""
    points, thirds = (
        np.asarray(points, np.float64),
        np.asarray(tangents, np.float64) / 3,
    )
    three = np.stack([points - thirds, points, points + thirds], axis=1)
    inside = np.ones((len(points), 3), dtype=bool)
    starts = _starts(counts)
    inside[starts, 0] = False
    inside[starts + np.asarray(counts, np.int64) - 1, 2] = False
    return three[inside], (3 * np.asarray(counts, np.int64) - 2).astype(np.uint32)


def with_phantoms(
    values: Array, counts: npt.NDArray[np.integer]
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.uint32]]:
    """Adds a point 2 p0 - p1 to either end of each curve, so that a B-spline or
    Catmull-Rom curve begins and ends at its original end points (USD's `pinned`)."""
    values = np.asarray(values, dtype=np.float64)
    starts, sizes = _starts(counts), np.asarray(counts, np.int64) + 2
    ends = starts + np.asarray(counts, np.int64) - 1
    out = np.empty((int(sizes.sum()), *values.shape[1:]))
    out_starts = _starts(sizes)
    out_ends = out_starts + sizes - 1
    inside = np.ones(len(out), dtype=bool)
    inside[out_starts] = inside[out_ends] = False
    out[inside] = values
    out[out_starts] = 2 * values[starts] - values[starts + 1]
    out[out_ends] = 2 * values[ends] - values[ends - 1]
    return out, sizes.astype(np.uint32)
