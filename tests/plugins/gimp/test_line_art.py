# SPDX-License-Identifier: GPL-3.0-or-later
"""Repainting what is drawn on a layer."""

import glob
import os
import unittest

import session
from gimp_case import GimpCase

DATA = os.environ.get("DUCTUS_DATA", os.path.join(session.SOURCE, "..", "shared", "data"))


class LineArt(GimpCase):
    def draw(self, layer="RGB-IMAGE", colour="0 0 0", paper="255 255 255"):
        """A cross and a ring of lines eight pixels wide."""
        self.image(layer=layer)
        self.gimp.run(
            "(gimp-context-set-background '(%s))" % paper +
            ("(gimp-drawable-fill (active image) FILL-BACKGROUND)" if layer == "RGB-IMAGE" else "") +
            "(gimp-context-set-foreground '(%s))" % colour +
            "(define (fill) (gimp-drawable-edit-fill (active image) FILL-FOREGROUND))"
            "(gimp-image-select-rectangle image CHANNEL-OP-REPLACE 20 96 120 8)(fill)"
            "(gimp-image-select-rectangle image CHANNEL-OP-REPLACE 76 40 8 120)(fill)"
            "(gimp-image-select-ellipse image CHANNEL-OP-REPLACE 170 50 100 100)"
            "(gimp-image-select-ellipse image CHANNEL-OP-SUBTRACT 178 58 84 84)(fill)"
            "(gimp-selection-none image)(gimp-context-set-foreground '(180 20 20))"
            "(gimp-context-set-background '(255 255 255))(gimp-image-clean-all image)")

    def check(self):
        layer = self.restyle("hand=anna; mode=pose; lines=line-art; result=both")
        self.gimp.run("(define made (aref (list-ref answer 2) 0))")
        self.assertEqual(self.gimp.number("(car (gimp-vectors-get-strokes made))"), 3, "two lines and a ring")
        self.gimp.run("(define (closed n) (list-ref (gimp-vectors-stroke-get-points made"
                      " (aref (cadr (gimp-vectors-get-strokes made)) n)) 3))")
        # The parts from left to right: the cross, then the ring.
        self.assertEqual(self.gimp.value("(map closed '(0 1 2))"), "(0 0 1)")
        painted = self.painted(layer)
        self.assertGreater(painted, 2500)
        self.assertLess(painted, 7500)
        self.assertEqual(self.gimp.number("(car (gimp-item-get-visible (aref (cadr (gimp-image-get-layers image)) 1)))"), 0)
        return layer

    def test_dark_lines_on_paper(self):
        self.draw()
        self.check()

    def test_light_lines_on_a_dark_ground(self):
        self.draw(colour="250 250 250", paper="20 30 60")
        self.check()

    def test_white_lines_on_a_transparent_layer(self):
        self.draw("RGBA-IMAGE", colour="255 255 255")
        self.check()

    def test_lines_keep_their_own_colours_where_asked(self):
        self.draw(colour="20 60 160")
        self.restyle("hand=anna; mode=pose; lines=line-art; colour=line-art; hide=false")
        for value, wanted in zip(self.colour(110, 100), (20, 60, 160)):
            self.assertAlmostEqual(value, wanted, delta=6)
        self.assertEqual(self.gimp.number("(car (gimp-item-get-visible (aref (cadr (gimp-image-get-layers image)) 1)))"), 1)

    def test_only_what_is_selected_is_repainted(self):
        self.draw()
        self.gimp.run("(gimp-image-select-rectangle image CHANNEL-OP-REPLACE 0 0 150 200)")
        self.restyle("hand=anna; mode=pose; lines=line-art; result=paths")
        self.gimp.run("(define made (aref (list-ref answer 2) 0))")
        self.assertEqual(self.gimp.number("(car (gimp-vectors-get-strokes made))"), 2)

    def test_a_layer_elsewhere_in_the_image(self):
        self.draw()
        self.gimp.run("(gimp-layer-set-offsets (active image) 40 10)")
        self.restyle("hand=anna; mode=pose; lines=line-art")
        self.assertEqual(self.colour(80, 110)[1:], [20, 20])

    def test_a_blank_layer(self):
        self.image(layer="RGB-IMAGE")
        self.refused("hand=anna; lines=line-art", "no lines were found")
        self.image(layer="RGBA-IMAGE")
        self.refused("hand=anna; lines=line-art", "no lines were found")

    def test_scanned_writing(self):
        pages = sorted(glob.glob(os.path.join(DATA, "handwriting_copiste", "wiki*.jpg")))
        if not pages:
            self.skipTest("no scans in " + DATA)
        self.gimp.run('(define image (car (gimp-file-load RUN-NONINTERACTIVE "%s" "scan")))'
                      "(gimp-image-crop image 900 700 600 800)(gimp-image-clean-all image)" % pages[0])
        layer = self.restyle("hand=anna; mode=pose; lines=line-art; result=both")
        self.gimp.run("(define made (aref (list-ref answer 2) 0))")
        self.assertGreater(self.gimp.number("(car (gimp-vectors-get-strokes made))"), 60)
        self.assertGreater(self.painted(layer), 5000)


if __name__ == "__main__":
    session.require("gimp")
    unittest.main()
