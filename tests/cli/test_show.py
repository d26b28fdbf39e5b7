# SPDX-License-Identifier: GPL-3.0-or-later
"""Diagrams of drawings and traces."""

import json
import struct
import unittest
import xml.etree.ElementTree as ElementTree

from program import DRAWINGS, ProgramTest, operations, recording, svg

SVG = "{http://www.w3.org/2000/svg}"


class ShowTest(ProgramTest):
    def shapes(self, name, tag):
        return list(ElementTree.parse(self.work / name).iter(SVG + tag))

    def texts(self, name):
        return [text.text for text in self.shapes(name, "text")]

    def setUp(self):
        super().setUp()
        self.recording = self.file("pen.inkml", recording())

    def test_a_recording_as_svg_and_png(self):
        self.succeed("show", self.recording, "-o", "out.svg")
        self.assertIn("pressure", self.texts("out.svg"))
        colours = {line.get("stroke") for line in self.shapes("out.svg", "polyline")}
        self.assertGreater(len(colours), 20)
        self.succeed("show", self.recording, "-o", "out.png", "--panel", "300", "--scale", "2")
        image = (self.work / "out.png").read_bytes()
        self.assertTrue(image.startswith(b"\x89PNG"))
        self.assertEqual(struct.unpack(">I", image[16:20])[0], 2 * (300 + 2 * 16))

    def test_every_choice_is_drawn(self):
        for by in ("pressure", "speed", "none"):
            for marks in ("none", "nibs", "needles", "both"):
                self.succeed("show", self.recording, "-o", "out.svg", "--by", by, "--marks", marks)
        for palette in ("violet-yellow", "blue-red"):
            for width in ("even", "pressure"):
                self.succeed("show", self.recording, "-o", "out.svg", "--palette", palette, "--width", width)

    def test_panels_side_by_side_have_captions(self):
        other = self.file("other.inkml", recording(strokes=3))
        self.succeed("show", self.recording, other, "-o", "out.svg")
        self.assertIn("other.inkml", self.texts("out.svg"))
        self.succeed("show", self.recording, other, "-o", "wide.svg", "--captions", "before|after")
        self.assertLessEqual({"before", "after"}, set(self.texts("wide.svg")))
        self.succeed("show", self.recording, other, "-o", "tall.svg", "--columns", "1")
        wide, tall = (ElementTree.parse(self.work / name).getroot() for name in ("wide.svg", "tall.svg"))
        self.assertGreater(float(wide.get("width")), 1.5 * float(tall.get("width")))
        self.assertGreater(float(tall.get("height")), 1.5 * float(wide.get("height")))

    def test_the_range_is_the_legend(self):
        self.succeed("show", self.recording, "-o", "out.svg", "--range", "-0.5,2.25")
        self.assertLessEqual({"-0.5", "2.2"}, {text[:4] for text in self.texts("out.svg")})

    def test_standard_input(self):
        self.succeed("show", "-", "-o", "out.svg", "--by", "none", stdin=DRAWINGS.joinpath("cat.svg").read_bytes())
        self.assertTrue(self.shapes("out.svg", "polyline"))

    def test_same_bytes_again(self):
        self.succeed("show", self.recording, "-o", "a.png")
        self.succeed("show", self.recording, "-o", "b.png")
        self.assertEqual((self.work / "a.png").read_bytes(), (self.work / "b.png").read_bytes())


