"""What is told of a groom."""

from __future__ import annotations

import dataclasses
from typing import Literal

import numpy as np

from .geometry import Doubles


@dataclasses.dataclass(frozen=True)
class Info:
    chunks: int
    strands: int  #: of all chunks at density 1
    guides: int
    segments: int  #: helices of a guide
    intervals: int  #: the most a strand has
    neighbours: int  #: guides of a strand
    first_frame: int  #: of its cache; both 0 where nothing moves
    last_frame: int
    cm_per_unit: float  #: of the scene's unit
    up: tuple[float, float, float]
    load_seconds: float
    fit_seconds: float
    bind_seconds: float
    bytes: int  #: kept while the groom is open
    frames: int  #: of its cache; 0: nothing moves
    basis: Literal["bspline", "hermite"]  #: that the groom asks for
    shape: Literal["any", "flat", "round", "ribbon"]  #: of strands, as drawn
    #: least and greatest corner of the guides at rest, cm: what to frame
    box: tuple[tuple[float, float, float], tuple[float, float, float]]


@dataclasses.dataclass(frozen=True)
class ChunkInfo:
    """Numbers of strands, of them those that binding had to work around."""

    strands: int
    bytes: int  #: kept while the chunk is bound
    no_facing_guide: int
    no_guide_in_reach: int
    no_guide_in_sight: int
    no_guide_in_region: int
    opposed_root_frames: int
    straight_guides: int

    def joined(self, other: ChunkInfo) -> ChunkInfo:
        """Of both."""
        pairs = zip(dataclasses.astuple(self), dataclasses.astuple(other))
        return ChunkInfo(*(mine + theirs for mine, theirs in pairs))


@dataclasses.dataclass(frozen=True)
class Check:
    strands: int
    failed: int
    outside: int  #: of them, beyond the tight bound
    orthogonality: float  #: max |R^T R - 1| of the frames
    length_error: float  #: max, relative, of the strand
    curve_length_error: float  #: max, relative, of the curve as emitted
    distance: float  #: max, from the curve to the strand, cm

    @property
    def passed(self) -> bool:
        return self.failed == 0 and self.outside == 0

    def joined(self, other: Check) -> Check:
        """Of both: counts added, the greatest of the rest, no number where one is none."""

        def greatest(name: str) -> float:
            return float(np.maximum(getattr(self, name), getattr(other, name)))

        return Check(
            strands=self.strands + other.strands,
            failed=self.failed + other.failed,
            outside=self.outside + other.outside,
            orthogonality=greatest("orthogonality"),
            length_error=greatest("length_error"),
            curve_length_error=greatest("curve_length_error"),
            distance=greatest("distance"),
        )


@dataclasses.dataclass(frozen=True, eq=False)
class Guides:
    """Super-Helices: `segments` helices each, root first."""

    root_positions: Doubles  #: [guides][3] cm
    root_frames: Doubles  #: [guides][3][3] columns: tangent, first, second axis
    segment_lengths: Doubles  #: [guides][segments] cm
    curvatures: Doubles  #: [guides][segments][3] twist and two bends, 1/cm
    fit_rms: Doubles | None  #: [guides] cm; None where the file held guides

    def __len__(self) -> int:
        return len(self.root_positions)

    @property
    def lengths(self) -> Doubles:
        """[guides] cm."""
        total: Doubles = self.segment_lengths.sum(axis=1)
        return total
