# SPDX-License-Identifier: GPL-3.0-or-later
"""Every procedure and every kind of result, and what is refused."""

import os
import signal
import threading
import time
import unittest

import gimp_case
import session
from gimp_case import GimpCase

SUFFIXES = ("", "-path", "-line-art", "-text")


def procedure(operation, suffix=""):
    return "plug-in-ductus-%s%s" % (operation["id"], suffix)


class EveryOperation(GimpCase):
    """No operation is named here: all that there are."""

    def arguments(self, name):
        """The types and descriptions of a procedure's arguments behind the first three."""
        text = self.gimp.run(
            '(let ((name "%s")) (let next ((i 3) (all ""))'
            " (if (< i (list-ref (gimp-procedural-db-proc-info name) 6))"
            "  (let ((a (gimp-procedural-db-proc-arg name i)))"
            '   (next (+ i 1) (string-append all (number->string (car a)) "|" (cadr a) " ")))'
            "  all)))" % name)
        return [(int(word.split("|")[0]), word.split("|")[1]) for word in text.split()]

    def test_is_registered_with_its_parameters(self):
        for operation in gimp_case.operations():
            for suffix in SUFFIXES:
                name = procedure(operation, suffix)
                names = [argument for _, argument in self.arguments(name)]
                if suffix == "-text":
                    self.assertEqual(names, ["settings"])
                    continue
                own = [parameter["id"] for parameter in operation["parameters"]]
                self.assertEqual([argument.removeprefix(operation["id"] + "-") for argument in names[-len(own):]],
                                 own, name)
                self.assertEqual(len(set(names)), len(names), "two arguments have the same name")
                self.assertEqual("lines" in names, suffix == "")
                self.assertIn("brush", names)

    def test_runs_with_all_arguments_one_by_one(self):
        for operation in gimp_case.operations():
            for suffix in SUFFIXES[:3]:
                name = procedure(operation, suffix)
                self.image()
                self.curve()
                if suffix == "-line-art":
                    self.gimp.run('(restyle image (active image) "hand=anna; size=9")')
                defaults = {parameter["id"]: parameter["default"] for parameter in operation["parameters"]}
                defaults.update({parameter["id"]: "eve" for parameter in operation["parameters"]
                                 if parameter["type"] == "hand"})
                own = {"lines": "path", "result": "both", "brush": "ink", "size": "auto", "opacity": "100",
                       "layer-mode": "normal", "colour": "foreground", "clip": "true", "tolerance": "0.5",
                       "hide": "true", "ink": "auto", "threshold": "auto", "widest-line": "100", "shortest-line": "4"}
                words = []
                for kind, argument in self.arguments(name):
                    value = own[argument] if argument in own else defaults[argument.removeprefix(operation["id"] + "-")]
                    words.append('"%s"' % value if kind == 4 else {"true": "1", "false": "0"}.get(value, value))
                target = "path" if suffix == "-path" else "(active image)"
                self.gimp.run("(define answer (%s RUN-NONINTERACTIVE image %s %s))" % (name, target, " ".join(words)))
                self.assertGreater(self.painted(int(self.gimp.number("(car answer)"))), 500, name)
                self.assertGreaterEqual(self.gimp.number("(cadr answer)"), 1)


