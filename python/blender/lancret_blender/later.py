"""Grows objects anew soon after something of them has changed, once for many changes."""

from __future__ import annotations

import bpy

_WAIT_SECONDS = 0.15
_names: set[str] = set()


def update(thing: bpy.types.Object) -> None:
    """From the timer, as a property's callback is no place to make data in. Without a
    window there are no timers: scripts call bpy.ops.object.lancret_update()."""
    if bpy.app.background or not thing.lancret.enabled:
        return
    _names.add(thing.name)
    if not bpy.app.timers.is_registered(_tick):
        bpy.app.timers.register(_tick, first_interval=_WAIT_SECONDS)


def forget() -> None:
    _names.clear()
    if bpy.app.timers.is_registered(_tick):
        bpy.app.timers.unregister(_tick)


def _tick() -> float | None:
    from . import grow, handlers, settings

    if handlers.rendering():
        return _WAIT_SECONDS
    while _names:
        thing = bpy.data.objects.get(_names.pop())
        if thing is not None and settings.is_lancret(thing):
            grow.anew(thing, bpy.context.scene)
    return None
