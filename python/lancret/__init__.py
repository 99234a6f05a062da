"""Lancret grows hair between Super-Helix guides at render time.

    with lancret.open("head.toml", parameters={"strands.count": 5000}) as groom:
        hair = groom.expand(attributes=("ids", "root_uv"))
        print(hair.points, hair.radii)

`lancret.usd` reads and writes USD; `lancret.notebook` draws strands with matplotlib.
"""

from . import notebook
from ._library import version
from .context import Context
from .curves import ALL, Attribute, Basis, Curves
from .errors import (
    CallError,
    Cancelled,
    Error,
    InputError,
    InternalError,
    LibraryNotFound,
    OutOfMemory,
)
from .figures import Check, ChunkInfo, Guides, Info
from .geometry import Mesh, Strands
from .groom import Groom
from .opening import evaluate, fit, open

__version__ = "0.1.0"
__all__ = [
    "ALL",
    "Attribute",
    "Basis",
    "CallError",
    "Cancelled",
    "Check",
    "ChunkInfo",
    "Context",
    "Curves",
    "Error",
    "Groom",
    "Guides",
    "Info",
    "InputError",
    "InternalError",
    "LibraryNotFound",
    "Mesh",
    "OutOfMemory",
    "Strands",
    "evaluate",
    "fit",
    "notebook",
    "open",
    "version",
]
