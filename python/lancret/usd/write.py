"""Strands as BasisCurves."""

from __future__ import annotations

import os
from collections.abc import Collection, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ..curves import Attribute, Basis, Curves
from ..errors import InputError
from ..groom import Groom
from ._pxr import Kind, Sdf, Tf, Usd, UsdGeom, Vt

_TYPES = {
    "linear": ("linear", None),
    "bspline": ("cubic", "bspline"),
    "catmull-rom": ("cubic", "catmullRom"),
    "bezier": ("cubic", "bezier"),
}
_EXTENSIONS = (".usd", ".usda", ".usdc")
#: Of one call of expand.
_MOST_TIMES = 64


def write(
    path: str | os.PathLike[str],
    groom: Groom,
    *,
    times: Sequence[float] | None = None,
    basis: Basis = "bspline",
    density: float = 0,
    max_error: float = 0,
    attributes: Collection[Attribute] = ("ids", "root_uv"),
    prim: str = "/Hair",
    a_prim_a_chunk: bool = False,
    metres_per_unit: float | None = None,
    frames_per_second: float = 24,
) -> None:
    """Grows a groom into a .usd, .usda or .usdc file, which appears when it is whole.

    The strands are BasisCurves below `prim`, in metres_per_unit (none: the groom's own)
    and with the groom's up axis: all in one prim, or a prim a chunk, so that no more than
    a chunk is in memory besides the stage. `times` become time samples; none: the first
    frame, or rest. Attributes become primvars: ids `id`, root_uv `st`, lengths
    `hairLength`, random `hairRandom`; normals the curves' own normals.
    """
    target = Path(path)
    if target.suffix not in _EXTENSIONS:
        raise InputError(f"{target}: is written as {', '.join(_EXTENSIONS)} only")
    if basis not in _TYPES:
        raise InputError(f"basis {basis!r}: USD's BasisCurves are {', '.join(_TYPES)}")
    valid = prim.startswith("/") and Sdf.Path.IsValidPathString(prim)[0]
    if not valid or not Sdf.Path(prim).IsRootPrimPath():
        raise InputError(f"prim {prim!r}: must be at the root, such as /Hair")
    metres = metres_per_unit or groom.info.cm_per_unit / 100
    asked: dict[str, Any] = {
        "basis": basis,
        "density": density,
        "max_error": max_error,
        "attributes": attributes,
        "unit": 100 * metres,
    }
    unfinished = target.with_name(f".{target.stem}.{os.getpid()}{target.suffix}")
    try:
        stage = _new_stage(unfinished)
        _describe(stage, groom, metres, times, frames_per_second)
        stage.SetDefaultPrim(UsdGeom.Xform.Define(stage, prim).GetPrim())
        Usd.ModelAPI(stage.GetDefaultPrim()).SetKind(Kind.Tokens.component)
        chunks = [(f"chunk_{i:05}", [i]) for i in groom.chunks]
        for name, numbers in chunks if a_prim_a_chunk else [("strands", groom.chunks)]:
            place = f"{prim}/{name}"
            if times is None:
                curves = groom.expand(numbers, **asked)
                if len(curves) or not a_prim_a_chunk:
                    add_curves(stage, place, curves)
                continue
            for i in range(0, len(times), _MOST_TIMES):
                batch = times[i : i + _MOST_TIMES]
                add_curves(stage, place, groom.expand(numbers, batch, **asked))
        stage.GetRootLayer().Save()
        del stage
        os.replace(unfinished, target)
    finally:
        unfinished.unlink(missing_ok=True)


def _new_stage(path: Path) -> Any:
    if not path.parent.is_dir():  # USD would make it
        raise InputError(f"{path.parent}: no such folder")
    try:
        return Usd.Stage.CreateNew(str(path))
    except Tf.ErrorException:
        raise InputError(f"{path.parent}: no file can be written there") from None


