"""Curves of every basis against closed forms."""

import unittest

import numpy as np

from lancret import InputError, cubic


class Cubic(unittest.TestCase):
    def test_bsplines_of_points_on_a_line_are_even_along_it(self):
        points = np.arange(6.0)[:, None]
        places, counts = cubic.sample(points, np.array([6]), "bspline", 4)
        self.assertEqual(counts.tolist(), [13])
        np.testing.assert_allclose(places[:, 0], np.linspace(1, 4, 13), atol=1e-14)

    def test_catmull_rom_passes_through_all_but_the_outer_points(self):
        points = np.random.default_rng(1).normal(size=(7, 3))
        places, _ = cubic.sample(points, np.array([7]), "catmull-rom", 5)
        np.testing.assert_allclose(places[::5], points[1:-1], atol=1e-14)

    def test_bezier_segments_agree_with_de_casteljau(self):
        points = np.random.default_rng(2).normal(size=(7, 3))
        places, counts = cubic.sample(points, np.array([7]), "bezier", 2)
        rows = points[3:].copy()
        while len(rows) > 1:
            rows = (rows[:-1] + rows[1:]) / 2
        np.testing.assert_allclose(places[3], rows[0], atol=1e-14)
        np.testing.assert_allclose(places[[0, 2, 4]], points[::3], atol=1e-14)
        self.assertEqual(counts.tolist(), [5])

    def test_strands_of_different_counts_stay_in_their_order(self):
        counts = np.array([5, 4, 5, 6])
        points = np.arange(counts.sum(), dtype=float)[:, None]
        places, sizes = cubic.sample(points, counts, "bspline", 1)
        self.assertEqual(sizes.tolist(), [3, 2, 3, 4])
        np.testing.assert_allclose(
            places[:, 0], [1, 2, 3, 6, 7, 10, 11, 12, 15, 16, 17, 18]
        )

    def test_phantom_points_make_bsplines_reach_their_ends(self):
        counts = np.array([2, 5])
        points = np.random.default_rng(3).normal(size=(7, 3))
        extended, extended_counts = cubic.with_phantoms(points, counts)
        places, sizes = cubic.sample(extended, extended_counts, "bspline", 1)
        self.assertEqual(extended_counts.tolist(), [4, 7])
        self.assertEqual(sizes.tolist(), [2, 5])
        np.testing.assert_allclose(
            places[[0, 1, 2, 6]], points[[0, 1, 2, 6]], atol=1e-14
        )

    def test_hermite_segments_begin_and_end_with_their_derivatives(self):
        random = np.random.default_rng(4)
        points, tangents = random.normal(size=(5, 4)), random.normal(size=(5, 4))
        bezier, counts = cubic.hermite_as_bezier(points, tangents, np.array([3, 2]))
        self.assertEqual(counts.tolist(), [7, 4])
        np.testing.assert_allclose(bezier[[0, 3, 6, 7, 10]], points)
        np.testing.assert_allclose(3 * (bezier[1] - bezier[0]), tangents[0], atol=1e-14)
        np.testing.assert_allclose(3 * (bezier[6] - bezier[5]), tangents[2], atol=1e-14)

    def test_no_curves_have_no_places(self):
        nothing, counts = np.empty((0, 4)), np.empty(0, np.uint32)
        for places, sizes in (
            cubic.sample(nothing, counts, "bspline", 4),
            cubic.with_phantoms(nothing, counts),
            cubic.hermite_as_bezier(nothing, nothing, counts),
        ):
            self.assertEqual((places.shape, sizes.shape), ((0, 4), (0,)))

    def test_counts_that_are_impossible_for_a_basis_are_refused(self):
        for count, basis in (
            (1, "linear"),
            (3, "bspline"),
            (5, "bezier"),
            (3, "bezier"),
        ):
            with self.assertRaisesRegex(
                InputError, f"{basis} curve cannot have {count} points"
            ):
                cubic.segments_of(count, basis)