class Results(GimpCase):
    def setUp(self):
        self.image()
        self.curve()

    def test_a_new_layer_is_above_the_active_one(self):
        layer = self.restyle("hand=eve; size=20; opacity=40; layer-mode=multiply")
        self.assertEqual(self.gimp.number("(layers image)"), 2)
        self.assertEqual(self.gimp.number("(car (gimp-image-get-item-position image %d))" % layer), 0)
        self.assertEqual(self.gimp.number("(car (gimp-layer-get-opacity %d))" % layer), 40)
        self.assertEqual(self.gimp.number("(car (gimp-layer-get-mode %d))" % layer),
                         self.gimp.number("LAYER-MODE-MULTIPLY"))
        self.assertGreater(self.painted(layer), 2000)
        self.assertEqual(self.gimp.number("(cadr answer)"), 0)
        self.no_open_group()

    def test_a_layer_in_a_group_gets_its_new_layer_into_the_group(self):
        self.gimp.run("(define group (car (gimp-layer-group-new image)))"
                      "(gimp-image-insert-layer image group 0 0)"
                      "(define inner (car (gimp-layer-new image 300 200 RGBA-IMAGE \"inner\" 100 0)))"
                      "(gimp-image-insert-layer image inner group 0)")
        layer = self.restyle("hand=eve; size=20", "inner")
        self.assertEqual(self.gimp.value("(car (gimp-item-get-parent %d))" % layer), self.gimp.value("group"))

    def test_paths_have_few_nodes_and_nothing_is_painted(self):
        self.assertEqual(self.restyle("hand=eve; result=paths"), -1)
        self.assertEqual(self.gimp.number("(layers image)"), 1)
        self.assertEqual(self.gimp.number("(paths image)"), 2)
        self.gimp.run("(define made (aref (list-ref answer 2) 0))")
        self.assertIn("curve", self.gimp.value("(car (gimp-item-get-name made))"))
        self.gimp.run("(define stroke (aref (cadr (gimp-vectors-get-strokes made)) 0))")
        numbers = self.gimp.number("(cadr (gimp-vectors-stroke-get-points made stroke))")
        self.assertGreaterEqual(numbers, 12)
        self.assertLess(numbers, 6 * 30)
        length = self.gimp.number("(car (gimp-vectors-stroke-get-length made stroke 0.5))")
        self.assertGreater(length, 220)
        self.assertLess(length, 400)

    def test_amount_nothing_gives_back_the_path(self):
        self.restyle("hand=eve; amount=0; result=paths; tolerance=0.05")
        self.gimp.run("(define made (aref (list-ref answer 2) 0))")
        lengths = [self.gimp.number("(let ((s (aref (cadr (gimp-vectors-get-strokes %s)) 0)))"
                                    "(car (gimp-vectors-stroke-get-length %s s 0.1)))" % (name, name))
                   for name in ("made", "path")]
        self.assertAlmostEqual(lengths[0], lengths[1], delta=0.5)

    def test_both_are_made_at_once(self):
        layer = self.restyle("hand=eve; size=20; result=both")
        self.assertGreater(self.painted(layer), 2000)
        self.assertEqual(self.gimp.number("(paths image)"), 2)

    def test_the_active_layer_is_painted_on(self):
        self.assertEqual(self.restyle("hand=eve; size=20; result=active-layer"), -1)
        self.assertEqual(self.gimp.number("(layers image)"), 1)
        self.assertGreater(self.painted(int(self.gimp.number("(active image)"))), 2000)

    def test_all_visible_paths_are_drawn_and_hidden_ones_are_not(self):
        self.gimp.run("(gimp-item-set-visible path TRUE)")
        self.curve("other", 30, 40, 270, 40)
        self.gimp.run("(gimp-item-set-visible path TRUE)")
        self.curve("hidden", 30, 170, 270, 170)
        self.gimp.run("(gimp-item-set-visible path FALSE)")
        self.restyle("hand=anna; lines=visible-paths; result=paths")
        self.assertEqual(self.gimp.number("(cadr answer)"), 2)

    def test_the_same_call_gives_the_same_bytes(self):
        written = []
        for _ in range(2):
            self.image()
            self.curve()
            self.restyle("hand=david; brush=charcoal; size=16; variation=0.7; seed=5")
            name = os.path.join(self.gimp.folder, "layer.ppm")
            self.gimp.run('(file-ppm-save RUN-NONINTERACTIVE image (car (gimp-image-flatten image)) "%s" "%s" 1)'
                          % (name, name))
            with open(name, "rb") as file:
                written.append(file.read())
        self.assertEqual(written[0], written[1])

    def test_all_brushes_paint(self):
        names = sorted(name[:-4] for name in os.listdir(os.path.join(session.BUILD, "share", "ductus", "brushes"))
                       if name.endswith(".myb"))
        self.assertGreater(len(names), 3)
        file = os.path.join(session.BUILD, "share", "ductus", "brushes", names[0] + ".myb")
        for name in [*names, file, "classic/pencil"]:
            if name == "classic/pencil" and not os.path.exists("/usr/share/mypaint-data"):
                continue
            self.assertGreater(self.painted(self.restyle("hand=eve; size=20; brush=" + name)), 300, name)


