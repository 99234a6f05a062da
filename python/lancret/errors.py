"""What can go wrong, with the library's own words."""

from __future__ import annotations


class Error(Exception):
    """Any failure of Lancret."""


class InputError(Error, ValueError):
    """A file or a parameter is at fault: the text says which, and the line."""


class CallError(Error):
    """A call is at fault: an index out of range, a groom that was closed."""


class OutOfMemory(Error, MemoryError):
    """There is no memory left."""


class Cancelled(Error):
    """`cancelled` said so."""


class LibraryNotFound(Error, ImportError):
    """There is no liblancret_procedural.so, or one of another version."""


class InternalError(Error, RuntimeError):
    """A mistake in Lancret."""


#: By lancret_status.
BY_STATUS: dict[int, type[Error]] = {
    1: InputError,
    2: CallError,
    3: OutOfMemory,
    4: Cancelled,
    5: InternalError,
}
MEANINGS = {
    1: "bad input",
    2: "a call that cannot be: a null pointer, an index out of range, a bad option",
    3: "out of memory",
    4: "cancelled",
    5: "a mistake in Lancret",
}
