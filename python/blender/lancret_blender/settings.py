"""What a Lancret object is told: properties of `Object.lancret`, kept in the .blend."""

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

from . import later

_BLENDS = (
    ("GROOM", "The groom's own", "What the groom says; without a word of it, detail"),
    ("detail", "Detail", "The heaviest guide's curls on the spine of all guides"),
    ("option1", "Option 1", "Weighted curvature and torsion"),
    ("option1-anchored", "Option 1, anchored", "The same, anchored to the spine"),
    ("option2", "Option 2", "Option 2 of docs/interpolation.md"),
    ("option3", "Option 3", "Option 3 of docs/interpolation.md"),
    ("bishop", "Bishop", "Curvature in frames without torsion"),
    ("nearest", "Nearest", "The nearest guide's shape"),
    ("position", "Position", "Weighted positions, to compare with"),
)


def _changed(settings: bpy.types.PropertyGroup, _context: Any) -> None:
    thing = settings.id_data
    if thing.lancret.live:
        later.update(thing)


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
    """An object that guides come from."""

    object: PointerProperty(type=bpy.types.Object, poll=_is_guides, update=_changed)


class LancretSettings(bpy.types.PropertyGroup):
    """One Lancret object. 0, or -1 for the seed, leaves it to the groom."""

    enabled: BoolProperty(description="This object's hair is grown by Lancret")
    live: BoolProperty(
        name="Live", description="Grow anew when something here changes", default=True
    )
    source: EnumProperty(
        name="Guides from",
        items=(
            ("FILE", "A file", "A groom (.toml), strands (.hair) or guides (.h5)"),
            ("SCENE", "Objects", "Curves, hair curves or hair particles of this scene"),
        ),
        update=_changed,
        options=set(),
    )
    file: StringProperty(name="File", subtype="FILE_PATH", update=_changed, options=set())
    guides: CollectionProperty(type=LancretGuides)
    scalp: PointerProperty(
        name="Scalp",
        description="The mesh that hair grows on, without its modifiers; none: the "
        "groom's own, or the guides' roots",
        type=bpy.types.Object,
        poll=_is_mesh,
        update=_changed,
    )

    count: _count("Strands", "Of the final render; 0: the groom's own", min=0)
    viewport: _number(
        "Viewport share",
        "Of the strands, that the viewport shows, the wider for it",
        default=0.05,
        min=0.0001,
        max=1,
    )
    blend: EnumProperty(name="Blend", items=_BLENDS, update=_changed, options=set())
    neighbours: _count("Guides a strand", "0: the groom's own", min=0, max=8)
    seed: _count("Seed", "Of the roots; -1: the groom's own", default=-1, min=-1)
    root_width: _number("Width at the root, cm", "0: the groom's own", min=0, precision=4)
    tip_width: _number(
        "At the tip, cm", "Where the root's is not 0: 0 is a point", min=0, precision=4
    )
    max_error: _number(
        "Error, cm",
        "That a curve may be off its strand; 0: the groom's own",
        min=0,
        precision=4,
    )
    chunk: _count("Strands a chunk", "That are grown at a time; 0: 4096", min=0)
    material: PointerProperty(name="Material", type=bpy.types.Material, update=_changed)

    # What came of it.
    points: PointerProperty(type=bpy.types.Object)
    nodes: PointerProperty(type=bpy.types.NodeTree)
    error: StringProperty()
    render_error: StringProperty()
    strands: IntProperty(name="Strands in the viewport")
    all_strands: IntProperty(name="Strands of the render")
    first_frame: IntProperty()
    last_frame: IntProperty()
    end_error: FloatProperty(name="Error at the ends, cm")


def is_lancret(candidate: bpy.types.Object) -> bool:
    return candidate.type == "CURVES" and candidate.lancret.enabled


def register() -> None:
    bpy.utils.register_class(LancretGuides)
    bpy.utils.register_class(LancretSettings)
    bpy.types.Object.lancret = PointerProperty(type=LancretSettings)


def unregister() -> None:
    del bpy.types.Object.lancret
    bpy.utils.unregister_class(LancretSettings)
    bpy.utils.unregister_class(LancretGuides)
