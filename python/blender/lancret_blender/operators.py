"""Add > Lancret Hair, and the buttons of the panel."""

from __future__ import annotations

from typing import Any

import bpy
from bpy.props import StringProperty

from . import groom_cache, grow, strand_object
from .objects import is_lancret


def _guides_of(context: Any) -> list[bpy.types.Object]:
    """The selected objects that have strands, except Lancret objects."""
    return [
        obj
        for obj in context.selected_objects
        if (obj.type in {"CURVE", "CURVES"} and not is_lancret(obj))
        or any(system.settings.type == "HAIR" for system in obj.particle_systems)
    ]


def _set_guides(obj: bpy.types.Object, guides: list[bpy.types.Object]) -> None:
    obj.lancret.guides.clear()
    for guide in guides:
        obj.lancret.guides.add().object = guide


class OBJECT_OT_lancret_add(bpy.types.Operator):
    """Add hair grown between the selected curves, on the active mesh, or from a file"""

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
            self.report({"ERROR"}, "Select curves as guides, or choose a file")
            return {"CANCELLED"}
        active = context.active_object
        on_mesh = active is not None and active.type == "MESH" and active.select_get()
        scalp = active if guides and on_mesh else None  # a file has its own
        obj = strand_object.make(context, scalp or (guides[0] if guides else None))
        settings = obj.lancret
        settings.live = False
        settings.source = "SCENE" if guides else "FILE"
        settings.file = "" if guides else self.filepath
        settings.scalp = scalp
        _set_guides(obj, guides)
        settings.live = True
        for selected in context.selected_objects:
            selected.select_set(False)
        obj.select_set(True)
        context.view_layer.objects.active = obj
        context.view_layer.update()
        return _grown(self, obj)


class _OnLancret:
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: Any) -> bool:
        return context.object is not None and is_lancret(context.object)


class OBJECT_OT_lancret_update(_OnLancret, bpy.types.Operator):
    """Reload guides, scalp and files, and regrow the strands in the viewport"""

    bl_idname = "object.lancret_update"
    bl_label = "Update"

    def execute(self, context: Any) -> set[str]:
        groom_cache.forget()
        return _grown(self, context.object)


class OBJECT_OT_lancret_take(_OnLancret, bpy.types.Operator):
    """Use the selected curves as guides"""

    bl_idname = "object.lancret_take"
    bl_label = "Use Selected Curves"

    def execute(self, context: Any) -> set[str]:
        guides = _guides_of(context)
        if not guides:
            self.report({"ERROR"}, "Also select curves, hair curves or hair particles")
            return {"CANCELLED"}
        _set_guides(context.object, guides)
        context.object.lancret.source = "SCENE"
        return _grown(self, context.object)


def _grown(operator: bpy.types.Operator, obj: bpy.types.Object) -> set[str]:
    if not grow.regrow(obj, bpy.context.scene):
        operator.report({"WARNING"}, obj.lancret.error)
    return {"FINISHED"}


def _menu(menu: Any, _context: Any) -> None:
    menu.layout.operator(OBJECT_OT_lancret_add.bl_idname, icon="OUTLINER_OB_CURVES")


_CLASSES = (OBJECT_OT_lancret_add, OBJECT_OT_lancret_update, OBJECT_OT_lancret_take)


def register() -> None:
    for cls in _CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.VIEW3D_MT_add.append(_menu)


def unregister() -> None:
    bpy.types.VIEW3D_MT_add.remove(_menu)
    for cls in reversed(_CLASSES):
        bpy.utils.unregister_class(cls)
