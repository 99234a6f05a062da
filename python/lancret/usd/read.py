"""Reads BasisCurves of any basis, wrap and width interpolation as strands."""

from __future__ import annotations

import dataclasses
import functools
import logging
from collections.abc import Collection
from typing import Any, Literal

import numpy as np

from .. import cubic
from ..errors import InputError
from ..geometry import Strands
from ._pxr import (
    PURPOSES,
    UsdGeom,
    array_of,
    matrix_of,
    moment,
    name_of,
    prims_of,
    stage_of,
    to_world,
)

_BASES = {"bspline": "bspline", "catmullRom": "catmull-rom", "bezier": "bezier"}
_PINNED = ("bspline", "catmull-rom")  # bases in which `pinned` implies extra end points
#: Places per segment of curves in a basis that the library lacks.
PLACES_PER_SEGMENT = 8


def read(
    source: Any,
    prim: str | None = None,
    time: float | None = None,
    *,
    transform: bool = True,
    wrap: Literal["nonperiodic", "pinned"] | None = None,
    purposes: Collection[str] = PURPOSES,
) -> Strands:
    """The strands of all BasisCurves at and below `prim` (None: in the stage) that are
    visible and have one of the `purposes`, in world space and the stage's units. `prim`
    itself is always read.

    source: a file, or a Usd.Stage.
    time: None: per prim, the time of the first sample of its points, for all attributes;
        if the points have no samples, their default.
    transform: False ignores transforms, for files whose points are in world space although
        they are below a transform, such as the hair of Blender 2.93.
    wrap: overrides the file's: "pinned" for files that leave it out but whose curves begin
        at their first points, again such as Blender's.

    `linear` and `bspline` curves keep their control points, and get the points that
    `pinned` implies. `bezier` and `catmullRom` curves are sampled at 8 places per segment
    and become Catmull-Rom curves through these. Widths (`primvars:widths`, else `widths`)
    become one per point, `primvars:st` at the roots root_uv, `primvars:id` ids. Attributes
    that only some of several prims have are left out, with a warning to the logger
    "lancret".

    Raises InputError for `periodic` curves, which have no root, for counts that do not
    match, for linear and cubic curves together, for prims that a PointInstancer places.
    """
    stage = stage_of(source)
    prims = prims_of(stage, prim, UsdGeom.BasisCurves, time, purposes)
    parts = {
        name_of(each): _read_prim(each, moment(each, time), transform, wrap)
        for each in prims
    }
    full = {name: part for name, part in parts.items() if len(part)}
    return dataclasses.replace(
        _joined(full or dict(list(parts.items())[:1])),
        metres_per_unit=UsdGeom.GetStageMetersPerUnit(stage),
        up="Z" if UsdGeom.GetStageUpAxis(stage) == UsdGeom.Tokens.z else "Y",
    )


@dataclasses.dataclass
class _Layout:
    """The layout of a prim's curves."""

    name: str
    basis: str
    pinned: bool
    counts: np.ndarray  # [curves] number of control points in the file

    @functools.cached_property
    def segments(self) -> np.ndarray:
        """[curves] number of segments."""
        out = np.empty(len(self.counts), dtype=np.int64)
        for count, curves in cubic.groups(self.counts):
            implied = 2 if self.pinned and self.basis in _PINNED else 0
            out[curves] = cubic.segments_of(count + implied, self.basis)
        return out

    @property
    def stretched(self) -> int:
        """The number of `varying` values that UsdGeomBasisCurves computes for pinned
        curves: as if they were not pinned. Both kinds of files exist. -1 if the curves
        are not pinned."""
        if (
            not (self.pinned and self.basis in _PINNED)
            or self.counts.min(initial=4) < 4
        ):
            return -1
        return int((self.counts - 2).sum())

    def elements(self, interpolation: str) -> int:
        return {
            "constant": 1,
            "uniform": len(self.counts),
            "varying": int((self.segments + 1).sum()),
            "faceVarying": int((self.segments + 1).sum()),  # the same for curves
            "vertex": int(self.counts.sum()),
        }.get(interpolation, -1)


