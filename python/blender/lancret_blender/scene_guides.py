"""Reads strands from objects of the scene as points in object space, root first.

Curves and hair curves are read without modifiers, hair particles as evaluated in the view
layer.
"""

from __future__ import annotations

import functools
from typing import Any

import bpy
import numpy as np
import numpy.typing as npt
from mathutils.geometry import interpolate_bezier

Floats = npt.NDArray[np.float32]
Counts = npt.NDArray[np.uint32]


def read(obj: bpy.types.Object, graph: Any) -> tuple[Floats, Counts]:
    """Points [n][3] and the number of points of each strand. Strands of one point and
    cyclic curves are skipped. `graph`: the depsgraph, needed for hair particles."""
    if obj.type == "CURVES":
        return _hair_curves(obj.data)
    if obj.type == "CURVE":
        found = [_spline(spline) for spline in obj.data.splines]
    else:
        found = _particles(obj.evaluated_get(graph))
    kept = [np.asarray(points, dtype=np.float32) for points in found if len(points) >= 2]
    if not kept:
        return np.empty((0, 3), np.float32), np.empty(0, np.uint32)
    return np.concatenate(kept), np.array([len(points) for points in kept], np.uint32)


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
        segment = interpolate_bezier(
            first.co, first.handle_right, second.handle_left, second.co, steps
        )
        places += [place[:] for place in segment[1:]]
    return places


def _nurbs(points: Floats, spline: Any) -> Any:
    """Places at equal steps of the parameter. `points` [n][4]: x y z weight."""
    count = len(points)
    if count < max(2, spline.order_u):
        return []
    ends, bezier = bool(spline.use_endpoint_u), bool(spline.use_bezier_u)
    steps = (count - spline.order_u + 1) * max(1, spline.resolution_u)
    weighted = points.astype(np.float64)
    weighted[:, :3] *= weighted[:, 3:]
    places = _weights(count, spline.order_u, ends, bezier, steps) @ weighted
    return places[:, :3] / places[:, 3:]


def _knots(count: int, order: int, ends: bool, bezier: bool) -> Any:
    """Blender's knots: simple ones, or of multiplicity order - 1 for Bezier curves."""
    each = order - 1 if bezier else 1
    first = order if ends else min(2, each)
    knots = 1.0 + (np.arange(count + order) - first) // each
    knots[:first] = 0
    if ends:
        knots[count:] = knots[count]
    return knots


@functools.cache
def _weights(count: int, order: int, ends: bool, bezier: bool, steps: int) -> Any:
    """[steps + 1][count]: weights of the control points at each place, by de Boor's
    algorithm; empty if there are too few points for the order."""
    knots = _knots(count, order, ends, bezier)
    if knots[order - 1] >= knots[count]:
        return np.empty((0, count))
    last = int(np.searchsorted(knots, knots[count])) - 1  # last span of positive length
    rows = []
    for u in np.linspace(knots[order - 1], knots[count], steps + 1):
        span = min(int(np.searchsorted(knots, u, side="right")) - 1, last)
        row = np.eye(count)[span - order + 1 : span + 1]
        for level in range(1, order):
            for j in range(order - 1, level - 1, -1):
                low = knots[span - order + 1 + j]
                share = (u - low) / (knots[span + 1 + j - level] - low)
                row[j] = (1 - share) * row[j - 1] + share * row[j]
        rows.append(row[-1])
    return np.array(rows)


def _particles(evaluated: bpy.types.Object) -> list[Any]:
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
