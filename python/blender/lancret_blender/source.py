"""The arguments of `lancret.open` for one object, and the errors of collecting them."""

from __future__ import annotations

import dataclasses
from typing import Any


class Fault(Exception):
    """An error that the user can correct; its text is shown in the panel."""


@dataclasses.dataclass(eq=False)
class Source:
    path: str | None = None
    parameters: dict[str, Any] = dataclasses.field(default_factory=dict)
    strands: Any = None
    scalp: Any = None
    chunk_strands: int = 0
