"""A groom that is open, and its strands."""

from __future__ import annotations

import contextlib
import ctypes
import functools
from collections.abc import Collection, Iterable
from ctypes import byref, c_float, c_void_p
from types import TracebackType
from typing import Any, Literal, Unpack

import numpy as np

from . import _abi
from ._handle import Handle
from ._library import library
from ._options import Options, Times, chunk_index, moments_of, options_of
from ._source import Source
from .context import Context
from .curves import IDS, Attribute, Basis, Curves, buffers_of, empty_curves, part
from .figures import Check, Guides, Info
from .errors import CallError
from .geometry import Doubles, Floats

#: Of the text of an error.
ERROR_BYTES = 4096


def _copy(pointer: Any, *shape: int) -> Doubles:
    if 0 in shape:
        return np.empty(shape)
    return np.ctypeslib.as_array(pointer, shape).copy()


class Groom:
    """A groom that is open: guides fitted, strands told but not grown. Close it, or use
    it in a `with`. Any number of threads may use one at once."""

    def __init__(self, context: Context, source: Source) -> None:
        self.context = context
        pointer, text = c_void_p(), ctypes.create_string_buffer(ERROR_BYTES)
        host = context.handle.enter()
        try:
            with context.handle.use():
                status = library().lancret_open(
                    host, byref(source.struct), byref(pointer), text, ERROR_BYTES
                )
            if pointer.value:

                def release(groom: int) -> None:
                    library().lancret_close(groom)
                    context.handle.leave()

                self._handle = Handle(pointer.value, release, "groom")
            context.raise_for(status, text.value.decode(errors="replace"))
        except BaseException:
            if "_handle" in self.__dict__:
                self._handle.close()
            else:
                context.handle.leave()
            raise

    # ---- its life ----

    def close(self) -> None:
        """Calls of other threads go on to their end; new ones raise CallError."""
        self._handle.close()

    @property
    def closed(self) -> bool:
        return self._handle.closed

    def __enter__(self) -> Groom:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        fault: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def __del__(self) -> None:
        if "_handle" in self.__dict__:
            self._handle.close()

    # ---- what it is ----

    @functools.cached_property
    def info(self) -> Info:
        struct = _abi.Info()
        with self._handle.use() as groom:
            self.context.raise_for(library().lancret_get_info(groom, byref(struct)))
        values = {name: getattr(struct, name) for name, *_ in _abi.Info._fields_[1:]}
        values["up"] = tuple(struct.up)
        values["box"] = tuple(struct.box[:3]), tuple(struct.box[3:])
        values["basis"] = _abi.BASIS_NAMES[struct.basis]
        values["shape"] = _abi.SHAPES[struct.shape]
        values["cm_per_unit"] = float(
            str(np.float32(struct.cm_per_unit))
        )  # 0.1, not ..01
        return Info(**values)

    @property
    def chunks(self) -> range:
        """The chunks' numbers: `for chunk in groom.chunks: groom.expand(chunk)`."""
        return range(self.info.chunks)

    def guides(self) -> Guides:
        struct = _abi.Guides()
        with self._handle.use() as groom:
            self.context.raise_for(library().lancret_get_guides(groom, byref(struct)))
            count, segments = struct.guides, struct.segments
            return Guides(
                root_positions=_copy(struct.root_positions, count, 3),
                root_frames=_copy(struct.root_frames, count, 3, 3),
                segment_lengths=_copy(struct.segment_lengths, count, segments),
                curvatures=_copy(struct.curvatures, count, segments, 3),
                fit_rms=_copy(struct.fit_rms, count) if struct.fit_rms else None,
            )

    # ---- strands ----

    def bound(
        self,
        chunk: int,
        times: Times = None,
        kind: Literal["reach", "tight"] = "reach",
        **options: Unpack[Options],
    ) -> Floats:
        """[2][3]: least and greatest corner of a box that holds a chunk at `times` and
        between them. "reach" costs next to nothing and is wide; "tight" grows the chunk.
        `options` are those of `expand`."""
        kinds = {"reach": _abi.REACH, "tight": _abi.TIGHT}
        if kind not in kinds:
            raise CallError(f"kind {kind!r}: is neither 'reach' nor 'tight'")
        box = (c_float * 6)()
        asked = options_of(moments_of(times), **options)
        with self._handle.use() as groom:
            status = library().lancret_bound(
                groom, chunk_index(chunk), byref(asked), kinds[kind], box
            )
        self.context.raise_for(status)
        return np.array(box, dtype=np.float32).reshape(2, 3)

    def expand(
        self,
        chunk: int | Iterable[int] | None = None,
        times: Times = None,
        basis: Basis = "bspline",
        density: float = 0,
        max_error: float = 0,
        attributes: Collection[Attribute] = IDS,
        *,
        pixels: float = 0,
        strands_a_pixel: float = 0,
        unit: float = 0,
    ) -> Curves:
        """Grows a chunk, some chunks, or all of them (None), into one set of arrays.

        times: frames, up to 256; none: the first, or rest.
        density: share of the strands that are grown, wider; 0: the groom's own.
        max_error: that curves may be off the strands, in the units given back; 0: the
            groom's own tolerance.
        pixels, strands_a_pixel: level of detail: how many the chunk covers, and at most
            how many strands each shall have.
        unit: cm of a unit of what is given back; 0: 1.
        """
        moments = moments_of(times)
        asked = options_of(
            moments,
            basis,
            density,
            max_error,
            attributes,
            pixels,
            strands_a_pixel,
            unit,
        )
        if chunk is None:
            chunk = self.chunks
        numbers = list(chunk) if isinstance(chunk, Iterable) else [chunk]
        with self._handle.use() as groom, contextlib.ExitStack() as bound:
            opened = [
                self._open_chunk(bound, groom, number, asked) for number in numbers
            ]
            sizes = [self._sizes(chunk_handle) for chunk_handle in opened]
            whole = empty_curves(
                basis,
                moments,
                attributes,
                strands=sum(size.strands for size in sizes),
                points=sum(size.points for size in sizes),
                neighbours=max((size.neighbours for size in sizes), default=0),
            )
            strand = point = 0
            for chunk_handle, size in zip(opened, sizes):
                strands = slice(strand, strand + size.strands)
                points = slice(point, point + size.points)
                buffers = buffers_of(part(whole, strands, points))
                self.context.raise_for(
                    library().lancret_chunk_write(chunk_handle, byref(buffers))
                )
                strand, point = strands.stop, points.stop
        return whole

    def _open_chunk(
        self,
        bound: contextlib.ExitStack,
        groom: int,
        number: int,
        asked: _abi.Options,
    ) -> int:
        pointer = c_void_p()
        status = library().lancret_chunk_open(
            groom, chunk_index(number), byref(asked), byref(pointer)
        )
        if pointer.value:
            bound.callback(library().lancret_chunk_close, pointer.value)
        self.context.raise_for(status)
        return pointer.value or 0

    def _sizes(self, chunk: int) -> _abi.Curves:
        sizes = _abi.Curves()
        self.context.raise_for(library().lancret_chunk_sizes(chunk, byref(sizes)))
        return sizes

    def check(
        self,
        chunk: int | None = None,
        times: Times = None,
        **options: Unpack[Options],
    ) -> Check:
        """Looks at every strand of a chunk, or of all (None), at the first of `times`."""
        asked = options_of(moments_of(times), **options)
        joined = Check(0, 0, 0, 0.0, 0.0, 0.0, 0.0)
        with self._handle.use() as groom:
            for number in self.chunks if chunk is None else (chunk,):
                struct = _abi.Check()
                self.context.raise_for(
                    library().lancret_check_chunk(
                        groom, chunk_index(number), byref(asked), byref(struct)
                    )
                )
                names = [name for name, *_ in _abi.Check._fields_[1:]]
                joined = joined.joined(Check(*(getattr(struct, n) for n in names)))
        return joined
