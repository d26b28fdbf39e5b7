# SPDX-License-Identifier: GPL-3.0-or-later
"""Operations by their tables, settings and runs."""

import gc
import json
import os
import signal
import threading
import time
import traceback
import unittest

from binding import PLAIN, drawing, ductus, hand_param, settings

LIBRARY = ductus.Library(ductus.hands()[0].name)


def table(type):
    """A parameter of a type, and its operation."""
    return next((o, p) for o in ductus.operations() for p in o.params if p.type == type)


class Tables(unittest.TestCase):
    def test_every_default_and_preset_is_accepted(self):
        for operation in ductus.operations():
            self.assertTrue(operation.id and operation.label and operation.summary)
            made = ductus.Settings(operation.id)
            for param in operation.params:
                self.assertTrue(param.id and param.label and param.tooltip and param.group)
                self.assertIn(param.type, ("bool", "int", "real", "choice", "auto", "seed", "hand", "style", "strokes"))
                if param.default:
                    made[param.id] = param.default
                    self.assertEqual(made[param.id], param.default, param.id)
                for choice in param.choices:
                    made[param.id] = choice.id
                self.assertEqual(bool(param.choices), param.type == "choice")
            for preset in operation.presets:
                made.preset(preset.id)
                for param, value in preset.values.items():
                    self.assertEqual(made[param], value)

    def test_they_are_those_of_the_library(self):
        from ductus._library import take_text
        told = json.loads(take_text("duct_operations_json", None))
        told = told["operations"] if isinstance(told, dict) else told
        self.assertEqual([(o["id"], o["label"], [p["id"] for p in o["parameters"]]) for o in told],
                         [(o.id, o.label, [p.id for p in o.params]) for o in ductus.operations()])


class Settings(unittest.TestCase):
    def test_take_pythons_values(self):
        for type, values in (("bool", (True, False)), ("real", None), ("int", None), ("seed", (0, 2**63 - 1))):
            operation, param = table(type)
            made = ductus.Settings(operation.id)
            for value in values or (param.minimum, param.maximum):
                value = int(value) if type in ("int", "seed") else value
                made[param.id] = value
                expected = str(value).lower() if type == "bool" else value
                self.assertEqual(made[param.id] if type == "bool" else type_of(type)(made[param.id]), expected)

    @unittest.skipIf(PLAIN, "numpy is put away")
    def test_take_numpys_values(self):
        import numpy
        for type, values in (("bool", (numpy.bool_(True), numpy.bool_(False))),
                             ("int", (numpy.int64(1), numpy.uint8(2), numpy.array(3))),
                             ("real", (numpy.float64(0.25), numpy.float32(0.5)))):
            operation, param = table(type)
            for value in values:
                made = ductus.Settings(operation.id)
                wanted = value.item()
                if type != "bool":
                    wanted = min(max(wanted, int(param.minimum)), int(param.maximum) or 1)
                    value = numpy.dtype(value.dtype).type(wanted)
                made[param.id] = value
                self.assertEqual(made[param.id] if type == "bool" else float(made[param.id]),
                                 str(wanted).lower() if type == "bool" else wanted)

    def test_bad_values_are_the_cores_sentence_and_change_nothing(self):
        operation, param = table("real")
        made = ductus.Settings(operation.id)
        for value in ("x", param.maximum + 1, float("nan"), True, ""):
            with self.assertRaisesRegex(ductus.Error, param.id) as caught:
                made[param.id] = value
            self.assertEqual(caught.exception.status, "bad-setting")
            self.assertEqual(made[param.id], param.default)
        with self.assertRaises(ductus.Error):
            made["no-such-parameter"] = 1
        with self.assertRaises(KeyError):
            made["no-such-parameter"]
        with self.assertRaises(ductus.Error):
            made.preset("no-such-preset")
        with self.assertRaises(ductus.Error):
            made.use_library(param.id, LIBRARY)
        with self.assertRaises(ductus.Error) as caught:
            ductus.Settings("no-such-operation")
        self.assertEqual(caught.exception.status, "not-found")


def type_of(name):
    return float if name == "real" else int


