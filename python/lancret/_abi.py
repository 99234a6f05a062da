"""The C interface in ctypes, field by field as in procedural/lancret_procedural.h.

Internal. The constructor of a struct sets its `size`.
"""

from __future__ import annotations

import ctypes
import dataclasses
from ctypes import (
    POINTER,
    c_char_p,
    c_double,
    c_float,
    c_int,
    c_size_t,
    c_uint,
    c_void_p,
)

from . import figures

ABI_VERSION = 2
OK, CANCELLED = 0, 4
REACH, TIGHT = 0, 1

#: lancret_strands.basis and lancret_options.basis.
BASES = {"linear": 0, "bspline": 1, "catmull-rom": 2, "bezier": 3, "hermite": 4}
BASIS_NAMES = {number: name for name, number in BASES.items()}
#: lancret_options.attributes.
ATTRIBUTES = {
    "tangents": 1,
    "normals": 2,
    "ids": 4,
    "root_uv": 8,
    "lengths": 16,
    "guides": 32,
    "arc_lengths": 64,
    "random": 128,
}
#: The `figure` argument of lancret_chunk_get_figures.
FIGURES = {
    "length_error": 0,
    "orthogonality": 1,
    "curvature": 2,
    "torsion": 3,
    "region": 4,
}
#: lancret_groom_info.shape.
SHAPES = {0: "any", 1: "flat", 2: "round", 3: "ribbon"}
LOG_LEVELS = {0: "info", 1: "warning", 2: "error"}

Log = ctypes.CFUNCTYPE(None, c_void_p, c_int, c_char_p)
Cancel = ctypes.CFUNCTYPE(c_int, c_void_p)
TextSink = ctypes.CFUNCTYPE(None, c_void_p, c_char_p)


class Sized(ctypes.Structure):
    """A struct that begins with its size."""

    def __init__(self, **fields: object) -> None:
        super().__init__(size=ctypes.sizeof(type(self)), **fields)


class Host(Sized):
    _fields_ = [
        ("size", c_size_t),
        ("user", c_void_p),
        ("log", Log),
        ("allocate", c_void_p),
        ("release", c_void_p),
        ("cancelled", Cancel),
        ("threads", c_int),
    ]


class Parameter(ctypes.Structure):
    _fields_ = [("name", c_char_p), ("text", c_char_p), ("number", c_double)]


class Strands(Sized):
    _fields_ = [
        ("size", c_size_t),
        ("basis", c_int),
        ("strands", c_uint),
        ("counts", POINTER(c_uint)),
        ("points", POINTER(c_float)),
    ]


class Mesh(Sized):
    _fields_ = [
        ("size", c_size_t),
        ("vertices", c_uint),
        ("triangles", c_uint),
        ("positions", POINTER(c_float)),
        ("corners", POINTER(c_uint)),
        ("uvs", POINTER(c_float)),
    ]


MeshSink = ctypes.CFUNCTYPE(c_int, c_void_p, POINTER(Mesh))


class Source(Sized):
    _fields_ = [
        ("size", c_size_t),
        ("path", c_char_p),
        ("text", c_char_p),
        ("folder", c_char_p),
        ("parameters", POINTER(Parameter)),
        ("parameter_count", c_size_t),
        ("strands", POINTER(Strands)),
        ("scalp", POINTER(Mesh)),
        ("chunk_strands", c_uint),
    ]


class Info(Sized):
    _fields_ = [
        ("size", c_size_t),
        ("chunks", c_uint),
        ("strands", c_uint),
        ("guides", c_uint),
        ("segments", c_uint),
        ("intervals", c_uint),
        ("neighbours", c_uint),
        ("first_frame", c_int),
        ("last_frame", c_int),
        ("cm_per_unit", c_float),
        ("up", c_float * 3),
        ("load_seconds", c_double),
        ("fit_seconds", c_double),
        ("bind_seconds", c_double),
        ("bytes", c_size_t),
        ("frames", c_int),
        ("basis", c_int),
        ("shape", c_int),
        ("box", c_float * 6),
    ]


class Options(Sized):
    _fields_ = [
        ("size", c_size_t),
        ("times", POINTER(c_double)),
        ("time_count", c_size_t),
        ("basis", c_int),
        ("max_error", c_float),
        ("density", c_double),
        ("pixels", c_double),
        ("strands_per_pixel", c_double),
        ("attributes", c_uint),
        ("unit", c_float),
    ]


FloatRows = POINTER(POINTER(c_float))


