"""Turns a Lancret object's settings into the arguments of `lancret.open`."""

from __future__ import annotations

from typing import Any

import bpy
import numpy as np

from . import groom_cache, scene_guides
from .package import lancret
from .source import Fault, Source
from .strands import from_blender, up_axis


def cm_per_unit(scene: bpy.types.Scene) -> float:
    return 100 * scene.unit_settings.scale_length


def source_of(obj: bpy.types.Object, scene: bpy.types.Scene) -> Source:
    """The source of an object; guides and scalp are where they were when
    `update_scene_objects` was last called. Raises Fault, or lancret.Error if a file cannot
    be used."""
    settings = obj.lancret
    source = Source(parameters=parameters_of(settings), chunk_strands=settings.chunk)
    graph = _layer(obj, scene).depsgraph if _uses_objects(obj) else None
    if settings.source == "FILE":
        if not settings.file:
            raise Fault("no file: choose a .toml, .hair or .h5 file")
        source.path = bpy.path.abspath(settings.file, library=obj.library)
        if settings.scalp is not None:
            unit, up = groom_cache.units(source.path)
            scale = cm_per_unit(scene) / unit
            source.scalp = _scalp(obj, settings.scalp, graph, up_axis(up), scale)
    else:
        source.strands = _guides(obj, scene, graph)
        if settings.scalp is not None:
            source.scalp = _scalp(obj, settings.scalp, graph, "Z", 1.0)
    return source


def update_scene_objects(objects: list[bpy.types.Object], scene: bpy.types.Scene) -> None:
    """Moves guides and scalps to the scene's frame, because a render does not move the
    objects that Python sees."""
    for layer in {_layer(obj, scene) for obj in objects if _uses_objects(obj)}:
        layer.update()


def _uses_objects(obj: bpy.types.Object) -> bool:
    return obj.lancret.source == "SCENE" or obj.lancret.scalp is not None


def _layer(obj: bpy.types.Object, scene: bpy.types.Scene) -> bpy.types.ViewLayer:
    layers = [layer for layer in scene.view_layers if obj.name in layer.objects]
    return (layers or scene.view_layers)[0]


def _matrix(obj: bpy.types.Object, graph: Any) -> Any:
    return np.array(obj.evaluated_get(graph).matrix_world)


def _to_local(obj: bpy.types.Object, graph: Any) -> Any:
    return np.array(obj.evaluated_get(graph).matrix_world.inverted_safe())


def parameters_of(settings: Any) -> dict[str, Any]:
    """The panel's overrides of the groom. Points do not adapt, because Cycles computes the
    end tangents itself, and with longer segments would exceed the tolerance there."""
    values: dict[str, Any] = {"strands.adapt": False}
    if settings.count > 0:
        values["strands.count"] = settings.count
    if settings.blend != "GROOM":
        values["strands.blend"] = settings.blend
    if settings.neighbours > 0:
        values["strands.neighbours"] = settings.neighbours
    if settings.seed >= 0:
        values["strands.seed"] = settings.seed
    if settings.root_width > 0:
        values["width.root"] = settings.root_width
        values["width.tip"] = settings.tip_width
    return values


def _guides(obj: bpy.types.Object, scene: bpy.types.Scene, graph: Any) -> Any:
    objects = [guide.object for guide in obj.lancret.guides if guide.object is not None]
    if not objects:
        raise Fault("no guides: select curves and press Use Selected Curves")
    to_local = _to_local(obj, graph)
    points, counts = [], []
    for guides in objects:
        local_points, local_counts = scene_guides.read(guides, graph)
        matrix = to_local @ _matrix(guides, graph)
        points.append(_transformed(local_points, matrix))
        counts.append(local_counts)
    all_counts = np.concatenate(counts)
    if not len(all_counts):
        raise Fault(f"{objects[0].name}: has no strands of two points or more")
    return lancret().Strands(
        points=np.concatenate(points),
        counts=all_counts,
        basis="catmull-rom",
        metres_per_unit=scene.unit_settings.scale_length,
        up="Z",
    )


def _scalp(obj: Any, scalp: bpy.types.Object, graph: Any, up: str, scale: float) -> Any:
    """The scalp's mesh, without modifiers, in the groom's axes and units."""
    mesh = scalp.data
    mesh.calc_loop_triangles()
    positions = np.empty((len(mesh.vertices), 3), dtype=np.float32)
    mesh.vertices.foreach_get("co", positions.ravel())
    corners = np.empty((len(mesh.loop_triangles), 3), dtype=np.int32)
    mesh.loop_triangles.foreach_get("vertices", corners.ravel())
    uvs = None
    if mesh.uv_layers.active is not None:
        loops = np.empty(len(corners) * 3, dtype=np.int32)
        mesh.loop_triangles.foreach_get("loops", loops)
        values = np.empty((len(mesh.loops), 2), dtype=np.float32)
        mesh.uv_layers.active.data.foreach_get("uv", values.ravel())
        uvs = values[loops].reshape(-1, 3, 2)
    matrix = _to_local(obj, graph) @ _matrix(scalp, graph)
    if np.linalg.det(matrix[:3, :3]) < 0:  # a mirror would flip the normals
        corners = corners[:, ::-1]
        uvs = None if uvs is None else uvs[:, ::-1]
    local = _transformed(positions, matrix)
    return lancret().Mesh(
        positions=from_blender(local, up) * np.float32(scale),
        corners=corners.astype(np.uint32),
        uvs=uvs,
    )


def _transformed(points: Any, matrix: Any) -> Any:
    """The identity leaves every bit unchanged."""
    if np.array_equal(matrix, np.eye(4)):
        return points
    moved = points.astype(np.float64) @ matrix[:3, :3].T + matrix[:3, 3]
    return moved.astype(np.float32)
