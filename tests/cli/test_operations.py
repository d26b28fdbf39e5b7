# SPDX-License-Identifier: GPL-3.0-or-later
"""Every operation of the tables, run as a user would, whatever its name."""

import json
import os
import unittest

from program import DRAWINGS, ProgramTest, operations, svg, waves


class OperationTest(ProgramTest):
    def run_each(self):
        """Yields each operation's id and the options it needs."""
        for operation in operations():
            with self.subTest(operation=operation["id"]):
                yield operation, [operation["id"], *self.needed(operation)]

    def test_vector_formats(self):
        source = self.file("in.svg", waves(3))
        for _, words in self.run_each():
            for ending in ("svg", "inkml", "csv"):
                self.assertEqual(self.succeed(*words, source, "-o", f"out.{ending}"), b"")
                self.assertTrue((self.work / f"out.{ending}").stat().st_size > 0)

    def test_images(self):
        source = self.file("in.svg", waves(2))
        for _, words in self.run_each():
            self.succeed(*words, source, "-o", "out.png")
            self.assertTrue((self.work / "out.png").read_bytes().startswith(b"\x89PNG"))

    def test_same_bytes_again_and_on_any_number_of_threads(self):
        source = self.file("in.svg", waves(8))
        for _, words in self.run_each():
            first = self.succeed(*words, source, "-o", "-", "--to", "inkml", "--threads", "1")
            for threads in (1, 2, 5):
                again = self.succeed(*words, source, "-o", "-", "--to", "inkml", f"--threads={threads}")
                self.assertEqual(first, again)

    def test_defaults_written_out_change_nothing(self):
        source = self.file("in.svg", waves(2))
        for operation, words in self.run_each():
            first = self.succeed(*words, source, "-o", "-", "--to", "inkml")
            spelled = []
            for parameter in operation["parameters"]:
                if parameter["type"] == "bool":
                    spelled.append(("--" if parameter["default"] == "true" else "--no-") + parameter["id"])
                elif parameter["type"] != "hand":
                    spelled += ["--" + parameter["id"], parameter["default"]]
            self.assertEqual(first, self.succeed(*words, *spelled, source, "-o", "-", "--to", "inkml"))

    def test_switches_can_be_written_in_four_ways(self):
        source = self.file("in.svg", waves(2))
        for operation, words in self.run_each():
            for parameter in operation["parameters"]:
                if parameter["type"] != "bool":
                    continue
                name = parameter["id"]
                results = [
                    self.succeed(*words, *way, source, "-o", "-", "--to", "inkml")
                    for way in ([f"--no-{name}"], [f"--{name}", "false"], [f"--{name}=false"])
                ]
                self.assertEqual(len(set(results)), 1)

    def test_presets_come_before_the_other_options_whatever_the_order(self):
        source = self.file("in.svg", waves(2))
        for operation, words in self.run_each():
            for preset in operation["presets"]:
                for param, _ in list(preset["values"].items())[:1]:
                    default = next(p["default"] for p in operation["parameters"] if p["id"] == param)
                    own = [f"--{param}={default}"]
                    chosen = ["--preset", preset["id"]]
                    self.assertEqual(
                        self.succeed(*words, *own, *chosen, source, "-o", "-", "--to", "inkml"),
                        self.succeed(*words, *chosen, *own, source, "-o", "-", "--to", "inkml"),
                    )

    def test_every_preset_runs(self):
        source = self.file("in.svg", waves(2))
        for operation, words in self.run_each():
            for preset in operation["presets"]:
                self.succeed(*words, "--preset", preset["id"], source, "-o", "out.svg")

    def test_trace_is_json_and_whole(self):
        source = self.file("in.svg", waves(2))
        for _, words in self.run_each():
            self.succeed(*words, source, "-o", "out.svg", "--trace", "trace.json")
            first = (self.work / "trace.json").read_bytes()
            json.loads(first)
            self.succeed(*words, source, "-o", "out.svg", "--trace", "trace.json", "--threads", "3")
            self.assertEqual(first, (self.work / "trace.json").read_bytes())
            self.assertEqual(sorted(os.listdir(self.work)), ["in.svg", "out.svg", "trace.json"])

    def test_several_drawings_and_traces(self):
        self.file("a.svg", waves(2))
        self.file("b.svg", waves(3))
        for _, words in self.run_each():
            self.succeed(*words, "a.svg", "b.svg", "-o", "out", "--to", "inkml", "--trace", "traces")
            self.assertEqual(sorted(os.listdir(self.work / "out")), ["a.inkml", "b.inkml"])
            self.assertEqual(sorted(os.listdir(self.work / "traces")), ["a.json", "b.json"])
            alone = self.succeed(*words, "b.svg", "-o", "-", "--to", "inkml")
            self.assertEqual(alone, (self.work / "out" / "b.inkml").read_bytes())

    def test_a_failed_run_leaves_nothing(self):
        self.file("in.svg", waves(2))
        for _, words in self.run_each():
            self.refuse(1, *words, "in.svg", "-o", "no/such/folder/out.svg", "--trace", "trace.json")
            self.refuse(1, *words, "in.svg", "-o", "out.svg", "--trace", "no/such/trace.json")
            self.refuse(1, *words, "none.svg", "-o", "out.svg", "--trace", "trace.json")
            self.refuse(2, *words, "in.svg", "-o", "out.svg", "--trace", "-")
            self.refuse(1, *words, "in.svg", "-o", "out.png", "--brush", "no-such-brush")

    def test_a_hand_that_is_not_there_lists_those_that_are(self):
        self.file("in.svg", waves(1))
        for operation in operations():
            for parameter in operation["parameters"]:
                if parameter["type"] == "hand":
                    words = [operation["id"], "in.svg", "-o", "out.svg", f"--{parameter['id']}"]
                    line = self.refuse(1, *words, "no-such-hand")
                    self.assertIn("no-such-hand", line)
                    self.assertIn(self.hands()[0], line)
                    self.file("hand.inkml", "this is no recording")
                    self.assertIn("hand.inkml", self.refuse(1, *words, "hand.inkml"))

    def test_odd_drawings(self):
        odd = {
            "empty": svg(),
            "one point": svg("M10 10"),
            "no length": svg("M10 10 L10 10"),
            "closed": svg("M10 10 L90 10 L50 60 Z"),
            "tiny": svg("M0 0 L1e-9 1e-9"),
            "far": svg("M1e8 1e8 L100000100 100000100"),
        }
        for _, words in self.run_each():
            for name, drawing in odd.items():
                source = self.file("in.svg", drawing)
                done = self.run_program(*words, source, "-o", "out.svg")
                self.assertIn(done.returncode, (0, 1), (name, done.stderr))
                self.assertEqual(done.stderr.count(b"\n"), done.returncode, (name, done.stderr))

    def test_our_own_drawings(self):
        for _, words in self.run_each():
            for source in sorted(DRAWINGS.glob("*.svg")):
                self.succeed(*words, source, "-o", "out.svg")


if __name__ == "__main__":
    unittest.main()