def _describe(
    stage: Any,
    groom: Groom,
    metres: float,
    times: Sequence[float] | None,
    frames_per_second: float,
) -> None:
    ups = {(0.0, 1.0, 0.0): UsdGeom.Tokens.y, (0.0, 0.0, 1.0): UsdGeom.Tokens.z}
    up = tuple(float(value) for value in groom.info.up)
    if up not in ups:
        raise InputError(f"scene.up: USD knows Y and Z alone; this groom has {up}")
    UsdGeom.SetStageUpAxis(stage, ups[up])
    UsdGeom.SetStageMetersPerUnit(stage, metres)
    if times is not None and len(times):
        stage.SetTimeCodesPerSecond(frames_per_second)
        stage.SetFramesPerSecond(frames_per_second)
        stage.SetStartTimeCode(float(min(times)))
        stage.SetEndTimeCode(float(max(times)))


def add_curves(stage: Any, path: str, curves: Curves) -> Any:
    """Puts curves at a path of a stage, in units of the stage: as they are, without a
    transform. At times that curves were asked for they are time samples, and those that
    are there stay. Returns the UsdGeom.BasisCurves."""
    if curves.basis not in _TYPES:
        raise InputError(f"{path}: USD's BasisCurves are {', '.join(_TYPES)}")
    made = UsdGeom.BasisCurves.Define(stage, path)
    kind, basis = _TYPES[curves.basis]
    made.CreateTypeAttr(kind)
    if basis:
        made.CreateBasisAttr(basis)
    made.CreateWrapAttr(UsdGeom.Tokens.nonperiodic)
    made.SetWidthsInterpolation(UsdGeom.Tokens.vertex)
    _set_counts(made, curves)
    for i, time in enumerate(curves.times or (None,)):
        _set_sample(made, curves, i, Usd.TimeCode(time) if curves.times else _default())
    _set_primvars(made, curves)
    return made


def _default() -> Any:
    return Usd.TimeCode.Default()


def _set_counts(made: Any, curves: Curves) -> None:
    """Once where all times have the same; as samples where they change."""
    attribute = made.CreateCurveVertexCountsAttr()
    counts = Vt.IntArray.FromNumpy(curves.counts.astype(np.int32))
    if not attribute.HasAuthoredValue():
        attribute.Set(counts)
        return
    before = attribute.Get(
        Usd.TimeCode(curves.times[0]) if curves.times else _default()
    )
    if before != counts:
        for time in curves.times:
            attribute.Set(counts, Usd.TimeCode(time))


def _set_sample(made: Any, curves: Curves, index: int, time: Any) -> None:
    points = np.ascontiguousarray(curves.positions[index, :, :3])
    widths = 2 * curves.positions[index, :, 3]
    made.CreatePointsAttr().Set(Vt.Vec3fArray.FromNumpy(points), time)
    made.CreateWidthsAttr().Set(Vt.FloatArray.FromNumpy(widths), time)
    if curves.normals is not None:
        normals = np.ascontiguousarray(curves.normals[index, :, :3])
        made.CreateNormalsAttr().Set(Vt.Vec3fArray.FromNumpy(normals), time)
        made.SetNormalsInterpolation(UsdGeom.Tokens.vertex)
    if len(points):
        extent = UsdGeom.Boundable.ComputeExtentFromPlugins(made, time)
        made.CreateExtentAttr().Set(extent, time)


def _set_primvars(made: Any, curves: Curves) -> None:
    primvars = UsdGeom.PrimvarsAPI(made)
    types = Sdf.ValueTypeNames

    def add(name: str, kind: Any, values: Any) -> None:
        primvars.CreatePrimvar(name, kind, UsdGeom.Tokens.uniform).Set(values)

    if curves.ids is not None:
        ids = Vt.IntArray.FromNumpy(curves.ids.astype(np.int32))
        add("id", types.IntArray, ids)
    if curves.root_uv is not None:
        uvs = Vt.Vec2fArray.FromNumpy(np.ascontiguousarray(curves.root_uv))
        add("st", types.TexCoord2fArray, uvs)
    if curves.lengths is not None:
        add("hairLength", types.FloatArray, Vt.FloatArray.FromNumpy(curves.lengths))
    if curves.random is not None:
        add("hairRandom", types.FloatArray, Vt.FloatArray.FromNumpy(curves.random))
