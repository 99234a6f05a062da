"""Opens, fits and measures grooms."""

from __future__ import annotations

import ctypes
import json
import os
from ctypes import byref
from typing import Any, TypedDict, Unpack

from . import _abi
from ._library import library
from ._source import Parameters, Source
from .context import CancelCallback, Context, LogCallback
from .figures import Guides
from .geometry import Mesh, Strands
from .groom import ERROR_BYTES, Groom

Path = str | os.PathLike[str]


def open(  # noqa: A001 - lancret.open is what it is called
    source: Path | None = None,
    *,
    text: str | None = None,
    folder: Path | None = None,
    parameters: Parameters | None = None,
    strands: Strands | None = None,
    scalp: Mesh | None = None,
    chunk_strands: int = 0,
    threads: int = 0,
    log: LogCallback | None = None,
    cancelled: CancelCallback | None = None,
    context: Context | None = None,
) -> Groom:
    """Opens a groom.

    source: a .toml, .hair or .h5 file, or the text of a TOML (told by its line breaks).
    text, folder: the TOML's text, and where file names in it start from; errors then name
        `source`.
    parameters: laid over the TOML, {"strands.count": 5000} or {"strands": {"count": 5000}}.
    strands, scalp: from memory, in place of the groom's files. What the strands know of
        units, axes and widths goes before the TOML, `parameters` before that.
    chunk_strands: at most so many strands a chunk; 0: 4096.
    threads, log, cancelled: see Context; or a `context` that several grooms share.

    Raises InputError with the file and line.
    """
    given = Source(
        source,
        text=text,
        folder=folder,
        parameters=parameters,
        strands=strands,
        scalp=scalp,
        chunk_strands=chunk_strands,
    )
    if context is not None:
        return Groom(context, given)
    own = Context(threads=threads, log=log, cancelled=cancelled)
    try:
        return Groom(own, given)
    finally:
        own.close()  # lives on as long as the groom


class How(TypedDict, total=False):
    """What `open` may be given besides a source and a context."""

    text: str | None
    folder: Path | None
    parameters: Parameters | None
    strands: Strands | None
    scalp: Mesh | None
    chunk_strands: int
    threads: int
    log: LogCallback | None
    cancelled: CancelCallback | None


def fit(
    source: Path | None = None, *, context: Context | None = None, **how: Unpack[How]
) -> Guides:
    """Super-Helix guides fitted to a groom's strands; `how` as for `open`."""
    with open(source, context=context, **how) as groom:
        return groom.guides()


def evaluate(
    source: Path | None = None,
    *,
    text: str | None = None,
    folder: Path | None = None,
    parameters: Parameters | None = None,
    strands: Strands | None = None,
    scalp: Mesh | None = None,
    context: Context | None = None,
) -> dict[str, Any]:
    """Leave-out measurement of a dense groom: each blend's figures, in the form of
    `lancret evaluate --json`."""
    given = Source(
        source,
        text=text,
        folder=folder,
        parameters=parameters,
        strands=strands,
        scalp=scalp,
    )
    own = context or Context()
    parts: list[bytes] = []
    sink = _abi.TextSink(lambda _user, part_of_it: parts.append(part_of_it))
    error = ctypes.create_string_buffer(ERROR_BYTES)
    with own.handle.use() as host:
        status = library().lancret_context_evaluate(
            host, byref(given.struct), sink, None, error, ERROR_BYTES
        )
    own.raise_for(status, error.value.decode(errors="replace"))
    report: dict[str, Any] = json.loads(b"".join(parts))
    return report
