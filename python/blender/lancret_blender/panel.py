"""Properties > Object > Lancret Hair."""

from __future__ import annotations

import textwrap
from typing import Any

import bpy

from .objects import is_lancret


class OBJECT_PT_lancret(bpy.types.Panel):
    bl_label = "Lancret Hair"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "object"

    @classmethod
    def poll(cls, context: Any) -> bool:
        return context.object is not None and is_lancret(context.object)

    def draw(self, context: Any) -> None:
        settings, layout = context.object.lancret, self.layout
        layout.use_property_split = True
        for text in (settings.error, settings.render_error):
            if text:
                self._error(layout.box(), text, context.region.width)
        row = layout.row()
        row.operator("object.lancret_update", icon="FILE_REFRESH")
        row.prop(settings, "live", toggle=True)
        layout.prop(settings, "source")
        if settings.source == "FILE":
            layout.prop(settings, "file")
        else:
            for guides in settings.guides:
                layout.prop(guides, "object", text="")
            layout.operator("object.lancret_take")
        layout.prop(settings, "scalp")
        for names in (
            ("count", "viewport", "seed"),
            ("blend", "neighbours"),
            ("root_width", "tip_width"),
            ("max_error", "chunk"),
            ("material",),
        ):
            column = layout.column(align=True)
            for name in names:
                column.prop(settings, name)
        self._figures(layout.column(align=True), settings)

    def _error(self, box: Any, text: str, width: int) -> None:
        box.alert = True
        lines = textwrap.wrap(text, max(20, width // 8))
        for number, line in enumerate(lines):
            box.label(text=line, icon="BLANK1" if number else "ERROR")

    def _figures(self, column: Any, settings: Any) -> None:
        column.label(
            text=f"{settings.strands:,} of {settings.all_strands:,} strands shown"
        )
        if settings.last_frame > settings.first_frame:
            column.label(
                text=f"Moves from frame {settings.first_frame} to {settings.last_frame}"
            )
        if settings.end_error > 0:
            column.label(text=f"Error at the ends: at most {settings.end_error:.2g} cm")


def register() -> None:
    bpy.utils.register_class(OBJECT_PT_lancret)


def unregister() -> None:
    bpy.utils.unregister_class(OBJECT_PT_lancret)
