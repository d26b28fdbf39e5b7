# SPDX-License-Identifier: GPL-3.0-or-later
"""The package `ductus` as a program of somebody else uses it."""

import array
import gc
import os
import pathlib
import subprocess
import sys
import tempfile
import threading
import unittest

PLAIN = os.environ.get("DUCTUS_TEST_NUMBERS") == "plain"
if PLAIN:
    sys.modules["numpy"] = None     # importing it fails

import ductus

SOURCE = pathlib.Path(os.environ["DUCTUS_SOURCE"])


def wave(count=60):
    return [3.0 * i for i in range(count)], [20.0 + (i % 7) for i in range(count)]


def drawing():
    made = ductus.Drawing(200, 100)
    made.add_stroke("wave", *wave())
    return made


def settings(**values):
    operation = ductus.operations()[0]
    made = ductus.Settings(operation.id)
    for param in operation.params:
        if param.type == "hand":
            made[param.id] = ductus.hands()[0].name
    for name, value in values.items():
        made[name] = value
    return made


class Tables(unittest.TestCase):
    def test_every_default_is_accepted_by_its_own_table(self):
        for operation in ductus.operations():
            made = ductus.Settings(operation.id)
            for param in operation.params:
                if param.default:
                    made[param.id] = param.default
                    self.assertEqual(made[param.id], param.default, param.id)
            for preset in operation.presets:
                made.preset(preset.id)
                for param, value in preset.values.items():
                    self.assertEqual(made[param], value)

    def test_bad_value_is_the_cores_sentence(self):
        operation = ductus.operations()[0]
        real = next(param for param in operation.params if param.type == "real")
        with self.assertRaisesRegex(ductus.Error, real.id) as caught:
            settings()[real.id] = "x"
        self.assertEqual(caught.exception.status, "bad-setting")
        with self.assertRaises(ductus.Error) as caught:
            ductus.Settings("no-such-operation")
        self.assertEqual(caught.exception.status, "not-found")


class Drawings(unittest.TestCase):
    def test_channels_come_back_as_they_went_in(self):
        made = ductus.Drawing()
        x, y = wave(5)
        stroke = made.add_stroke("é", x, array.array("d", y), pressure=[0, 0.25, 0.5, 0.75, 1], closed=True,
                                 color=(1, 0.5, 0), opacity=0.5, width=3)
        self.assertEqual(list(stroke.channel("x")), x)
        self.assertEqual(list(made[0].channel("pressure")), [0, 0.25, 0.5, 0.75, 1])
        self.assertIsNone(made[0].channel("twist"))
        self.assertEqual((made[0].id, made[0].closed, made[0].color, made[0].width), ("é", True, (1, 0.5, 0), 3))
        made[0].set("pressure", None)
        self.assertFalse(made[0].has("pressure"))

    @unittest.skipIf(PLAIN, "numpy is put away")
    def test_numpy_arrays_of_any_layout(self):
        import numpy
        points = numpy.arange(12, dtype=numpy.float32).reshape(6, 2)
        stroke = ductus.Drawing().add_stroke("s", points[:, 0], points[:, 1])
        self.assertEqual(stroke.channel("y").tolist(), [1, 3, 5, 7, 9, 11])

    def test_lengths_that_differ_add_nothing(self):
        made = ductus.Drawing()
        with self.assertRaises(ductus.Error):
            made.add_stroke("s", [1, 2], [1])
        with self.assertRaises(ductus.Error):
            made.add_stroke("s", [1, 2], [1, 2], pressure=[1])
        self.assertEqual(len(made), 0)

    def test_stroke_keeps_its_drawing(self):
        stroke = drawing()[0]
        gc.collect()
        self.assertEqual(len(stroke.channel("x")), 60)

    def test_read_and_write(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "a.svg")
            drawing().write(path)
            self.assertEqual(len(ductus.Drawing.read(path)), 1)
            with self.assertRaises(ductus.Error) as caught:
                ductus.Drawing.read(pathlib.Path(folder, "none.svg"))
            self.assertIn("none.svg", str(caught.exception))


