"""Grooms through the library."""

import threading
import time

import numpy as np

import lancret

from .support import SMALL, WithFolder


def all_arrays(curves):
    names = ("counts", "positions", "tangents", "normals", "ids", "root_uv", "lengths",
             "guides", "weights", "arc_lengths", "random")
    return {
        name: getattr(curves, name) for name in names if getattr(curves, name) is not None
    }


def lawn(n=5, side=4.0, length=5.0, points=24):
    """n * n curls that stand on a square in the plane Z = 0."""
    t = np.linspace(0, 1, points)
    curl = length * np.stack(
        [0.04 * (np.cos(9 * t) - 1), 0.04 * np.sin(9 * t), t], axis=1
    )
    at = side * (np.arange(n) + 0.5) / n
    roots = np.stack([*np.meshgrid(at, at), np.zeros((n, n))], axis=-1).reshape(-1, 1, 3)
    return lancret.Strands((roots + curl).reshape(-1, 3), np.full(n * n, points))


def square(side=4.0):
    corners = [[0, 1, 2], [0, 2, 3]]
    uvs = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], np.float32)
    return lancret.Mesh(
        side * np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]), corners, uvs[corners]
    )


class Opening(WithFolder):
    def test_a_path_a_text_and_parameters_give_the_same_groom(self):
        path = self.file("small.toml", SMALL)
        with lancret.open(path) as groom:
            by_path = groom.expand()
            self.assertEqual((groom.info.guides, groom.info.strands), (40, 300))
        with lancret.open(SMALL) as groom:
            by_text = groom.expand()
        with lancret.open(
            SMALL.replace("300", "7"), parameters={"strands": {"count": 300}}
        ) as groom:
            by_parameter = groom.expand()
        np.testing.assert_array_equal(by_path.positions, by_text.positions)
        np.testing.assert_array_equal(by_path.positions, by_parameter.positions)

    def test_errors_name_the_file_and_the_line(self):
        path = self.file("bad.toml", "[strands]\n\ncount = -4\n")
        with self.assertRaisesRegex(lancret.InputError, r"bad\.toml:3: .*count"):
            lancret.open(path)
        with self.assertRaisesRegex(lancret.InputError, "nowhere.toml"):
            lancret.open(self.folder / "nowhere.toml")
        with self.assertRaisesRegex(lancret.InputError, "strands.cuont"):
            lancret.open(SMALL, parameters={"strands.cuont": 3})
        with self.assertRaisesRegex(lancret.InputError, r"named\.toml:2: "):
            lancret.open("named.toml", text="[strands]\ncount = 0.5\n")

    def test_a_closed_groom_says_so_and_may_be_closed_twice(self):
        groom = lancret.open(SMALL)
        groom.close()
        groom.close()
        self.assertTrue(groom.closed)
        with self.assertRaisesRegex(lancret.CallError, "the groom is closed"):
            groom.expand(0)

    def test_a_groom_outlives_its_context_object(self):
        with lancret.Context() as context:
            groom = lancret.open(SMALL, context=context)
        self.assertEqual(len(groom.expand()), 300)
        groom.close()
        with self.assertRaisesRegex(lancret.CallError, "the context is closed"):
            lancret.open(SMALL, context=context)

    def test_strands_and_scalp_may_come_from_memory(self):
        with lancret.open(
            strands=lawn(), scalp=square(), parameters={"strands.count": 200}
        ) as groom:
            self.assertEqual((groom.info.guides, groom.info.strands), (25, 200))
            hair = groom.expand(attributes=lancret.ALL)
            guides = groom.guides()
        np.testing.assert_allclose(hair.positions[0, hair.first[:-1], 2], 0, atol=0.6)
        roots, _ = hair.places(a_piece=1)
        self.assertEqual(hair.root_uv.shape, (200, 2))
        # On the square, texture coordinates are places over its side of 4 cm.
        places, first = hair.places(a_piece=1)
        np.testing.assert_allclose(
            hair.root_uv, places[first[:-1], :2] / 4, atol=1e-4
        )
        np.testing.assert_allclose(guides.root_positions[:, 2], 0, atol=1e-5)
        self.assertLess(guides.fit_rms.max(), 0.05)

    def test_strands_in_other_units_are_the_same_hair(self):
        with lancret.open(strands=lawn()) as groom:
            in_cm = groom.expand()
        metres = lawn()
        metres = lancret.Strands(
            metres.points / 100, metres.counts, metres_per_unit=1, up="Z"
        )
        with lancret.open(strands=metres) as groom:
            self.assertEqual(groom.info.cm_per_unit, 100)
            self.assertEqual(groom.info.up, (0, 0, 1))
            in_metres = groom.expand(unit=100)
        # A rounding of float32 in the division, and what the fit makes of it.
        np.testing.assert_allclose(
            in_metres.positions * 100, in_cm.positions, atol=2e-3
        )

    def test_fit_gives_helices_whose_lengths_are_the_strands(self):
        guides = lancret.fit(strands=lawn(), parameters={"guides.segments": 12})
        self.assertEqual(guides.curvatures.shape, (25, 12, 3))
        frames = guides.root_frames
        np.testing.assert_allclose(
            frames @ frames.transpose(0, 2, 1), np.tile(np.eye(3), (25, 1, 1)), atol=1e-9
        )
        chords = np.linalg.norm(np.diff(lawn().strand(0), axis=0), axis=1).sum()
        # The curve through 24 points of an arc of 9 radians is longer than its chords by
        # (0.39)^2 / 24 of what turns, less than a hundredth of all.
        np.testing.assert_allclose(guides.lengths, chords, rtol=0.01)


