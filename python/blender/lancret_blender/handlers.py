"""What happens at a render, a change of frame and another file.

A render: `render_pre` comes before each frame, when the scene is at it and nothing has
been evaluated; there each object gets a mesh with all its strands in place of the
viewport's, which is put back at the end; an empty one where they cannot be grown, so that
hair is missing rather than wrong. Blender also says `frame_change_pre` in a
render, for each moment of motion blur: that is passed over.
"""

from __future__ import annotations

from typing import Any

import bpy
from bpy.app.handlers import persistent

from . import grow, later, opened, sources
from .settings import is_lancret

_viewport: dict[str, str] = {}  # of points objects, the mesh that the viewport shows
_unfilled: set[str] = set()  # objects whose points were made in a render
_rendering = False


def rendering() -> bool:
    return _rendering


def _lancret_objects(
    scene: bpy.types.Scene, rendered: bool = False
) -> list[bpy.types.Object]:
    """Of a scene, those of instanced collections too; or what a render shows of them."""
    found, seen = {}, set()

    def walk(collection: bpy.types.Collection) -> None:
        if collection in seen or (rendered and collection.hide_render):
            return
        seen.add(collection)
        for one in collection.objects:
            if rendered and one.hide_render:
                continue
            if is_lancret(one):
                found[one.name_full] = one
            if one.instance_type == "COLLECTION" and one.instance_collection:
                walk(one.instance_collection)
        for child in collection.children:
            walk(child)

    walk(scene.collection)
    return list(found.values())


@persistent
def _render_init(_scene: bpy.types.Scene, *_: Any) -> None:
    global _rendering
    _rendering = True


@persistent
def _render_pre(scene: bpy.types.Scene, *_: Any) -> None:
    _put_back()  # the frame before
    things = _lancret_objects(scene, rendered=True)
    sources.update_objects(things, scene)
    for thing in things:
        if thing.lancret.points is None:
            _unfilled.add(thing.name)
        full = bpy.data.meshes.new(f"{thing.name} in full")
        grow.in_full(thing, scene, full)
        points = thing.lancret.points
        if points is None:
            bpy.data.meshes.remove(full)
            continue
        _viewport[points.name] = points.data.name
        points.data = full


@persistent
def _render_end(scene: bpy.types.Scene, *_: Any) -> None:
    global _rendering
    _rendering = False
    _put_back()
    while _unfilled:
        thing = bpy.data.objects.get(_unfilled.pop())
        if thing is not None and is_lancret(thing):
            grow.in_viewport(thing, scene)


def _put_back() -> None:
    """What the viewport shows."""
    while _viewport:
        name, mesh = _viewport.popitem()
        points = bpy.data.objects.get(name)
        if points is None or mesh not in bpy.data.meshes:
            continue
        full = points.data
        points.data = bpy.data.meshes[mesh]
        bpy.data.meshes.remove(full)


@persistent
def _frame_change(scene: bpy.types.Scene, *_: Any) -> None:
    if _rendering:
        return
    for thing in _lancret_objects(scene):
        told = thing.lancret
        if told.last_frame > told.first_frame:
            grow.in_viewport(thing, scene)


@persistent
def _load_pre(*_: Any) -> None:
    global _rendering
    _rendering = False
    _viewport.clear()
    _unfilled.clear()
    later.forget()
    opened.forget()


_HANDLERS = (
    ("render_init", _render_init),
    ("render_pre", _render_pre),
    ("render_complete", _render_end),
    ("render_cancel", _render_end),
    ("frame_change_pre", _frame_change),
    ("load_pre", _load_pre),
)


def register() -> None:
    for name, handler in _HANDLERS:
        getattr(bpy.app.handlers, name).append(handler)


def unregister() -> None:
    for name, handler in _HANDLERS:
        getattr(bpy.app.handlers, name).remove(handler)
    later.forget()
    opened.close()
