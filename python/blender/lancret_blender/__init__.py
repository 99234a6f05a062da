"""Lancret hair in Blender: grows strands between guides, for the viewport and renders."""

from __future__ import annotations

bl_info = {
    "name": "Lancret hair",
    "author": "The Lancret authors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "Add > Lancret Hair, Properties > Object > Lancret Hair",
    "description": "Hair grown between Super-Helix guides at render time",
    "category": "Object",
}

from . import handlers, operators, panel, settings  # noqa: E402

_PARTS = (settings, operators, panel, handlers)


def register() -> None:
    for part in _PARTS:
        part.register()


def unregister() -> None:
    for part in reversed(_PARTS):
        part.unregister()
