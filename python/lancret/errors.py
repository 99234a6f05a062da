"""The exceptions of this package. Their texts are the library's."""

from __future__ import annotations


class Error(Exception):
    """The base of all errors of Lancret."""


class InputError(Error, ValueError):
    """A file or a parameter is invalid; the text names it, and the line."""


class CallError(Error):
    """A call is invalid: an index out of range, an unknown name, a closed groom."""


class OutOfMemory(Error, MemoryError):
    """Memory is exhausted."""


class Cancelled(Error):
    """The `cancelled` callback returned True."""


class LibraryNotFound(Error, ImportError):
    """liblancret_procedural.so is missing or has another version."""


class InternalError(Error, RuntimeError):
    """A bug in Lancret."""


#: By lancret_status.
BY_STATUS: dict[int, type[Error]] = {
    1: InputError,
    2: CallError,
    3: OutOfMemory,
    4: Cancelled,
    5: InternalError,
}
MEANINGS = {
    1: "invalid input",
    2: "invalid call: a null pointer, an index out of range, an invalid option",
    3: "out of memory",
    4: "cancelled",
    5: "internal error",
}
