"""Writes strands as BasisCurves."""

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
#: Maximum number of times in memory at once.
_MAX_TIMES = 64


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
    """Grows a groom into a .usd, .usda or .usdc file, which appears once it is complete.

    The strands are BasisCurves below `prim`, in metres_per_unit (None: the groom's unit)
    and with the groom's up axis. They are in one prim, or in one per chunk; then only one
    chunk at a time is in memory besides the stage. `times` become time samples; None: the
    first frame, or rest. Attributes become primvars: ids `id`, root_uv `st`, lengths
    `hairLength`, random `hairRandom`; normals become the curves' normals; others cannot be
    written. Stages of this process that have the file open are reloaded.
    """
    target = Path(path)
    if target.suffix not in _EXTENSIONS:
        raise InputError(f"{target}: extension must be one of {', '.join(_EXTENSIONS)}")
    if basis not in _TYPES:
        raise InputError(f"basis {basis!r}: USD supports {', '.join(_TYPES)}")
    valid = prim.startswith("/") and Sdf.Path.IsValidPathString(prim)[0]
    if not valid or not Sdf.Path(prim).IsRootPrimPath():
        raise InputError(f"prim {prim!r}: must be a root prim, such as /Hair")
    unknown = set(attributes) - _ATTRIBUTES
    if unknown:
        raise InputError(
            f"attributes {', '.join(sorted(unknown))}: cannot be written; "
            f"{', '.join(sorted(_ATTRIBUTES))} can"
        )
    moments = moments_of(times)
    if times is not None and not moments:
        raise InputError("times: must not be empty; omit it for the first frame")
    metres = metres_per_unit or groom.info.cm_per_unit / 100
    options: dict[str, Any] = {
        "basis": basis,
        "density": density,
        "max_error": max_error,
        "attributes": attributes,
        "unit": 100 * metres,
    }
    # A unique name, because USD may keep the layer of an earlier attempt that failed.
    unfinished = target.with_name(f".{target.stem}.{uuid.uuid4().hex}{target.suffix}")
    try:
        stage = _new_stage(unfinished)
        _describe(stage, groom, metres, moments, frames_per_second)
        stage.SetDefaultPrim(UsdGeom.Xform.Define(stage, prim).GetPrim())
        Usd.ModelAPI(stage.GetDefaultPrim()).SetKind(Kind.Tokens.component)
        chunks = [(f"chunk_{i:05}", [i]) for i in groom.chunks]
        for name, numbers in chunks if prim_per_chunk else [("strands", groom.chunks)]:
            place = f"{prim}/{name}"
            for i in range(0, max(1, len(moments)), _MAX_TIMES):
                batch = moments[i : i + _MAX_TIMES] or None
                curves = groom.expand(numbers, batch, **options)
                if len(curves) or not prim_per_chunk:
                    add_curves(stage, place, curves)
        stage.GetRootLayer().Save()
        stage = None
        os.replace(unfinished, target)
    finally:
        unfinished.unlink(missing_ok=True)
    open_layer = Sdf.Layer.Find(str(target.resolve()))
    if open_layer:
        open_layer.Reload(force=True)


def _new_stage(path: Path) -> Any:
    if not path.parent.is_dir():  # USD would create it
        raise InputError(f"{path.parent}: no such folder")
    try:
        return Usd.Stage.CreateNew(str(path))
    except Tf.ErrorException:
        raise InputError(f"{path.parent}: folder is not writable") from None


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
        raise InputError(f"scene.up: is {up}; USD supports only Y and Z")
    UsdGeom.SetStageUpAxis(stage, ups[up])
    UsdGeom.SetStageMetersPerUnit(stage, metres)
    if times:
        stage.SetTimeCodesPerSecond(frames_per_second)
        stage.SetFramesPerSecond(frames_per_second)
        stage.SetStartTimeCode(min(times))
        stage.SetEndTimeCode(max(times))


def add_curves(stage: Any, path: str, curves: Curves) -> Any:
    """Adds curves to a stage, in the stage's units, without a transform. Curves with
    `times` become time samples, in addition to existing ones, which must be of the same
    strands. Returns the UsdGeom.BasisCurves.
    """
    if curves.basis not in _TYPES:
        raise InputError(
            f"{path}: basis {curves.basis!r}: USD supports {', '.join(_TYPES)}"
        )
    prim = UsdGeom.BasisCurves.Define(stage, path)
    kind, basis = _TYPES[curves.basis]
    prim.CreateTypeAttr(kind)
    if basis:
        prim.CreateBasisAttr(basis)
    prim.CreateWrapAttr(UsdGeom.Tokens.nonperiodic)
    prim.SetWidthsInterpolation(UsdGeom.Tokens.vertex)
    _set_counts(prim, curves)
    for i, time in enumerate(curves.times or (None,)):
        _set_sample(prim, curves, i, Usd.TimeCode(time) if curves.times else _default())
    _set_primvars(prim, curves)
    return prim


def _default() -> Any:
    return Usd.TimeCode.Default()


def _set_counts(prim: Any, curves: Curves) -> None:
    """Sets the counts, which are the same at all times."""
    attribute = prim.CreateCurveVertexCountsAttr()
    counts = Vt.IntArray.FromNumpy(curves.counts.astype(np.int32))
    ids = _as_ints(curves.ids)
    primvar = UsdGeom.PrimvarsAPI(prim).GetPrimvar("id")
    before = primvar.Get() if primvar else None
    if attribute.HasAuthoredValue() and (attribute.Get() != counts or before != ids):
        raise InputError(
            f"{prim.GetPath()}: has curves with different ids or numbers of points; add "
            "the same strands at all times, or use another path"
        )
    attribute.Set(counts)


def _as_ints(ids: Any) -> Any:
    return None if ids is None else Vt.IntArray.FromNumpy(ids.astype(np.int32))


def _set_sample(prim: Any, curves: Curves, index: int, time: Any) -> None:
    points = np.ascontiguousarray(curves.positions[index, :, :3])
    widths = 2 * curves.positions[index, :, 3]
    prim.CreatePointsAttr().Set(Vt.Vec3fArray.FromNumpy(points), time)
    prim.CreateWidthsAttr().Set(Vt.FloatArray.FromNumpy(widths), time)
    if curves.normals is not None:
        normals = np.ascontiguousarray(curves.normals[index, :, :3])
        prim.CreateNormalsAttr().Set(Vt.Vec3fArray.FromNumpy(normals), time)
        prim.SetNormalsInterpolation(UsdGeom.Tokens.vertex)
    if len(points):
        extent = UsdGeom.Boundable.ComputeExtentFromPlugins(prim, time)
        prim.CreateExtentAttr().Set(extent, time)


def _set_primvars(prim: Any, curves: Curves) -> None:
    primvars = UsdGeom.PrimvarsAPI(prim)
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