class Growing(WithFolder):
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
        for how in ({"chunk_strands": 17}, {"threads": 1}, {"threads": 4}):
            with lancret.open(SMALL, **how) as groom:
                got = groom.expand(attributes=lancret.ALL)
            ours = np.argsort(got.ids)
            np.testing.assert_array_equal(got.ids[ours], expected.ids[order])
            np.testing.assert_array_equal(got.lengths[ours], expected.lengths[order])
            for a, b in zip(ours, order):
                np.testing.assert_array_equal(got.strand(a), expected.strand(b))

    def test_attributes_are_there_only_where_asked_for(self):
        self.assertEqual(
            set(all_arrays(self.groom.expand(0, attributes=()))), {"counts", "positions"}
        )
        with_two = all_arrays(self.groom.expand(0, attributes=("lengths", "guides")))
        self.assertEqual(
            set(with_two), {"counts", "positions", "lengths", "guides", "weights"}
        )
        with self.assertRaisesRegex(lancret.CallError, "'colour': is none of tangents"):
            self.groom.expand(0, attributes=("colour",))

    def test_attributes_are_what_they_say(self):
        hair = self.groom.expand(attributes=lancret.ALL)
        self.assertEqual(sorted(hair.ids), list(range(300)))
        np.testing.assert_allclose(hair.weights.sum(axis=1), 1, atol=1e-6)
        self.assertLess(hair.guides.max(), 40)
        self.assertTrue(((0 <= hair.random) & (hair.random < 1)).all())
        # The mean of 300 uniform numbers has a deviation of 0.0167: six of them.
        self.assertAlmostEqual(float(hair.random.mean()), 0.5, delta=0.1)
        np.testing.assert_allclose(
            np.linalg.norm(hair.tangents[0, :, :3], axis=1), 1, atol=1e-4
        )
        places, first = hair.places(a_piece=16)
        steps = np.linalg.norm(np.diff(places[:, :3], axis=0), axis=1)
        length = [steps[a : b - 1].sum() for a, b in zip(first[:-1], first[1:])]
        # 16 chords a piece that turns by less than a radian: 1/(24 * 16^2) short; the
        # curve itself may be off by the tolerance.
        np.testing.assert_allclose(length, hair.lengths, rtol=5e-3)

    def test_every_basis_follows_the_same_strands(self):
        error = 0.02
        fine = self.groom.expand(0, basis="hermite", max_error=0.0005)
        places, first = fine.places(a_piece=16)
        for basis in ("linear", "bspline", "catmull-rom", "bezier", "hermite"):
            with self.subTest(basis=basis):
                hair = self.groom.expand(0, basis=basis, max_error=error)
                ours, at = hair.places(a_piece=4)
                self.assertEqual(len(at), len(first))
                for i in range(0, len(hair), 7):
                    mine = ours[at[i] : at[i + 1], :3]
                    true = places[first[i] : first[i + 1], :3]
                    off = np.linalg.norm(mine[:, None] - true[None], axis=2).min(axis=1)
                    near = np.linalg.norm(np.diff(true, axis=0), axis=1).max() / 2
                    self.assertLess(off.max(), error + near + 0.001)
                    np.testing.assert_allclose(mine[0], true[0], atol=2e-3)
                    np.testing.assert_allclose(mine[-1], true[-1], atol=error + 2e-3)

    def test_bounds_hold_the_strands(self):
        for chunk in self.groom.chunks:
            hair = self.groom.expand(chunk, basis="linear")
            reach = self.groom.bound(chunk, basis="linear")
            tight = self.groom.bound(chunk, kind="tight", basis="linear")
            low = (hair.points - hair.radii[:, None]).min(axis=0)
            high = (hair.points + hair.radii[:, None]).max(axis=0)
            for box in (reach, tight):
                self.assertTrue((box[0] <= low + 1e-5).all() and (high <= box[1] + 1e-5).all())
            self.assertTrue((reach[0] <= tight[0] + 1e-4).all())
            self.assertTrue((tight[1] <= reach[1] + 1e-4).all())

    def test_fewer_strands_are_some_of_all_and_wider(self):
        whole, share = self.groom.expand(), self.groom.expand(density=0.25)
        self.assertAlmostEqual(len(share) / 300, 0.25, delta=0.05)
        self.assertTrue(set(share.ids) <= set(whole.ids))
        area = [hair.radii.sum() for hair in (whole, share)]
        self.assertAlmostEqual(area[1] / area[0], 1, delta=0.15)

    def test_units_scale_places_widths_and_lengths(self):
        cm, m = (
            self.groom.expand(0, attributes=("lengths",), unit=unit) for unit in (0, 100)
        )
        np.testing.assert_allclose(m.positions * 100, cm.positions, rtol=1e-6, atol=1e-7)
        np.testing.assert_allclose(m.lengths * 100, cm.lengths, rtol=1e-6)

    def test_arrays_are_the_memory_that_the_library_wrote_to(self):
        hair = self.groom.expand(attributes=lancret.ALL)
        for array in (hair.positions, hair.tangents):
            self.assertEqual(array.ctypes.data % 16, 0)
            self.assertTrue(array.flags.c_contiguous)
        self.assertTrue(np.shares_memory(hair.points, hair.positions))
        self.assertTrue(np.shares_memory(hair.strand(3), hair.positions))

    def test_the_proof_passes_and_adds_up(self):
        check = self.groom.check()
        self.assertEqual((check.strands, check.failed, check.outside), (300, 0, 0))
        self.assertTrue(check.passed)
        self.assertLess(check.length_error, 1e-3)
        self.assertEqual(self.groom.check(0).strands, len(self.groom.expand(0)))

    def test_calls_that_cannot_be_are_refused(self):
        for call in (
            lambda: self.groom.expand(len(self.groom.chunks)),
            lambda: self.groom.expand(-1),
            lambda: self.groom.expand(0, density=float("nan")),
            lambda: self.groom.expand(0, times=[0.0] * 65),
            lambda: self.groom.bound(10_000),
        ):
            with self.assertRaises(lancret.CallError):
                call()


