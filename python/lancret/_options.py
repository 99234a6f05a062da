"""Converts keyword arguments to lancret_options."""

from __future__ import annotations

import operator
from collections.abc import Collection, Sequence
from ctypes import c_double
from typing import TypedDict

import numpy as np

from . import _abi
from .curves import Attribute, Basis, attribute_bits
from .errors import CallError

Times = float | Sequence[float] | None

_U32 = 2**32


class Options(TypedDict, total=False):
    """The keyword arguments of `Groom.expand` besides chunks and times."""

    basis: Basis
    density: float
    max_error: float
    attributes: Collection[Attribute]
    pixels: float
    strands_per_pixel: float
    unit: float


def chunk_index(chunk: int) -> int:
    try:
        number = operator.index(chunk)
    except TypeError:
        raise CallError(f"chunk {chunk!r}: must be a whole number") from None
    if not 0 <= number < _U32:
        raise CallError(f"chunk {number}: does not exist")
    return number


def moments_of(times: Times) -> tuple[float, ...]:
    if times is None:
        return ()
    if np.ndim(times) == 0:
        return (float(times),)  # type: ignore[arg-type]
    return tuple(float(time) for time in times)  # type: ignore[union-attr]


def options_of(
    times: tuple[float, ...] = (),
    basis: Basis = "bspline",
    density: float = 0,
    max_error: float = 0,
    attributes: Collection[Attribute] = (),
    pixels: float = 0,
    strands_per_pixel: float = 0,
    unit: float = 0,
) -> _abi.Options:
    if basis not in _abi.BASES:
        raise CallError(f"basis {basis!r}: must be one of {', '.join(_abi.BASES)}")
    return _abi.Options(
        times=(c_double * len(times))(*times) if times else None,
        time_count=len(times),
        basis=_abi.BASES[basis],
        max_error=max_error,
        density=density,
        pixels=pixels,
        strands_per_pixel=strands_per_pixel,
        attributes=attribute_bits(attributes),
        unit=unit,
    )
