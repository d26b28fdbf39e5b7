# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad documents and settings: one sentence, no document, so that Inkscape keeps the one it has."""

import shutil
import unittest

from extension import EXTENSION, LINE, OURS, Case, document, find
from test_elements import STROKE

PATH = f'<path id="s" d="{LINE}" {STROKE}/>'


class Hostile(Case):
    def test_settings_that_are_not_allowed(self):
        for values, word in (({"p_hand": "nobody"}, "nobody"), ({"p_amount": "7"}, "amount"),
                             ({"p_hand": "", "p_hand_file": ""}, "Hand"), ({"p_hand_file": "/nowhere.inkml"}, "nowhere"),
                             ({"operation": "no-such"}, "no-such"), ({"tolerance": "0"}, "tolerance"),
                             ({"p_mode": "sideways"}, "mode")):
            with self.subTest(values):
                self.assertIn(word, self.refused(document(PATH), **values))

    def test_hand_file_that_is_no_recording(self):
        path = self.folder / "bad.inkml"
        path.write_text("<ink")
        self.assertIn("bad.inkml", self.refused(document(PATH), p_hand_file=path))

    def test_paths_that_hold_no_line(self):
        for d in ("", "M", "M 5,5", "none", "M NaN,1 L 2,2", "Z", "L 1,1"):
            with self.subTest(d):
                done = self.run_extension(document(f'<path id="s" d="{d}" {STROKE}/>'))
                self.assertNotIn(b"Traceback", done.stderr)
                self.assertLessEqual(len(done.stderr.splitlines()), 1)

    def test_numbers_beyond_every_page(self):
        self.assertIn("s: ", self.refused(document(f'<path id="s" d="M 0,0 L 1e300,5" {STROKE}/>')))
        self.assertIn("s: ", self.refused(document(f'<path id="s" d="M 0,0 L 1e12,5" {STROKE}/>')))

    def test_one_bad_path_beside_a_good_one_changes_nothing(self):
        self.refused(document(PATH.replace('"s"', '"a"') + f'<path id="b" d="M 0,0 L 1e12,5" {STROKE}/>'))

    def test_transforms_without_a_size(self):
        self.assertIn("nothing", self.refused(document(f'<g transform="scale(0)">{PATH}</g>')))
        self.assertIn("nothing", self.refused(document(PATH, 'width="0" height="0" viewBox="0 0 0 0"')
                                              .replace("<path", '<path transform="matrix(1 0 0 0 0 0)"')))

    def test_deep_nesting(self):
        for depth in (200, 3000):
            done = self.run_extension(document("<g>" * depth + PATH + "</g>" * depth))
            self.assertNotIn(b"Traceback", done.stderr)
            self.assertLessEqual(len(done.stderr.strip().splitlines()), 1)

    def test_tiny_huge_and_repeated_points(self):
        for d in ("M 0,0 L 0,0", "M 1,1 L 1.0000001,1", "M 5,5 h 0 v 0 h 0", "M 0,0 " + "L 5,5 " * 2000,
                  "M 0,0 " + "C 1,1 2,2 0,0 " * 500, "M -30000,0 L 30000,0"):
            with self.subTest(d[:30]):
                done = self.run_extension(document(f'<path id="s" d="{d}" {STROKE}/>'))
                self.assertNotIn(b"Traceback", done.stderr)
                self.assertNotIn(b"should not happen", done.stderr)

    def test_strange_styles(self):
        for style in ("stroke:#000;fill:none;stroke-width:-3", "stroke:#000;fill:none;stroke-width:nan",
                      "stroke:#000;fill:none;stroke-width:1e99", "stroke:url(#g) red;fill:none;stroke-width:5%", ";;:;x"):
            with self.subTest(style):
                done = self.run_extension(document(f'<path id="s" d="{LINE}" style="{style}"/>'))
                self.assertEqual(done.returncode, 0, done.stderr)

    def test_missing_binding_and_missing_library(self):
        alone = self.folder / "alone"
        shutil.copytree(EXTENSION, alone)
        sentence = self.refused(document(PATH), folder=alone, environment={"PYTHONPATH": "/usr/share/inkscape/extensions"})
        self.assertIn("install", sentence)
        sentence = self.refused(document(PATH), environment={"DUCTUS_LIBRARY": "/nowhere/libductus.so"})
        self.assertIn("libductus", sentence)

    def test_files_that_are_no_drawing(self):
        for data in (b"", b"<svg", b"\x00\xff", b"<html/>"):
            done = self.run_extension(data)
            self.assertEqual(done.stdout, b"")
            self.assertNotIn(b"Traceback", done.stderr)


if __name__ == "__main__":
    unittest.main()
