"""A C handle that is released once, and only when no call uses it."""

from __future__ import annotations

import contextlib
import threading
from collections.abc import Callable, Iterator

from .errors import CallError

_inside = threading.local()


def in_a_call() -> bool:
    """Whether the thread that asks is in a call of the library, from Python."""
    return getattr(_inside, "depth", 0) > 0


class Handle:
    """`close` may be called at any time and from any thread: what uses the handle then
    goes on, and the last to leave releases it."""

    def __init__(self, pointer: int, release: Callable[[int], None], what: str) -> None:
        self._pointer, self._release, self._what = pointer, release, what
        self._lock = threading.Lock()
        self._users, self._closed = 0, False

    @property
    def closed(self) -> bool:
        return self._closed

    def enter(self) -> int:
        with self._lock:
            if self._closed:
                raise CallError(f"the {self._what} is closed")
            self._users += 1
        return self._pointer

    def leave(self) -> None:
        with self._lock:
            self._users -= 1
            last = self._closed and self._users == 0
        if last:
            self._release(self._pointer)

    @contextlib.contextmanager
    def use(self) -> Iterator[int]:
        pointer = self.enter()
        _inside.depth = getattr(_inside, "depth", 0) + 1
        try:
            yield pointer
        finally:
            _inside.depth -= 1
            self.leave()

    def close(self) -> None:
        with self._lock:
            if self._closed:
                return
            self._closed = True
            unused = self._users == 0
        if unused:
            self._release(self._pointer)
