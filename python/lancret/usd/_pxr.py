"""usd-core, asked for only when it is needed."""

from __future__ import annotations

import os
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


def prims_of(stage: Any, prim: str | None, kind: Any) -> list[Any]:
    """Prims of a kind at and below `prim`, or of all the stage; instances too. Raises
    InputError where there are none."""
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
    return found


def moment(time: float | None) -> Any:
    """The time to read at; none: the default, or the first sample where there is none."""
    return Usd.TimeCode.EarliestTime() if time is None else Usd.TimeCode(time)


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
