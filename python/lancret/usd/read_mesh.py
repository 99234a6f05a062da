"""Reads a mesh that hair grows on."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

import numpy as np

from ..errors import InputError
from ..geometry import Mesh
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


def read_mesh(
    source: Any,
    prim: str | None = None,
    time: float | None = None,
    uv: str | None = None,
    *,
    purposes: Collection[str] = PURPOSES,
) -> Mesh:
    """A mesh in world space and the stage's units. Faces become fans of triangles from
    their first corner, holes are left out, and subdivision surfaces are read as their
    control mesh.

    prim: the mesh or an ancestor; None: the only mesh of the stage that is visible and has
        one of the `purposes`.
    time: as in `read`.
    uv: the primvar with texture coordinates; None: `st`, else the first with two
        components.
    """
    stage = stage_of(source)
    found = prims_of(stage, prim, UsdGeom.Mesh, time, purposes)
    if len(found) > 1:
        paths = ", ".join(str(each.GetPath()) for each in found[:8])
        raise InputError(
            f"{stage.GetRootLayer().identifier}: has {len(found)} meshes; choose one with "
            f"`prim`: {paths}"
        )
    return _read_prim(found[0], moment(found[0], time), uv)


def _read_prim(prim: Any, time: Any, uv: str | None) -> Mesh:
    mesh = UsdGeom.Mesh(prim)
    points = array_of(mesh.GetPointsAttr(), time, (-1, 3), np.float64)
    counts = array_of(mesh.GetFaceVertexCountsAttr(), time, (-1,), np.int64)
    indices = array_of(mesh.GetFaceVertexIndicesAttr(), time, (-1,), np.int64)
    name = name_of(prim)
    if counts.size == 0 or counts.min() < 3 or counts.sum() != len(indices):
        raise InputError(
            f"{name}: faceVertexCounts must be 3 or more each and add up to "
            f"{len(indices)} corners"
        )
    if indices.min() < 0 or indices.max() >= len(points):
        raise InputError(
            f"{name}: faceVertexIndices must be from 0 to {len(points) - 1}"
        )
    matrix = matrix_of(prim, time)
    holes = array_of(mesh.GetHoleIndicesAttr(), time, (-1,), np.int64)
    kept = ~np.isin(np.arange(len(counts)), holes)
    corners = _fans(counts)[np.repeat(kept, counts - 2)]
    left_handed = str(mesh.GetOrientationAttr().Get()) == "leftHanded"
    mirrored = np.linalg.det(matrix[:3, :3]) < 0
    if left_handed != mirrored:
        corners = corners[:, ::-1]
    uvs = _uvs(prim, time, uv, indices, len(points))
    return Mesh(
        positions=to_world(points, matrix),
        corners=indices[corners],
        uvs=None if uvs is None else uvs[corners],
    )


def _fans(counts: np.ndarray) -> np.ndarray:
    """[triangles][3] indices of corners; each face is a fan from its first corner."""
    starts = np.cumsum(counts) - counts
    triangles = counts - 2
    first = np.repeat(starts, triangles)
    second = np.arange(triangles.sum()) - np.repeat(
        np.cumsum(triangles) - triangles, triangles
    )
    return np.stack([first, first + second + 1, first + second + 2], axis=1)


def _uvs(
    prim: Any, time: Any, uv: str | None, indices: np.ndarray, points: int
) -> np.ndarray | None:
    """[corners][2]; None if no primvar matches."""
    primvars = UsdGeom.PrimvarsAPI(prim)
    names = (
        [uv]
        if uv
        else ["st"]
        + [str(each.GetPrimvarName()) for each in primvars.GetPrimvarsWithValues()]
    )
    for name in names:
        primvar = primvars.GetPrimvar(name)
        value = primvar.ComputeFlattened(time) if primvar else None
        if value is None or np.array(value).shape[1:] != (2,):
            continue
        values: np.ndarray = np.array(value, dtype=np.float32)
        kind = str(primvar.GetInterpolation())
        if kind == "faceVarying" and len(values) == len(indices):
            return values
        if kind in ("vertex", "varying") and len(values) == points:
            of_corners: np.ndarray = values[indices]
            return of_corners
    if uv:
        raise InputError(
            f"{name_of(prim)}: has no primvar {uv} with two components per corner"
        )
    return None
