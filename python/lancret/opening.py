"""Opens, fits and evaluates grooms."""

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


def open(  # noqa: A001 - used as lancret.open
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

    source: a .toml, .hair or .h5 file, or the text of a TOML, if it has line breaks.
    text, folder: the text of a TOML, and the folder that file names in it are relative
        to; error messages then name `source`.
    parameters: override the TOML: {"strands.count": 5000} or {"strands": {"count": 5000}}.
    strands, scalp: in memory, instead of the groom's files. The unit, up axis and widths
        of the strands override the TOML; `parameters` override both.
    chunk_strands: maximum number of strands per chunk; 0: 4096.
    threads, log, cancelled: see Context. Or pass a `context`, to share it.

    Raises InputError with file and line.
    """
    groom_source = Source(
        source,
        text=text,
        folder=folder,
        parameters=parameters,
        strands=strands,
        scalp=scalp,
        chunk_strands=chunk_strands,
    )
    if context is not None:
        return Groom(context, groom_source)
    new_context = Context(threads=threads, log=log, cancelled=cancelled)
    try:
        return Groom(new_context, groom_source)
    finally:
        new_context.close()  # the groom keeps it alive


class OpenOptions(TypedDict, total=False):
    """The keyword arguments of `open` besides the source and the context."""

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
    source: Path | None = None,
    *,
    context: Context | None = None,
    **options: Unpack[OpenOptions],
) -> Guides:
    """Super-Helix guides fitted to a groom's strands. `options`: as in `open`."""
    with open(source, context=context, **options) as groom:
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
    """Evaluates each blend on held-out strands of a dense groom; the same report as
    `lancret evaluate --json`."""
    groom_source = Source(
        source,
        text=text,
        folder=folder,
        parameters=parameters,
        strands=strands,
        scalp=scalp,
    )
    used_context = context or Context()
    parts: list[bytes] = []
    sink = _abi.TextSink(lambda _user, part: parts.append(part))
    error = ctypes.create_string_buffer(ERROR_BYTES)
    with used_context.handle.use() as handle:
        status = library().lancret_context_evaluate(
            handle, byref(groom_source.struct), sink, None, error, ERROR_BYTES
        )
    used_context.raise_for(status, error.value.decode(errors="replace"))
    report: dict[str, Any] = json.loads(b"".join(parts))
    return report
