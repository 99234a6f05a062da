"""Results of queries about a groom."""

from __future__ import annotations

import dataclasses
from typing import Literal

import numpy as np

from .geometry import Doubles


@dataclasses.dataclass(frozen=True)
class Info:
    chunks: int
    strands: int  #: in all chunks at density 1
    guides: int
    segments: int  #: helices per guide
    intervals: int  #: maximum per strand
    neighbours: int  #: guides per strand
    first_frame: int  #: of the cache; first and last are 0 if nothing moves
    last_frame: int
    cm_per_unit: float  #: length unit of the scene
    up: tuple[float, float, float]
    load_seconds: float
    fit_seconds: float
    bind_seconds: float
    bytes: int  #: memory held while the groom is open
    frames: int  #: of the cache; 0 if nothing moves
    basis: Literal["bspline", "hermite"]  #: basis that the groom requests
    shape: Literal["any", "flat", "round", "ribbon"]  #: cross section to draw
    #: minimum and maximum corner of the box of the guides at rest, cm
    box: tuple[tuple[float, float, float], tuple[float, float, float]]


@dataclasses.dataclass(frozen=True)
class ChunkInfo:
    """The number of strands, and how many of them binding had to make an exception for.

    This is the one table of these counters in Python; the C struct is derived from it.
    """

    strands: int = 0
    bytes: int = 0  #: memory held while the chunk is open
    no_facing_guide: int = 0
    no_guide_in_reach: int = 0
    no_guide_in_sight: int = 0
    no_guide_in_region: int = 0
    opposed_root_frames: int = 0
    straight_guides: int = 0

    def joined(self, other: ChunkInfo) -> ChunkInfo:
        """The sums of both."""
        pairs = zip(dataclasses.astuple(self), dataclasses.astuple(other))
        return ChunkInfo(*(mine + theirs for mine, theirs in pairs))


@dataclasses.dataclass(frozen=True)
class Check:
    """The result of checking strands: counts, and the maximum of each error."""

    strands: int = 0
    failed: int = 0
    outside: int = 0  #: strands that leave the tight box
    orthogonality: float = 0.0  #: |R^T R - 1| of the frames
    length_error: float = 0.0  #: of the strand, relative
    curve_length_error: float = 0.0  #: of the emitted curve, relative
    distance: float = 0.0  #: from the curve to the strand, cm

    @property
    def passed(self) -> bool:
        return self.failed == 0 and self.outside == 0

    def joined(self, other: Check) -> Check:
        """The sums of the counts and the maxima of the errors; NaN if either is NaN."""

        def maximum(name: str) -> float:
            return float(np.maximum(getattr(self, name), getattr(other, name)))

        return Check(
            strands=self.strands + other.strands,
            failed=self.failed + other.failed,
            outside=self.outside + other.outside,
            orthogonality=maximum("orthogonality"),
            length_error=maximum("length_error"),
            curve_length_error=maximum("curve_length_error"),
            distance=maximum("distance"),
        )


@dataclasses.dataclass(frozen=True, eq=False)
class Guides:
    """Super-Helices of `segments` helices each, root first."""

    root_positions: Doubles  #: [guides][3] cm
    root_frames: Doubles  #: [guides][3][3] columns: tangent, first axis, second axis
    segment_lengths: Doubles  #: [guides][segments] cm
    curvatures: Doubles  #: [guides][segments][3] twist and two bends, 1/cm
    fit_rms: Doubles | None  #: [guides] cm; None if the guides were not fitted

    def __len__(self) -> int:
        return len(self.root_positions)

    @property
    def lengths(self) -> Doubles:
        """[guides] cm."""
        total: Doubles = self.segment_lengths.sum(axis=1)
        return total
