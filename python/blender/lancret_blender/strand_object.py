"""The objects that hold strands in Blender.

A Lancret object is an empty hair Curves object, because Cycles draws only those as hair.
Its strands are the edges of a mesh whose object is in no collection; geometry nodes turn
them into curves when Blender evaluates the object. So all data can be written from Python
at any time, even in the handlers of a render; Blender 3.4 cannot resize Curves.
"""

from __future__ import annotations

from typing import Any

import bpy
import numpy as np

from .strands import Strands

NAME = "Lancret hair"


def make(context: Any, parent: bpy.types.Object | None) -> bpy.types.Object:
    """Creates a Lancret object without strands, at its parent's place."""
    obj = bpy.data.objects.new(NAME, bpy.data.hair_curves.new(NAME))
    context.collection.objects.link(obj)
    obj.parent = parent
    settings = obj.lancret
    settings.enabled = True
    settings.material = material()
    # A render calls handlers, which write data, from its own thread.
    context.scene.render.use_lock_interface = True
    prepare(obj)
    return obj


def _own_points(obj: bpy.types.Object) -> None:
    """Gives an object points and nodes of its own; a copied object keeps its strands."""
    settings = obj.lancret
    if settings.points is not None:
        mesh = settings.points.data.copy()
    else:
        mesh = bpy.data.meshes.new(f"{obj.name} points")
    settings.points = bpy.data.objects.new(mesh.name, mesh)
    settings.nodes = _nodes(settings.points)


def _nodes(points: bpy.types.Object) -> bpy.types.NodeTree:
    tree = bpy.data.node_groups.new(points.name, "GeometryNodeTree")
    for direction in ("INPUT", "OUTPUT"):
        if hasattr(tree, "interface"):  # Blender 4.0 and newer
            tree.interface.new_socket(
                "Geometry", in_out=direction, socket_type="NodeSocketGeometry"
            )
        else:
            sockets = tree.inputs if direction == "INPUT" else tree.outputs
            sockets.new("NodeSocketGeometry", "Geometry")
    source = tree.nodes.new("GeometryNodeObjectInfo")
    source.inputs["Object"].default_value = points
    curves = tree.nodes.new("GeometryNodeMeshToCurve")
    set_material = tree.nodes.new("GeometryNodeSetMaterial")
    output = tree.nodes.new("NodeGroupOutput")
    for column, node in enumerate((source, curves, set_material, output)):
        node.location = (200 * column, 0)
    tree.links.new(source.outputs["Geometry"], curves.inputs[0])
    tree.links.new(curves.outputs[0], set_material.inputs["Geometry"])
    tree.links.new(set_material.outputs[0], output.inputs[0])
    return tree


def prepare(obj: bpy.types.Object) -> None:
    """Ensures that an object has points and nodes of its own (a copy shares those of its
    original), the modifier, and its material."""
    settings = obj.lancret
    shared = any(
        other != obj and other.lancret.points == settings.points
        for other in bpy.data.objects
        if other.type == "CURVES" and other.lancret.enabled
    )
    if settings.points is None or shared:
        _own_points(obj)
    set_material = _set_material_node(settings.nodes)
    if set_material is None:
        settings.nodes = _nodes(settings.points)
        set_material = _set_material_node(settings.nodes)
    if set_material.inputs["Material"].default_value != settings.material:
        set_material.inputs["Material"].default_value = settings.material
    modifier = obj.modifiers.get("Lancret") or obj.modifiers.new("Lancret", "NODES")
    if modifier.node_group != settings.nodes:
        modifier.node_group = settings.nodes


def _set_material_node(tree: bpy.types.NodeTree | None) -> Any:
    """The node that sets the material; None if it was deleted."""
    kind = "GeometryNodeSetMaterial"
    nodes = tree.nodes if tree else ()
    return next((node for node in nodes if node.bl_idname == kind), None)


def write(mesh: bpy.types.Mesh, strands: Strands) -> None:
    """Replaces the mesh by edges from each point of a strand to the next."""
    mesh.clear_geometry()
    points = len(strands.points)
    mesh.vertices.add(points)
    mesh.vertices.foreach_set("co", np.ravel(strands.points))
    starts = np.delete(np.arange(points, dtype=np.int32), strands.last)
    edges = np.stack([starts, starts + 1], axis=-1)
    mesh.edges.add(len(edges))
    mesh.edges.foreach_set("vertices", np.ravel(edges))
    _attribute(mesh, "radius", "FLOAT", "value", strands.radii)
    if strands.velocities is not None:
        _attribute(mesh, "velocity", "FLOAT_VECTOR", "vector", strands.velocities)
    elif "velocity" in mesh.attributes:
        mesh.attributes.remove(mesh.attributes["velocity"])
    mesh.update_tag()


def _attribute(mesh: Any, name: str, kind: str, field: str, values: Any) -> None:
    attribute = mesh.attributes.get(name) or mesh.attributes.new(name, kind, "POINT")
    attribute.data.foreach_set(field, np.ravel(values))


def material() -> bpy.types.Material:
    """The default hair material, created on the first call."""
    existing = bpy.data.materials.get(NAME)
    if existing is not None:
        return existing
    created = bpy.data.materials.new(NAME)
    if bpy.app.version < (5, 0):
        created.use_nodes = True
    nodes = created.node_tree.nodes
    nodes.clear()
    hair = nodes.new("ShaderNodeBsdfHairPrincipled")
    hair.parametrization = "MELANIN"
    output = nodes.new("ShaderNodeOutputMaterial")
    output.location = (300, 0)
    created.node_tree.links.new(hair.outputs[0], output.inputs["Surface"])
    return created
