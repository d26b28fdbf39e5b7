# SPDX-License-Identifier: GPL-3.0-or-later
"""What script/demo and script/test do beside building: the gallery and the count."""

import pathlib
import re
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ElementTree

from program import DRAWINGS, ENVIRONMENT, PROGRAM, SOURCE, ProgramTest, svg

SVG = "{http://www.w3.org/2000/svg}"


class GalleryTest(ProgramTest):
    def test_every_picture_of_the_page_is_there(self):
        ours = self.folder / "ours"
        ours.mkdir()
        (ours / "lettering.svg").write_bytes((DRAWINGS / "lettering.svg").read_bytes())
        yours = self.file("my drawing.svg", svg("M10 50 C60 10 120 90 190 50"))
        gallery = self.folder / "gallery"
        subprocess.run(
            [sys.executable, SOURCE / "script" / "lib" / "gallery.py", PROGRAM, gallery, ours, yours],
            check=True,
            stdout=subprocess.DEVNULL,
            env={**ENVIRONMENT, **self.environment},
        )
        pictures = re.findall(r'src="([^"]+)"', (gallery / "index.html").read_text())
        self.assertGreaterEqual(len(pictures), 8)
        for picture in pictures:
            self.assertTrue((gallery / picture).stat().st_size > 0, picture)
        marks = list(ElementTree.parse(gallery / "lettering-diagram.svg").iter(f"{SVG}path"))
        self.assertGreater(len(marks), 100)

    def test_a_broken_drawing_ends_it_with_the_programs_sentence(self):
        bad = self.file("bad.svg", "no drawing")
        done = subprocess.run(
            [sys.executable, SOURCE / "script" / "lib" / "gallery.py", PROGRAM, self.folder / "g", DRAWINGS, bad],
            capture_output=True,
            text=True,
            check=False,
            env={**ENVIRONMENT, **self.environment},
        )
        self.assertEqual(done.returncode, 1)
        self.assertIn("bad.svg", done.stderr)


class CountTest(ProgramTest):
    def count(self, *words):
        done = subprocess.run(
            [sys.executable, SOURCE / "script" / "lib" / "count.py", *map(str, words)],
            capture_output=True,
            text=True,
            check=False,
        )
        return done.returncode, done.stdout.splitlines()[-1]

    def test_reports_are_summed_up(self):
        head = '<testsuite><testcase name="a" status="run"/><testcase name="b" status="run"/>'
        skipped = '<testcase name="c" status="notrun"><skipped message="SKIP_RETURN_CODE=77"/></testcase></testsuite>'
        good = self.file("good.xml", head + skipped)
        bad = self.file("bad.xml", head + '<testcase name="c" status="fail"/></testsuite>')
        self.assertEqual(self.count("0", "0", good), (0, "4 passed, 0 failed, 1 skipped"))
        self.assertEqual(self.count("0", "0", good, bad), (1, "6 passed, 1 failed, 1 skipped"))
        self.assertEqual(self.count("1", "0", good), (1, "3 passed, 1 failed, 1 skipped"))

    def test_a_program_that_was_not_built_is_a_failure(self):
        missing = '<testcase status="notrun"><skipped message="Unable to find executable"/></testcase>'
        report = self.file("missing.xml", f"<testsuite>{missing}</testsuite>")
        self.assertEqual(self.count("0", "0", report), (1, "2 passed, 1 failed, 0 skipped"))

    def test_a_report_that_is_missing_or_empty_is_a_failure(self):
        empty = self.file("empty.xml", "<testsuite/>")
        self.assertEqual(self.count("0", "0", empty), (1, "2 passed, 1 failed, 0 skipped"))
        self.assertEqual(self.count("0", "0", pathlib.Path("none.xml")), (1, "2 passed, 1 failed, 0 skipped"))


class DrawingsTest(ProgramTest):
    def test_our_drawings_are_plain_vector_drawings(self):
        """Stroked lines without pressure, to be seen as they are by any program."""
        self.assertGreaterEqual(len(list(DRAWINGS.glob("*.svg"))), 5)
        for path in DRAWINGS.glob("*.svg"):
            tree = ElementTree.parse(path)
            self.assertTrue(tree.getroot().find(f"{SVG}title").text)
            ids = [element.get("id") for element in tree.iter(f"{SVG}path")]
            self.assertNotIn(None, ids)
            self.assertEqual(len(set(ids)), len(ids))


if __name__ == "__main__":
    unittest.main()