class SegmentTest(ProgramTest):
    """Traces as the operations write them."""

    def setUp(self):
        super().setUp()
        self.file("in.svg", svg("M10 10 C60 90 120 -30 190 60", "M20 80 L180 90"))
        self.hand = self.file("pen.inkml", recording())
        for operation in operations():
            hands = [p["id"] for p in operation["parameters"] if p["type"] == "hand"]
            if hands:
                self.operation = operation["id"], f"--{hands[0]}", self.hand
        self.succeed(*self.operation, "in.svg", "-o", "out.inkml", "--trace", "t.json")

    def test_segments_with_the_hand_beside(self):
        trace = json.loads((self.work / "t.json").read_text())
        self.succeed("show", "out.inkml", "--trace", "t.json", "-o", "a.svg")
        self.succeed("show", "out.inkml", "--trace", "t.json", "--hand", self.hand, "-o", "b.svg")
        alone, beside = ((self.work / name).read_text() for name in ("a.svg", "b.svg"))
        samples = [s["passes"][-1]["samples"] for s in trace["strokes"]]
        segments = sum(
            1 + sum(sample.get("next") == "jump" for sample in stroke[:-1]) for stroke in samples
        )
        self.assertIn(f"{segments} segments", alone)
        self.assertEqual(alone.count("<polyline"), segments)
        used = {sample["chosen"][0] for stroke in samples for sample in stroke}
        self.assertEqual(beside.count("<polyline"), 2 * segments + len(used))

    def test_either_pass(self):
        for name in ("trajectory", "pose"):
            self.succeed("show", "in.svg", "--trace", "t.json", "--pass", name, "-o", f"{name}.svg")

    def test_damaged_traces_are_one_sentence(self):
        text = (self.work / "t.json").read_text()
        for name, content in {
            "half": text[: len(text) // 2],
            "empty": "",
            "other": json.dumps({"a": 1}),
            "far": text.replace('"chosen": [', '"chosen": [9', 1),
            "binary": "\x00\x01\x02",
            "deep": '{"a": ' + "[" * 100000,
        }.items():
            self.file("bad.json", content)
            with self.subTest(name):
                line = self.refuse(1, "show", "out.inkml", "--trace", "bad.json", "-o", "x.svg")
                self.assertTrue(line.startswith("bad.json: "), line)

    def test_another_hand_is_refused(self):
        other = self.file("other.inkml", recording(strokes=5))
        line = self.refuse(1, "show", "out.inkml", "--trace", "t.json", "--hand", other, "-o", "x.svg")
        self.assertIn("strokes differ", line)

    def test_a_run_without_chosen_places_is_refused(self):
        for choice in ("average",):
            self.succeed(*self.operation, "in.svg", "-o", "out.svg", "--trace", "u.json", "--select", choice)
            line = self.refuse(1, "show", "out.svg", "--trace", "u.json", "-o", "x.svg")
            self.assertIn("--select optimal", line)


class MisuseTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.file("in.svg", svg("M10 10 L90 50"))

    def test_what_is_needed(self):
        self.assertIn("give a drawing", self.refuse(2, "show", "-o", "x.svg"))
        self.assertIn("-o OUT", self.refuse(2, "show", "in.svg"))
        self.assertIn("-o OUT", self.refuse(2, "show", "in.svg", "-o", "x.gif"))
        self.assertIn("--trace", self.refuse(2, "show", "in.svg", "-o", "x.svg", "--by", "segments"))
        self.assertIn("--trace", self.refuse(2, "show", "in.svg", "-o", "x.svg", "--hand", "x"))
        self.assertIn("one drawing", self.refuse(2, "show", "in.svg", "in.svg", "-o", "x.svg", "--trace", "t"))

    def test_ranges(self):
        for text in ("1", "1,", ",1", "a,b", "2,1", "1,1", "nan,1", "1,2,3", ""):
            self.assertIn("--range", self.refuse(2, "show", "in.svg", "-o", "x.svg", "--range", text), text)

    def test_captions_for_drawings_that_are_not(self):
        self.assertIn("--captions", self.refuse(2, "show", "in.svg", "-o", "x.svg", "--captions", "a|b"))

    def test_a_channel_that_is_not_there(self):
        for by, says in (("pressure", "pressure"), ("tilt", "tilt"), ("twist", "twist"), ("speed", "time")):
            self.assertIn(f"no stroke has {says}", self.refuse(1, "show", "in.svg", "-o", "x.svg", "--by", by))

    def test_files_that_are_not_there(self):
        self.assertIn("nosuch.svg", self.refuse(1, "show", "nosuch.svg", "-o", "x.svg"))
        self.assertIn("nosuch.json", self.refuse(1, "show", "in.svg", "--trace", "nosuch.json", "-o", "x.svg"))
        self.assertIn("nosuch", self.refuse(1, "show", "in.svg", "-o", "nosuch/x.svg", "--by", "none"))


if __name__ == "__main__":
    unittest.main()
