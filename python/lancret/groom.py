"""A groom that is open, and its strands."""

from __future__ import annotations

import contextlib
import ctypes
import functools
from collections.abc import Collection, Iterable, Sequence
from ctypes import byref, c_float, c_void_p
from types import TracebackType
from typing import Any, Literal, Unpack

import numpy as np

from . import _abi, _chunk, _told
from ._handle import Handle
from ._library import library
from ._options import Options, Times, chunk_index, moments_of, options_of
from ._source import Source
from .context import Context
from .curves import IDS, Attribute, Basis, Curves, buffers_of, empty_curves, part
from .errors import CallError
from .figures import Check, ChunkInfo, Guides, Info
from .geometry import Floats, Mesh

#: Of the text of an error.
ERROR_BYTES = 4096
Figure = Literal["length_error", "orthogonality", "curvature", "torsion", "region"]


class Groom:
    """A groom that is open: guides fitted, strands told but not grown. Close it, or use
    it in a `with`. Any number of threads may use one at once."""

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
        with self._handle.use() as groom:
            return _told.info_of(self.context, groom)

    @property
    def chunks(self) -> range:
        """The chunks' numbers: `for chunk in groom.chunks: groom.expand(chunk)`."""
        return range(self.info.chunks)

    def guides(self) -> Guides:
        with self._handle.use() as groom:
            return _told.guides_of(self.context, groom)

    def describe(self) -> dict[str, Any]:
        """What guides were fitted to, and how well: groom_strands, guides, segments,
        blend, fit, roots."""
        with self._handle.use() as groom:
            return _told.description_of(self.context, groom)

    def head(self, time: float | None = None) -> Mesh:
        """What is seen of the head at a time (none: the first frame, or rest), in cm;
        without vertices where there is none."""
        at = float(self.info.first_frame if time is None else time)
        with self._handle.use() as groom:
            return _told.head_of(self.context, groom, at)

    def is_still(self, times: float | Sequence[float]) -> bool:
        """Whether guides and head are at all of these times where they are at the first,
        so that the strands of one are those of all."""
        with self._handle.use() as groom:
            return _told.is_still(self.context, groom, moments_of(times))

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
            status = library().lancret_groom_get_chunk_box(
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
        strands_per_pixel: float = 0,
        unit: float = 0,
    ) -> Curves:
        """Grows a chunk, some chunks, or all of them (None), into one set of arrays.

        times: frames, up to 256; none: the first, or rest.
        density: share of the strands that are grown, wider; 0: the groom's own.
        max_error: that curves may be off the strands, in the units given back; 0: the
            groom's own tolerance.
        pixels, strands_per_pixel: level of detail: how many the chunk covers, and at most
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
            strands_per_pixel,
            unit,
        )
        numbers = self._numbers(chunk)
        with self._handle.use() as groom, contextlib.ExitStack() as until_done:
            opened = [
                until_done.enter_context(
                    _chunk.bound(self.context, groom, number, asked)
                )
                for number in numbers
            ]
            sizes = [_chunk.sizes_of(self.context, handle) for handle in opened]
            whole = empty_curves(
                basis,
                moments,
                attributes,
                strands=sum(size.strands for size in sizes),
                points=sum(size.points for size in sizes),
                neighbours=max((size.neighbours for size in sizes), default=0),
            )
            strand = point = 0
            for handle, size in zip(opened, sizes):
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
        """A figure of the strands that `expand` gives of the same chunks and options, one
        strand after another; a strand of n `pieces` has

        "length_error": one, relative, of what was synthesised;
        "region": one, its number;
        "orthogonality": n + 1, at the ends of its pieces, |R^T R - 1| of the frame;
        "curvature", "torsion": n, in its pieces, 1/cm; torsion above 0 is right-handed.

        What is no finite number is the largest float32. Raises InputError for the torsion
        of frames that are carried without twist, and the region where there are none.
        """
        asked = options_of(moments_of(time), **options)
        parts, numbers = [np.empty(0, dtype=np.float32)], self._numbers(chunk)
        with self._handle.use() as groom:
            for number in numbers:
                with _chunk.bound(self.context, groom, number, asked) as handle:
                    parts.append(_chunk.figures_of(self.context, handle, figure))
        return np.concatenate(parts)

    def binding(
        self,
        chunk: int | Iterable[int] | None = None,
        time: float | None = None,
        **options: Unpack[Options],
    ) -> ChunkInfo:
        """What binding had to work around, of some chunks or all (None) together."""
        asked = options_of(moments_of(time), **options)
        joined, numbers = ChunkInfo(0, 0, 0, 0, 0, 0, 0, 0), self._numbers(chunk)
        with self._handle.use() as groom:
            for number in numbers:
                with _chunk.bound(self.context, groom, number, asked) as handle:
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
        """Looks at every strand of some chunks, or of all (None), at the first of
        `times`."""
        asked = options_of(moments_of(times), **options)
        joined, numbers = Check(0, 0, 0, 0.0, 0.0, 0.0, 0.0), self._numbers(chunk)
        with self._handle.use() as groom:
            for number in numbers:
                struct = _abi.Check()
                self.context.raise_for(
                    library().lancret_groom_check_chunk(
                        groom, chunk_index(number), byref(asked), byref(struct)
                    )
                )
                names = [name for name, *_ in _abi.Check._fields_[1:]]
                joined = joined.joined(Check(*(getattr(struct, n) for n in names)))
        return joined