class Hosts(WithFolder):
    def test_cancelling_ends_a_call(self):
        stop = threading.Event()
        with lancret.open(
            SMALL, parameters={"strands.count": 400_000}, cancelled=stop.is_set
        ) as groom:
            stop.set()
            with self.assertRaises(lancret.Cancelled):
                groom.expand()
            stop.clear()
            self.assertGreater(len(groom.expand(0)), 0)
        with self.assertRaises(lancret.Cancelled):
            lancret.open(SMALL, cancelled=lambda: True)

    def test_an_exception_of_a_callback_comes_out_of_the_call(self):
        def broken():
            raise ZeroDivisionError("mine")

        with self.assertRaisesRegex(ZeroDivisionError, "mine"):
            lancret.open(SMALL, cancelled=broken)

    def test_many_threads_grow_the_same_hair(self):
        with lancret.open(SMALL, chunk_strands=32) as groom:
            expected = groom.expand().positions
            got = [None] * 8

            def work(i):
                for _ in range(3):
                    got[i] = groom.expand().positions

            threads = [threading.Thread(target=work, args=(i,)) for i in range(8)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
            for positions in got:
                np.testing.assert_array_equal(positions, expected)

    def test_closing_waits_for_who_still_grows(self):
        groom = lancret.open(SMALL, parameters={"strands.count": 100_000})
        groom.info
        done = []
        thread = threading.Thread(target=lambda: done.append(len(groom.expand())))
        thread.start()
        time.sleep(0.01)
        groom.close()
        thread.join()
        self.assertIn(done, ([], [100_000]))  # refused, or whole

    def test_warnings_go_to_the_log(self):
        said = []
        strands = lawn()
        far = lancret.Strands(strands.points + [0, 0, 0.3], strands.counts)
        with lancret.open(
            strands=far, scalp=square(), log=lambda *line: said.append(line)
        ):
            pass
        self.assertTrue(all(level in ("info", "warning", "error") for level, _ in said))

    def test_evaluate_gives_each_blends_figures(self):
        report = lancret.evaluate(strands=lawn(10), scalp=square())
        self.assertIn("detail", str(report))