def _layout(curves: Any, time: Any, points: int, wrap_override: str | None) -> _Layout:
    name = name_of(curves.GetPrim())
    wrap = wrap_override or str(curves.GetWrapAttr().Get())
    kind = str(curves.GetTypeAttr().Get())
    basis = (
        "linear" if kind == "linear" else _BASES.get(str(curves.GetBasisAttr().Get()))
    )
    if basis is None:
        raise InputError(
            f"{name}: basis is {curves.GetBasisAttr().Get()}; expected one of "
            f"{', '.join(_BASES)}"
        )
    if wrap == "periodic":
        raise InputError(
            f"{name}: wrap is periodic, but a closed curve has no root; expected "
            "nonperiodic or pinned"
        )
    counts = array_of(curves.GetCurveVertexCountsAttr(), time, (-1,), np.int64)
    if counts.size and (counts.min() < 2 or counts.sum() != points):
        raise InputError(
            f"{name}: curveVertexCounts must be 2 or more each and add up to {points} "
            f"points; the minimum is {counts.min()}, the sum {counts.sum()}"
        )
    layout = _Layout(name, basis, wrap == "pinned", counts)
    try:
        layout.segments
    except InputError as fault:
        raise InputError(f"{name}: {fault}") from None
    return layout


def _read_prim(prim: Any, time: Any, transform: bool, wrap: str | None) -> Strands:
    curves = UsdGeom.BasisCurves(prim)
    points = array_of(curves.GetPointsAttr(), time, (-1, 3), np.float64)
    layout = _layout(curves, time, len(points), wrap)
    matrix = matrix_of(prim, time) if transform else np.eye(4)
    points = to_world(points, matrix)
    widths = _widths(curves, layout, time)
    if widths is not None:  # the mean scale, as a non-uniform one has no single width
        widths = widths * abs(np.linalg.det(matrix[:3, :3])) ** (1 / 3)
        points = np.column_stack([points, widths])
    basis, counts = layout.basis, layout.counts
    if layout.pinned and basis in _PINNED:
        points, counts = cubic.with_phantoms(points, counts)
    if basis in ("bezier", "catmull-rom"):
        points, counts = cubic.sample(points, counts, basis, PLACES_PER_SEGMENT)
        basis = "catmull-rom"
    return Strands(
        points=points[:, :3],
        counts=counts,
        basis=basis,  # type: ignore[arg-type]
        widths=None if widths is None else points[:, 3],
        root_uv=_root_uv(prim, layout, time),
        ids=_ids(prim, layout, time),
    )


def _widths(curves: Any, layout: _Layout, time: Any) -> np.ndarray | None:
    """Widths at the control points; None if the prim has none."""
    found = _primvar(curves.GetPrim(), ("widths",), time)
    if found is not None:
        widths, kind = np.array(found[0], dtype=np.float64), found[1]
    else:
        widths = array_of(curves.GetWidthsAttr(), time, (-1,), np.float64)
        kind = str(curves.GetWidthsInterpolation())
    if not widths.size:
        return None
    if not np.isfinite(widths).all():
        raise InputError(
            f"{layout.name}: primvars:widths contains a number that is not finite"
        )
    return _at_points(widths, kind, layout, "widths")


def _at_points(values: np.ndarray, kind: str, layout: _Layout, what: str) -> np.ndarray:
    """Converts values of any interpolation to one per control point."""
    if kind == "faceVarying":
        kind = "varying"
    stretched = kind == "varying" and len(values) == layout.stretched
    if len(values) != layout.elements(kind) and not stretched:
        raise InputError(
            f"{layout.name}: {what} are {kind}: expected {layout.elements(kind)} values, found "
            f"{len(values)}"
        )
    if kind == "constant":
        return np.repeat(values, int(layout.counts.sum()), axis=0)
    if kind == "uniform":
        return np.repeat(values, layout.counts, axis=0)
    if kind == "varying":
        return _varying_at_points(values, layout, stretched)
    return values


