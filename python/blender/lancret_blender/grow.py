"""Grows a Lancret object's strands: a share for the viewport, all for a render."""

from __future__ import annotations

import sys
import traceback
from typing import Any

import bpy

from . import groom_cache, strand_object, strands
from .package import lancret
from .scene_source import cm_per_unit, source_of, update_scene_objects
from .source import Fault


def regrow(obj: bpy.types.Object, scene: bpy.types.Scene) -> bool:
    """Like `in_viewport`, on the user's request, and clears the last render error."""
    obj.lancret.render_error = ""
    return in_viewport(obj, scene)


def in_viewport(obj: bpy.types.Object, scene: bpy.types.Scene) -> bool:
    """Grows the viewport's share into the object's points. On failure returns False, sets
    `lancret.error` and leaves the strands unchanged."""
    settings = obj.lancret

    def work() -> None:
        strand_object.prepare(obj)
        update_scene_objects([obj], scene)
        groom, grown = _strands(obj, scene, settings.viewport)
        strand_object.write(settings.points.data, grown)
        info = groom.info
        settings.strands, settings.all_strands = len(grown), info.strands
        settings.first_frame, settings.last_frame = info.first_frame, info.last_frame
        settings.end_error = grown.end_error * cm_per_unit(scene)

    settings.error = _error_of(obj, work)
    return not settings.error


def for_render(
    obj: bpy.types.Object, scene: bpy.types.Scene, mesh: bpy.types.Mesh
) -> bool:
    """Grows all strands at the scene's frame into `mesh`. Call `update_scene_objects`
    first. On failure returns False and leaves `mesh` empty; `lancret.render_error` keeps
    the first error."""

    def work() -> None:
        strand_object.prepare(obj)
        strand_object.write(mesh, _strands(obj, scene, 0, blur=True)[1])

    text = _error_of(obj, work)
    settings = obj.lancret
    if text and not settings.render_error:
        settings.render_error = f"frame {scene.frame_current}: {text}"
    return not text


def _strands(
    obj: bpy.types.Object, scene: bpy.types.Scene, density: float, blur: bool = False
) -> tuple[Any, strands.Strands]:
    settings = obj.lancret
    unit = cm_per_unit(scene)
    groom = groom_cache.groom(source_of(obj, scene), obj.name_full)
    times = times_of(groom.info, scene, blur)
    curves = groom.expand(
        times=times,
        basis=strands.BASIS,
        density=density,
        max_error=settings.max_error / unit,
        attributes=(),
        unit=unit,
    )
    fps = scene.render.fps / scene.render.fps_base
    up = strands.up_axis(groom.info.up)
    return groom, strands.drawn(curves, up, times, fps)


def times_of(info: Any, scene: bpy.types.Scene, blur: bool) -> tuple[float, ...]:
    """The scene's frame, clamped to those of the groom; empty if the groom does not move.
    With motion blur: start, middle and end of the shutter, because Cycles moves points
    evenly to both sides of the middle."""
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
    # Blender 4.2 and newer have it in the first place, older ones in the second.
    for settings in (scene.render, getattr(scene, "cycles", None)):
        if hasattr(settings, "motion_blur_position"):
            return str(settings.motion_blur_position)
    return "CENTER"


def _error_of(obj: bpy.types.Object, work: Any) -> str:
    """Runs `work` and returns the text of its error, for the panel; "" if it succeeds."""
    try:
        work()
    except Fault as fault:
        text = str(fault)
    except ImportError as fault:
        not_found = getattr(sys.modules.get("lancret"), "LibraryNotFound", ())
        text = str(fault)
        if not isinstance(fault, not_found):
            text = f"the Python package lancret cannot be imported: {text}"
    except Exception as fault:
        text = str(fault) or type(fault).__name__
        if not isinstance(fault, lancret().Error):
            traceback.print_exc()
    else:
        return ""
    print(f"lancret: {obj.name}: {text}", file=sys.stderr, flush=True)
    return text
