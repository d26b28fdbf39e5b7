# SPDX-License-Identifier: GPL-3.0-or-later
"""The hand's pressure as outlines, PowerStroke path effects and segments."""

import unittest

import ductus
from extension import INKSCAPE, LINE, SVG, Case, document, find
from test_elements import STROKE, box


def places(root, name="s"):
    effect = find(root, find(root, name).get(INKSCAPE + "path-effect")[1:])
    return [tuple(float(v) for v in point.split(",")) for point in effect.get("offset_points").split("|")]


class Widths(Case):
    def line(self, **values):
        return self.apply(document(f'<path id="s" d="{LINE}" {STROKE}/>'), **values)

    def test_outline_is_the_strokes_colour_and_about_as_wide(self):
        root = self.line(width_kind="outline")
        style = find(root, "s").get("style")
        self.assertIn("fill:#102030", style)
        self.assertIn("stroke:none", style)
        outline, spine = box(find(root, "s").get("d")), box(find(self.line(width_kind="none"), "s").get("d"))
        for a, b in zip(outline, spine):
            self.assertTrue(0 < abs(a - b) < 4, (outline, spine))

    def test_width_comes_from_the_setting_where_it_is_set(self):
        def span(**values):
            x0, y0, x1, y1 = box(find(self.line(**values), "s").get("d"))
            return y1 - y0
        self.assertGreater(span(width="20"), span(width="2") + 8)

    def test_powerstroke_has_rising_places_on_the_path_and_half_widths(self):
        root = self.line(width_kind="powerstroke", thinnest="1", thickest="1", aspect="1")
        element = find(root, "s")
        nodes = ductus.Path(element.get(INKSCAPE + "original-d")).nodes
        points = places(root)
        self.assertEqual(points[0][0], 0)
        self.assertAlmostEqual(points[-1][0], nodes - 1, places=3)
        for _, half in points:
            self.assertAlmostEqual(half, 1, delta=0.3)     # the stroke is 2 wide; tilt flattens the nib
        self.assertGreater(ductus.Path(element.get("d")).nodes, nodes)
        pressed = places(self.line(width_kind="powerstroke"))
        self.assertGreater(max(half for _, half in pressed) / min(half for _, half in pressed), 1.2)
        self.assertEqual(sorted(at for at, _ in pressed), [at for at, _ in pressed])

    def test_powerstroke_of_scaled_paths_is_in_their_own_units(self):
        body = f'<g transform="scale(10)"><path id="s" d="M 1,5 C 4,1 8,9 12,5" style="fill:none;stroke:#000;stroke-width:.2"/></g>'
        root = self.apply(document(body), width_kind="powerstroke", thinnest="1", thickest="1", aspect="1")
        for _, half in places(root):
            self.assertAlmostEqual(half, 0.1, delta=0.03)

    def test_segments_are_plain_strokes_that_join(self):
        root = self.line(width_kind="segments")
        group = find(root, "s")
        self.assertEqual(group.tag, SVG + "g")
        ends = [ductus.Path(child.get("d")).points for child in group]
        self.assertGreater(len(ends), 1)
        for before, after in zip(ends, ends[1:]):
            self.assertAlmostEqual(before[-2], after[0], places=2)
            self.assertAlmostEqual(before[-1], after[1], places=2)
        widths = {child.get("style") for child in group}
        self.assertGreater(len(widths), 1)

    def test_dashed_marked_and_unstroked_paths_keep_their_stroke(self):
        for style in ("fill:none;stroke:#000;stroke-dasharray:4,2", "fill:none;stroke:#000;marker-end:url(#m)",
                      "fill:#ff0000;stroke:none"):
            element = find(self.apply(document(f'<path id="s" d="{LINE}" style="{style}"/>')), "s")
            self.assertEqual(element.get("style"), style)
            self.assertNotEqual(element.get("d"), LINE)

    def test_a_path_that_text_runs_along_stays_a_line(self):
        text = '<text><textPath xlink:href="#s">word</textPath></text>'
        element = find(self.apply(document(f'<path id="s" d="{LINE}" {STROKE}/>{text}')), "s")
        self.assertNotEqual(element.get("d"), LINE)
        self.assertIn("stroke:#102030", element.get("style"))

    def test_strokes_that_do_not_scale_keep_the_width_they_show(self):
        line = '<g transform="scale(10)"><path id="s" d="M 1,5 H 12" style="fill:none;stroke:#000;stroke-width:2{}"/></g>'
        heights = []
        for more in ("", ";vector-effect:non-scaling-stroke"):
            x0, y0, x1, y1 = box(find(self.apply(document(line.format(more)), p_mode="pose"), "s").get("d"))
            heights.append(y1 - y0)
        self.assertGreater(heights[0], 5 * heights[1])

    def test_filled_and_stroked_shapes_keep_the_fill_beneath_the_line(self):
        for kind in ("outline", "powerstroke", "segments"):
            body = '<circle id="s" cx="60" cy="50" r="30" style="fill:#ffee00;stroke:#000;stroke-width:2"/>'
            group = find(self.apply(document(body), width_kind=kind), "s")
            self.assertEqual(group.tag, SVG + "g")
            self.assertIn("fill:#ffee00", group[0].get("style"))
            self.assertIn("stroke:none", group[0].get("style"))
            self.assertGreater(len(group), 1)

    def test_the_users_own_path_effects_go_on_working(self):
        body = (f'<defs><inkscape:path-effect effect="spiro" id="e"/></defs><path id="s" inkscape:path-effect="#e" '
                f'inkscape:original-d="{LINE}" d="M 0,0 L 1,1" {STROKE}/>')
        element = find(self.apply(document(body)), "s")
        self.assertEqual(element.get(INKSCAPE + "path-effect"), "#e")
        self.assertNotEqual(element.get(INKSCAPE + "original-d"), LINE)
        self.assertIsNone(element.get("d"))     # Inkscape computes it

    def test_tolerance_decides_the_number_of_nodes_and_the_report_tells_it(self):
        counts = []
        for tolerance in ("0.02", "2"):
            self.line(width_kind="none", tolerance=tolerance, report="true")
            self.assertIn("1 path: 2 nodes before, ", self.message)
            counts.append(int(self.message.split("before, ")[1].split()[0]))
        self.assertGreater(counts[0], 1.5 * counts[1])


if __name__ == "__main__":
    unittest.main()
