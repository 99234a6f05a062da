"""Grows a Lancret object's strands: a share for the viewport, all for a render."""

from __future__ import annotations

import sys
import traceback
from typing import Any

import bpy

from . import opened, strand_object, strands
from .package import lancret
from .sources import Fault, cm_per_unit, source_of, update_objects


def anew(thing: bpy.types.Object, scene: bpy.types.Scene) -> bool:
    """What the user asks for: as `in_viewport`, and what a render could not do is past."""
    thing.lancret.render_error = ""
    return in_viewport(thing, scene)


def in_viewport(thing: bpy.types.Object, scene: bpy.types.Scene) -> bool:
    """Into the points that the viewport shows. False where it cannot, with the reason in
    `lancret.error`; the strands are then those of before."""
    told = thing.lancret

    def work() -> None:
        strand_object.prepare(thing)
        update_objects([thing], scene)
        groom, grown = _strands(thing, scene, told.viewport)
        strand_object.write(told.points.data, grown)
        info = groom.info
        told.strands, told.all_strands = len(grown), info.strands
        told.first_frame, told.last_frame = info.first_frame, info.last_frame
        told.end_error = grown.end_error * cm_per_unit(scene)

    told.error = _fault_of(thing, work)
    return not told.error


def in_full(
    thing: bpy.types.Object, scene: bpy.types.Scene, mesh: bpy.types.Mesh
) -> bool:
    """All strands at the scene's frame into a mesh of the caller's, who has called
    `update_objects`. False where it cannot:
    the mesh stays empty, and `lancret.render_error` keeps the first reason."""

    def work() -> None:
        strand_object.prepare(thing)
        strand_object.write(mesh, _strands(thing, scene, 0, blur=True)[1])

    text = _fault_of(thing, work)
    told = thing.lancret
    if text and not told.render_error:
        told.render_error = f"frame {scene.frame_current}: {text}"
    return not text


def _strands(
    thing: bpy.types.Object, scene: bpy.types.Scene, density: float, blur: bool = False
) -> tuple[Any, strands.Strands]:
    told = thing.lancret
    unit = cm_per_unit(scene)
    groom = opened.groom(source_of(thing, scene), thing.name_full)
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
    """The frame, within the groom's; for motion blur the shutter's middle between its
    ends, as Cycles moves points evenly to both sides."""
    if info.last_frame <= info.first_frame:
        return ()

    def within(time: float) -> float:
        return min(max(time, float(info.first_frame)), float(info.last_frame))

    now = scene.frame_current_final
    if not (blur and scene.render.use_motion_blur):
        return (within(now),)
    half = scene.render.motion_blur_shutter / 2
    now += {"START": half, "END": -half}.get(_blur_position(scene), 0)
    return (within(now - half), within(now), within(now + half))


def _blur_position(scene: bpy.types.Scene) -> str:
    for settings in (scene.render, getattr(scene, "cycles", None)):  # 4.2; before
        if hasattr(settings, "motion_blur_position"):
            return str(settings.motion_blur_position)
    return "CENTER"


def _fault_of(thing: bpy.types.Object, work: Any) -> str:
    """What keeps `work` from being done, for the panel; "" where it is done."""
    try:
        work()
    except Fault as fault:
        text = str(fault)
    except ImportError as fault:
        found = getattr(sys.modules.get("lancret"), "LibraryNotFound", ())
        text = str(fault)
        if not isinstance(fault, found):
            text = f"the Python package lancret is not there: {text}"
    except Exception as fault:
        text = str(fault) or type(fault).__name__
        if not isinstance(fault, lancret().Error):
            traceback.print_exc()
    else:
        return ""
    print(f"lancret: {thing.name}: {text}", file=sys.stderr, flush=True)
    return text