class Runs(unittest.TestCase):
    def test_same_result_on_any_number_of_threads(self):
        results = [ductus.run(settings(LIBRARY), drawing(2), threads=threads) for threads in (1, 2, 2)]
        for stroke in (0, 1):
            for channel in ("x", "y", "pressure"):
                first, *others = [bytes(result[stroke].channel(channel)) for result in results]
                self.assertEqual([first, first], others)

    def test_the_drawing_stays_as_it_is(self):
        given = drawing()
        before = given.to_bytes("inkml")
        result = ductus.run(settings(LIBRARY), given)
        self.assertEqual(given.to_bytes("inkml"), before)
        self.assertNotEqual(result.to_bytes("inkml"), before)
        self.assertEqual((result[0].id, result.size), (given[0].id, given.size))

    def test_trace_arrives_whole(self):
        pieces = []
        ductus.run(settings(LIBRARY), drawing(), trace=pieces.append)
        self.assertIn("settings", json.loads(b"".join(pieces)))

    def test_progress_tells_how_far(self):
        heard = []
        ductus.run(settings(LIBRARY), drawing(2), progress=heard.append)       # returns None: goes on
        self.assertEqual((heard[0], heard[-1], heard), (0, 1, sorted(heard)))

    def test_progress_cancels(self):
        for place in range(2):
            heard = []

            def progress(fraction):
                heard.append(fraction)
                return len(heard) <= place
            with self.assertRaises(ductus.Cancelled) as caught:
                ductus.run(settings(LIBRARY), drawing(2), progress=progress)
            self.assertEqual(caught.exception.status, "cancelled")
            self.assertEqual(len(heard), place + 1)

    def test_exceptions_of_callbacks_are_raised_again_as_they_were(self):
        # How often progress is heard depends on the time, but at 0 and at 1 always.
        for place in (0, 0.001, 1):
            heard = []

            def fail(fraction):
                heard.append(fraction)
                if fraction >= place:
                    try:
                        [][1]
                    except IndexError as error:
                        raise ZeroDivisionError("mine") from error
            with self.assertRaisesRegex(ZeroDivisionError, "mine") as caught:
                ductus.run(settings(LIBRARY), drawing(2), progress=fail)
            self.assertEqual([fraction >= place for fraction in heard], [False] * (len(heard) - 1) + [True])
            self.assertIsInstance(caught.exception.__cause__, IndexError)
            text = "".join(traceback.format_exception(ZeroDivisionError, caught.exception, caught.exception.__traceback__))
            self.assertIn("in fail", text)
            self.assertNotIn("Cancelled", text)

        def fail_at_once(_):
            raise KeyboardInterrupt
        with self.assertRaises(KeyboardInterrupt):
            ductus.run(settings(LIBRARY), drawing(), trace=fail_at_once)

    def test_ctrl_c_stops_a_run(self):
        made, given = settings(LIBRARY), drawing(5000)
        begin = time.monotonic()
        threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            ductus.run(made, given, threads=1)
        self.assertLess(time.monotonic() - begin, 10)

    def test_pythons_lock_is_free_during_a_run(self):
        counted, stop = [0], threading.Event()

        def count():
            while not stop.wait(0.0005):
                counted[0] += 1
        thread = threading.Thread(target=count)
        thread.start()
        strokes, seconds = 4, 0
        while seconds < 0.4:        # a run that takes its time, however fast this machine is
            strokes *= 2
            made, given = settings(LIBRARY), drawing(strokes)
            before, begin = counted[0], time.monotonic()
            ductus.run(made, given, threads=1)
            during, seconds = counted[0] - before, time.monotonic() - begin
        stop.set()
        thread.join()
        self.assertGreater(during, 40)

    def test_runs_at_the_same_time_do_not_disturb_each_other(self):
        expected = ductus.run(settings(LIBRARY), drawing()).to_bytes("inkml")
        made, failed = [], []

        def work(stop):
            try:
                for _ in range(3):
                    made.append(ductus.run(settings(LIBRARY), drawing(), progress=lambda _: not stop).to_bytes("inkml"))
            except ductus.Cancelled:
                failed.append(stop)
        threads = [threading.Thread(target=work, args=(stop,)) for stop in (False, True, False)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual((made, failed), ([expected] * 6, [True]))

    def test_what_cannot_be_run_is_a_sentence(self):
        made = ductus.Drawing()
        made.add_stroke("s", [0, float("nan")], [0, 1])
        with self.assertRaises(ductus.Error) as caught:
            ductus.run(settings(LIBRARY), made)
        self.assertEqual(caught.exception.status, "bad-argument")
        operation = next(o for o in ductus.operations() if any(p.type == "hand" for p in o.params))
        made = ductus.Settings(operation.id)
        made[hand_param(operation)] = "no such hand"
        with self.assertRaisesRegex(ductus.Error, "no such hand") as caught:
            ductus.run(made, drawing())
        self.assertEqual(caught.exception.status, "not-found")


class Libraries(unittest.TestCase):
    def test_opened_library_is_used_and_kept(self):
        made = settings()
        library = ductus.Library(ductus.hands()[0].name)
        hand = hand_param(next(o for o in ductus.operations() if any(p.type == "hand" for p in o.params)))
        expected = ductus.run(made, drawing()).to_bytes("inkml")
        made[hand] = "no such hand"
        made.use_library(hand, library)
        del library
        gc.collect()
        self.assertEqual(ductus.run(made, drawing()).to_bytes("inkml"), expected)
        made.use_library(hand, None)
        with self.assertRaises(ductus.Error):
            ductus.run(made, drawing())

    def test_hands_can_be_opened(self):
        for hand in ductus.hands():
            self.assertTrue(hand.builtin and os.path.exists(hand.path), hand)
        library = ductus.Library(ductus.hands()[0].path)
        self.assertEqual(library.stroke_count, LIBRARY.stroke_count)
        self.assertGreater(library.sample_count, 1000)
        self.assertGreater(library.unit, 0)
        self.assertTrue(library.has("pressure") and library.has("x"))
        self.assertEqual(len(library.drawing()), library.stroke_count)
        with self.assertRaisesRegex(ductus.Error, ductus.hands()[0].name) as caught:
            ductus.Library("no such hand")
        self.assertEqual(caught.exception.status, "not-found")

    def test_of_ones_own_recordings(self):
        import tempfile
        first, second = drawing(3), drawing(4)
        for recording in (first, second):
            for stroke in recording:
                stroke.set("pressure", [i / 60 for i in range(60)])
        library = ductus.Library.build([first, second], name="mine", artist="Ä", scales=(1, 0.5), weights=[1, 2])
        self.assertEqual((library.stroke_count, library.name, library.artist, library.licence), (14, "mine", "Ä", ""))
        self.assertFalse(library.has("twist"))
        ductus.run(settings(library), drawing())
        with tempfile.TemporaryDirectory() as folder:
            library.save(folder + "/mine.inkml")
            self.assertEqual(ductus.Library(folder + "/mine.inkml").stroke_count, 14)
        with self.assertRaises(ValueError):
            ductus.Library.build([first], weights=[1, 2])
        with self.assertRaises(ductus.Error):
            ductus.Library.build([])
        with self.assertRaises(ductus.Error):
            ductus.Library.build([ductus.Drawing()])


if __name__ == "__main__":
    unittest.main()