class Refusals(GimpCase):
    def setUp(self):
        self.image()

    def test_no_path(self):
        self.refused("hand=eve", "no active path")
        self.refused("hand=eve; lines=visible-paths", "no visible path")

    def test_a_path_without_a_line(self):
        self.gimp.run('(gimp-image-insert-vectors image (car (gimp-vectors-new image "bare")) 0 0)')
        self.refused("hand=eve", "'bare' has no line")

    def test_a_path_outside_of_the_canvas(self):
        self.curve("away", 1000, 1000, 1200, 1000)
        self.refused("hand=eve; size=10", "outside the image")
        self.assertEqual(self.restyle("hand=eve; result=paths"), -1)
        self.assertEqual(self.gimp.number("(paths image)"), 2)

    def test_a_path_far_beyond_any_canvas(self):
        self.curve("away", -1e7, 50, 1e7, 50)
        self.restyle("hand=eve; size=10; mode=pose")
        self.curve("too far", -1e12, 50, 1e12, 50)
        self.refused("hand=eve; size=10", "'too far'")

    def test_nothing_selected(self):
        self.refused("hand=eve; lines=selection", "nothing is selected")

    def test_a_locked_layer(self):
        self.curve()
        self.gimp.run("(gimp-item-set-lock-content (active image) TRUE)")
        self.refused("hand=eve; result=active-layer", "locked")
        self.assertGreater(self.painted(self.restyle("hand=eve; size=20")), 2000)

    def test_a_group(self):
        self.curve()
        self.gimp.run("(define group (car (gimp-layer-group-new image)))(gimp-image-insert-layer image group 0 0)")
        self.refused("hand=eve; result=active-layer", "group of layers", "group")

    def test_a_palette(self):
        self.image(kind="RGB")
        self.curve()
        self.gimp.run("(gimp-image-convert-indexed image CONVERT-DITHER-NONE CONVERT-PALETTE-GENERATE 8 FALSE FALSE"
                      " \"\")")
        self.refused("hand=eve", "palette")
        self.restyle("hand=eve; result=paths")
        self.assertEqual(self.gimp.number("(paths image)"), 2)

    def test_settings_that_there_are_not(self):
        self.curve()
        self.refused("hand=eve; brush=broom", "no brush \\\"broom\\\"".replace("\\", ""))
        self.refused("hand=nobody", "no hand")
        self.refused("", "none was chosen")
        self.refused("hand=eve; speed=3", "no setting 'speed'")
        self.refused("hand=eve; opacity=300", "0 to 100")
        self.refused("hand=eve; lines=edges", "one of")
        self.refused("hand", "name=value")

    def test_a_layer_of_another_image(self):
        self.curve()
        self.gimp.run("(define other (make-image 50 50 RGB PRECISION-U8-GAMMA RGB-IMAGE))")
        self.refused("hand=eve", "another image", "(active other)")

    def test_too_few_arguments(self):
        self.curve()
        with self.assertRaises(session.Failed):
            self.gimp.run("(plug-in-ductus-restyle RUN-NONINTERACTIVE image (active image))")
        self.assertEqual(self.gimp.number("(layers image)"), 1)

    def test_an_ended_process_leaves_the_image_as_it_was(self):
        """What GIMP does when the user cancels at its progress bar."""
        for index in range(150):
            self.curve("c%d" % index, 30, index, 270, index + 20)
        self.gimp.run("(define (all-visible list n) (if (> n 0) (begin (gimp-item-set-visible (aref list (- n 1)) TRUE)"
                      " (all-visible list (- n 1)))))"
                      "(let ((v (gimp-image-get-vectors image))) (all-visible (cadr v) (car v)))"
                      "(gimp-image-clean-all image)")
        killer = threading.Thread(target=self.end_plugin)
        killer.start()
        with self.assertRaises(session.Failed):
            self.restyle("hand=eve; lines=visible-paths; brush=bristle; size=150; neighbours=100")
        killer.join()
        self.assertTrue(self.ended, "the plug-in had ended before it could be stopped")
        self.assertEqual(self.gimp.number("(layers image)"), 1)
        self.assertEqual(self.gimp.number("(paths image)"), 150)
        self.assertEqual(self.gimp.value("(car (gimp-image-is-dirty image))"), "0")
        self.no_open_group()

    def end_plugin(self):
        self.ended = False
        for _ in range(100):
            time.sleep(0.05)
            for name in filter(str.isdigit, os.listdir("/proc")):
                try:
                    with open("/proc/%s/stat" % name) as file:
                        words = file.read().split()
                    # A process of this GIMP's own group, running long enough to have begun its work.
                    if words[1] == "(ductus-gimp)" and int(words[4]) == self.gimp.process.pid and int(words[13]) > 20:
                        os.kill(int(name), signal.SIGTERM)
                        self.ended = True
                        return
                except (OSError, IndexError, ValueError):
                    continue


if __name__ == "__main__":
    session.require("gimp")
    unittest.main()
