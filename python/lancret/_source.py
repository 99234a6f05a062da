"""Converts the arguments of `lancret.open` to lancret_source."""

from __future__ import annotations

import ctypes
import os
from collections.abc import Iterator, Mapping
from ctypes import POINTER, c_float, c_uint
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _abi
from .errors import InputError
from .geometry import Mesh, Strands

Parameters = Mapping[str, Any]


def pointer_to(array: npt.NDArray[Any] | None, kind: type[Any]) -> Any:
    """A C pointer to an array's memory; None for None. The array must outlive it."""
    if array is None:
        return None
    return array.ctypes.data_as(POINTER(kind))


def flat(parameters: Parameters, table: str = "") -> Iterator[tuple[str, Any]]:
    """Yields ("strands.count", 5) for {"strands": {"count": 5}} and {"strands.count": 5}."""
    for key, value in parameters.items():
        name = f"{table}{key}"
        if isinstance(value, Mapping):
            yield from flat(value, f"{name}.")
        else:
            yield name, value


def _parameter(name: str, value: Any) -> _abi.Parameter:
    if isinstance(value, (str, os.PathLike)):
        return _abi.Parameter(_bytes(name), _bytes(value), 0.0)
    try:
        number = float(value)
    except (TypeError, ValueError, OverflowError):
        raise InputError(
            f"{name}: {value!r} is neither text nor a number nor true or false; put "
            "lists into the TOML"
        ) from None
    if isinstance(value, (int, np.integer)) and number != value:
        raise InputError(f"{name}: {value} is above 2^53; put it into the TOML")
    return _abi.Parameter(_bytes(name), None, number)


def _with_defaults_of(
    strands: Strands, parameters: dict[str, Any], *, has_toml: bool
) -> dict[str, Any]:
    """`parameters`, completed by the unit, up axis and widths of the strands. has_toml:
    the strands' unit is unknown unless they or `parameters` set it."""
    values: dict[str, Any] = {}
    if strands.metres_per_unit is not None:
        values["scene.metres_per_unit"] = strands.metres_per_unit
    elif not has_toml:
        values["scene.metres_per_unit"] = 0.01
    if strands.up is not None:
        values["scene.up"] = strands.up
    values |= parameters
    taper = strands.taper()
    if taper is not None and not {"width.root", "width.tip"} <= set(parameters):
        if "scene.metres_per_unit" not in values:
            raise InputError(
                "widths: unknown unit; set metres_per_unit of the strands, or width.root "
                "and width.tip, in cm, in `parameters`"
            )
        cm = 100 * float(values["scene.metres_per_unit"])
        values = {"width.root": taper[0] * cm, "width.tip": taper[1] * cm} | values
    return values


class Source:
    """A lancret_source and the memory that it points to."""

    def __init__(
        self,
        source: str | os.PathLike[str] | None,
        *,
        text: str | None = None,
        folder: str | os.PathLike[str] | None = None,
        parameters: Parameters | None = None,
        strands: Strands | None = None,
        scalp: Mesh | None = None,
        chunk_strands: int = 0,
    ) -> None:
        if isinstance(source, str) and "\n" in source:
            if text is not None:
                raise InputError("the text of the TOML is given twice")
            source, text = None, source
        has_toml = source is not None or bool(text)
        if source is None and text is None and strands is not None:
            text = ""  # the groom consists of the strands only
        values = dict(flat(parameters or {}))
        if strands is not None:
            values = _with_defaults_of(strands, values, has_toml=has_toml)
        if not 0 <= chunk_strands < 2**32:
            raise InputError(f"chunk_strands: must be 0 or more, not {chunk_strands}")
        self._kept: list[object] = [strands, scalp]
        listed = (_abi.Parameter * len(values))(
            *(_parameter(name, value) for name, value in values.items())
        )
        self.struct = _abi.Source(
            path=_bytes(source),
            text=_bytes(text),
            folder=_bytes(folder),
            parameters=listed,
            parameter_count=len(values),
            chunk_strands=chunk_strands,
        )
        if strands is not None:
            self.struct.strands = ctypes.pointer(_strands(strands))
        if scalp is not None:
            self.struct.scalp = ctypes.pointer(_mesh(scalp))


def _bytes(value: str | os.PathLike[str] | None) -> bytes | None:
    if value is None:
        return None
    encoded = os.fsencode(value)
    if b"\0" in encoded:
        raise InputError("text must not contain a zero byte")
    return encoded


def _strands(strands: Strands) -> _abi.Strands:
    if strands.basis not in _abi.BASES:
        raise InputError(
            f"basis {strands.basis!r}: must be one of {', '.join(_abi.BASES)}"
        )
    return _abi.Strands(
        basis=_abi.BASES[strands.basis],
        strands=len(strands.counts),
        counts=pointer_to(strands.counts, c_uint),
        points=pointer_to(strands.points, c_float),
    )


def _mesh(mesh: Mesh) -> _abi.Mesh:
    return _abi.Mesh(
        vertices=len(mesh.positions),
        triangles=len(mesh.corners),
        positions=pointer_to(mesh.positions, c_float),
        corners=pointer_to(mesh.corners, c_uint),
        uvs=pointer_to(mesh.uvs, c_float),
    )
