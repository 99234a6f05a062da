"""Grows a Lancret object's strands: a share for the viewport, all for a render."""

from __future__ import annotations

import traceback
from typing import Any

import bpy

from . import opened, strand_object, strands
from .package import lancret
from .sources import Fault, cm_per_unit, source_of


def in_viewport(thing: bpy.types.Object) -> bool:
    """Into the points that the viewport shows. False where it cannot, with the reason in
    `lancret.error`; the strands are then those of before."""
    told = thing.lancret

    def work() -> None:
        strand_object.prepare(thing)
        scene = bpy.context.scene
        groom, grown = _strands(thing, scene, told.viewport)
        strand_object.write(told.points.data, grown)
        info = groom.info
        told.strands, told.all_strands = len(grown), info.strands
        told.first_frame, told.last_frame = info.first_frame, info.last_frame
        told.end_error = grown.end_error * cm_per_unit(scene)

    return _guarded(thing, work)


def in_full(
    thing: bpy.types.Object, scene: bpy.types.Scene, mesh: bpy.types.Mesh
) -> bool:
    """All strands at the scene's frame into a mesh of the caller's."""

    def work() -> None:
        strand_object.prepare(thing)
        strand_object.write(mesh, _strands(thing, scene, 0, blur=True)[1])

    return _guarded(thing, work)


def _strands(
    thing: bpy.types.Object, scene: bpy.types.Scene, density: float, blur: bool = False
) -> tuple[Any, strands.Strands]:
    told = thing.lancret
    unit = cm_per_unit(scene)
    groom = opened.groom(source_of(thing, scene))
    times = times_of(groom.info, scene, blur)
    curves = groom.expand(
        times=times,
        basis=strands.BASIS,
        density=density,
        max_error=told.max_error / unit,
        attributes=(),
        unit=unit,
    )
    a_second = scene.render.fps / scene.render.fps_base
    up = strands.up_axis(groom.info.up)
    return groom, strands.drawn(curves, up, times, a_second)


def times_of(info: Any, scene: bpy.types.Scene, blur: bool) -> tuple[float, ...]:
    """The frame, within the groom's; for motion blur with the shutter's ends about it,
    as Cycles moves points evenly to both sides of the frame."""
    if info.last_frame <= info.first_frame:
        return ()

    def within(time: float) -> float:
        return min(max(time, float(info.first_frame)), float(info.last_frame))

    now = scene.frame_current_final
    if not (blur and scene.render.use_motion_blur):
        return (within(now),)
    half = scene.render.motion_blur_shutter / 2
    return (within(now - half), within(now), within(now + half))


def _guarded(thing: bpy.types.Object, work: Any) -> bool:
    told = thing.lancret
    try:
        work()
    except Fault as fault:
        text = str(fault)
    except ImportError as fault:
        text = f"the Python package lancret is not there: {fault}"
    except Exception as fault:
        text = str(fault) or type(fault).__name__
        if not isinstance(fault, lancret().Error):
            traceback.print_exc()
    else:
        told.error = ""
        return True
    told.error = text
    print(f"lancret: {thing.name}: {text}")
    return False
