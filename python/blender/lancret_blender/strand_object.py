"""The objects that hold strands in Blender.

A Lancret object is an (empty) hair Curves object: Cycles draws nothing else as hair. Its
strands are a mesh of edges, of an object that no collection has, and geometry nodes make
curves of them whenever Blender evaluates the object. That way everything can be written
from Python at once and anywhere, in a render's handlers too; Blender 3.4 has no call that
would resize Curves.
"""

from __future__ import annotations

from typing import Any

import bpy
import numpy as np

from .strands import Strands

NAME = "Lancret hair"


def make(context: Any, parent: bpy.types.Object | None) -> bpy.types.Object:
    """A Lancret object without strands, at its parent's place."""
    thing = bpy.data.objects.new(NAME, bpy.data.hair_curves.new(NAME))
    context.collection.objects.link(thing)
    thing.parent = parent
    told = thing.lancret
    told.enabled = True
    told.material = material()
    # Data is written by handlers that a render calls from its own thread.
    context.scene.render.use_lock_interface = True
    prepare(thing)
    return thing


def _own_points(thing: bpy.types.Object) -> None:
    """With the strands that it was copied with, if any."""
    told = thing.lancret
    if told.points is not None:
        mesh = told.points.data.copy()
    else:
        mesh = bpy.data.meshes.new(f"{thing.name} points")
    told.points = bpy.data.objects.new(mesh.name, mesh)
    told.nodes = _nodes(told.points)


def _nodes(points: bpy.types.Object) -> bpy.types.NodeTree:
    tree = bpy.data.node_groups.new(points.name, "GeometryNodeTree")
    for way in ("INPUT", "OUTPUT"):
        if hasattr(tree, "interface"):  # Blender 4.0
            tree.interface.new_socket(
                "Geometry", in_out=way, socket_type="NodeSocketGeometry"
            )
        else:
            sockets = tree.inputs if way == "INPUT" else tree.outputs
            sockets.new("NodeSocketGeometry", "Geometry")
    source = tree.nodes.new("GeometryNodeObjectInfo")
    source.inputs["Object"].default_value = points
    curves = tree.nodes.new("GeometryNodeMeshToCurve")
    coat = tree.nodes.new("GeometryNodeSetMaterial")
    output = tree.nodes.new("NodeGroupOutput")
    for place, node in enumerate((source, curves, coat, output)):
        node.location = (200 * place, 0)
    tree.links.new(source.outputs["Geometry"], curves.inputs[0])
    tree.links.new(curves.outputs[0], coat.inputs["Geometry"])
    tree.links.new(coat.outputs[0], output.inputs[0])
    return tree


def prepare(thing: bpy.types.Object) -> None:
    """Points and nodes of its own, where it is a copy of another or they are gone; its
    modifier and material."""
    told = thing.lancret
    shared = any(
        other != thing and other.lancret.points == told.points
        for other in bpy.data.objects
        if other.type == "CURVES" and other.lancret.enabled
    )
    if told.points is None or shared:
        _own_points(thing)
    coat = _coat(told.nodes)
    if coat is None:
        told.nodes = _nodes(told.points)
        coat = _coat(told.nodes)
    if coat.inputs["Material"].default_value != told.material:
        coat.inputs["Material"].default_value = told.material
    modifier = thing.modifiers.get("Lancret") or thing.modifiers.new("Lancret", "NODES")
    if modifier.node_group != told.nodes:
        modifier.node_group = told.nodes


def _coat(tree: bpy.types.NodeTree | None) -> Any:
    """The node that sets the material; none where the tree has it no more."""
    kind = "GeometryNodeSetMaterial"
    return (
        next((one for one in tree.nodes if one.bl_idname == kind), None) if tree else None
    )


def write(mesh: bpy.types.Mesh, strands: Strands) -> None:
    """Edges from each point of a strand to the next."""
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
    """One of hair, made where there is none."""
    found = bpy.data.materials.get(NAME)
    if found is not None:
        return found
    made = bpy.data.materials.new(NAME)
    if bpy.app.version < (5, 0):
        made.use_nodes = True
    nodes = made.node_tree.nodes
    nodes.clear()
    hair = nodes.new("ShaderNodeBsdfHairPrincipled")
    hair.parametrization = "MELANIN"
    output = nodes.new("ShaderNodeOutputMaterial")
    output.location = (300, 0)
    made.node_tree.links.new(hair.outputs[0], output.inputs["Surface"])
    return made
