"""An open groom and its strands."""

from __future__ import annotations

import contextlib
import ctypes
import dataclasses
import functools
from collections.abc import Collection, Iterable, Sequence
from ctypes import byref, c_float, c_void_p
from types import TracebackType
from typing import Any, Literal, Unpack

import numpy as np

from . import _abi, _chunk, _queries
from ._handle import Handle
from ._library import library
from ._options import Options, Times, chunk_index, moments_of, options_of
from ._source import Source
from .context import Context
from .curves import IDS, Attribute, Basis, Curves, buffers_of, empty_curves, part
from .errors import CallError
from .figures import Check, ChunkInfo, Guides, Info
from .geometry import Floats, Mesh

#: Size of the buffer for the text of an error.
ERROR_BYTES = 4096
Figure = Literal["length_error", "orthogonality", "curvature", "torsion", "region"]


class Groom:
    """An open groom: guides are fitted and strands are placed, but not yet grown. Close
    it, or use it in a `with` statement. Any number of threads may use it at once."""

    def __init__(self, context: Context, source: Source) -> None:
        self.context = context
        pointer, text = c_void_p(), ctypes.create_string_buffer(ERROR_BYTES)
        host = context.handle.enter()
        try:
            with context.handle.use():
                status = library().lancret_groom_open(
                    host, byref(source.struct), byref(pointer), text, ERROR_BYTES
                )
            if pointer.value:

                def release(groom: int) -> None:
                    library().lancret_groom_close(groom)
                    context.handle.leave()

                self._handle = Handle(pointer.value, release, "groom")
            context.raise_for(status, text.value.decode(errors="replace"))
        except BaseException:
            if "_handle" in self.__dict__:
                self._handle.close()
            else:
                context.handle.leave()
            raise

    def close(self) -> None:
        """Calls in other threads finish normally; new calls raise CallError."""
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

    @functools.cached_property
    def info(self) -> Info:
        with self._handle.use() as groom:
            return _queries.info_of(self.context, groom)

    @property
    def chunks(self) -> range:
        """The chunk numbers: `for chunk in groom.chunks: groom.expand(chunk)`."""
        return range(self.info.chunks)

    def guides(self) -> Guides:
        with self._handle.use() as groom:
            return _queries.guides_of(self.context, groom)

    def describe(self) -> dict[str, Any]:
        """Details of the groom, such as the errors of the fit. Keys: groom_strands,
        guides, segments, blend, fit, roots."""
        with self._handle.use() as groom:
            return _queries.description_of(self.context, groom)

    def head(self, time: float | None = None) -> Mesh:
        """The visible mesh of the head at `time` (None: the first frame, or rest), in cm;
        empty if there is no head."""
        frame = float(self.info.first_frame if time is None else time)
        with self._handle.use() as groom:
            return _queries.head_of(self.context, groom, frame)

    def is_still(self, times: float | Sequence[float]) -> bool:
        """Whether guides and head are the same at all of these times, so that the strands
        of one time are those of all."""
        with self._handle.use() as groom:
            return _queries.is_still(self.context, groom, moments_of(times))

    def box(
        self,
        chunk: int,
        times: Times = None,
        kind: Literal["reach", "tight"] = "reach",
        **options: Unpack[Options],
    ) -> Floats:
        """[2][3]: minimum and maximum corner of a bounding box of a chunk at `times` and
        between them. "reach" is fast and wide; "tight" grows the chunk. `options`: as in
        `expand`."""
        kinds = {"reach": _abi.REACH, "tight": _abi.TIGHT}
        if kind not in kinds:
            raise CallError(f"kind {kind!r}: must be 'reach' or 'tight'")
        corners = (c_float * 6)()
        struct = options_of(moments_of(times), **options)
        with self._handle.use() as groom:
            status = library().lancret_groom_get_chunk_box(
                groom, chunk_index(chunk), byref(struct), kinds[kind], corners
            )
        self.context.raise_for(status)
        return np.array(corners, dtype=np.float32).reshape(2, 3)

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
        strands_per_pixel: float = 0,
        unit: float = 0,
    ) -> Curves:
        """Grows one chunk, several, or all (None) into one set of arrays.

        times: frame numbers, at most 256; None: the first frame, or rest.
        density: fraction of the strands to grow; fewer strands are wider. 0: the groom's.
        max_error: maximum distance from a curve to its strand, in units of the result;
            0: the groom's tolerance.
        pixels, strands_per_pixel: level of detail: the number of pixels that the chunk
            covers, and the maximum number of strands per pixel.
        unit: length unit of the result in cm; 0: 1 cm.
        """
        moments = moments_of(times)
        struct = options_of(
            moments,
            basis,
            density,
            max_error,
            attributes,
            pixels,
            strands_per_pixel,
            unit,
        )
        numbers = self._numbers(chunk)
        with self._handle.use() as groom, contextlib.ExitStack() as stack:
            handles = [
                stack.enter_context(_chunk.opened(self.context, groom, number, struct))
                for number in numbers
            ]
            sizes = [_chunk.sizes_of(self.context, handle) for handle in handles]
            whole = empty_curves(
                basis,
                moments,
                attributes,
                strands=sum(size.strands for size in sizes),
                points=sum(size.points for size in sizes),
                neighbours=max((size.neighbours for size in sizes), default=0),
            )
            strand = point = 0
            for handle, size in zip(handles, sizes):
                strands = slice(strand, strand + size.strands)
                points = slice(point, point + size.points)
                buffers = buffers_of(part(whole, strands, points))
                self.context.raise_for(
                    library().lancret_chunk_write(handle, byref(buffers))
                )
                strand, point = strands.stop, points.stop
        return whole

    def figures(
        self,
        figure: Figure,
        chunk: int | Iterable[int] | None = None,
        time: float | None = None,
        **options: Unpack[Options],
    ) -> Floats:
        """A figure of the strands that `expand` returns for the same chunks and options,
        one strand after another. Values per strand with n `segments`:

        "length_error": 1, relative error of the strand's length;
        "region": 1, number of its region;
        "orthogonality": n + 1, |R^T R - 1| of the frame at the ends of segments;
        "curvature", "torsion": n, 1/cm in each segment; torsion > 0 is right-handed.

        Values that are not finite are returned as the largest float32. Raises InputError
        for "torsion" if frames are twist-free, and for "region" if there are no regions.
        """
        struct = options_of(moments_of(time), **options)
        parts, numbers = [np.empty(0, dtype=np.float32)], self._numbers(chunk)
        with self._handle.use() as groom:
            for number in numbers:
                with _chunk.opened(self.context, groom, number, struct) as handle:
                    parts.append(_chunk.figures_of(self.context, handle, figure))
        return np.concatenate(parts)

    def binding(
        self,
        chunk: int | Iterable[int] | None = None,
        time: float | None = None,
        **options: Unpack[Options],
    ) -> ChunkInfo:
        """The counters of binding, summed over some chunks or all (None)."""
        struct = options_of(moments_of(time), **options)
        joined, numbers = ChunkInfo(), self._numbers(chunk)
        with self._handle.use() as groom:
            for number in numbers:
                with _chunk.opened(self.context, groom, number, struct) as handle:
                    joined = joined.joined(_chunk.info_of(self.context, handle))
        return joined

    def _numbers(self, chunk: int | Iterable[int] | None) -> list[int]:
        if chunk is None:
            return list(self.chunks)
        return list(chunk) if isinstance(chunk, Iterable) else [chunk]

    def check(
        self,
        chunk: int | Iterable[int] | None = None,
        times: Times = None,
        **options: Unpack[Options],
    ) -> Check:
        """Checks every strand of some chunks, or of all (None), at the first of
        `times`."""
        struct = options_of(moments_of(times), **options)
        joined, numbers = Check(), self._numbers(chunk)
        names = [field.name for field in dataclasses.fields(Check)]
        with self._handle.use() as groom:
            for number in numbers:
                check = _abi.Check()
                self.context.raise_for(
                    library().lancret_groom_check_chunk(
                        groom, chunk_index(number), byref(struct), byref(check)
                    )
                )
                joined = joined.joined(Check(*(getattr(check, n) for n in names)))
        return joined
