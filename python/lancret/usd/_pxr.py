"""usd-core, asked for only when it is needed."""

from __future__ import annotations

import os
from collections.abc import Collection
from typing import Any

import numpy as np

from ..errors import InputError

try:
    from pxr import Gf, Kind, Sdf, Tf, Usd, UsdGeom, Vt
except ImportError as fault:
    raise ImportError(
        "lancret.usd needs usd-core: pip install 'lancret[usd]', or pip install usd-core"
    ) from fault

__all__ = ["Gf", "Kind", "Sdf", "Tf", "Usd", "UsdGeom", "Vt"]


def stage_of(source: Any) -> Any:
    """A stage as it is; else that of a file. Raises InputError."""
    if isinstance(source, Usd.Stage):
        return source
    path = os.fspath(source)
    if not os.path.isfile(path):
        raise InputError(f"{path}: no such file")
    try:
        return Usd.Stage.Open(path)
    except Tf.ErrorException as fault:
        raise InputError(f"{path}: cannot be read as USD: {_short(fault)}") from None


def _short(fault: Exception) -> str:
    lines = [line.strip() for line in str(fault).splitlines() if line.strip()]
    return lines[-1] if lines else "no reason given"


def name_of(prim: Any) -> str:
    """A file and a place in it, for messages."""
    return f"{prim.GetStage().GetRootLayer().identifier}:{prim.GetPath()}"


#: Of what is read unless said otherwise.
PURPOSES = ("default", "render")


def prims_of(
    stage: Any,
    prim: str | None,
    kind: Any,
    time: float | None,
    purposes: Collection[str],
) -> list[Any]:
    """Prims of a kind at and below `prim`, or of all the stage, that are visible and of
    one of the purposes; instances too. `prim` itself is taken whatever it is. Raises
    InputError where there are none, and of prims that a PointInstancer would place."""
    top = stage.GetPrimAtPath(prim) if prim else stage.GetPseudoRoot()
    name = stage.GetRootLayer().identifier
    if not top:
        raise InputError(f"{name}: has no prim {prim}")
    found = [
        each
        for each in Usd.PrimRange(top, Usd.TraverseInstanceProxies())
        if each.IsA(kind)
    ]
    if not found:
        raise InputError(f"{name_of(top)}: has no {kind.__name__} at or below it")
    seen = [each for each in found if each == top or _is_seen(each, time, purposes)]
    if not seen:
        raise InputError(
            f"{name_of(top)}: has {len(found)} {kind.__name__}, but none that is visible "
            f"and of purpose {' or '.join(purposes)}"
        )
    for each in seen:
        if each != top:
            _refuse_instancer(each, top)
    return seen


def _is_seen(prim: Any, time: float | None, purposes: Collection[str]) -> bool:
    image = UsdGeom.Imageable(prim)
    hidden = image.ComputeVisibility(moment(prim, time)) == UsdGeom.Tokens.invisible
    return not hidden and str(image.ComputePurpose()) in purposes


def _refuse_instancer(prim: Any, top: Any) -> None:
    above = prim.GetParent()
    while above and above != top:
        if above.IsA(UsdGeom.PointInstancer):
            raise InputError(
                f"{name_of(prim)}: is placed by the PointInstancer {above.GetPath()}, "
                "whose places are not read; name the prim to have it where it stands"
            )
        above = above.GetParent()


def moment(prim: Any, time: float | None) -> Any:
    """The time to read a prim at, with its transform and all else; none: that of its
    points' first sample; where they have none, defaults and first samples."""
    if time is not None:
        return Usd.TimeCode(time)
    samples = UsdGeom.PointBased(prim).GetPointsAttr().GetTimeSamples()
    return Usd.TimeCode(samples[0]) if samples else Usd.TimeCode.EarliestTime()


def matrix_of(prim: Any, time: Any) -> np.ndarray:
    """Local to world, for row vectors: world = [x y z 1] @ matrix."""
    return np.array(UsdGeom.XformCache(time).GetLocalToWorldTransform(prim))


def to_world(points: np.ndarray, matrix: np.ndarray) -> np.ndarray:
    world: np.ndarray = np.asarray(points, np.float64) @ matrix[:3, :3] + matrix[3, :3]
    return world


def array_of(
    attribute: Any, time: Any, shape: tuple[int, ...], dtype: Any
) -> np.ndarray:
    """An attribute's value; empty where it has none. Raises InputError where a number in
    it is not finite."""
    value = attribute.Get(time)
    array = np.array(value if value is not None else [], dtype=dtype).reshape(shape)
    if not np.isfinite(array).all():
        raise InputError(
            f"{name_of(attribute.GetPrim())}: {attribute.GetName()} has a number that is "
            "not finite"
        )
    return array
