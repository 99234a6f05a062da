"""The resources that grooms share: loaded guides, a thread limit, a log, cancellation."""

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

# Errors are also raised, so their log entry is only for debugging.
_LOGGING = {"info": logging.INFO, "warning": logging.WARNING, "error": logging.DEBUG}


def log_to_logging(level: str, text: str) -> None:
    """The default log: logging.getLogger("lancret")."""
    logging.getLogger("lancret").log(_LOGGING[level], text)


class _Callbacks:
    """The callbacks of the library, called from any thread. Keeps the first exception of
    a callback until a call raises it: an exception of `log` on a thread that is inside a
    call is raised by that call, any other by the call that ends first."""

    def __init__(self, log: LogCallback, cancelled: CancelCallback | None) -> None:
        self._log, self._cancelled = log, cancelled
        self._lock = threading.Lock()
        self._raised: BaseException | None = None
        self._local = threading.local()  # for calls that log on their own thread
        self.c_log = _abi.Log(self.log)
        self.c_cancel = _abi.Cancel(self.cancel)

    def keep(self, fault: BaseException) -> None:
        with self._lock:
            self._raised = self._raised or fault

    def take_raised(self) -> BaseException | None:
        local: BaseException | None = self._local.__dict__.pop("raised", None)
        if local is not None:
            return local
        with self._lock:
            raised, self._raised = self._raised, None
        return raised

    def take_error(self) -> str:
        message: str = self._local.__dict__.pop("error", "")
        return message

    def log(self, _user: int | None, level: int, text: bytes) -> None:
        try:
            message = text.decode(errors="replace")
            name = _abi.LOG_LEVELS.get(level, "error")
            if name == "error":
                self._local.error = message
            self._log(name, message)
        except BaseException as fault:  # noqa: BLE001 - must not reach C
            if in_a_call():
                self._local.__dict__.setdefault("raised", fault)
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
    """Grooms of one context share their guides, which are cached by files, parameters and
    frame.

    threads: maximum number of threads per call; 0: one per processor.
    log: called with "info", "warning" or "error" and a text, from any thread; by default
        Python's logging. If it raises on the thread of a call, that call raises the
        exception.
    cancelled: called every few milliseconds during work, on a separate thread. If it
        returns True, all calls raise `Cancelled`. If it raises, all calls end, and the
        first one to end raises the exception.
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
        if cancelled is not None:
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
        """Raises the exception of a callback, or the error of the status; no-op for
        LANCRET_OK. `text` replaces the logged message."""
        raised, logged = self._callbacks.take_raised(), self._callbacks.take_error()
        if raised is not None:
            raise raised
        if status == _abi.OK:
            return
        kind: type[Error] = BY_STATUS.get(status, InternalError)
        raise kind(text or logged or MEANINGS.get(status, f"status {status}"))

    def close(self) -> None:
        """Open grooms stay usable; the last one to be closed releases the context."""
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
        if "handle" in self.__dict__:  # missing if __init__ raised
            self.handle.close()
