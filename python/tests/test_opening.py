"""Opening grooms from files, texts and memory."""

import numpy as np

import lancret

from .shapes import lawn, square
from .support import SMALL, WithFolder


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
        with self.assertRaisesRegex(lancret.InputError, "unknown key .cuont"):
            lancret.open(SMALL, parameters={"strands.cuont": 3})
        with self.assertRaisesRegex(lancret.InputError, r"named\.toml:2: "):
            lancret.open("named.toml", text="[strands]\ncount = 0.5\n")

    def test_a_closed_groom_refuses_calls_and_may_be_closed_twice(self):
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
        places, first = hair.places(per_segment=1)
        roots = places[first[:-1], :3]
        # A B-spline's root is a mean of control points below 4, each rounded by 2^-23.
        np.testing.assert_allclose(roots[:, 2], 0, atol=2**-23)
        # Texture coordinates are positions divided by the square's side of 4 cm, rounded
        # by 2^-25.
        np.testing.assert_allclose(hair.root_uv, roots[:, :2] / 4, atol=2**-24)
        np.testing.assert_array_equal(guides.root_positions[:, 2], 0)
        # 8 helices fit a curl of 9 radians, 5 cm long, within 0.0018 cm.
        self.assertLess(guides.fit_rms.max(), 0.0025)

    def test_strands_in_other_units_are_the_same_hair(self):
        with lancret.open(strands=lawn()) as groom:
            in_cm = groom.expand()
        strands = lawn()
        small = lancret.Strands(  # scaling by a power of two rounds nothing
            strands.points * 64, strands.counts, metres_per_unit=0.01 / 64, up="Z"
        )
        with lancret.open(strands=small) as groom:
            self.assertEqual(groom.info.cm_per_unit, 1 / 64)
            self.assertEqual(groom.info.up, (0, 0, 1))
            np.testing.assert_array_equal(groom.expand().positions, in_cm.positions)

    def test_fit_gives_helices_whose_lengths_are_the_strands(self):
        guides = lancret.fit(strands=lawn(), parameters={"guides.segments": 12})
        self.assertEqual(guides.curvatures.shape, (25, 12, 3))
        frames = guides.root_frames
        np.testing.assert_allclose(
            frames @ frames.transpose(0, 2, 1),
            np.tile(np.eye(3), (25, 1, 1)),
            atol=1e-9,
        )
        chords = np.linalg.norm(np.diff(lawn().strand(0), axis=0), axis=1).sum()
        # The curve through 24 points of an arc of 9 radians is longer than its chords by
        # (0.39)^2 / 24 of the part that turns, less than a hundredth of the length.
        np.testing.assert_allclose(guides.lengths, chords, rtol=0.01)