class Runs(unittest.TestCase):
    def test_same_result_on_any_number_of_threads(self):
        results = [ductus.run(settings(), drawing(), threads=threads)[0] for threads in (1, 2, 2)]
        for channel in ("x", "y", "pressure"):
            first, *others = [bytes(result.channel(channel)) for result in results]
            self.assertEqual([first, first], others)

    def test_trace_arrives_whole(self):
        import json
        pieces = []
        ductus.run(settings(), drawing(), trace=pieces.append)
        self.assertIn("settings", json.loads(b"".join(pieces)))

    def test_progress_cancels(self):
        with self.assertRaises(ductus.Cancelled):
            ductus.run(settings(), drawing(), progress=lambda fraction: False)

    def test_exception_in_progress_or_trace_is_raised_again(self):
        def fail(_):
            raise ZeroDivisionError("mine")
        with self.assertRaisesRegex(ZeroDivisionError, "mine"):
            ductus.run(settings(), drawing(), progress=fail)
        with self.assertRaisesRegex(ZeroDivisionError, "mine"):
            ductus.run(settings(), drawing(), trace=fail)

    def test_pythons_lock_is_free_during_a_run(self):
        counted, stop = [0], threading.Event()

        def count():
            while not stop.is_set():
                counted[0] += 1
        big = ductus.Drawing()
        for i in range(100):
            big.add_stroke(f"s{i}", *wave())
        made = settings()
        thread = threading.Thread(target=count)
        thread.start()
        before = counted[0]
        ductus.run(made, big, threads=1)
        during = counted[0] - before
        stop.set()
        thread.join()
        self.assertGreater(during, 100)

    def test_nan_is_refused(self):
        made = ductus.Drawing()
        made.add_stroke("s", [0, float("nan")], [0, 1])
        with self.assertRaises(ductus.Error):
            ductus.run(settings(), made)

    def test_opened_library_is_used(self):
        made = settings()
        hand = next(param.id for param in ductus.operations()[0].params if param.type == "hand")
        library = ductus.Library(ductus.hands()[0].name)
        self.assertGreater(library.stroke_count, 100)
        made[hand] = "no such hand"
        made.use_library(hand, library)
        del library
        gc.collect()
        self.assertEqual(len(ductus.run(made, drawing())), 1)


class Paths(unittest.TestCase):
    def test_svg_to_strokes_and_back(self):
        path = ductus.Path("M 0,0 C 40,-60 80,60 120,0 Z M 5,5 L 9,9")
        path.map((2, 0, 0, 2, 10, 0))
        made = ductus.Drawing()
        path.flatten("p", 0.05, made)
        self.assertEqual([(stroke.id, stroke.closed) for stroke in made], [("p", True), ("p/2", False)])
        fitted = ductus.Path()
        fitted.fit(made[1], 0.1)
        self.assertEqual(fitted.svg(), "M 20,10 L 28,18")
        self.assertEqual(fitted.nodes, 2)
        self.assertEqual(list(fitted.verbs), [ductus.MOVE, ductus.LINE])
        self.assertEqual([round(v, 6) for v in fitted.points], [20, 10, 28, 18])
        fitted.clear()
        self.assertEqual(len(fitted.points), 0)

    def test_outline_and_widths_follow_pressure(self):
        stroke = ductus.Drawing().add_stroke("s", [0, 50, 100], [0, 0, 0], pressure=[0, 0.5, 1])
        path, nib = ductus.Path(), ductus.Nib(width=10, aspect=1)
        path.fit(stroke, 0.1)
        widths = path.widths(0, stroke, nib)
        self.assertAlmostEqual(widths[0][1], 3, places=5)
        self.assertAlmostEqual(widths[-1][1], 17, places=5)
        outline = ductus.Path()
        outline.outline(stroke, nib)
        self.assertGreater(outline.nodes, 3)
        with self.assertRaises(ductus.Error):
            path.widths(5, stroke)


class Loading(unittest.TestCase):
    def test_missing_library_is_one_sentence(self):
        for place, word in (("/nowhere/libductus.so", "no such file"), (str(SOURCE / "LICENSE"), "LICENSE")):
            run = subprocess.run(
                [sys.executable, "-c",
                 "import ductus\ntry:\n    ductus.version()\nexcept ductus.Missing as error:\n    print(error)"],
                env={**os.environ, "DUCTUS_LIBRARY": place}, capture_output=True, text=True, check=True)
            self.assertEqual(len(run.stdout.splitlines()), 1, run.stdout)
            self.assertIn(word, run.stdout)

    def test_many_handles_do_not_pile_up(self):
        def resident():
            return int(pathlib.Path("/proc/self/statm").read_text().split()[1])
        for _ in range(200):
            drawing()
        before = resident()
        for _ in range(4000):
            ductus.Path("M 0,0 C 40,-60 80,60 120,0")
            drawing()
        self.assertLess(resident() - before, 500)      # pages of 4 KiB


if __name__ == "__main__":
    unittest.main()
