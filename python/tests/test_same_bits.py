"""Python's strands are those of the command-line program, bit for bit. Points do not adapt,
because the program's text files of control points have equal counts."""

import subprocess
import unittest

import numpy as np

import lancret

from .support import SMALL, WithFolder, command

EQUAL_COUNTS = {"strands.adapt": False}
CURLY = SMALL.replace("[guides.made]", "[guides.made]\ncurl_radius = 0.5\nfrizz = 0.05")


@unittest.skipUnless(command(), "the program `lancret` is not built")
class SameBits(WithFolder):
    def expand(self, name, *arguments):
        subprocess.run(
            [command(), "expand", *arguments, "-o", str(self.folder / name)],
            check=True,
            capture_output=True,
        )
        return self.folder / name

    def control_points(self, groom, *arguments):
        """[points][4] of `lancret expand -o .txt`, whose numbers are exact float32."""
        rows = self.expand("out.txt", groom, *arguments).read_text().split()
        return np.array([np.float32(word) for word in rows]).reshape(-1, 4)

    def test_bsplines_of_made_grooms(self):
        for text in (
            SMALL,
            CURLY,
            SMALL + 'blend = "option1"\n',
            SMALL + "tolerance=0.2\n",
        ):
            with self.subTest(text=text):
                path = self.file("groom.toml", text)
                expected = self.control_points(path)
                with lancret.open(
                    path, chunk_strands=70, parameters=EQUAL_COUNTS
                ) as groom:
                    hair = groom.expand()
                order = np.argsort(hair.ids)
                ours = np.concatenate([hair.strand(i) for i in order])
                self.assertEqual(ours.tobytes(), expected.tobytes())

    def test_points_adapt_as_in_the_program(self):
        path = self.file("groom.toml", SMALL)
        file = self.expand("out.hair", path).read_bytes()
        strands, points = np.frombuffer(file, "<u4", 2, 4)  # docs/formats.md
        segments = np.frombuffer(file, "<u2", strands, 128)
        joints = np.frombuffer(file, "<f4", 3 * points, 128 + 2 * strands)
        with lancret.open(path, chunk_strands=70) as groom:
            hair = groom.expand()
        order = np.argsort(hair.ids)
        self.assertGreater(len(set(segments)), 2)
        np.testing.assert_array_equal(hair.segments[order], segments)
        places, first = hair.places(per_segment=1)
        ours = np.concatenate([places[first[i] : first[i + 1], :3] for i in order])
        off = np.linalg.norm(ours - joints.reshape(-1, 3), axis=1)
        self.assertLess(off.max(), 0.03)  # the groom's tolerance

    def test_a_fraction_of_the_strands(self):
        path = self.file("groom.toml", SMALL)
        expected = self.control_points(path, "--density", "0.3")
        with lancret.open(path, parameters=EQUAL_COUNTS) as groom:
            hair = groom.expand(density=0.3)
        order = np.argsort(hair.ids)
        ours = np.concatenate([hair.strand(i) for i in order])
        self.assertEqual(ours.tobytes(), expected.tobytes())

    def test_frames_of_a_cache(self):
        path = self.file(
            "groom.toml",
            SMALL + "[motion]\nkeys = [{ frame = 1 }, "
            "{ frame = 3, turn = [0, 20, 0] }]\n",
        )
        cache = self.folder / "cache.h5"
        subprocess.run(
            [command(), "simulate", path, "--frames", "1-3", "-o", cache],
            check=True,
            capture_output=True,
        )
        with lancret.open(cache, parameters=EQUAL_COUNTS) as groom:
            self.assertEqual((groom.info.first_frame, groom.info.last_frame), (1, 3))
            self.assertEqual(groom.info.frames, 3)
            self.assertFalse(groom.is_still((1, 2)))
            self.assertTrue(groom.is_still((3, 4)))  # held after the last
            self.assertFalse(
                np.array_equal(groom.head(1).positions, groom.head(3).positions)
            )
            np.testing.assert_array_equal(
                groom.head().positions, groom.head(1).positions
            )
            times = (1, 2.25, 3)
            together = groom.expand(times=times)
            order = np.argsort(together.ids)
            for i, time in enumerate(times):
                expected = self.control_points(cache, "--frame", str(time))
                ours = np.concatenate([together.strand(s, i) for s in order])
                self.assertEqual(ours.tobytes(), expected.tobytes(), time)
