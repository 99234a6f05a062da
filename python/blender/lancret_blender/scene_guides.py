"""Strands of the scene's objects: points on them, in the object's own space, root first.

Curves and hair curves are read as they are, without modifiers; hair particles as the view
layer has evaluated them.
"""

from __future__ import annotations

from typing import Any

import bpy
import numpy as np
import numpy.typing as npt
from mathutils.geometry import interpolate_bezier

Floats = npt.NDArray[np.float32]
Counts = npt.NDArray[np.uint32]


def read(thing: bpy.types.Object) -> tuple[Floats, Counts]:
    """Points [n][3] and how many each strand has; what has fewer than two, or goes round,
    is left out."""
    if thing.type == "CURVES":
        return _hair_curves(thing.data)
    if thing.type == "CURVE":
        found = [_spline(spline) for spline in thing.data.splines]
    else:
        found = _particles(thing)
    kept = [np.asarray(one, dtype=np.float32) for one in found if len(one) >= 2]
    if not kept:
        return np.empty((0, 3), np.float32), np.empty(0, np.uint32)
    return np.concatenate(kept), np.array([len(one) for one in kept], np.uint32)


def _hair_curves(curves: Any) -> tuple[Floats, Counts]:
    points = np.empty((len(curves.points), 3), np.float32)
    if not len(points):
        return points, np.empty(0, np.uint32)
    curves.attributes["position"].data.foreach_get("vector", points.ravel())
    offsets = np.empty(len(curves.curves) + 1, np.int32)
    curves.curve_offset_data.foreach_get("value", offsets)
    counts = np.diff(offsets)
    kept = counts >= 2
    return points[np.repeat(kept, counts)], counts[kept].astype(np.uint32)


def _spline(spline: Any) -> Any:
    if spline.use_cyclic_u:
        return []
    if spline.type == "BEZIER":
        return _bezier(spline)
    points = np.empty((len(spline.points), 4), np.float32)
    spline.points.foreach_get("co", points.ravel())
    if spline.type == "NURBS":
        return _nurbs(points, spline)
    return points[:, :3]


def _bezier(spline: Any) -> Any:
    knots = spline.bezier_points
    steps = max(1, spline.resolution_u) + 1
    places = [knots[0].co[:]] if len(knots) else []
    for first, second in zip(knots[:-1], knots[1:]):
        piece = interpolate_bezier(
            first.co, first.handle_right, second.handle_left, second.co, steps
        )
        places += [place[:] for place in piece[1:]]
    return places


def _nurbs(points: Floats, spline: Any) -> Any:
    """Places at equal steps of the parameter, by de Boor; w is the weight."""
    order, count = spline.order_u, len(points)
    if count < max(2, order):
        return []
    knots = np.arange(count + order, dtype=np.float64)
    if spline.use_endpoint_u:
        knots = np.clip(knots, order - 1, count)
    weighted = points.astype(np.float64)
    weighted[:, :3] *= weighted[:, 3:]
    steps = (count - order + 1) * max(1, spline.resolution_u)
    places = []
    for u in np.linspace(knots[order - 1], knots[count], steps + 1):
        span = min(int(np.searchsorted(knots, u, side="right")) - 1, count - 1)
        row = weighted[span - order + 1 : span + 1].copy()
        for level in range(1, order):
            for j in range(order - 1, level - 1, -1):
                low = knots[span - order + 1 + j]
                share = (u - low) / (knots[span + 1 + j - level] - low)
                row[j] = (1 - share) * row[j - 1] + share * row[j]
        places.append(row[-1, :3] / row[-1, 3])
    return places


def _particles(thing: bpy.types.Object) -> list[Any]:
    evaluated = thing.evaluated_get(bpy.context.evaluated_depsgraph_get())
    found = []
    for modifier in evaluated.modifiers:
        if modifier.type != "PARTICLE_SYSTEM":
            continue
        system = modifier.particle_system
        if system.settings.type != "HAIR":
            continue
        for particle in system.particles:
            keys = particle.hair_keys
            found.append([k.co_object(evaluated, modifier, particle)[:] for k in keys])
    return found
