"""Handlers of renders, frame changes and the loading of files.

`render_pre` runs before each frame, when the scene is at that frame and nothing has been
evaluated yet. There each object gets a mesh with all its strands in place of the
viewport's, which is restored after the render. If the strands cannot be grown the mesh is
empty: the hair is then missing rather than wrong. During a render Blender also calls
`frame_change_pre`, for each time of the motion blur; these calls are ignored.
"""

from __future__ import annotations

from typing import Any

import bpy
from bpy.app.handlers import persistent

from . import deferred, groom_cache, grow, render_state, scene_source
from .objects import is_lancret, lancret_objects

_viewport: dict[str, str] = {}  # points object -> the mesh that its viewport shows
_unfilled: set[str] = set()  # objects whose points were created during a render


@persistent
def _render_init(_scene: bpy.types.Scene, *_: Any) -> None:
    render_state.set_rendering(True)


@persistent
def _render_pre(scene: bpy.types.Scene, *_: Any) -> None:
    _restore_viewport()  # of the previous frame
    objects = lancret_objects(scene, rendered=True)
    scene_source.update_scene_objects(objects, scene)
    for obj in objects:
        if obj.lancret.points is None:
            _unfilled.add(obj.name)
        full = bpy.data.meshes.new(f"{obj.name} for render")
        grow.for_render(obj, scene, full)
        points = obj.lancret.points
        if points is None:
            bpy.data.meshes.remove(full)
            continue
        _viewport[points.name] = points.data.name
        points.data = full


@persistent
def _render_end(scene: bpy.types.Scene, *_: Any) -> None:
    render_state.set_rendering(False)
    _restore_viewport()
    while _unfilled:
        obj = bpy.data.objects.get(_unfilled.pop())
        if obj is not None and is_lancret(obj):
            grow.in_viewport(obj, scene)


def _restore_viewport() -> None:
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
    if render_state.rendering():
        return
    for obj in lancret_objects(scene):
        settings = obj.lancret
        if settings.last_frame > settings.first_frame:
            grow.in_viewport(obj, scene)


@persistent
def _load_pre(*_: Any) -> None:
    render_state.set_rendering(False)
    _viewport.clear()
    _unfilled.clear()
    deferred.forget()
    groom_cache.forget()


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
    deferred.forget()
    groom_cache.close()
