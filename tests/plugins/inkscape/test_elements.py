# SPDX-License-Identifier: GPL-3.0-or-later
"""Everything that a drawing may hold."""

import unittest

import ductus
from extension import LINE, OURS, SVG, Case, document, find

STROKE = 'style="fill:none;stroke:#102030;stroke-width:2"'
SHAPES = {
    "path": f'<path id="s" d="{LINE}" {STROKE}/>',
    "rect": f'<rect id="s" x="20" y="20" width="90" height="50" rx="6" {STROKE}/>',
    "circle": f'<circle id="s" cx="60" cy="50" r="30" {STROKE}/>',
    "ellipse": f'<ellipse id="s" cx="60" cy="50" rx="40" ry="20" {STROKE}/>',
    "line": f'<line id="s" x1="10" y1="20" x2="120" y2="60" {STROKE}/>',
    "polyline": f'<polyline id="s" points="10,20 60,80 120,30" {STROKE}/>',
    "polygon": f'<polygon id="s" points="10,20 60,80 120,30" {STROKE}/>',
}


def box(path_data):
    points = ductus.Path(path_data).points
    return min(points[0::2]), min(points[1::2]), max(points[0::2]), max(points[1::2])


class Elements(Case):
    def test_every_shape_becomes_a_path_where_it_was(self):
        for name, body in SHAPES.items():
            with self.subTest(name):
                element = find(self.apply(document(body), width_kind="none"), "s")
                self.assertEqual(element.tag, SVG + "path")
                x0, y0, x1, y1 = box(element.get("d"))
                self.assertTrue(0 <= x0 < 35 and 80 < x1 < 140 and 0 < y0 < 45 and 50 < y1 < 95, (x0, y0, x1, y1))
                self.assertEqual(element.get("d").rstrip().endswith("Z"), name in ("rect", "circle", "ellipse", "polygon"))
                for attribute in ("x", "cx", "points", "x1", "width", "r", "rx"):
                    self.assertIsNone(element.get(attribute))

    def test_transforms_units_and_viewbox_are_resolved_and_put_back(self):
        plain = box(find(self.apply(document(f'<path id="s" d="{LINE}" {STROKE}/>'), width_kind="none"), "s").get("d"))
        # The same line on the page, in other coordinates: turned by a quarter, in millimetres, in tenths.
        inner = "M 50,-10 C 10,-40 90,-80 50,-120"
        turned = document(f'<g transform="scale(2)"><g transform="rotate(90)"><path id="s" transform="scale(0.5)" d="{inner}" '
                          f'{STROKE}/></g></g>')
        x0, y0, x1, y1 = box(find(self.apply(turned, width_kind="none"), "s").get("d"))
        for got, expected in zip((-y1, x0, -y0, x1), plain):
            self.assertAlmostEqual(got, expected, delta=0.1)
        small = document(f'<path id="s" d="M 1,5 C 4,1 8,9 12,5" style="fill:none;stroke:#000;stroke-width:0.2"/>',
                         'width="200" height="100" viewBox="0 0 20 10"')
        for got, expected in zip(box(find(self.apply(small, width_kind="none"), "s").get("d")), plain):
            self.assertAlmostEqual(10 * got, expected, delta=0.1)

    def test_nested_groups_are_entered_and_styles_inherited(self):
        body = ('<g id="layer" inkscape:groupmode="layer" style="stroke:#ff0000;fill:none"><g stroke-width="3">'
                f'<path id="s" class="c" d="{LINE}"><title>a line</title></path></g></g>')
        element = find(self.apply(document(body), "layer"), "s")
        self.assertIn("fill:#ff0000", element.get("style"))
        self.assertEqual(element.get("class"), "c")
        self.assertEqual(element[0].text, "a line")

    def test_style_sheets_count(self):
        body = f'<style>.ink {{ fill:none; stroke:#00aa00; stroke-width:3 }}</style><path id="s" class="ink" d="{LINE}"/>'
        self.assertIn("fill:#00aa00", find(self.apply(document(body)), "s").get("style").lower())

    def test_compound_paths_stay_compound(self):
        body = f'<path id="s" d="{LINE} M 10,80 L 120,80 M 150,20 h 30 v 30 h -30 z" {STROKE}/>'
        element = find(self.apply(document(body), width_kind="none"), "s")
        self.assertEqual(element.get("d").count("M"), 3)
        self.assertEqual(element.get("d").count("Z"), 1)

    def test_hidden_locked_defined_and_foreign_things_are_left_alone(self):
        kept = (f'<defs><path id="d" d="{LINE}" {STROKE}/><clipPath id="k"><path id="kp" d="{LINE}"/></clipPath>'
                f'<symbol id="y"><path id="yp" d="{LINE}" {STROKE}/></symbol><mask id="m"><path id="mp" d="{LINE}"/></mask>'
                f'<marker id="r"><path id="rp" d="{LINE}" {STROKE}/></marker></defs>'
                f'<g sodipodi:insensitive="true"><path id="l" d="{LINE}" {STROKE}/></g>'
                f'<g style="display:none"><path id="h" d="{LINE}" {STROKE}/></g>'
                f'<path id="v" visibility="hidden" d="{LINE}" {STROKE}/>'
                f'<image id="i" width="10" height="10"/><use id="u" xlink:href="#s" x="5"/><text id="t">word</text>')
        root = self.apply(document(kept + f'<path id="s" clip-path="url(#k)" d="{LINE}" {STROKE}/>'))
        for name in ("d", "kp", "yp", "mp", "rp", "l", "h", "v"):
            self.assertEqual(find(root, name).get("d"), LINE, name)
        self.assertNotEqual(find(root, "s").get("d"), LINE)
        self.assertEqual(find(root, "s").get("clip-path"), "url(#k)")
        self.assertEqual(find(root, "u").tag, SVG + "use")

    def test_only_the_selection_changes(self):
        body = f'<path id="a" d="{LINE}" {STROKE}/><path id="b" d="{LINE}" {STROKE}/>'
        root = self.apply(document(body), "b")
        self.assertEqual(find(root, "a").get("d"), LINE)
        self.assertNotEqual(find(root, "b").get("d"), LINE)

    def test_order_and_count_of_elements_stay(self):
        body = "".join(f'<path id="p{i}" d="M {10 + i},10 C 40,{10 * i} 80,90 120,50" {STROKE}/>' for i in range(8))
        root = self.apply(document(body))
        self.assertEqual([child.get("id") for child in root if child.tag == SVG + "path"], [f"p{i}" for i in range(8)])

    def test_text_is_told_and_others_are_changed(self):
        body = f'<text id="t">word</text><path id="s" d="{LINE}" {STROKE}/>'
        self.apply(document(body), "t", "s")
        self.assertEqual(self.message, "")
        self.apply(document(body), "t", "s", report="true")
        self.assertIn("1 text left alone", self.message)
        self.assertIn("Object to Path", self.refused(document('<text id="t">word</text>'), "t"))

    def test_what_cannot_be_changed_is_told(self):
        clone = f'<path id="s" d="{LINE}" {STROKE}/><use id="u" xlink:href="#s"/>'
        self.assertIn("clones", self.refused(document(clone), "u"))
        locked = f'<g sodipodi:insensitive="true"><path id="s" d="{LINE}" {STROKE}/></g>'
        self.assertIn("locked", self.refused(document(locked)))
        self.assertIn("no paths", self.refused(document("<g/>")))

    def test_same_input_gives_the_same_bytes(self):
        body = "".join(SHAPES[name].replace('"s"', f'"{name}"') for name in SHAPES)
        outputs = set()
        for _ in range(2):
            self.apply(document(body), p_variation="0.5", p_seed="3")
            outputs.add(self.output)
        self.assertEqual(len(outputs), 1)

    def test_editing_one_path_leaves_the_others_choices(self):
        def lines(first):
            body = "".join(f'<path id="p{i}" d="M 10,{20 + 9 * i} {first if i == 0 else "c 30,-20 60,30 110,0"}" {STROKE}/>'
                           for i in range(5))
            root = self.apply(document(body), p_variation="0.8", p_scale_auto="false", p_scale="1")
            return [find(root, f"p{i}").get("d") for i in range(5)]
        before, after = lines("c 30,-20 60,30 110,0"), lines("c 10,30 60,-30 100,10")
        self.assertNotEqual(before[0], after[0])
        self.assertEqual(before[1:], after[1:])


if __name__ == "__main__":
    unittest.main()