def _varying_at_points(
    values: np.ndarray, layout: _Layout, stretched: bool
) -> np.ndarray:
    """Interpolates values at the ends of segments linearly. A control point is at the
    parameter of its largest weight; the outer points of a cubic that is not pinned are
    extrapolated. `stretched` values are evenly spaced along the curve."""
    sizes = layout.counts - 2 if stretched else layout.segments + 1
    out = np.empty(int(layout.counts.sum()))
    starts, out_starts = (np.cumsum(n) - n for n in (sizes, layout.counts))
    for count, curves in cubic.groups(layout.counts):
        size = int(sizes[curves[0]])
        rows = values[starts[curves][:, None] + np.arange(size)]
        t = np.arange(count, dtype=np.float64) / cubic.STEPS[layout.basis]
        if stretched:
            t *= (size - 1) / (count - 1)
        elif layout.basis in _PINNED and not layout.pinned:
            t -= 1
        low = np.clip(np.floor(t).astype(int), 0, size - 2)
        between = rows[:, low] + (t - low) * (rows[:, low + 1] - rows[:, low])
        out[out_starts[curves][:, None] + np.arange(count)] = between
    return out


def _primvar(prim: Any, names: tuple[str, ...], time: Any) -> tuple[Any, str] | None:
    for name in names:
        primvar = UsdGeom.PrimvarsAPI(prim).FindPrimvarWithInheritance(name)
        if primvar and primvar.HasValue():
            value = primvar.ComputeFlattened(time)
            if value is not None and len(value):
                return value, str(primvar.GetInterpolation())
    return None


def _of_roots(found: tuple[Any, str] | None, layout: _Layout, dtype: Any) -> Any:
    """A primvar's value at each root; None if its size does not match."""
    if found is None:
        return None
    values, kind = np.array(found[0], dtype=dtype), found[1]
    if len(values) != layout.elements(kind):
        return None
    if kind == "constant":
        return np.repeat(values, len(layout.counts), axis=0)
    if kind == "uniform":
        return values
    each = layout.counts if kind == "vertex" else layout.segments + 1
    return values[np.cumsum(each) - each]


def _root_uv(prim: Any, layout: _Layout, time: Any) -> Any:
    found = _primvar(prim, ("st", "uv", "UVMap"), time)
    if found is not None and np.shape(found[0])[-1:] != (2,):
        return None
    return _of_roots(found, layout, np.float32)


def _ids(prim: Any, layout: _Layout, time: Any) -> Any:
    found = _primvar(prim, ("id", "ids"), time)
    if found is not None and np.array(found[0]).dtype.kind not in "iu":
        return None
    return _of_roots(found, layout, np.int64)


def _joined(named: dict[str, Strands]) -> Strands:
    parts = list(named.values())
    if len(parts) == 1:
        return parts[0]
    bases = {part.basis for part in parts}
    if "linear" in bases and len(bases) > 1:
        raise InputError("linear and cubic curves together: read them prim by prim")
    if len(bases) > 1:
        parts = [_through_places(part) for part in parts]

    def together(name: str) -> Any:
        arrays = [getattr(part, name) for part in parts]
        without = [path for path, array in zip(named, arrays) if array is None]
        if not without:
            return np.concatenate(arrays)
        if len(without) < len(arrays):
            logging.getLogger("lancret").warning(
                "%s: has no %s; those of the other prims are ignored",
                without[0],
                name,
            )
        return None

    return Strands(
        points=together("points"),
        counts=together("counts"),
        basis=parts[0].basis,
        widths=together("widths"),
        root_uv=together("root_uv"),
        ids=together("ids"),
    )


def _through_places(strands: Strands) -> Strands:
    """Converts B-splines to Catmull-Rom curves through places on them."""
    if strands.basis != "bspline":
        return strands
    values = strands.points
    if strands.widths is not None:
        values = np.column_stack([values, strands.widths])
    places, counts = cubic.sample(values, strands.counts, "bspline", PLACES_PER_SEGMENT)
    return dataclasses.replace(
        strands,
        points=places[:, :3],
        counts=counts,
        basis="catmull-rom",
        widths=None if strands.widths is None else places[:, 3],
    )
