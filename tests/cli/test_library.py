# SPDX-License-Identifier: GPL-3.0-or-later
"""Stroke libraries: building, listing, and using one's own."""

import json
import pathlib
import re
import unittest

from program import ProgramTest, operations, recording, svg, waves


class LibraryTest(ProgramTest):
    def own_folder(self):
        folder = pathlib.Path(self.environment["XDG_DATA_HOME"]) / "ductus" / "hands"
        folder.mkdir(parents=True, exist_ok=True)
        return folder

    def test_build_is_silent_and_the_same_again(self):
        self.file("pen.inkml", recording())
        self.assertEqual(self.succeed("library", "build", "pen.inkml", "-o", "a.inkml"), b"")
        self.succeed("library", "build", "pen.inkml", "-o", "b.inkml", "--name", "a")
        self.succeed("library", "build", "pen.inkml", "-o", "c.inkml", "--name", "a", "--threads", "1")
        self.assertEqual((self.work / "b.inkml").read_bytes(), (self.work / "c.inkml").read_bytes())

    def test_a_built_library_is_listed_with_its_facts_and_can_be_used(self):
        self.file("pen.inkml", recording(strokes=9))
        target = self.own_folder() / "mine.inkml"
        self.succeed(
            "library", "build", "pen.inkml", "-o", target, "--name", "mine", "--artist", 'A "B" Ü', "--licence", "CC0-1.0"
        )
        mine = [h for h in json.loads(self.succeed("library", "list", "--json")) if h["name"] == "mine"]
        self.assertEqual(len(mine), 1)
        self.assertEqual(mine[0]["strokes"], 9)
        self.assertEqual(mine[0]["artist"], 'A "B" Ü')
        self.assertEqual(mine[0]["licence"], "CC0-1.0")
        self.assertFalse(mine[0]["builtin"])
        self.assertIn("pressure", mine[0]["channels"])
        self.assertIn("mine", self.succeed("library", "list").decode())

    def test_recordings_are_joined(self):
        self.file("a.inkml", recording(strokes=5))
        self.file("b.inkml", recording(strokes=7))
        target = self.own_folder() / "both.inkml"
        self.succeed("library", "build", "a.inkml", "b.inkml", "-o", target)
        both = [h for h in json.loads(self.succeed("library", "list", "--json")) if h["path"] == str(target)]
        self.assertEqual(both[0]["strokes"], 12)

    def test_a_channel_that_some_recordings_lack_is_not_lost_in_silence(self):
        self.file("pen.inkml", recording(strokes=5))
        bare = recording(strokes=4).replace('<channel name="F" type="decimal"/>', "")
        self.file("bare.inkml", re.sub(r" [0-9.]+(?=,|</trace>)", "", bare))
        words = ("library", "build", "pen.inkml", "bare.inkml", "-o", "both.inkml")
        done = self.run_program(*words)
        self.assertEqual(done.returncode, 0)
        self.assertEqual(done.stderr.decode(), "ductus: bare.inkml has no pressure; so the library goes without\n")
        self.assertEqual(self.run_program(*words, "--quiet").stderr, b"")
        self.assertEqual(self.run_program("library", "build", "bare.inkml", "-o", "bare2.inkml").stderr, b"")

    def test_built_in_hands_say_that_they_are_synthetic(self):
        builtin = [h for h in json.loads(self.succeed("library", "list", "--json")) if h["builtin"]]
        self.assertTrue(builtin)
        self.assertIn("synthetic", self.succeed("library", "list").decode())
        for hand in builtin:
            self.assertGreaterEqual(hand["strokes"], 150)

    def test_a_broken_hand_is_listed_as_such(self):
        (self.own_folder() / "broken.inkml").write_text("no ink at all")
        broken = [h for h in json.loads(self.succeed("library", "list", "--json")) if h["name"] == "broken"]
        self.assertTrue(broken[0]["error"])
        self.assertIn("cannot be opened", self.succeed("library", "list").decode())

    def test_recordings_that_make_no_library(self):
        self.file("nothing.svg", svg())
        self.file("point.svg", svg("M10 10 L10 10"))
        self.file("noise.inkml", "no ink at all")
        for name in ("nothing.svg", "point.svg", "noise.inkml", "none.inkml"):
            self.assertIn(name, self.refuse(1, "library", "build", name, "-o", "out.inkml"))
        self.file("pen.inkml", recording())
        self.refuse(1, "library", "build", "pen.inkml", "-o", "no/such/out.inkml")
        self.refuse(2, "library", "build", "pen.inkml", "-o", "out.svg")

    def test_a_recording_can_be_a_hand_directly(self):
        self.file("pen.inkml", recording())
        self.file("in.svg", waves(2))
        self.succeed("library", "build", "pen.inkml", "-o", "lib.inkml")
        for operation in operations():
            for parameter in operation["parameters"]:
                if parameter["type"] == "hand":
                    words = [operation["id"], "in.svg", "-o", "-", "--to", "inkml", f"--{parameter['id']}"]
                    # The library was resampled and written with finitely many digits, so the results need not be
                    # the same to the last digit; both have to work.
                    self.succeed(*words, "pen.inkml")
                    self.succeed(*words, "lib.inkml")

    def test_sizes_and_weights_and_position(self):
        self.file("a.inkml", recording(strokes=5))
        self.file("b.inkml", recording(strokes=7))
        target = self.own_folder() / "rich.inkml"
        self.succeed("library", "build", "a.inkml", "b.inkml", "-o", target, "--scales", "0.5,1", "--weights", "2,1.5")
        rich = [h for h in json.loads(self.succeed("library", "list", "--json")) if h["path"] == str(target)]
        self.assertEqual(rich[0]["strokes"], 24)
        self.assertIn("2*5 1.5*7 2*5 1.5*7", target.read_text())
        self.succeed("library", "build", "a.inkml", "-o", "plain.inkml")
        self.succeed("library", "build", "a.inkml", "-o", "flat.inkml", "--remove-position")
        self.assertNotEqual((self.work / "plain.inkml").read_bytes(), (self.work / "flat.inkml").read_bytes())

    def test_sizes_and_weights_that_are_none(self):
        self.file("a.inkml", recording())
        for option, value in (
            ("scales", ""), ("scales", "1,"), ("scales", "0"), ("scales", "-1"), ("scales", "nan"), ("scales", "1;2"),
            ("scales", "1e9"), ("scales", ",".join(["1"] * 17)), ("weights", "1,1"), ("weights", "0"), ("weights", "x"),
        ):
            self.assertIn(option, self.refuse(2, "library", "build", "a.inkml", "-o", "out.inkml", f"--{option}={value}"))
        self.assertFalse((self.work / "out.inkml").exists())

    def test_report_as_text_json_and_picture(self):
        self.file("a.inkml", recording(strokes=12))
        self.file("b.inkml", recording(strokes=20, samples=60))
        text = self.succeed("library", "report", "a.inkml", "b.inkml").decode()
        self.assertIn("consistent: similar shapes are drawn with similar pose", text)
        self.assertIn("a, b", text)
        report = json.loads(self.succeed("library", "report", "a.inkml", "b.inkml", "--json", "-o", "r.svg"))
        self.assertEqual([entry["name"] for entry in report["libraries"]], ["a", "b"])
        self.assertEqual(len(report["between"]), 1)
        for entry in report["libraries"] + report["between"]:
            self.assertGreater(entry["similar"], entry["random"])
            self.assertGreater(entry["pairs"], 200)
            self.assertEqual(list(entry["channels"]), ["pressure"])
        self.assertTrue((self.work / "r.svg").read_text().startswith("<?xml"))
        again = json.loads(self.succeed("library", "report", "a.inkml", "b.inkml", "--json", "--threads", "1"))
        self.assertEqual(again, report)
        self.succeed("library", "report", "a.inkml", "-o", "r.png")
        self.assertTrue((self.work / "r.png").read_bytes().startswith(b"\x89PNG"))

    def test_reports_that_cannot_be_made(self):
        self.file("a.inkml", recording())
        self.refuse(2, "library", "report")
        self.assertIn(".svg", self.refuse(2, "library", "report", "a.inkml", "-o", "r.gif"))
        self.assertIn("none.inkml", self.refuse(1, "library", "report", "a.inkml", "none.inkml"))
        self.refuse(1, "library", "report", "a.inkml", "-o", "no/such/r.svg")
        self.refuse(2, "library", "report", "a.inkml", "--radius", "1")

    def test_built_in_hands_are_as_consistent_as_real_ones(self):
        names = [h["name"] for h in json.loads(self.succeed("library", "list", "--json")) if h["builtin"]]
        for entry in json.loads(self.succeed("library", "report", *names, "--json"))["libraries"]:
            self.assertGreater(entry["similar"], entry["random"])


if __name__ == "__main__":
    unittest.main()
