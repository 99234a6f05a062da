"""Converts Lancret's curves to Blender's: axes, ends, velocities. Does not need bpy."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float32]

# Cycles draws Catmull-Rom curves.
BASIS = "catmull-rom"

# up axis -> for each of Blender's axes: the groom's axis and its sign. These are quarter
# turns, which round nothing.
_AXES = {
    "X": ((2, -1), (1, 1), (0, 1)),
    "Y": ((0, 1), (2, -1), (1, 1)),
    "Z": ((0, 1), (1, 1), (2, 1)),
}


def up_axis(up: Sequence[float]) -> str:
    return "XYZ"[int(np.argmax(np.abs(up)))]


def to_blender(points: Any, up: str) -> Floats:
    """[..., 3] from a groom's axes to Blender's, where z is up."""
    turned = np.empty((*points.shape[:-1], 3), dtype=np.float32)
    for axis, (place, sign) in enumerate(_AXES[up]):
        turned[..., axis] = points[..., place] if sign > 0 else -points[..., place]
    return turned


def from_blender(points: Any, up: str) -> Floats:
    """The inverse of `to_blender`."""
    turned = np.empty((*points.shape[:-1], 3), dtype=np.float32)
    for axis, (place, sign) in enumerate(_AXES[up]):
        turned[..., place] = points[..., axis] if sign > 0 else -points[..., axis]
    return turned


@dataclasses.dataclass(eq=False)
class Strands:
    points: Floats  #: [points][3], in Blender's units and axes
    radii: Floats  #: [points]
    last: npt.NDArray[np.int64]  #: [strands], index of the last point of each
    velocities: Floats | None  #: [points][3], units per second
    end_error: float  #: bound of Cycles' error at the ends of strands, units

    def __len__(self) -> int:
        return len(self.last)


def drawn(curves: Any, up: str, times: tuple[float, ...], fps: float) -> Strands:
    """Converts lancret.Curves in BASIS. Of three `times`, in frames, the middle one is
    drawn and the velocities are the mean from the first to the last."""
    counts = curves.counts.astype(np.int64)
    ends = np.cumsum(counts) - 1
    starts = ends - counts + 1
    # The first and last control points only set end tangents; Cycles would draw to them.
    kept = np.ones(curves.positions.shape[1], dtype=bool)
    kept[starts] = kept[ends] = False
    middle = len(curves.positions) // 2
    values = curves.positions[middle]
    inner = values[kept]
    velocities = None
    if len(times) == 3 and times[2] > times[0]:
        moved = curves.positions[2] - curves.positions[0]
        rate = np.float32(fps / (times[2] - times[0]))
        velocities = to_blender(moved[kept, :3] * rate, up)
    return Strands(
        points=to_blender(inner[:, :3], up),
        radii=np.ascontiguousarray(inner[:, 3]),
        last=np.cumsum(counts - 2) - 1,
        velocities=velocities,
        end_error=max(
            _end_error(values, starts, starts + 1, starts + 2),
            _end_error(values, ends, ends - 1, ends - 2),
        ),
    )


def _end_error(values: Any, outer: Any, end: Any, inner: Any) -> float:
    """Bound of the sideways error of the first or last segments in Cycles. Cycles
    duplicates the end point in place of the outer point; this changes the derivative at
    the end by half of (outer - end), and the curve by at most 4/27 of that."""
    if not len(end):
        return 0.0
    off = values[outer, :3].astype(np.float64) - values[end, :3]
    along = values[inner, :3].astype(np.float64) - values[end, :3]
    length = np.maximum(np.linalg.norm(along, axis=1), 1e-30)
    across = np.linalg.norm(np.cross(off, along), axis=1) / length
    return float(across.max() * 2 / 27)
