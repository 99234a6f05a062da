"""From a Lancret object's settings to what `lancret.open` is given."""

from __future__ import annotations

import dataclasses
from typing import Any

import bpy
import numpy as np

from . import opened, scene_guides
from .package import lancret
from .strands import from_blender, up_axis


class Fault(Exception):
    """What the user can set right; the text goes to the panel."""


@dataclasses.dataclass(eq=False)
class Source:
    path: str | None = None
    parameters: dict[str, Any] = dataclasses.field(default_factory=dict)
    strands: Any = None
    scalp: Any = None
    chunk_strands: int = 0


def cm_per_unit(scene: bpy.types.Scene) -> float:
    return 100 * scene.unit_settings.scale_length


def source_of(thing: bpy.types.Object, scene: bpy.types.Scene) -> Source:
    """Of objects as they stood when `update_objects` was last called. Raises Fault, or
    lancret.Error where a file cannot be used."""
    told = thing.lancret
    made = Source(parameters=parameters_of(told), chunk_strands=told.chunk)
    graph = _layer(thing, scene).depsgraph if _of_objects(thing) else None
    if told.source == "FILE":
        if not told.file:
            raise Fault("there is no file: choose a .toml, .hair or .h5")
        made.path = bpy.path.abspath(told.file, library=thing.library)
        if told.scalp is not None:
            unit, up = opened.units(made.path)
            scale = cm_per_unit(scene) / unit
            made.scalp = _scalp(thing, told.scalp, graph, up_axis(up), scale)
    else:
        made.strands = _guides(thing, scene, graph)
        if told.scalp is not None:
            made.scalp = _scalp(thing, told.scalp, graph, "Z", 1.0)
    return made


def update_objects(things: list[bpy.types.Object], scene: bpy.types.Scene) -> None:
    """Puts guides and scalps where they are at the scene's frame: a render by itself does
    not move those that Python sees."""
    for layer in {_layer(thing, scene) for thing in things if _of_objects(thing)}:
        layer.update()


def _of_objects(thing: bpy.types.Object) -> bool:
    return thing.lancret.source == "SCENE" or thing.lancret.scalp is not None


def _layer(thing: bpy.types.Object, scene: bpy.types.Scene) -> bpy.types.ViewLayer:
    layers = [layer for layer in scene.view_layers if thing.name in layer.objects]
    return (layers or scene.view_layers)[0]


def _matrix(thing: bpy.types.Object, graph: Any) -> Any:
    return np.array(thing.evaluated_get(graph).matrix_world)


def _to_local(thing: bpy.types.Object, graph: Any) -> Any:
    return np.array(thing.evaluated_get(graph).matrix_world.inverted_safe())


def parameters_of(told: Any) -> dict[str, Any]:
    """What the panel lays over the groom. Points do not adapt: with longer pieces Cycles,
    which turns the ends by itself, would be off there by more than the tolerance."""
    said: dict[str, Any] = {"strands.adapt": False}
    if told.count > 0:
        said["strands.count"] = told.count
    if told.blend != "GROOM":
        said["strands.blend"] = told.blend
    if told.neighbours > 0:
        said["strands.neighbours"] = told.neighbours
    if told.seed >= 0:
        said["strands.seed"] = told.seed
    if told.root_width > 0:
        said["width.root"] = told.root_width
        said["width.tip"] = told.tip_width
    return said


def _guides(thing: bpy.types.Object, scene: bpy.types.Scene, graph: Any) -> Any:
    objects = [one.object for one in thing.lancret.guides if one.object is not None]
    if not objects:
        raise Fault("there are no guides: select curves and take them")
    to_local = _to_local(thing, graph)
    points, counts = [], []
    for one in objects:
        found, sizes = scene_guides.read(one, graph)
        matrix = to_local @ _matrix(one, graph)
        points.append(_transformed(found, matrix))
        counts.append(sizes)
    counts_of_all = np.concatenate(counts)
    if not len(counts_of_all):
        raise Fault(f"{objects[0].name}: has no strands of two points or more")
    return lancret().Strands(
        points=np.concatenate(points),
        counts=counts_of_all,
        basis="catmull-rom",
        metres_per_unit=scene.unit_settings.scale_length,
        up="Z",
    )


def _scalp(thing: Any, scalp: bpy.types.Object, graph: Any, up: str, scale: float) -> Any:
    """Its mesh, without modifiers, in the groom's axes and units."""
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
    matrix = _to_local(thing, graph) @ _matrix(scalp, graph)
    if np.linalg.det(matrix[:3, :3]) < 0:  # a mirror would turn the inside out
        corners = corners[:, ::-1]
        uvs = None if uvs is None else uvs[:, ::-1]
    local = _transformed(positions, matrix)
    return lancret().Mesh(
        positions=from_blender(local, up) * np.float32(scale),
        corners=corners.astype(np.uint32),
        uvs=uvs,
    )


def _transformed(points: Any, matrix: Any) -> Any:
    """Unchanged, to the bit, by the identity."""
    if np.array_equal(matrix, np.eye(4)):
        return points
    moved = points.astype(np.float64) @ matrix[:3, :3].T + matrix[:3, 3]
    return moved.astype(np.float32)
