"""BasisCurves as strands, whatever their basis, wrap and widths."""

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
_PINNED = ("bspline", "catmull-rom")  # of which the ends need points that are not there
#: Places on a piece of curves that the library has no basis for.
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
    """The strands of every BasisCurves at or below `prim` (none: of the stage) that is
    visible and of one of the `purposes`, in world space and the stage's units. `prim`
    itself is read whatever it is.

    source: a file, or a Usd.Stage. time: none: of each prim the time of its points' first
        sample, for all of it; where points have no samples, their default.
    transform: False takes points as they stand, for files whose points are in world space
        below a transform all the same, such as Blender 2.93's hair.
    wrap: in place of the file's: "pinned" for files that do not say so but whose curves
        are meant to begin at their first points, as Blender's again.

    `linear` and `bspline` curves keep their control points, with the points that
    `pinned` only implies. `bezier` and `catmullRom` curves, which are no B-splines,
    become places on the curve, 8 a piece, for a curve through them. Widths
    (`primvars:widths`, else `widths`) come along at each point, `primvars:st` of the roots
    as root_uv, `primvars:id` as ids; what only some of several prims have is left out,
    with a warning to the logger "lancret".

    Raises InputError: for `periodic` curves, which have no root; for counts that do not
    fit; for linear and cubic curves together; for prims that a PointInstancer places.
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
class _Form:
    """What a prim says its points are."""

    name: str
    basis: str
    pinned: bool
    counts: np.ndarray  # [curves] of control points as they stand in the file

    @functools.cached_property
    def pieces(self) -> np.ndarray:
        """[curves]"""
        out = np.empty(len(self.counts), dtype=np.int64)
        for count, curves in cubic.groups(self.counts):
            implied = 2 if self.pinned and self.basis in _PINNED else 0
            out[curves] = cubic.pieces_of(count + implied, self.basis)
        return out

    @property
    def stretched(self) -> int:
        """What UsdGeomBasisCurves computes as the number of `varying` values of pinned
        curves: as if they were not pinned. Files of either kind are about."""
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
            "varying": int((self.pieces + 1).sum()),
            "faceVarying": int((self.pieces + 1).sum()),  # of curves the same
            "vertex": int(self.counts.sum()),
        }.get(interpolation, -1)


def _form(curves: Any, time: Any, points: int, said_wrap: str | None) -> _Form:
    name = name_of(curves.GetPrim())
    wrap = said_wrap or str(curves.GetWrapAttr().Get())
    kind = str(curves.GetTypeAttr().Get())
    basis = (
        "linear" if kind == "linear" else _BASES.get(str(curves.GetBasisAttr().Get()))
    )
    if basis is None:
        raise InputError(
            f"{name}: basis is {curves.GetBasisAttr().Get()}; one of {', '.join(_BASES)} "
            "can be read"
        )
    if wrap == "periodic":
        raise InputError(
            f"{name}: wrap is periodic: a closed curve has no root to grow from; open it "
            "(wrap nonperiodic or pinned)"
        )
    counts = array_of(curves.GetCurveVertexCountsAttr(), time, (-1,), np.int64)
    if counts.size and (counts.min() < 2 or counts.sum() != points):
        raise InputError(
            f"{name}: curveVertexCounts must be 2 or more each and make {points} points "
            f"in all; the least is {counts.min()}, the sum {counts.sum()}"
        )
    form = _Form(name, basis, wrap == "pinned", counts)
    try:
        form.pieces
    except InputError as fault:
        raise InputError(f"{name}: {fault}") from None
    return form


def _read_prim(prim: Any, time: Any, transform: bool, wrap: str | None) -> Strands:
    curves = UsdGeom.BasisCurves(prim)
    points = array_of(curves.GetPointsAttr(), time, (-1, 3), np.float64)
    form = _form(curves, time, len(points), wrap)
    matrix = matrix_of(prim, time) if transform else np.eye(4)
    points = to_world(points, matrix)
    widths = _widths(curves, form, time)
    if (
        widths is not None
    ):  # a transform that scales unevenly has no one width: the mean
        widths = widths * abs(np.linalg.det(matrix[:3, :3])) ** (1 / 3)
        points = np.column_stack([points, widths])
    basis, counts = form.basis, form.counts
    if form.pinned and basis in _PINNED:
        points, counts = cubic.with_phantoms(points, counts)
    if basis in ("bezier", "catmull-rom"):
        points, counts = cubic.sample(points, counts, basis, PLACES_PER_SEGMENT)
        basis = "catmull-rom"
    return Strands(
        points=points[:, :3],
        counts=counts,
        basis=basis,  # type: ignore[arg-type]
        widths=None if widths is None else points[:, 3],
        root_uv=_root_uv(prim, form, time),
        ids=_ids(prim, form, time),
    )


def _widths(curves: Any, form: _Form, time: Any) -> np.ndarray | None:
    """Widths at each control point; none where the prim has none."""
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
            f"{form.name}: primvars:widths has a number that is not finite"
        )
    return _at_points(widths, kind, form, "widths")


def _at_points(values: np.ndarray, kind: str, form: _Form, what: str) -> np.ndarray:
    """Values of any interpolation as one a control point."""
    if kind == "faceVarying":
        kind = "varying"
    stretched = kind == "varying" and len(values) == form.stretched
    if len(values) != form.elements(kind) and not stretched:
        raise InputError(
            f"{form.name}: {what} are {kind}, and so should be {form.elements(kind)}; "
            f"there are {len(values)}"
        )
    if kind == "constant":
        return np.repeat(values, int(form.counts.sum()), axis=0)
    if kind == "uniform":
        return np.repeat(values, form.counts, axis=0)
    if kind == "varying":
        return _varying_at_points(values, form, stretched)
    return values


def _varying_at_points(values: np.ndarray, form: _Form, stretched: bool) -> np.ndarray:
    """Linear between the ends of pieces. A control point lies at the parameter that its
    own weight is greatest at; the outer ones of a cubic that is not pinned lie beyond.
    `stretched` values lie evenly along the curve."""
    made = form.counts - 2 if stretched else form.pieces + 1
    out = np.empty(int(form.counts.sum()))
    starts, out_starts = (np.cumsum(n) - n for n in (made, form.counts))
    for count, curves in cubic.groups(form.counts):
        some = int(made[curves[0]])
        mine = values[starts[curves][:, None] + np.arange(some)]
        at = np.arange(count, dtype=np.float64) / cubic.STEPS[form.basis]
        if stretched:
            at *= (some - 1) / (count - 1)
        elif form.basis in _PINNED and not form.pinned:
            at -= 1
        low = np.clip(np.floor(at).astype(int), 0, some - 2)
        between = mine[:, low] + (at - low) * (mine[:, low + 1] - mine[:, low])
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


def _of_roots(found: tuple[Any, str] | None, form: _Form, dtype: Any) -> Any:
    """A primvar's value at each root; none where its size fits nothing."""
    if found is None:
        return None
    values, kind = np.array(found[0], dtype=dtype), found[1]
    if len(values) != form.elements(kind):
        return None
    if kind == "constant":
        return np.repeat(values, len(form.counts), axis=0)
    if kind == "uniform":
        return values
    each = form.counts if kind == "vertex" else form.pieces + 1
    return values[np.cumsum(each) - each]


def _root_uv(prim: Any, form: _Form, time: Any) -> Any:
    found = _primvar(prim, ("st", "uv", "UVMap"), time)
    if found is not None and np.shape(found[0])[-1:] != (2,):
        return None
    return _of_roots(found, form, np.float32)


def _ids(prim: Any, form: _Form, time: Any) -> Any:
    found = _primvar(prim, ("id", "ids"), time)
    if found is not None and np.array(found[0]).dtype.kind not in "iu":
        return None
    return _of_roots(found, form, np.int64)


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
                "%s: has no %s, and so those of the other prims are left out",
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
    """B-splines as curves through places on them."""
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
