"""The settings of a Lancret object: `Object.lancret`, stored in the .blend file."""

from __future__ import annotations

from typing import Any

import bpy
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)

from . import deferred

_BLENDS = (
    ("GROOM", "From the groom", "The blend that the groom sets; detail if it sets none"),
    (
        "detail",
        "Detail",
        "Curls of the guide with the largest weight, on a blended spine",
    ),
    ("option1", "Option 1", "Weighted mean of curvature and torsion"),
    ("option1-anchored", "Option 1, anchored", "Option 1, anchored to the blended spine"),
    ("option2", "Option 2", "Option 2 of docs/interpolation.md"),
    ("option3", "Option 3", "Option 3 of docs/interpolation.md"),
    ("bishop", "Bishop", "Weighted curvature in twist-free frames"),
    ("nearest", "Nearest", "The shape of the nearest guide"),
    ("position", "Position", "Weighted mean of positions, for comparison"),
)


def _changed(settings: bpy.types.PropertyGroup, _context: Any) -> None:
    obj = settings.id_data
    if obj.lancret.live:
        deferred.update(obj)


def _is_guides(_settings: Any, candidate: bpy.types.Object) -> bool:
    return candidate.type in {"CURVE", "CURVES"} or bool(candidate.particle_systems)


def _is_mesh(_settings: Any, candidate: bpy.types.Object) -> bool:
    return candidate.type == "MESH"


def _number(name: str, description: str, **more: Any) -> Any:
    return FloatProperty(
        name=name, description=description, update=_changed, options=set(), **more
    )


def _count(name: str, description: str, **more: Any) -> Any:
    return IntProperty(
        name=name, description=description, update=_changed, options=set(), **more
    )


class LancretGuides(bpy.types.PropertyGroup):
    """An object whose strands are guides."""

    object: PointerProperty(type=bpy.types.Object, poll=_is_guides, update=_changed)


class LancretSettings(bpy.types.PropertyGroup):
    """0, or -1 for the seed, uses the groom's value."""

    enabled: BoolProperty(description="Lancret grows the hair of this object")
    live: BoolProperty(
        name="Live", description="Regrow when a setting changes", default=True
    )
    source: EnumProperty(
        name="Guides from",
        items=(
            ("FILE", "A file", "A groom (.toml), strands (.hair) or guides (.h5)"),
            ("SCENE", "Objects", "Curves, hair curves or hair particles in this scene"),
        ),
        update=_changed,
        options=set(),
    )
    file: StringProperty(name="File", subtype="FILE_PATH", update=_changed, options=set())
    guides: CollectionProperty(type=LancretGuides)
    scalp: PointerProperty(
        name="Scalp",
        description="The mesh that hair grows on, without modifiers. If empty: the "
        "groom's scalp, or the roots of the guides",
        type=bpy.types.Object,
        poll=_is_mesh,
        update=_changed,
    )

    count: _count("Strands", "Number of strands in renders; 0: the groom's value", min=0)
    viewport: _number(
        "Viewport share",
        "Fraction of the strands shown in the viewport; fewer strands are drawn wider",
        default=0.05,
        min=0.0001,
        max=1,
    )
    blend: EnumProperty(name="Blend", items=_BLENDS, update=_changed, options=set())
    neighbours: _count(
        "Guides per strand",
        "Number of guides blended into a strand; 0: the groom's value",
        min=0,
        max=8,
    )
    seed: _count(
        "Seed",
        "Random seed of the root positions; -1: the groom's value",
        default=-1,
        min=-1,
    )
    root_width: _number(
        "Width at the root, cm",
        "Diameter at the root; 0: the groom's widths",
        min=0,
        precision=4,
    )
    tip_width: _number(
        "Width at the tip, cm",
        "Diameter at the tip, if the width at the root is not 0; 0: pointed",
        min=0,
        precision=4,
    )
    max_error: _number(
        "Error, cm",
        "Maximum distance from a drawn curve to its strand; 0: the groom's value",
        min=0,
        precision=4,
    )
    chunk: _count(
        "Strands per chunk", "Maximum number of strands grown at once; 0: 4096", min=0
    )
    material: PointerProperty(name="Material", type=bpy.types.Material, update=_changed)

    # Results.
    points: PointerProperty(type=bpy.types.Object)
    nodes: PointerProperty(type=bpy.types.NodeTree)
    error: StringProperty()
    render_error: StringProperty()
    strands: IntProperty(name="Strands in the viewport")
    all_strands: IntProperty(name="Strands in renders")
    first_frame: IntProperty()
    last_frame: IntProperty()
    end_error: FloatProperty(name="Error at the ends, cm")


def register() -> None:
    bpy.utils.register_class(LancretGuides)
    bpy.utils.register_class(LancretSettings)
    bpy.types.Object.lancret = PointerProperty(type=LancretSettings)


def unregister() -> None:
    del bpy.types.Object.lancret
    bpy.utils.unregister_class(LancretSettings)
    bpy.utils.unregister_class(LancretGuides)
