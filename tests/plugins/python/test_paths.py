# SPDX-License-Identifier: GPL-3.0-or-later
"""Bezier paths."""

import unittest

from binding import ductus


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
        self.assertEqual((len(fitted.points), len(fitted.verbs), fitted.svg()), (0, 0, ""))

    def test_by_hand_and_by_svg_are_the_same(self):
        path = ductus.Path()
        path.move(1, 2)
        path.line(3.25, 4)
        path.cubic(5, 6, 7, 8, 9, 10)
        path.close()
        self.assertEqual(list(path.verbs), [ductus.MOVE, ductus.LINE, ductus.CUBIC, ductus.CLOSE])
        self.assertEqual(list(path.points), [1, 2, 3.25, 4, 5, 6, 7, 8, 9, 10])
        again = ductus.Path(path.svg())
        self.assertEqual((list(again.verbs), list(again.points)), (list(path.verbs), list(path.points)))
        self.assertEqual(path.svg(1).split()[3], "3.3" if "3.3" in path.svg(1) else "3.2,4")
        again.add_svg("M 0,0 H 5")
        self.assertEqual(len(again.verbs), 6)

    def test_a_bad_matrix_maps_nothing(self):
        path = ductus.Path("M 1,2 L 3,4")
        for matrix in ((1, 2), (1, 0, 0, 1, 0, 0, 0), None):
            with self.assertRaises((ValueError, TypeError)):
                path.map(matrix)
        self.assertEqual(path.svg(), "M 1,2 L 3,4")

    def test_an_error_in_svg_ends_the_path_there(self):
        self.assertEqual(ductus.Path("M 0,0 L 1,1 L x").svg(), "M 0,0 L 1,1")
        with self.assertRaises(ductus.Error):
            ductus.Path("M 0,0\0")

    def test_outline_and_widths_follow_pressure(self):
        stroke = ductus.Drawing().add_stroke("s", [0, 50, 100], [0, 0, 0], pressure=[0, 0.5, 1])
        path, nib = ductus.Path(), ductus.Nib(width=10, aspect=1)
        path.fit(stroke, 0.1)
        widths = path.widths(0, stroke, nib)
        self.assertAlmostEqual(widths[0][1], 3, places=5)
        self.assertAlmostEqual(widths[-1][1], 17, places=5)
        self.assertGreater(len(path.widths(0, stroke, ductus.Nib(width=10, aspect=1, thickest=3))), 1)
        outline = ductus.Path()
        outline.outline(stroke, nib)
        self.assertGreater(outline.nodes, 3)
        without = ductus.Path()
        without.outline(stroke)
        self.assertNotEqual(without.svg(), outline.svg())
        for subpath in (5, -1):
            with self.assertRaises(ductus.Error):
                path.widths(subpath, stroke)

    def test_what_has_no_place_is_refused(self):
        path = ductus.Path("M 0,0 L 1,1")
        for tolerance in (0, -1, float("nan")):
            with self.assertRaises(ductus.Error) as caught:
                path.flatten("p", tolerance, ductus.Drawing())
            self.assertEqual(caught.exception.status, "bad-argument")
        path.line(float("inf"), 0)
        with self.assertRaises(ductus.Error):
            path.flatten("p", 0.1, ductus.Drawing())


if __name__ == "__main__":
    unittest.main()
