"""Add > Lancret Hair, and what the panel's buttons do."""

from __future__ import annotations

from typing import Any

import bpy
from bpy.props import StringProperty

from . import grow, opened, strand_object
from .settings import is_lancret


def _guides_of(context: Any) -> list[bpy.types.Object]:
    """The selected objects that have strands, but no Lancret hair."""
    return [
        one
        for one in context.selected_objects
        if (one.type in {"CURVE", "CURVES"} and not is_lancret(one))
        or any(system.settings.type == "HAIR" for system in one.particle_systems)
    ]


def _take(thing: bpy.types.Object, guides: list[bpy.types.Object]) -> None:
    thing.lancret.guides.clear()
    for guide in guides:
        thing.lancret.guides.add().object = guide


class OBJECT_OT_lancret_add(bpy.types.Operator):
    """Hair between the selected curves, on the active mesh; or of a file"""

    bl_idname = "object.lancret_add"
    bl_label = "Lancret Hair"
    bl_options = {"REGISTER", "UNDO"}

    filepath: StringProperty(subtype="FILE_PATH", options={"SKIP_SAVE"})
    filter_glob: StringProperty(default="*.toml;*.hair;*.h5", options={"HIDDEN"})

    def invoke(self, context: Any, _event: Any) -> set[str]:
        if not self.filepath and not _guides_of(context):
            context.window_manager.fileselect_add(self)
            return {"RUNNING_MODAL"}
        return self.execute(context)

    def execute(self, context: Any) -> set[str]:
        guides = [] if self.filepath else _guides_of(context)
        if not guides and not self.filepath:
            self.report({"ERROR"}, "Select curves to be guides, or choose a file")
            return {"CANCELLED"}
        active = context.active_object
        on_mesh = active is not None and active.type == "MESH" and active.select_get()
        scalp = active if guides and on_mesh else None  # files have their own
        thing = strand_object.make(context, scalp or (guides[0] if guides else None))
        told = thing.lancret
        told.live = False
        told.source, told.file = ("SCENE", "") if guides else ("FILE", self.filepath)
        told.scalp = scalp
        _take(thing, guides)
        told.live = True
        for one in context.selected_objects:
            one.select_set(False)
        thing.select_set(True)
        context.view_layer.objects.active = thing
        context.view_layer.update()
        return _grown(self, thing)


class _OnLancret:
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: Any) -> bool:
        return context.object is not None and is_lancret(context.object)


class OBJECT_OT_lancret_update(_OnLancret, bpy.types.Operator):
    """Read guides, scalp and files again, and grow the viewport's strands"""

    bl_idname = "object.lancret_update"
    bl_label = "Update"

    def execute(self, context: Any) -> set[str]:
        opened.forget()
        return _grown(self, context.object)


class OBJECT_OT_lancret_take(_OnLancret, bpy.types.Operator):
    """Make the selected curves the guides"""

    bl_idname = "object.lancret_take"
    bl_label = "Take the Selected Curves"

    def execute(self, context: Any) -> set[str]:
        guides = _guides_of(context)
        if not guides:
            self.report({"ERROR"}, "Select curves, hair curves or hair particles too")
            return {"CANCELLED"}
        _take(context.object, guides)
        context.object.lancret.source = "SCENE"
        return _grown(self, context.object)


def _grown(operator: bpy.types.Operator, thing: bpy.types.Object) -> set[str]:
    if not grow.anew(thing, bpy.context.scene):
        operator.report({"WARNING"}, thing.lancret.error)
    return {"FINISHED"}


def _menu(menu: Any, _context: Any) -> None:
    menu.layout.operator(OBJECT_OT_lancret_add.bl_idname, icon="OUTLINER_OB_CURVES")


_CLASSES = (OBJECT_OT_lancret_add, OBJECT_OT_lancret_update, OBJECT_OT_lancret_take)


def register() -> None:
    for one in _CLASSES:
        bpy.utils.register_class(one)
    bpy.types.VIEW3D_MT_add.append(_menu)


def unregister() -> None:
    bpy.types.VIEW3D_MT_add.remove(_menu)
    for one in reversed(_CLASSES):
        bpy.utils.unregister_class(one)
