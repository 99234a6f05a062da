"""Regrows objects shortly after a change, once for several changes."""

from __future__ import annotations

import bpy

from . import grow, render_state
from .objects import is_lancret

_WAIT_SECONDS = 0.15
_names: set[str] = set()


def update(obj: bpy.types.Object) -> None:
    """Schedules a regrow. A timer does it, because the callback of a property must not
    create data. Without a window there are no timers; scripts call
    bpy.ops.object.lancret_update()."""
    if bpy.app.background or not obj.lancret.enabled:
        return
    _names.add(obj.name)
    if not bpy.app.timers.is_registered(_tick):
        bpy.app.timers.register(_tick, first_interval=_WAIT_SECONDS)


def forget() -> None:
    """Drops everything that is scheduled."""
    _names.clear()
    if bpy.app.timers.is_registered(_tick):
        bpy.app.timers.unregister(_tick)


def _tick() -> float | None:
    if render_state.rendering():
        return _WAIT_SECONDS
    while _names:
        obj = bpy.data.objects.get(_names.pop())
        if obj is not None and is_lancret(obj):
            grow.regrow(obj, bpy.context.scene)
    return None
