# SPDX-License-Identifier: GPL-3.0-or-later
"""Real recordings and drawings, where they are: $DUCTUS_DATA, or ../shared/data beside the checkout."""

import os
import pathlib
import re
import unittest

import program
from program import SOURCE, ProgramTest

DATA = pathlib.Path(os.environ.get("DUCTUS_DATA") or SOURCE.parent / "shared" / "data")
HAND = DATA / "helpinghand" / "SteveEnglish1.cyn"


@unittest.skipUnless(HAND.exists(), "no real recordings here (set DUCTUS_DATA to their folder)")
class Real(ProgramTest):
    def some(self, folder, pattern):
        """All files of a kind; every fifth in a build with sanitizers, which is too slow for all."""
        return sorted((DATA / folder).glob(pattern))[:: 5 if program.SANITIZED else 1]

    def run_well(self, *words):
        result = program.program(*words, "--quiet")
        self.assertEqual(result.returncode, 0, result.stderr)
        return result

    def test_every_line_drawing_in_a_real_hand(self):
        for drawing in self.some("svg_lineart", "*.svg"):
            output = self.folder / drawing.name
            self.run_well("restyle", "--hand", HAND, drawing, "-o", output)
            text = output.read_bytes()
            self.assertNotIn(b"nan", text.lower().replace(b"nance", b""))
            # The same elements with the same ids are still there.
            ids = set(re.findall(rb'\bid="([^"]+)"', drawing.read_bytes()))
            self.assertLessEqual(ids, set(re.findall(rb'\bid="([^"]+)"', text)), drawing.name)

    def test_amount_zero_gives_every_drawing_back(self):
        for drawing in self.some("svg_lineart", "*.svg"):
            output = self.folder / drawing.name
            self.run_well("restyle", "--hand", HAND, "--amount", "0", drawing, "-o", output)
            self.assertEqual(output.read_bytes(), drawing.read_bytes(), drawing.name)

    def test_every_recording_is_a_hand(self):
        for hand in self.some("helpinghand", "*.cyn"):
            output = self.folder / "out.inkml"
            self.run_well("restyle", "--hand", hand, SOURCE / "data" / "drawings" / "cat.svg", "-o", output)
            self.assertIn(b"name=\"F\"", output.read_bytes())

    def test_queries_without_pose_get_one(self):
        output = self.folder / "houses.cyn"
        self.run_well("restyle", "--hand", HAND, "--mode", "pose", DATA / "helpinghand_queries" / "houses.cyn", "-o", output)
        rows = [line.split() for line in output.read_text().splitlines() if len(line.split()) == 8]
        self.assertEqual(len(rows), 4171)
        for column in (4, 5, 6, 7):
            self.assertGreater(len({row[column] for row in rows}), 1000)


if __name__ == "__main__":
    unittest.main()
