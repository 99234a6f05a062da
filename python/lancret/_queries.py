"""Queries of an open groom, by its C handle."""

from __future__ import annotations

import json
from ctypes import byref, c_double, c_int
from typing import Any

import numpy as np

from . import _abi
from ._library import library
from .context import Context
from .figures import Guides, Info
from .geometry import Mesh


def _copy(pointer: Any, *shape: int) -> Any:
    if 0 in shape:
        return np.empty(shape)
    return np.ctypeslib.as_array(pointer, shape).copy()


def info_of(context: Context, groom: int) -> Info:
    struct = _abi.Info()
    context.raise_for(library().lancret_groom_get_info(groom, byref(struct)))
    values = {name: getattr(struct, name) for name, *_ in _abi.Info._fields_[1:]}
    values["up"] = tuple(struct.up)
    values["box"] = tuple(struct.box[:3]), tuple(struct.box[3:])
    values["basis"] = _abi.BASIS_NAMES[struct.basis]
    values["shape"] = _abi.SHAPES[struct.shape]
    # The shortest decimal of the float32: 0.1, not 0.10000000149.
    values["cm_per_unit"] = float(str(np.float32(struct.cm_per_unit)))
    return Info(**values)


def guides_of(context: Context, groom: int) -> Guides:
    struct = _abi.Guides()
    context.raise_for(library().lancret_groom_get_guides(groom, byref(struct)))
    count, segments = struct.guides, struct.segments
    return Guides(
        root_positions=_copy(struct.root_positions, count, 3),
        root_frames=_copy(struct.root_frames, count, 3, 3),
        segment_lengths=_copy(struct.segment_lengths, count, segments),
        curvatures=_copy(struct.curvatures, count, segments, 3),
        fit_rms=_copy(struct.fit_rms, count) if struct.fit_rms else None,
    )


def description_of(context: Context, groom: int) -> dict[str, Any]:
    parts: list[bytes] = []
    sink = _abi.TextSink(lambda _user, part: parts.append(part))
    context.raise_for(library().lancret_groom_describe(groom, sink, None))
    described: dict[str, Any] = json.loads(b"".join(parts))
    return described


def head_of(context: Context, groom: int, time: float) -> Mesh:
    arrays: dict[str, Any] = {}

    def take(_user: int | None, pointer: Any) -> int:
        mesh = pointer.contents
        arrays["positions"] = _copy(mesh.positions, mesh.vertices, 3)
        arrays["corners"] = _copy(mesh.corners, mesh.triangles, 3).astype(np.uint32)
        arrays["uvs"] = _copy(mesh.uvs, mesh.triangles, 3, 2) if mesh.uvs else None
        return _abi.OK

    sink = _abi.MeshSink(take)
    context.raise_for(library().lancret_groom_get_head(groom, time, sink, None))
    return Mesh(**arrays)


def is_still(context: Context, groom: int, moments: tuple[float, ...]) -> bool:
    still, times = c_int(), (c_double * len(moments))(*moments)
    status = library().lancret_groom_is_still(groom, times, len(moments), byref(still))
    context.raise_for(status)
    return bool(still.value)
