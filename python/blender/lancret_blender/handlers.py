"""What happens at a render, a change of frame and another file.

A render: `render_pre` comes before each frame, when the scene is at it and nothing has
been evaluated; there each object gets a mesh with all its strands in place of the
viewport's, which is put back at the end. Blender also says `frame_change_pre` in a
render, for each moment of motion blur: that is passed over.
"""

from __future__ import annotations

from typing import Any

import bpy
from bpy.app.handlers import persistent

from . import grow, later, opened
from .settings import is_lancret

_viewport: dict[str, str] = {}  # of points objects, the mesh that the viewport shows
_rendering = False


def rendering() -> bool:
    return _rendering


def _lancret_objects(scene: bpy.types.Scene) -> list[bpy.types.Object]:
    return [one for one in scene.objects if is_lancret(one)]


@persistent
def _render_init(_scene: bpy.types.Scene, *_: Any) -> None:
    global _rendering
    _rendering = True


@persistent
def _render_pre(scene: bpy.types.Scene, *_: Any) -> None:
    for thing in _lancret_objects(scene):
        if thing.hide_render:
            continue
        full = bpy.data.meshes.new(f"{thing.name} in full")
        if not grow.in_full(thing, scene, full):
            bpy.data.meshes.remove(full)
            continue
        points = thing.lancret.points
        before = points.data
        points.data = full
        if points.name in _viewport:  # the frame before
            bpy.data.meshes.remove(before)
        else:
            _viewport[points.name] = before.name


@persistent
def _render_end(_scene: bpy.types.Scene, *_: Any) -> None:
    global _rendering
    _rendering = False
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
            grow.in_viewport(thing)


@persistent
def _load_pre(*_: Any) -> None:
    global _rendering
    _rendering = False
    _viewport.clear()
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
