"""Threads, logs and cancellation."""

import threading
import time
import unittest

import numpy as np

import lancret

from .shapes import lawn, square
from .support import SMALL


class Hosts(unittest.TestCase):
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

    def test_an_exception_of_a_callback_is_raised_by_the_call(self):
        def broken():
            raise ZeroDivisionError("mine")

        with self.assertRaisesRegex(ZeroDivisionError, "mine"):
            lancret.open(SMALL, cancelled=broken)

    def test_an_exception_of_a_log_is_raised_by_the_call_that_logged(self):
        lines, outcome = [], []

        def other():
            try:
                with lancret.open(SMALL, context=context):
                    outcome.append("open")
            except ValueError as fault:
                outcome.append(fault)

        def log(_level, _text):
            if threading.current_thread() is not mine:
                return
            lines.append(1)
            if len(lines) == 1:
                raise ValueError("mine")
            if len(lines) == 2:  # a complete call on another thread
                thread = threading.Thread(target=other)
                thread.start()
                thread.join()

        mine = threading.current_thread()
        with lancret.Context(log=log) as context:
            with self.assertRaisesRegex(ValueError, "mine"):
                lancret.open(SMALL + "seed = 5\n", context=context)
            self.assertEqual(outcome, ["open"])
            lancret.open(SMALL, context=context).close()  # no exception is left over

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

    def test_closing_waits_for_calls_in_progress(self):
        groom = lancret.open(SMALL, parameters={"strands.count": 30_000})
        groom.info
        done = []

        def grow():
            try:
                done.append(len(groom.expand()))
            except lancret.CallError as fault:
                done.append(str(fault))

        thread = threading.Thread(target=grow)
        thread.start()
        time.sleep(0.01)
        groom.close()
        thread.join()
        self.assertIn(done, (["the groom is closed"], [30_000]))

    def test_warnings_go_to_the_log(self):
        lines = []
        strands = lawn()
        far = lancret.Strands(strands.points + [0, 0, 0.3], strands.counts)
        with lancret.open(
            strands=far, scalp=square(), log=lambda *line: lines.append(line)
        ):
            pass
        warnings = [text for level, text in lines if level == "warning"]
        self.assertEqual(len(warnings), 1, lines)
        self.assertRegex(warnings[0], "moved 25 of 25 guide roots onto the scalp, by up to 0.300 cm")

    def test_evaluate_gives_each_blends_figures(self):
        report = lancret.evaluate(strands=lawn(10), scalp=square())
        self.assertIn("place", report["blends"]["detail"])
        # The limit of `lancret check`.
        self.assertLess(max(report["blends"]["detail"]["length_error"].values()), 1e-5)
