"""Strands as BasisCurves."""

from __future__ import annotations

import os
import uuid
from collections.abc import Collection
from pathlib import Path
from typing import Any

import numpy as np

from .._options import Times, moments_of
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
_ATTRIBUTES = {"ids", "root_uv", "lengths", "random", "normals"}
#: That are in memory at once.
_MOST_TIMES = 64


def write(
    path: str | os.PathLike[str],
    groom: Groom,
    *,
    times: Times = None,
    basis: Basis = "bspline",
    density: float = 0,
    max_error: float = 0,
    attributes: Collection[Attribute] = ("ids", "root_uv"),
    prim: str = "/Hair",
    prim_per_chunk: bool = False,
    metres_per_unit: float | None = None,
    frames_per_second: float = 24,
) -> None:
    """Grows a groom into a .usd, .usda or .usdc file, which appears when it is whole.

    The strands are BasisCurves below `prim`, in metres_per_unit (none: the groom's own)
    and with the groom's up axis: all in one prim, or a prim a chunk, so that no more than
    a chunk is in memory besides the stage. `times` become time samples; none: the first
    frame, or rest. Attributes become primvars: ids `id`, root_uv `st`, lengths
    `hairLength`, random `hairRandom`; normals the curves' own normals; others cannot be
    written. Stages of this process that have the file open see the new one.
    """
    target = Path(path)
    if target.suffix not in _EXTENSIONS:
        raise InputError(f"{target}: is written as {', '.join(_EXTENSIONS)} only")
    if basis not in _TYPES:
        raise InputError(f"basis {basis!r}: USD's BasisCurves are {', '.join(_TYPES)}")
    valid = prim.startswith("/") and Sdf.Path.IsValidPathString(prim)[0]
    if not valid or not Sdf.Path(prim).IsRootPrimPath():
        raise InputError(f"prim {prim!r}: must be at the root, such as /Hair")
    unknown = set(attributes) - _ATTRIBUTES
    if unknown:
        raise InputError(
            f"attributes {', '.join(sorted(unknown))}: cannot be written; "
            f"{', '.join(sorted(_ATTRIBUTES))} can"
        )
    moments = moments_of(times)
    if times is not None and not moments:
        raise InputError("times: there are none; leave them out for the first frame")
    metres = metres_per_unit or groom.info.cm_per_unit / 100
    asked: dict[str, Any] = {
        "basis": basis,
        "density": density,
        "max_error": max_error,
        "attributes": attributes,
        "unit": 100 * metres,
    }
    # A name that USD has never seen: it may hold on to the layer of one that failed.
    unfinished = target.with_name(f".{target.stem}.{uuid.uuid4().hex}{target.suffix}")
    try:
        stage = _new_stage(unfinished)
        _describe(stage, groom, metres, moments, frames_per_second)
        stage.SetDefaultPrim(UsdGeom.Xform.Define(stage, prim).GetPrim())
        Usd.ModelAPI(stage.GetDefaultPrim()).SetKind(Kind.Tokens.component)
        chunks = [(f"chunk_{i:05}", [i]) for i in groom.chunks]
        for name, numbers in chunks if prim_per_chunk else [("strands", groom.chunks)]:
            place = f"{prim}/{name}"
            for i in range(0, max(1, len(moments)), _MOST_TIMES):
                batch = moments[i : i + _MOST_TIMES] or None
                curves = groom.expand(numbers, batch, **asked)
                if len(curves) or not prim_per_chunk:
                    add_curves(stage, place, curves)
        stage.GetRootLayer().Save()
        stage = None
        os.replace(unfinished, target)
    finally:
        unfinished.unlink(missing_ok=True)
    opened = Sdf.Layer.Find(str(target.resolve()))
    if opened:
        opened.Reload(force=True)


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
    times: tuple[float, ...],
    frames_per_second: float,
) -> None:
    ups = {(0.0, 1.0, 0.0): UsdGeom.Tokens.y, (0.0, 0.0, 1.0): UsdGeom.Tokens.z}
    up = tuple(float(value) for value in groom.info.up)
    if up not in ups:
        raise InputError(f"scene.up: USD knows Y and Z alone; this groom has {up}")
    UsdGeom.SetStageUpAxis(stage, ups[up])
    UsdGeom.SetStageMetersPerUnit(stage, metres)
    if times:
        stage.SetTimeCodesPerSecond(frames_per_second)
        stage.SetFramesPerSecond(frames_per_second)
        stage.SetStartTimeCode(min(times))
        stage.SetEndTimeCode(max(times))


def add_curves(stage: Any, path: str, curves: Curves) -> Any:
    """Puts curves at a path of a stage, in units of the stage: as they are, without a
    transform. At times that curves were asked for they are time samples, and those that
    are there stay; they must be of the same strands. Returns the UsdGeom.BasisCurves.
    """
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
    """Once for all times, as Lancret's strands have as many points at one as at others."""
    attribute = made.CreateCurveVertexCountsAttr()
    counts = Vt.IntArray.FromNumpy(curves.counts.astype(np.int32))
    ids = _as_ints(curves.ids)
    primvar = UsdGeom.PrimvarsAPI(made).GetPrimvar("id")
    before = primvar.Get() if primvar else None
    if attribute.HasAuthoredValue() and (attribute.Get() != counts or before != ids):
        raise InputError(
            f"{made.GetPath()}: has curves with other ids or numbers of points; add all "
            "times of the same strands, or to another path"
        )
    attribute.Set(counts)


def _as_ints(ids: Any) -> Any:
    return None if ids is None else Vt.IntArray.FromNumpy(ids.astype(np.int32))


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
        add("id", types.IntArray, _as_ints(curves.ids))
    if curves.root_uv is not None:
        uvs = Vt.Vec2fArray.FromNumpy(np.ascontiguousarray(curves.root_uv))
        add("st", types.TexCoord2fArray, uvs)
    if curves.lengths is not None:
        add("hairLength", types.FloatArray, Vt.FloatArray.FromNumpy(curves.lengths))
    if curves.random is not None:
        add("hairRandom", types.FloatArray, Vt.FloatArray.FromNumpy(curves.random))
