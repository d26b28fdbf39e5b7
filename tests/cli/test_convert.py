# SPDX-License-Identifier: GPL-3.0-or-later
"""Reading and writing: formats, folders, standard input and output, and inputs that mean harm."""

import os
import pathlib
import unittest
import xml.etree.ElementTree as ElementTree

from program import DRAWINGS, ProgramTest, recording, svg

BILLION_LAUGHS = (
    '<?xml version="1.0"?><!DOCTYPE svg [<!ENTITY a "ha ha ha ha ha ha ha ha ha ha">'
    + "".join(f'<!ENTITY {chr(98 + i)} "{("&" + chr(97 + i) + ";") * 10}">' for i in range(12))
    + ']><svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"><path d="&m;" stroke="red"/></svg>'
)


class ConvertTest(ProgramTest):
    def test_success_is_silent(self):
        source = self.file("in.svg", svg("M10 10 C40 0 60 90 90 50"))
        self.assertEqual(self.succeed("convert", source, "-o", "out.inkml"), b"")
        self.assertTrue((self.work / "out.inkml").stat().st_size > 0)

    def test_every_format_reads_what_it_wrote(self):
        source = self.file("in.inkml", recording(strokes=3))
        for ending in ("inkml", "csv", "svg"):
            self.succeed("convert", source, "-o", f"a.{ending}")
            self.succeed("convert", f"a.{ending}", "-o", f"b.{ending}")
            self.assertTrue((self.work / f"b.{ending}").stat().st_size > 0)

    def test_inkml_round_trip_is_stable(self):
        source = self.file("in.inkml", recording(strokes=3))
        self.succeed("convert", source, "-o", "a.inkml")
        self.succeed("convert", "a.inkml", "-o", "b.inkml")
        self.assertEqual((self.work / "a.inkml").read_bytes(), (self.work / "b.inkml").read_bytes())

    def test_svg_to_svg_keeps_what_is_not_touched(self):
        source = DRAWINGS / "cat.svg"
        self.succeed("convert", source, "-o", "out.svg")
        ids = {element.get("id") for element in ElementTree.parse(source).iter()}
        kept = {element.get("id") for element in ElementTree.parse(self.work / "out.svg").iter()}
        self.assertEqual(ids, kept)

    def test_output_may_be_the_input(self):
        source = self.file("in.svg", svg("M10 10 L90 50"))
        self.succeed("convert", source, "-o", source)
        ElementTree.parse(source)

    def test_standard_input_and_output(self):
        drawing = svg("M10 10 L90 50").encode()
        text = self.succeed("convert", "-", "-o", "-", "--to", "csv", stdin=drawing)
        self.assertGreater(len(text.splitlines()), 2)
        again = self.succeed("convert", "-", "--from=csv", "-o-", "--to=svg", stdin=text)
        self.assertIn(b"<svg", again)

    def test_from_names_the_format_of_a_file(self):
        text = self.succeed("convert", "-", "-o", "-", "--to", "csv", stdin=svg("M10 10 L90 50").encode())
        self.file("table.dat", text)
        self.succeed("convert", "table.dat", "--from", "csv", "-o", "out.svg")
        ElementTree.parse(self.work / "out.svg")

    def test_a_name_that_looks_like_an_option(self):
        self.file("-in.svg", svg("M10 10 L90 50"))
        self.succeed("convert", "-o", "out.csv", "--", "-in.svg")
        self.assertTrue((self.work / "out.csv").exists())

    def test_several_go_into_a_folder_that_is_made(self):
        for name in ("a.svg", "b.svg"):
            self.file(name, svg("M10 10 L90 50"))
        self.succeed("convert", "a.svg", "b.svg", "-o", "out")
        self.assertEqual(sorted(os.listdir(self.work / "out")), ["a.svg", "b.svg"])
        self.succeed("convert", "a.svg", "b.svg", "-o", "out", "--to", "csv")
        self.assertEqual(sorted(os.listdir(self.work / "out")), ["a.csv", "a.svg", "b.csv", "b.svg"])
        self.succeed("convert", "a.svg", "-o", "one/")
        self.assertEqual(os.listdir(self.work / "one"), ["a.svg"])

    def test_several_need_a_folder(self):
        for name in ("a.svg", "b.svg", "x/a.svg"):
            self.file(name, svg("M10 10 L90 50"))
        self.assertIn("folder", self.refuse(2, "convert", "a.svg", "b.svg", "-o", "out.svg"))
        self.assertIn("standard output", self.refuse(2, "convert", "a.svg", "b.svg", "-o", "-", "--to", "svg"))
        self.assertIn("both", self.refuse(2, "convert", "a.svg", "x/a.svg", "-o", "out"))
        self.assertIn("standard input", self.refuse(2, "convert", "a.svg", "-", "-o", "out"))

    def test_a_folder_that_was_made_for_nothing_goes_again(self):
        self.file("a.svg", "this is no drawing")
        self.file("b.svg", svg("M10 10 L90 50"))
        self.assertIn("a.svg", self.refuse(1, "convert", "a.svg", "b.svg", "-o", "out"))

    def test_places_that_cannot_be_written(self):
        self.file("in.svg", svg("M10 10 L90 50"))
        self.file("folder.svg/x", "")
        self.assertIn("no/such", self.refuse(1, "convert", "in.svg", "-o", "no/such/out.svg"))
        self.assertIn("no/such", self.refuse(1, "convert", "in.svg", "-o", "no/such/"))

    def test_a_full_disk(self):
        if not pathlib.Path("/dev/full").exists():
            self.skipTest("no /dev/full here")
        self.file("in.svg", svg("M10 10 L90 50"))
        with open("/dev/full", "wb") as full:
            from program import ENVIRONMENT, PROGRAM
            import subprocess

            done = subprocess.run([PROGRAM, "convert", "in.svg", "-o", "-", "--to", "svg"], stdout=full,
                                  stderr=subprocess.PIPE, cwd=self.work, env=ENVIRONMENT, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn(b"standard output", done.stderr)


class HostileTest(ProgramTest):
    """Exit 1, one line that names the file, and nothing left behind."""

    def refuse_file(self, name, content):
        path = self.file(name, content)
        line = self.refuse(1, "convert", name, "-o", "out.inkml")
        self.assertTrue(line.startswith(f"{name}: "), line)
        path.unlink()
        return line

    def test_files_that_are_not_there(self):
        self.assertTrue(self.refuse(1, "convert", "none.svg", "-o", "out.svg").startswith("none.svg: "))
        self.assertTrue(self.refuse(1, "convert", ".", "-o", "out.svg").startswith(".: "))
        self.assertTrue(self.refuse(1, "convert", "", "-o", "out.svg"))

    def test_empty_and_noise(self):
        for ending in ("svg", "inkml", "csv", "cyn", "xyz"):
            self.refuse_file(f"empty.{ending}", b"")
            self.refuse_file(f"zeros.{ending}", bytes(5000))
            self.refuse_file(f"noise.{ending}", bytes((i * 7919 + i // 3) & 0xFF for i in range(5000)))

    def test_empty_standard_input(self):
        self.assertTrue(self.refuse(1, "convert", "-", "-o", "o.svg").startswith("standard input: "))

    def test_truncated(self):
        drawing = (DRAWINGS / "cat.svg").read_bytes()
        for size in (1, 60, 500, len(drawing) // 2, len(drawing) - 8):
            self.refuse_file("cut.svg", drawing[:size])
        ink = recording().encode()
        for size in (1, 60, 500, len(ink) // 2, len(ink) - 5):
            self.refuse_file("cut.inkml", ink[:size])

    def test_billion_laughs(self):
        self.refuse_file("laughs.svg", BILLION_LAUGHS)
        self.refuse_file("laughs.inkml", BILLION_LAUGHS.replace("svg", "ink"))

    def test_entities_do_not_read_files(self):
        secret = self.file("secret", "M10 10 L90 50")
        text = (
            f'<!DOCTYPE svg [<!ENTITY s SYSTEM "file://{secret}">]><svg xmlns="http://www.w3.org/2000/svg" '
            'width="9" height="9"><title>&s;</title><path d="M0 0 L5 5" stroke="red"/></svg>'
        )
        self.file("steal.svg", text)
        done = self.run_program("convert", "steal.svg", "-o", "out.svg")
        self.assertIn(done.returncode, (0, 1))
        if done.returncode == 0:
            self.assertNotIn(b"L90 50", (self.work / "out.svg").read_bytes())

    def test_deep_groups(self):
        depth = 20000
        self.refuse_file(
            "deep.svg", '<svg xmlns="http://www.w3.org/2000/svg">' + "<g>" * depth + "</g>" * depth + "</svg>"
        )

    def test_numbers_that_are_none(self):
        for value in ("nan", "inf", "1e999"):
            path = self.file("bad.csv", f"stroke,x,y\n0,1,2\n0,{value},4\n")
            line = self.refuse(1, "convert", path.name, "-o", "out.svg")
            self.assertIn("bad.csv", line)


if __name__ == "__main__":
    unittest.main()
