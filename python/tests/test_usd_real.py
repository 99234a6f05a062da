"""USD files of other programs, with their peculiarities."""

import unittest

import numpy as np

from lancret import Strands, cubic

from .support import DATA, HAS_USD, needs_data, needs_usd

if HAS_USD:
    from lancret import usd


@needs_usd
@needs_data
class RealFiles(unittest.TestCase):
    def test_a_pinned_tuft_that_has_only_samples(self):
        read = usd.read(DATA / "tuft_bspline.usda")
        self.assertEqual((len(read), read.basis), (1987, "bspline"))
        self.assertTrue((read.counts == 12).all())
        self.assertEqual((read.metres_per_unit, read.up), (1, "Y"))
        self.assertEqual(read.ids.shape, (1987,))
        places, counts = cubic.sample(read.points, read.counts, "bspline", 1)
        roots = places[:: counts[0]]
        mesh = usd.read_mesh(DATA / "tuft_bspline.usda")
        near = np.linalg.norm(roots[:50, None] - mesh.positions[None], axis=2).min(
            axis=1
        )
        self.assertLess(near.max(), 0.05)  # the sphere's edges are about 0.03 long
        outwards = np.einsum(
            "ij,ij->i",
            np.cross(
                mesh.positions[mesh.corners[:, 1]] - mesh.positions[mesh.corners[:, 0]],
                mesh.positions[mesh.corners[:, 2]] - mesh.positions[mesh.corners[:, 0]],
            ),
            mesh.positions[mesh.corners[:, 0]],
        )
        self.assertGreater((outwards > 0).mean(), 0.99)  # left-handed, so flipped

    def test_blenders_hair_has_no_wrap_and_a_transform(self):
        read = usd.read(DATA / "wavy_blender.usda")
        self.assertEqual((len(read), read.basis, read.up), (72, "bspline", "Z"))
        self.assertTrue((read.counts == 9).all())
        self.assertIsNone(read.widths)
        np.testing.assert_allclose(  # the file's first point, moved by its parent
            read.points[0], [-0.24708444, -0.66069597, -2 * 0.80387932], atol=1e-6
        )
        self.assertIsInstance(read, Strands)
        meant = usd.read(DATA / "wavy_blender.usda", transform=False, wrap="pinned")
        places, counts = cubic.sample(meant.points, meant.counts, "bspline", 1)
        plane = usd.read_mesh(DATA / "wavy_blender.usda")
        np.testing.assert_allclose(
            places[:: counts[0], 2], plane.positions[0, 2], atol=1e-4
        )
