"""Helpers of the tests: an empty scene with the add-on, a small groom, reading back."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import bpy
import lancret_blender
import numpy as np
from lancret_blender import strands
from lancret_blender.package import lancret

GROOM = """
[guides]
count = 30
segments = 8
[guides.made]
strands = 60
shortest = 15
longest = 20
curl_radius = 0.4
curl_wavelength = 6
[strands]
count = 400
[width]
root = 0.012
tip = 0.004
"""


class InBlender(unittest.TestCase):
    def setUp(self):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        lancret_blender.register()
        self.addCleanup(lancret_blender.unregister)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.groom = self.folder / "groom.toml"
        self.groom.write_text(GROOM)
        self.scene = bpy.context.scene

    def add(self, path=None):
        """Adds a Lancret object for a file (default: the small groom)."""
        bpy.ops.object.lancret_add(filepath=str(path or self.groom))
        return bpy.context.object

    def update(self, obj):
        bpy.context.view_layer.objects.active = obj
        bpy.ops.object.lancret_update()

    def small_render(self):
        self.scene.render.engine = "CYCLES"
        self.scene.cycles.samples = 1
        self.scene.cycles.use_denoising = False
        self.scene.render.resolution_x = self.scene.render.resolution_y = 8
        if self.scene.camera is None:
            camera = bpy.data.objects.new("eye", bpy.data.cameras.new("eye"))
            self.scene.collection.objects.link(camera)
            self.scene.camera = camera
        self.scene.render.filepath = str(self.folder / "picture.png")


def evaluated(obj):
    """Points [n][3], radii [n] and counts of the curves that Blender draws for an object."""
    curves = obj.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
    points = np.empty((len(curves.points), 3), np.float32)
    curves.attributes["position"].data.foreach_get("vector", points.ravel())
    radii = np.empty(len(points), np.float32)
    curves.attributes["radius"].data.foreach_get("value", radii)
    offsets = np.empty(len(curves.curves) + 1, np.int32)
    curves.curve_offset_data.foreach_get("value", offsets)
    return points, radii, np.diff(offsets)


def of_the_abi(path, density=0.0, times=None, unit=100.0, parameters=None, **options):
    """The same from Lancret, chunk by chunk, strand by strand, in Blender's axes, for a
    groom with Y up."""
    points, radii, counts = [], [], []
    values = {"strands.adapt": False} | (parameters or {})
    with lancret().open(path, parameters=values, **options) as groom:
        for chunk in groom.chunks:
            curves = groom.expand(
                chunk, times, strands.BASIS, density, attributes=(), unit=unit
            )
            for number in range(len(curves)):
                inner = curves.strand(number)[1:-1]
                points.append(np.stack([inner[:, 0], -inner[:, 2], inner[:, 1]], -1))
                radii.append(inner[:, 3])
                counts.append(len(inner))
    return np.concatenate(points), np.concatenate(radii), np.array(counts)


def same_bits(a, b):
    a, b = np.ascontiguousarray(a), np.ascontiguousarray(b)
    return a.shape == b.shape and a.dtype == b.dtype and a.tobytes() == b.tobytes()


def assert_same(test, found, expected):
    """Compares counts, and points and radii bit for bit."""
    test.assertGreater(len(expected[2]), 0)
    test.assertTrue(np.array_equal(found[2], expected[2]), "counts")
    test.assertTrue(same_bits(found[0], expected[0]), "positions")
    test.assertTrue(same_bits(found[1], expected[1]), "radii")


def lancret_command():
    """The command-line tool, to make caches; skips the test if there is none."""
    command = os.environ.get("LANCRET_COMMAND")
    if not command:
        raise unittest.SkipTest("LANCRET_COMMAND does not name the lancret command")
    return command


def simulate(groom, frames, cache):
    subprocess.run(
        [lancret_command(), "simulate", groom, "--frames", frames, "-o", cache],
        check=True,
        capture_output=True,
    )
