# SPDX-License-Identifier: GPL-3.0-or-later
"""Originals are kept, come back as they were, and are what an operation is applied to again."""

import copy
import unittest

from lxml import etree

import ductus
from extension import INKSCAPE, LINE, OURS, SVG, Case, describe, document, find
from test_elements import SHAPES, STROKE

KINDS = ("outline", "powerstroke", "segments", "none")


class Originals(Case):
    def remove(self, output, *ids):
        return self.apply(output, *ids, task="remove")

    def test_remove_gives_the_document_back(self):
        filled = '<rect id="f" x="130" y="20" width="40" height="50" style="fill:#ffe0a0;stroke:#803010"/>'
        body = "<defs/><g>" + "".join(SHAPES[name].replace('"s"', f'"{name}"') for name in SHAPES) + filled + "</g>"
        expected = describe(etree.fromstring(document(body)))
        for kind in KINDS:
            with self.subTest(kind):
                root = self.apply(document(body), width_kind=kind)
                self.assertNotEqual(describe(root), expected)
                self.assertEqual(describe(self.remove(self.output)), expected)

    def test_again_starts_from_the_original(self):
        for kind in KINDS:
            with self.subTest(kind):
                self.apply(document(SHAPES["path"]), width_kind="outline", p_hand="bruno")
                twice = describe(self.apply(self.output, "s", width_kind=kind))
                once = describe(self.apply(document(SHAPES["path"]), "s", width_kind=kind))
                self.assertEqual([row for row in twice if "defs" not in row[0]],
                                 [row for row in once if "defs" not in row[0]])

    def test_a_filled_shape_that_was_made_a_group_is_changed_again_by_any_of_its_parts(self):
        filled = '<rect id="s" x="130" y="20" width="40" height="50" style="fill:#ffe0a0;stroke:#803010"/>'
        root = self.apply(document(filled))
        self.assertEqual(find(root, "s").tag, SVG + "g")
        find(root, "s")[1].set("id", "inside")
        again = self.apply(etree.tostring(root), "inside", width_kind="none")
        self.assertEqual(find(again, "s").tag, SVG + "path")
        self.assertEqual(len(find(again, "s")), 0)

    def test_settings_are_kept_on_the_element(self):
        import json
        element = find(self.apply(document(SHAPES["path"]), p_variation="0.25"), "s")
        kept = json.loads(element.get(OURS + "settings"))
        self.assertEqual(kept["settings"]["variation"], "0.25")
        before, after = element.get(OURS + "nodes").split()
        self.assertEqual(int(before), 2)
        self.assertGreater(int(after), 2)

    def test_what_was_moved_comes_back_moved(self):
        """Inkscape folds a move into the points of a path."""
        root = self.apply(document(SHAPES["rect"]), width_kind="none")
        element = find(root, "s")
        path = ductus.Path(element.get("d"))
        path.map((2, 0, 0, 2, 30, -5))
        element.set("d", path.svg(4))
        back = find(self.remove(etree.tostring(root)), "s")
        self.assertEqual((back.tag, back.get("x"), back.get("width")), (SVG + "rect", "20", "90"))
        values = [float(v) for v in back.get("transform").replace(" ", ",").strip("matrix(),").split(",") if v]
        for got, expected in zip(values, (2, 0, 0, 2, 30, -5)):
            self.assertAlmostEqual(got, expected, delta=0.02)

    def test_a_transform_set_since_then_stays(self):
        root = self.apply(document(SHAPES["path"]))
        find(root, "s").set("transform", "translate(7,8)")
        back = find(self.remove(etree.tostring(root)), "s")
        self.assertEqual(back.get("d"), LINE)
        self.assertEqual(back.get("transform").replace(" ", ""), "translate(7,8)")

    def test_bake_forgets_the_original(self):
        self.apply(document(SHAPES["path"] + SHAPES["rect"].replace('"s"', '"r"')), width_kind="powerstroke")
        result = find(self.apply(self.output, "s", task="bake"), "s")
        self.assertFalse([name for name in result.attrib if name.startswith(OURS)])
        self.assertIn("nothing here", self.refused(self.output, "s", task="remove"))
        self.assertEqual(find(self.remove(self.output), "r").tag, SVG + "rect")

    def test_remove_takes_its_path_effects_along_and_no_others(self):
        effect = '<defs id="defs"><inkscape:path-effect effect="spiro" id="mine"/></defs>'
        root = self.apply(document(effect + SHAPES["path"]), width_kind="powerstroke")
        self.assertEqual(len(find(root, "defs")), 2)
        self.assertEqual([child.get("id") for child in find(self.remove(self.output), "defs")], ["mine"])

    def test_copies_keep_their_path_effect_until_the_last_is_removed(self):
        root = self.apply(document("<defs/>" + SHAPES["path"]), width_kind="powerstroke")
        copied = copy.deepcopy(find(root, "s"))
        copied.set("id", "copy")
        root.append(copied)
        root = self.remove(etree.tostring(root), "s")
        effect = find(root, "copy").get(INKSCAPE + "path-effect")[1:]
        self.assertIsNotNone(find(root, effect))
        self.assertEqual(find(root, "s").get("d"), LINE)
        self.assertIsNone(find(self.remove(self.output, "copy"), effect))

    def test_a_copied_group_is_changed_and_not_the_one_it_is_a_copy_of(self):
        filled = '<rect id="s" x="130" y="20" width="40" height="50" style="fill:#ffe0a0;stroke:#803010"/>'
        root = self.apply(document(filled))
        copied = copy.deepcopy(find(root, "s"))
        copied.set("id", "copy")
        copied[1].set("id", "inside")
        root.append(copied)
        root = self.remove(etree.tostring(root), "inside")
        self.assertEqual((find(root, "s").tag, find(root, "copy").tag), (SVG + "g", SVG + "rect"))

    def test_baked_path_effects_outlive_a_later_removal(self):
        self.apply(document(SHAPES["path"]), width_kind="powerstroke")
        baked = self.apply(self.output, task="bake")
        effect = find(baked, "s").get(INKSCAPE + "path-effect")
        self.apply(self.output)
        back = self.remove(self.output)
        self.assertEqual(find(back, "s").get(INKSCAPE + "path-effect"), effect)
        self.assertIsNotNone(find(back, effect[1:]))

    def test_what_somebody_put_into_a_results_group_stays_seen(self):
        filled = '<rect id="s" x="130" y="20" width="40" height="50" style="fill:#ffe0a0;stroke:#803010"/>'
        root = self.apply(document(filled))
        find(root, "s").set("transform", "translate(3,4)")
        etree.SubElement(find(root, "s"), SVG + "circle", id="guest", r="5")
        root = self.remove(etree.tostring(root))
        self.assertEqual((find(root, "s").tag, len(find(root, "s"))), (SVG + "rect", 0))
        self.assertIs(find(root, "s").getnext(), find(root, "guest"))
        self.assertIn("translate(3,4)", find(root, "guest").get("transform").replace(" ", ""))

    def test_nothing_to_remove_is_told(self):
        self.assertIn("nothing here was made by Ductus", self.refused(document(SHAPES["path"]), task="remove"))

    def test_a_record_that_somebody_broke_does_no_harm(self):
        for broken in ("", "{", "[1]", '{"tag": 5, "attributes": {}}', '{"tag": "x"}'):
            root = self.apply(document(SHAPES["path"]))
            find(root, "s").set(OURS + "original", broken)
            done = self.run_extension(etree.tostring(root), task="remove")
            self.assertNotIn(b"Traceback", done.stderr)


if __name__ == "__main__":
    unittest.main()
