"""Whether Blender is rendering. Set by the handlers."""

from __future__ import annotations

_rendering = False


def rendering() -> bool:
    return _rendering


def set_rendering(value: bool) -> None:
    global _rendering
    _rendering = value