class Curves(Sized):
    _fields_ = [
        ("size", c_size_t),
        ("basis", c_int),
        ("strands", c_uint),
        ("points", c_uint),
        ("times", c_uint),
        ("neighbours", c_uint),
        ("counts", POINTER(c_uint)),
        ("positions", FloatRows),
        ("tangents", FloatRows),
        ("normals", FloatRows),
        ("ids", POINTER(c_uint)),
        ("root_uv", POINTER(c_float)),
        ("lengths", POINTER(c_float)),
        ("guides", POINTER(c_uint)),
        ("weights", POINTER(c_float)),
        ("arc_lengths", POINTER(c_float)),
        ("random", POINTER(c_float)),
    ]


class ChunkInfo(Sized):
    _fields_ = [
        ("size", c_size_t),
        *(
            (field.name, c_size_t if field.name == "bytes" else c_uint)
            for field in dataclasses.fields(figures.ChunkInfo)
        ),
    ]


class Check(Sized):
    _fields_ = [
        ("size", c_size_t),
        ("strands", c_uint),
        ("failed", c_uint),
        ("outside", c_uint),
        ("orthogonality", c_double),
        ("length_error", c_double),
        ("curve_length_error", c_double),
        ("distance", c_double),
    ]


class Guides(Sized):
    _fields_ = [
        ("size", c_size_t),
        ("guides", c_uint),
        ("segments", c_uint),
        ("root_positions", POINTER(c_double)),
        ("root_frames", POINTER(c_double)),
        ("segment_lengths", POINTER(c_double)),
        ("curvatures", POINTER(c_double)),
        ("fit_rms", POINTER(c_double)),
    ]


#: The structs by C name, for the test that compares them with the header.
STRUCTS: dict[str, type[ctypes.Structure]] = {
    "lancret_host": Host,
    "lancret_parameter": Parameter,
    "lancret_strands": Strands,
    "lancret_mesh": Mesh,
    "lancret_source": Source,
    "lancret_groom_info": Info,
    "lancret_options": Options,
    "lancret_curves": Curves,
    "lancret_chunk_info": ChunkInfo,
    "lancret_check": Check,
    "lancret_guides": Guides,
}

#: Result and argument types of each function; handles are c_void_p.
FUNCTIONS: dict[str, tuple[object, list[object]]] = {
    "lancret_version": (c_char_p, []),
    "lancret_abi_version": (c_int, []),
    "lancret_context_create": (c_int, [c_int, POINTER(Host), POINTER(c_void_p)]),
    "lancret_context_destroy": (None, [c_void_p]),
    "lancret_groom_open": (
        c_int,
        [c_void_p, POINTER(Source), POINTER(c_void_p), c_char_p, c_size_t],
    ),
    "lancret_groom_close": (None, [c_void_p]),
    "lancret_groom_get_info": (c_int, [c_void_p, POINTER(Info)]),
    "lancret_groom_describe": (c_int, [c_void_p, TextSink, c_void_p]),
    "lancret_groom_get_head": (c_int, [c_void_p, c_double, MeshSink, c_void_p]),
    "lancret_groom_is_still": (
        c_int,
        [c_void_p, POINTER(c_double), c_size_t, POINTER(c_int)],
    ),
    "lancret_groom_get_chunk_box": (
        c_int,
        [c_void_p, c_uint, POINTER(Options), c_int, POINTER(c_float)],
    ),
    "lancret_chunk_open": (
        c_int,
        [c_void_p, c_uint, POINTER(Options), POINTER(c_void_p)],
    ),
    "lancret_chunk_get_sizes": (c_int, [c_void_p, POINTER(Curves)]),
    "lancret_chunk_write": (c_int, [c_void_p, POINTER(Curves)]),
    "lancret_chunk_close": (None, [c_void_p]),
    "lancret_chunk_get_info": (c_int, [c_void_p, POINTER(ChunkInfo)]),
    "lancret_chunk_get_figures": (c_int, [c_void_p, c_int, c_size_t, POINTER(c_float)]),
    "lancret_groom_check_chunk": (
        c_int,
        [c_void_p, c_uint, POINTER(Options), POINTER(Check)],
    ),
    "lancret_groom_get_guides": (c_int, [c_void_p, POINTER(Guides)]),
    "lancret_context_evaluate": (
        c_int,
        [c_void_p, POINTER(Source), TextSink, c_void_p, c_char_p, c_size_t],
    ),
}
