"""Strands and meshes in memory, as input of a groom."""

from __future__ import annotations

import dataclasses
import functools
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from .errors import InputError

Floats = npt.NDArray[np.float32]
Doubles = npt.NDArray[np.float64]
Counts = npt.NDArray[np.uint32]
AnyNumbers = npt.NDArray[Any]
StrandBasis = Literal["linear", "bspline", "catmull-rom"]


def _rows(values: npt.ArrayLike, width: int, what: str) -> Floats:
    """`values` as C-ordered float32 [n][width], without a copy if possible."""
    array = np.ascontiguousarray(values, dtype=np.float32)
    if array.ndim != 2 or array.shape[1] != width:
        raise InputError(f"{what}: shape is {array.shape}, must be (n, {width})")
    return array


def starts_of(counts: npt.ArrayLike) -> npt.NDArray[np.int64]:
    """[strands + 1] index of the first point of each strand, then the end."""
    return np.concatenate([[0], np.cumsum(counts, dtype=np.int64)])


#: Sets a field of a frozen dataclass, in its __post_init__.
_set = object.__setattr__


def _whole(values: npt.ArrayLike, what: str) -> Counts:
    array = np.asarray(values)
    if array.size and not np.issubdtype(array.dtype, np.integer):
        raise InputError(f"{what}: must be whole numbers")
    if array.size and (array.min() < 0 or array.max() >= 2**32):
        raise InputError(f"{what}: must be from 0 to 2^32 - 1")
    return np.ascontiguousarray(array, dtype=np.uint32)


@dataclasses.dataclass(eq=False, frozen=True)
class Strands:
    """Hairs as points, root first. Arrays are validated and converted; float32 points and
    uint32 counts are used without a copy. Fields cannot be assigned: use
    `dataclasses.replace`."""

    points: AnyNumbers  #: [sum of counts][3], in units of `metres_per_unit`
    counts: AnyNumbers  #: [strands] number of points, >= 2; >= 4 for B-splines
    basis: StrandBasis = "catmull-rom"
    widths: AnyNumbers | None = None  #: [points] diameters, in the same units
    root_uv: AnyNumbers | None = None  #: [strands][2]
    ids: AnyNumbers | None = None  #: [strands]
    metres_per_unit: float | None = None  #: None: the groom's unit
    up: Literal["X", "Y", "Z"] | None = None  #: None: the groom's axis

    def __post_init__(self) -> None:
        _set(self, "points", _rows(self.points, 3, "points"))
        _set(self, "counts", _whole(self.counts, "counts"))
        if self.counts.ndim != 1:
            raise InputError("counts: must be a list of whole numbers")
        total = int(self.counts.sum(dtype=np.uint64))
        if total != len(self.points):
            raise InputError(
                f"counts: sum is {total}, but there are {len(self.points)} points"
            )
        minimum = 4 if self.basis == "bspline" else 2
        if len(self.counts) and self.counts.min() < minimum:
            raise InputError(
                f"counts: a strand has {self.counts.min()} points; a {self.basis} strand "
                f"needs {minimum} or more"
            )
        if self.widths is not None:
            _set(self, "widths", np.ascontiguousarray(self.widths, dtype=np.float32))
            if self.widths.shape != (len(self.points),):
                raise InputError("widths: must have one value per point")

    def __len__(self) -> int:
        return len(self.counts)

    @functools.cached_property
    def first(self) -> npt.NDArray[np.int64]:
        """[strands + 1] index of the first point of each strand, then the end."""
        return starts_of(self.counts)

    def strand(self, index: int) -> AnyNumbers:
        """[points][3] of one strand, a view."""
        first = self.first
        return self.points[first[index] : first[index + 1]]

    def taper(self) -> tuple[float, float] | None:
        """Median diameters at roots and at tips, in the strands' unit; None without
        widths."""
        if self.widths is None or not len(self):
            return None
        roots, tips = self.first[:-1], self.first[1:] - 1
        at_roots, at_tips = self.widths[roots], self.widths[tips]
        if self.basis == "bspline":  # widths are control values: evaluate the curve
            at_roots = (
                at_roots + 4 * self.widths[roots + 1] + self.widths[roots + 2]
            ) / 6
            at_tips = (at_tips + 4 * self.widths[tips - 1] + self.widths[tips - 2]) / 6
        return float(np.median(at_roots)), float(np.median(at_tips))


@dataclasses.dataclass(eq=False, frozen=True)
class Mesh:
    """A triangle mesh that hair grows on."""

    positions: AnyNumbers  #: [vertices][3], in the scene's units
    corners: AnyNumbers  #: [triangles][3], counter-clockwise seen from outside
    uvs: AnyNumbers | None = None  #: [triangles][3][2]

    def __post_init__(self) -> None:
        _set(self, "positions", _rows(self.positions, 3, "positions"))
        _set(self, "corners", _whole(self.corners, "corners"))
        if self.corners.ndim != 2 or self.corners.shape[1] != 3:
            raise InputError(f"corners: shape is {self.corners.shape}, must be (n, 3)")
        if self.uvs is not None:
            _set(self, "uvs", np.ascontiguousarray(self.uvs, dtype=np.float32))
            if self.uvs.shape != (len(self.corners), 3, 2):
                raise InputError(
                    f"uvs: shape is {self.uvs.shape}, must be ({len(self.corners)}, 3, 2)"
                )
