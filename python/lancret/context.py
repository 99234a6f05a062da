"""What grooms share: loaded guides, a thread limit, a log and a way to stop."""

from __future__ import annotations

import ctypes
import logging
import threading
from collections.abc import Callable
from types import TracebackType

from . import _abi
from ._handle import Handle, in_a_call
from ._library import library
from .errors import BY_STATUS, MEANINGS, CallError, Error, InternalError

LogCallback = Callable[[str, str], None]
CancelCallback = Callable[[], bool]

# An error is raised as well, and so is none to log twice.
_LOGGING = {"info": logging.INFO, "warning": logging.WARNING, "error": logging.DEBUG}


def log_to_logging(level: str, text: str) -> None:
    """The default log: the logger "lancret" of Python's logging."""
    logging.getLogger("lancret").log(_LOGGING[level], text)


class _Callbacks:
    """What the library calls, from any thread. Keeps the first exception of a callback:
    of a log on a thread that is in a call itself for that call; else for whichever call
    ends first."""

    def __init__(self, log: LogCallback, cancelled: CancelCallback | None) -> None:
        self._log, self._cancelled = log, cancelled
        self._lock = threading.Lock()
        self._raised: BaseException | None = None
        self._own = threading.local()  # of a call that logs on its own thread
        self.c_log = _abi.Log(self.log)
        self.c_cancel = _abi.Cancel(self.cancel)

    def keep(self, fault: BaseException) -> None:
        with self._lock:
            self._raised = self._raised or fault

    def take_raised(self) -> BaseException | None:
        own: BaseException | None = self._own.__dict__.pop("raised", None)
        if own is not None:
            return own
        with self._lock:
            raised, self._raised = self._raised, None
        return raised

    def take_error(self) -> str:
        words: str = self._own.__dict__.pop("error", "")
        return words

    def log(self, _user: int | None, level: int, text: bytes) -> None:
        try:
            words = text.decode(errors="replace")
            name = _abi.LOG_LEVELS.get(level, "error")
            if name == "error":
                self._own.error = words
            self._log(name, words)
        except BaseException as fault:  # noqa: BLE001 - must not reach C
            if in_a_call():
                self._own.__dict__.setdefault("raised", fault)
            else:
                self.keep(fault)

    def cancel(self, _user: int | None) -> int:
        try:
            if self._raised is not None:
                return 1
            return int(self._cancelled is not None and bool(self._cancelled()))
        except BaseException as fault:  # noqa: BLE001
            self.keep(fault)
            return 1


class Context:
    """Grooms of one context share guides that were loaded once, told by their files,
    parameters and frame.

    threads: at most so many at once for one call; 0: as many as the machine has.
    log: called with "info", "warning" or "error" and a text, from any thread; by default
        Python's logging. An exception in it comes out of the call that logged, where that
        did so on its own thread.
    cancelled: asked every few milliseconds of work, from a thread of its own; true ends
        all calls with `Cancelled`. An exception in it ends them, and comes out of the
        first to end.
    """

    def __init__(
        self,
        *,
        threads: int = 0,
        log: LogCallback | None = None,
        cancelled: CancelCallback | None = None,
    ) -> None:
        self._callbacks = _Callbacks(log or log_to_logging, cancelled)
        if not 0 <= threads < 2**31:
            raise CallError(f"threads: must be 0 or more, not {threads}")
        host = _abi.Host(log=self._callbacks.c_log, threads=threads)
        if cancelled is not None:  # else nobody need be asked
            host.cancelled = self._callbacks.c_cancel
        pointer = ctypes.c_void_p()
        self.raise_for(
            library().lancret_context_create(
                _abi.ABI_VERSION, ctypes.byref(host), ctypes.byref(pointer)
            )
        )
        callbacks = self._callbacks  # must live as long as the handle

        def release(handle: int, _keep: _Callbacks = callbacks) -> None:
            library().lancret_context_destroy(handle)

        self.handle = Handle(pointer.value or 0, release, "context")

    def raise_for(self, status: int, text: str = "") -> None:
        """Nothing for LANCRET_OK; else the error that the status stands for."""
        raised, said = self._callbacks.take_raised(), self._callbacks.take_error()
        if raised is not None:
            raise raised
        if status == _abi.OK:
            return
        kind: type[Error] = BY_STATUS.get(status, InternalError)
        raise kind(text or said or MEANINGS.get(status, f"status {status}"))

    def close(self) -> None:
        """Grooms that are still open keep what they need until they are closed."""
        self.handle.close()

    def __enter__(self) -> Context:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        fault: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def __del__(self) -> None:
        if "handle" in self.__dict__:  # else it was never made
            self.handle.close()
