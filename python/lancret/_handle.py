"""A C handle that is released once, after the last call that uses it."""

from __future__ import annotations

import contextlib
import threading
from collections.abc import Callable, Iterator

from .errors import CallError

_inside = threading.local()


def in_a_call() -> bool:
    """Whether Python code on the current thread is inside a call of the library."""
    return getattr(_inside, "depth", 0) > 0


class Handle:
    """`close` may be called at any time from any thread. Calls in progress continue, and
    the last one releases the handle. `name` is for messages."""

    def __init__(self, pointer: int, release: Callable[[int], None], name: str) -> None:
        self._pointer, self._release, self._name = pointer, release, name
        self._lock = threading.Lock()
        self._users, self._closed = 0, False

    @property
    def closed(self) -> bool:
        return self._closed

    def enter(self) -> int:
        with self._lock:
            if self._closed:
                raise CallError(f"the {self._name} is closed")
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
