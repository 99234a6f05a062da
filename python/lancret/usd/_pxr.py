"""usd-core, imported only with lancret.usd, and helpers to read prims."""

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
    """`source` if it is a stage, else the stage of a file. Raises InputError."""
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
    """File and path of a prim, for messages."""
    return f"{prim.GetStage().GetRootLayer().identifier}:{prim.GetPath()}"


#: Purposes of prims that are read by default.
PURPOSES = ("default", "render")


def prims_of(
    stage: Any,
    prim: str | None,
    kind: Any,
    time: float | None,
    purposes: Collection[str],
) -> list[Any]:
    """Prims of a kind at and below `prim` (None: in the whole stage), including instances,
    that are visible and have one of the purposes; `prim` itself is always included. Raises
    InputError if there are none, and for prims that a PointInstancer places."""
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
    visible = [
        each for each in found if each == top or _is_visible(each, time, purposes)
    ]
    if not visible:
        raise InputError(
            f"{name_of(top)}: has {len(found)} {kind.__name__}, but none that is visible "
            f"and has purpose {' or '.join(purposes)}"
        )
    for each in visible:
        if each != top:
            _refuse_instancer(each, top)
    return visible


def _is_visible(prim: Any, time: float | None, purposes: Collection[str]) -> bool:
    image = UsdGeom.Imageable(prim)
    hidden = image.ComputeVisibility(moment(prim, time)) == UsdGeom.Tokens.invisible
    return not hidden and str(image.ComputePurpose()) in purposes


def _refuse_instancer(prim: Any, top: Any) -> None:
    above = prim.GetParent()
    while above and above != top:
        if above.IsA(UsdGeom.PointInstancer):
            raise InputError(
                f"{name_of(prim)}: is placed by the PointInstancer {above.GetPath()}, "
                "which is not supported; name the prim to read the prototype itself"
            )
        above = above.GetParent()


def moment(prim: Any, time: float | None) -> Any:
    """The time at which to read a prim, its transform and its attributes: `time`; if it is
    None, the first sample of the points; without samples, defaults and first samples."""
    if time is not None:
        return Usd.TimeCode(time)
    samples = UsdGeom.PointBased(prim).GetPointsAttr().GetTimeSamples()
    return Usd.TimeCode(samples[0]) if samples else Usd.TimeCode.EarliestTime()


def matrix_of(prim: Any, time: Any) -> np.ndarray:
    """[4][4] local to world, for row vectors: world = [x y z 1] @ matrix."""
    return np.array(UsdGeom.XformCache(time).GetLocalToWorldTransform(prim))


def to_world(points: np.ndarray, matrix: np.ndarray) -> np.ndarray:
    world: np.ndarray = np.asarray(points, np.float64) @ matrix[:3, :3] + matrix[3, :3]
    return world


def array_of(
    attribute: Any, time: Any, shape: tuple[int, ...], dtype: Any
) -> np.ndarray:
    """An attribute's value; empty if it has none. Raises InputError if a number is not
    finite."""
    value = attribute.Get(time)
    array = np.array(value if value is not None else [], dtype=dtype).reshape(shape)
    if not np.isfinite(array).all():
        raise InputError(
            f"{name_of(attribute.GetPrim())}: {attribute.GetName()} contains a number that "
            "is not finite"
        )
    return array
