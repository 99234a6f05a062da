"""Expanding strands of an open groom."""

import dataclasses
import unittest

import numpy as np

import lancret

from .support import SMALL


def all_arrays(curves):
    names = (
        "counts",
        "positions",
        "tangents",
        "normals",
        "ids",
        "root_uv",
        "lengths",
        "guides",
        "weights",
        "arc_lengths",
        "random",
    )
    return {
        name: getattr(curves, name)
        for name in names
        if getattr(curves, name) is not None
    }


class Growing(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.groom = lancret.open(SMALL, chunk_strands=64)

    @classmethod
    def tearDownClass(cls):
        cls.groom.close()

    def test_all_chunks_together_are_each_chunk_in_turn(self):
        whole = all_arrays(self.groom.expand(attributes=lancret.ALL))
        self.assertGreater(len(self.groom.chunks), 4)
        each = [
            all_arrays(self.groom.expand(chunk, attributes=lancret.ALL))
            for chunk in self.groom.chunks
        ]
        for name, array in whole.items():
            axis = 1 if name in ("positions", "tangents", "normals") else 0
            together = np.concatenate([part[name] for part in each], axis=axis)
            np.testing.assert_array_equal(array, together, name)

    def test_the_same_bits_for_any_chunk_size_and_number_of_threads(self):
        expected = self.groom.expand(attributes=lancret.ALL)
        order = np.argsort(expected.ids)
        for options in ({"chunk_strands": 17}, {"threads": 1}, {"threads": 4}):
            with lancret.open(SMALL, **options) as groom:
                got = groom.expand(attributes=lancret.ALL)
            ours = np.argsort(got.ids)
            np.testing.assert_array_equal(got.ids[ours], expected.ids[order])
            np.testing.assert_array_equal(got.lengths[ours], expected.lengths[order])
            for a, b in zip(ours, order):
                np.testing.assert_array_equal(got.strand(a), expected.strand(b))

    def test_only_requested_attributes_are_returned(self):
        self.assertEqual(
            set(all_arrays(self.groom.expand(0, attributes=()))),
            {"counts", "positions"},
        )
        with_two = all_arrays(self.groom.expand(0, attributes=("lengths", "guides")))
        self.assertEqual(
            set(with_two), {"counts", "positions", "lengths", "guides", "weights"}
        )
        with self.assertRaisesRegex(
            lancret.CallError, "'colour': must be one of tangents"
        ):
            self.groom.expand(0, attributes=("colour",))

    def test_attributes_have_the_documented_values(self):
        hair = self.groom.expand(attributes=lancret.ALL)
        self.assertEqual(sorted(hair.ids), list(range(300)))
        np.testing.assert_allclose(hair.weights.sum(axis=1), 1, atol=1e-6)
        self.assertLess(hair.guides.max(), 40)
        self.assertTrue(((0 <= hair.random) & (hair.random < 1)).all())
        # The mean of 300 uniform numbers has a standard deviation of 0.0167; delta is 6 of these.
        self.assertAlmostEqual(float(hair.random.mean()), 0.5, delta=0.1)
        np.testing.assert_allclose(
            np.linalg.norm(hair.tangents[0, :, :3], axis=1), 1, atol=1e-4
        )
        places, first = hair.places(per_segment=16)
        steps = np.linalg.norm(np.diff(places[:, :3], axis=0), axis=1)
        length = [steps[a : b - 1].sum() for a, b in zip(first[:-1], first[1:])]
        # 16 chords per segment, which turns by less than a radian, are short by
        # 1/(24 * 16^2); the curve itself is within the tolerance.
        np.testing.assert_allclose(length, hair.lengths, rtol=5e-3)

    def test_every_basis_follows_the_same_strands(self):
        error = 0.02
        fine = self.groom.expand(0, basis="hermite", max_error=0.0005)
        places, first = fine.places(per_segment=16)
        for basis in ("linear", "bspline", "catmull-rom", "bezier", "hermite"):
            with self.subTest(basis=basis):
                hair = self.groom.expand(0, basis=basis, max_error=error)
                ours, starts = hair.places(per_segment=4)
                same = {strand: i for i, strand in enumerate(fine.ids)}
                self.assertEqual(set(hair.ids), set(same))
                for i in range(0, len(hair), 7):
                    j = same[hair.ids[i]]
                    mine = ours[starts[i] : starts[i + 1], :3]
                    true = places[first[j] : first[j + 1], :3]
                    off = np.linalg.norm(mine[:, None] - true[None], axis=2).min(axis=1)
                    # The sum of the distances from a place to the strand, from there to
                    # the fine curve, and along that to a place on it.
                    near = np.linalg.norm(np.diff(true, axis=0), axis=1).max() / 2
                    self.assertLess(off.max(), error + 0.0005 + near)
                    # Roots are exact, except that a B-spline's is a mean of three control
                    # points, each rounded by at most half of 2^-19, as they are below 32.
                    self.assertLess(np.linalg.norm(mine[0] - true[0]), 3**0.5 * 2**-20)
                    self.assertLess(np.linalg.norm(mine[-1] - true[-1]), error + 0.0005)

    def test_no_strands_have_no_places(self):
        for basis in ("linear", "hermite"):
            hair = self.groom.expand(basis=basis, density=1e-6)
            self.assertEqual(len(hair), 0)
            places, first = hair.places()
            self.assertEqual((places.shape, first.tolist()), ((0, 4), [0]))

    def test_some_strands_are_copies_in_the_requested_order(self):
        hair = self.groom.expand(attributes=lancret.ALL)
        some = hair.some([7, 3, 250])
        self.assertEqual(some.ids.tolist(), hair.ids[[7, 3, 250]].tolist())
        for mine, theirs in enumerate((7, 3, 250)):
            np.testing.assert_array_equal(some.strand(mine), hair.strand(theirs))
            points = slice(some.first[mine], some.first[mine + 1])
            whole = slice(hair.first[theirs], hair.first[theirs + 1])
            for name in ("tangents", "normals"):
                np.testing.assert_array_equal(
                    getattr(some, name)[:, points], getattr(hair, name)[:, whole]
                )
            np.testing.assert_array_equal(
                some.arc_lengths[points], hair.arc_lengths[whole]
            )
        self.assertEqual(len(hair.some([])), 0)

    def test_every_cubic_basis_has_the_same_number_of_segments(self):
        expected = self.groom.expand(0, basis="hermite", max_error=0.02)
        self.assertTrue((expected.segments == expected.counts - 1).all())
        bezier = self.groom.expand(0, basis="bezier", max_error=0.02)
        np.testing.assert_array_equal(bezier.ids, expected.ids)
        np.testing.assert_array_equal(bezier.segments, expected.segments)
        linear = self.groom.expand(0, basis="linear", max_error=0.02)
        np.testing.assert_array_equal(linear.segments, linear.counts - 1)

    def test_boxes_contain_the_strands(self):
        for chunk in self.groom.chunks:
            hair = self.groom.expand(chunk, basis="linear")
            reach = self.groom.box(chunk, basis="linear")
            tight = self.groom.box(chunk, kind="tight", basis="linear")
            low = (hair.points - hair.radii[:, None]).min(axis=0)
            high = (hair.points + hair.radii[:, None]).max(axis=0)
            for box in (reach, tight):
                self.assertTrue((box[0] <= low).all() and (high <= box[1]).all())
            self.assertTrue((reach[0] <= tight[0]).all())
            self.assertTrue((tight[1] <= reach[1]).all())

    def test_fewer_strands_are_a_subset_and_wider(self):
        whole, share = self.groom.expand(), self.groom.expand(density=0.25)
        # Strands of rank below 0.275 are grown, the last of them thinner: 82.5 of 300, with
        # a standard deviation of sqrt(300 * 0.275 * 0.725) = 7.7; delta is 4 of these.
        self.assertAlmostEqual(len(share), 82.5, delta=31)
        same = {strand: i for i, strand in enumerate(whole.ids)}
        wider = []
        for i, strand in enumerate(share.ids):
            mine, theirs = share.strand(i), whole.strand(same[strand])
            np.testing.assert_array_equal(mine[:, :3], theirs[:, :3])
            wider.append(mine[0, 3] / theirs[0, 3])
            # Two radii are rounded, each by a relative 2^-24.
            np.testing.assert_allclose(mine[:, 3], wider[-1] * theirs[:, 3], rtol=3e-7)
        self.assertEqual(max(wider), 4)
        # The standard deviation of the sum is sqrt((1/d - 1) / 300) = 0.1; delta is 3 of these.
        self.assertAlmostEqual(sum(wider) / 300, 1, delta=0.3)

    def test_units_scale_places_widths_and_lengths(self):
        cm, m = (
            self.groom.expand(0, attributes=("lengths",), unit=unit)
            for unit in (0, 100)
        )
        np.testing.assert_allclose(
            m.positions * 100, cm.positions, rtol=1e-6, atol=1e-7
        )
        np.testing.assert_allclose(m.lengths * 100, cm.lengths, rtol=1e-6)

    def test_arrays_are_views_of_the_memory_that_the_library_wrote_to(self):
        hair = self.groom.expand(attributes=lancret.ALL)
        for array in (hair.positions, hair.tangents):
            self.assertEqual(array.ctypes.data % 16, 0)
            self.assertTrue(array.flags.c_contiguous)
        self.assertTrue(np.shares_memory(hair.points, hair.positions))
        self.assertTrue(np.shares_memory(hair.strand(3), hair.positions))

    def test_the_check_passes_and_adds_up(self):
        check = self.groom.check()
        self.assertEqual((check.strands, check.failed, check.outside), (300, 0, 0))
        self.assertTrue(check.passed)
        self.assertLess(check.length_error, 1e-5)  # the limit of `lancret check`
        self.assertEqual(self.groom.check(0).strands, len(self.groom.expand(0)))
        spoilt = dataclasses.replace(check, distance=float("nan"))
        for joined in (check.joined(spoilt), spoilt.joined(check)):
            self.assertTrue(np.isnan(joined.distance))
            self.assertEqual(joined.strands, 600)

    def test_invalid_calls_are_refused(self):
        for call in (
            lambda: self.groom.expand(len(self.groom.chunks)),
            lambda: self.groom.expand(-1),
            lambda: self.groom.box(0.7),
            lambda: self.groom.expand(["0"]),
            lambda: self.groom.expand(0, density=float("nan")),
            lambda: self.groom.expand(0, times=[0.0] * 257),
            lambda: self.groom.box(10_000),
        ):
            with self.assertRaises(lancret.CallError):
                call()
