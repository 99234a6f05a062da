"""Queries of grooms and chunks."""

import unittest

import numpy as np

import lancret

from .shapes import lawn, square
from .support import SMALL


def helices(hand=1, number=5):
    """Helices of radius 1 that climb by 0.5 per radian, so their curvature is 0.8. `hand`
    > 0: right-handed."""
    t = np.linspace(0, 6, 60)
    helix = np.stack([np.cos(t) - 1, hand * np.sin(t), t / 2], axis=1)
    points = np.concatenate([helix + [3 * i, 0, 0] for i in range(number)])
    return lancret.Strands(points, [60] * number)


class Figures(unittest.TestCase):
    def test_of_strands_are_as_many_as_their_segments(self):
        with lancret.open(SMALL, chunk_strands=64) as groom:
            for basis in ("bspline", "bezier", "linear", "hermite"):
                hair = groom.expand(basis=basis)
                for figure, expected in (
                    ("length_error", len(hair)),
                    ("orthogonality", hair.segments.sum() + len(hair)),
                    ("curvature", hair.segments.sum()),
                    ("torsion", hair.segments.sum()),
                ):
                    found = groom.figures(figure, basis=basis)
                    self.assertEqual(len(found), expected, (basis, figure))
            one = groom.figures("curvature", chunk=1, basis="hermite")
            before = groom.expand(0, basis="hermite").segments.sum()
            whole = groom.figures("curvature", basis="hermite")
            np.testing.assert_array_equal(one, whole[before : before + len(one)])
            self.assertEqual(len(groom.figures("curvature", chunk=[])), 0)

    def test_agree_with_the_check(self):
        with lancret.open(SMALL, chunk_strands=64) as groom:
            check = groom.check()
            for figure in ("orthogonality", "length_error"):
                worst = np.abs(groom.figures(figure)).max()
                self.assertEqual(np.float32(getattr(check, figure)), worst)

    def test_of_helices_are_their_guides(self):
        """Without a scalp, children have the guides' roots and are copies of them."""
        for hand in (1, -1):
            with lancret.open(
                strands=helices(hand),
                parameters={"strands.count": 5, "guides.segments": 6},
            ) as groom:
                hair = groom.expand(attributes=("guides",))
                guides = groom.guides().curvatures
                curvature, torsion = (
                    groom.figures(name).reshape(5, -1)
                    for name in ("curvature", "torsion")
                )
            # The fit is within 2 %, which 60 points on a curl of 6 radians allow.
            np.testing.assert_allclose(curvature, 0.8, rtol=0.02)
            self.assertTrue((hand * torsion > 0).all())
            self.assertEqual(curvature.shape[1] % guides.shape[1], 0)
            each = curvature.shape[1] // guides.shape[1]
            bends = np.linalg.norm(guides[:, :, 1:], axis=2)
            guide = hair.guides[:, 0]
            for found, expected in ((curvature, bends), (torsion, guides[:, :, 0])):
                np.testing.assert_allclose(
                    found,
                    np.repeat(expected[guide], each, axis=1),
                    rtol=1e-4,
                    atol=1e-4,
                )

    def test_that_do_not_exist_are_refused(self):
        with lancret.open(SMALL) as groom:
            with self.assertRaisesRegex(lancret.InputError, "no regions"):
                groom.figures("region")
            with self.assertRaisesRegex(
                lancret.CallError, "'beauty': must be one of length"
            ):
                groom.figures("beauty")
        untwisted = SMALL + 'blend = "option3"\n'
        with lancret.open(untwisted) as groom:
            with self.assertRaises(lancret.InputError):
                groom.figures("torsion")
            self.assertGreater(groom.figures("curvature").max(), 0)

    def test_binding_counts_every_strand(self):
        with lancret.open(SMALL, chunk_strands=64) as groom:
            whole = groom.binding()
            self.assertEqual(whole.strands, 300)
            self.assertEqual(
                whole.bytes, sum(groom.binding(i).bytes for i in groom.chunks)
            )
            self.assertEqual(whole.no_guide_in_reach, 0)
        near = {"strands.max_distance": 0.001}
        with lancret.open(SMALL, parameters=near) as groom:
            self.assertEqual(groom.binding().no_guide_in_reach, 300)


class Queries(unittest.TestCase):
    def test_info_has_the_box_and_what_to_draw(self):
        with lancret.open(strands=lawn()) as groom:
            info = groom.info
        self.assertEqual((info.frames, info.basis, info.shape), (0, "bspline", "any"))
        points = lawn().points
        # Guides are fitted within 0.0025 cm, and are inside the box of their joints.
        np.testing.assert_allclose(info.box[0], points.min(axis=0), atol=0.02)
        np.testing.assert_allclose(info.box[1], points.max(axis=0), atol=0.02)
        options = {"strands.curve": "hermite", "strands.shape": "round"}
        with lancret.open(SMALL, parameters=options) as groom:
            self.assertEqual((groom.info.basis, groom.info.shape), ("hermite", "round"))

    def test_the_description_is_of_the_fit(self):
        with lancret.open(SMALL) as groom:
            description, guides = groom.describe(), groom.guides()
        self.assertEqual((description["guides"], description["segments"]), (40, 6))
        shares = guides.fit_rms / guides.lengths
        self.assertLessEqual(description["fit"]["rms_over_length_median"], shares.max())
        self.assertEqual(description["blend"], "detail")

    def test_the_head_is_the_mesh_that_was_passed_in(self):
        given = square()
        with lancret.open(strands=lawn(), scalp=given) as groom:
            head = groom.head()
            np.testing.assert_array_equal(head.positions, given.positions)
            np.testing.assert_array_equal(head.corners, given.corners)
            np.testing.assert_array_equal(head.uvs, given.uvs)
            self.assertTrue(groom.is_still([1, 2, 3.5]))
            with self.assertRaises(lancret.CallError):
                groom.is_still([])
        with lancret.open(strands=lawn()) as groom:
            head = groom.head()
        self.assertEqual((len(head.positions), len(head.corners)), (0, 0))
