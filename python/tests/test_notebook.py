"""Pictures and histograms of strands."""

import sys
import unittest
import unittest.mock

import numpy as np

import lancret
from lancret import notebook

from .support import needs_plots


def circles(radii, points=33):
    """Half circles about Z as polylines."""
    angles = np.linspace(0, np.pi, points)
    rows = [
        np.stack(
            [r * np.cos(angles), r * np.sin(angles), 0 * angles, 0 * angles], axis=1
        )
        for r in radii
    ]
    return lancret.Curves(
        basis="linear",
        times=(),
        counts=np.full(len(radii), points, np.uint32),
        positions=np.concatenate(rows).astype(np.float32)[None],
    )


class Figures(unittest.TestCase):
    def test_lengths_and_curvatures_of_circles(self):
        lengths, curvatures = notebook.lengths_and_curvatures(circles([1, 4]))
        # A chord has length 2 r sin(a / 2); the circle through three points is the circle.
        expected = 32 * 2 * np.sin(np.pi / 64) * np.array([1, 4])
        np.testing.assert_allclose(lengths, expected, rtol=1e-5)
        np.testing.assert_allclose(curvatures, np.repeat([1, 0.25], 31), rtol=1e-3)

    @needs_plots
    def test_a_picture_has_three_views_of_max_strands_lines(self):
        figure = notebook.picture(circles([1, 2, 3, 4]), max_strands=2)
        self.assertEqual(len(figure.axes), 3)
        self.assertEqual(len(figure.axes[0].collections[0].get_segments()), 2 * 32)

    @needs_plots
    def test_up_is_up_in_the_first_two_views(self):
        front, side, _ = notebook.picture(circles([1]), up=2).axes
        self.assertEqual((front.get_ylabel(), side.get_ylabel()), ("z", "z"))

    @needs_plots
    def test_histograms_count_every_strand(self):
        figure = notebook.histograms(circles([1, 2, 3]))
        counted = sum(bar.get_height() for bar in figure.axes[0].patches)
        self.assertEqual(counted, 3)

    @needs_plots
    def test_strands_of_two_points_have_no_curvature(self):
        lengths, curvatures = notebook.lengths_and_curvatures(circles([1, 2], points=2))
        self.assertEqual((lengths.tolist(), len(curvatures)), ([2, 4], 0))
        notebook.histograms(circles([1, 2], points=2))

    def test_without_matplotlib_the_error_names_what_to_install(self):
        curves = circles([1])
        with unittest.mock.patch.dict(sys.modules, {"matplotlib": None}):
            for draw in (notebook.picture, notebook.histograms):
                with self.assertRaisesRegex(ImportError, r"lancret\[notebook\]"):
                    draw(curves)

    def test_no_strands_are_an_error(self):
        with self.assertRaisesRegex(lancret.InputError, "no strands"):
            notebook._lines(
                circles([1, 2]).__class__(
                    "linear",
                    (),
                    np.empty(0, np.uint32),
                    np.empty((1, 0, 4), np.float32),
                ),
                0,
                5,
            )
