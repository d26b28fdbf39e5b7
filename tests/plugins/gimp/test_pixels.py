# SPDX-License-Identifier: GPL-3.0-or-later
"""What is painted: in images of every precision and kind, and where selection, masks and locks let it."""

import glob
import unittest

import session
from gimp_case import GimpCase

PRECISIONS = ["PRECISION-%s-%s" % (size, encoding)
              for size in ("U8", "U16", "FLOAT") for encoding in ("LINEAR", "GAMMA")]


class Precisions(GimpCase):
    def test_the_foreground_colour_is_the_same_in_every_precision(self):
        coverage = {}
        for precision in PRECISIONS:
            self.image(200, 120, precision=precision, layer="RGB-IMAGE")
            self.curve("curve", 20, 60, 180, 60)
            layer = self.restyle("hand=anna; mode=pose; size=24")
            for value, wanted in zip(self.colour(100, 60), (180, 20, 20)):
                self.assertAlmostEqual(value, wanted, delta=2, msg=precision)
            coverage[precision] = self.painted(layer)
            self.assertEqual(self.gimp.value("(car (gimp-image-get-precision image))"), self.gimp.value(precision))
        self.assertLess(max(coverage.values()) - min(coverage.values()), 0.03 * max(coverage.values()), coverage)

    def test_grey_images_get_the_colours_luminance(self):
        for precision in ("PRECISION-U8-GAMMA", "PRECISION-FLOAT-LINEAR"):
            self.image(200, 120, "GRAY", precision, "GRAY-IMAGE")
            self.curve("curve", 20, 60, 180, 60)
            self.restyle("hand=anna; mode=pose; size=24")
            grey = self.colour(100, 60)
            # sRGB (180, 20, 20) has the luminance of grey 91.
            self.assertAlmostEqual(grey[0], 91, delta=12, msg=precision)
            self.assertEqual(grey[0], grey[1])

    def test_a_profile_of_the_image_is_minded(self):
        """The paint has the numbers that GIMP's own fill has, which in a wider space are not those of sRGB."""
        profile = next(iter(glob.glob("/usr/share/color/icc/**/rommrgb.icc", recursive=True)), None)
        if profile is None:
            self.skipTest("no colour profile here")
        self.image(200, 120, precision="PRECISION-U16-GAMMA", layer="RGB-IMAGE")
        self.gimp.run('(gimp-image-set-color-profile-from-file image "file://%s")' % profile)
        self.curve("curve", 20, 60, 180, 60)
        layer = self.restyle("hand=anna; mode=pose; size=24")
        for value, wanted in zip(self.colour(100, 60), (180, 20, 20)):
            self.assertAlmostEqual(value, wanted, delta=2)
        self.gimp.run("(gimp-image-select-rectangle image CHANNEL-OP-REPLACE 0 0 20 20)"
                      "(gimp-drawable-edit-fill %d FILL-FOREGROUND)(gimp-selection-none image)" % layer)
        painted, filled = [self.gimp.numbers("(cadr (gimp-drawable-get-pixel %d %d %d))" % (layer, x, y))
                           for x, y in ((100, 60), (10, 10))]
        # Sixteen bits, the lower ones first.
        self.assertEqual(painted[1::2], filled[1::2])
        self.assertNotEqual(painted[1], 180)


class Limits(GimpCase):
    def setUp(self):
        self.image()
        self.curve()

    def left_and_right(self, layer):
        """How much is painted in each half."""
        halves = []
        for x in (0, 150):
            self.gimp.run("(gimp-image-select-rectangle image CHANNEL-OP-REPLACE %d 0 150 200)" % x)
            halves.append(self.painted(layer))
        self.gimp.run("(gimp-selection-none image)")
        return halves

    def test_the_selection_clips(self):
        self.gimp.run("(gimp-image-select-rectangle image CHANNEL-OP-REPLACE 0 0 150 200)")
        left, right = self.left_and_right(self.restyle("hand=eve; size=20"))
        self.assertGreater(left, 1000)
        self.assertEqual(right, 0)

    def test_the_selection_clips_on_the_active_layer(self):
        self.gimp.run("(gimp-image-select-rectangle image CHANNEL-OP-REPLACE 0 0 150 200)")
        self.restyle("hand=eve; size=20; result=active-layer")
        left, right = self.left_and_right(int(self.gimp.number("(active image)")))
        self.assertGreater(left, 1000)
        self.assertEqual(right, 0)

    def test_clipping_can_be_switched_off(self):
        self.gimp.run("(gimp-image-select-rectangle image CHANNEL-OP-REPLACE 0 0 150 200)")
        left, right = self.left_and_right(self.restyle("hand=eve; size=20; clip=false"))
        self.assertGreater(min(left, right), 1000)

    def test_nothing_inside_of_the_selection(self):
        self.gimp.run("(gimp-image-select-rectangle image CHANNEL-OP-REPLACE 0 180 20 20)")
        self.refused("hand=eve; size=10", "outside the selection")

    def test_the_outline_of_the_selection_is_drawn_on_both_sides(self):
        self.gimp.run("(gimp-image-select-ellipse image CHANNEL-OP-REPLACE 100 50 100 100)")
        selected = self.gimp.value("(gimp-selection-bounds image)")
        self.gimp.run("(define others (paths image))")
        layer = self.restyle("hand=anna; mode=pose; lines=selection; size=12")
        inside = self.painted(layer)
        self.assertEqual(self.gimp.value("(gimp-selection-bounds image)"), selected)
        self.gimp.run("(gimp-selection-none image)")
        self.assertGreater(self.painted(layer), 1.4 * inside)
        self.assertGreater(inside, 300)
        self.assertEqual(self.gimp.value("(paths image)"), self.gimp.value("others"))

    def half_layer(self):
        """The active layer opaque in its left half only."""
        self.gimp.run("(gimp-image-select-rectangle image CHANNEL-OP-REPLACE 0 0 150 200)"
                      "(gimp-drawable-edit-fill (active image) FILL-BACKGROUND)(gimp-selection-none image)")

    def test_locked_alpha_keeps_new_layers_inside(self):
        self.half_layer()
        self.gimp.run("(gimp-layer-set-lock-alpha (active image) TRUE)")
        left, right = self.left_and_right(self.restyle("hand=eve; size=20"))
        self.assertGreater(left, 1000)
        self.assertEqual(right, 0)

    def test_locked_alpha_of_the_active_layer_stays_as_it_is(self):
        self.half_layer()
        self.gimp.run("(gimp-layer-set-lock-alpha (active image) TRUE)")
        layer = int(self.gimp.number("(active image)"))
        before = self.left_and_right(layer)
        self.restyle("hand=eve; size=20; result=active-layer")
        self.assertEqual(self.left_and_right(layer), before)
        reds = [self.colour(x, y) for x in range(30, 140, 10) for y in range(70, 130, 5)]
        self.assertTrue(any(red[1] < 60 for red in reds), "nothing was painted")

    def test_a_layer_mask_keeps_new_layers_inside(self):
        self.gimp.run("(gimp-image-select-rectangle image CHANNEL-OP-REPLACE 0 0 150 200)"
                      "(define mask (car (gimp-layer-create-mask (active image) ADD-MASK-SELECTION)))"
                      "(gimp-layer-add-mask (active image) mask)(gimp-selection-none image)")
        left, right = self.left_and_right(self.restyle("hand=eve; size=20", "(car (gimp-image-get-active-layer image))"))
        self.assertGreater(left, 1000)
        self.assertEqual(right, 0)

    def test_a_mask_can_be_painted_on(self):
        self.gimp.run("(define mask (car (gimp-layer-create-mask (active image) ADD-MASK-WHITE)))"
                      "(gimp-layer-add-mask (active image) mask)(gimp-context-set-foreground '(0 0 0))")
        before = self.gimp.number("(car (gimp-drawable-histogram mask HISTOGRAM-VALUE 0 1))")
        self.restyle("hand=eve; size=20; result=active-layer", "mask")
        after = self.gimp.number("(car (gimp-drawable-histogram mask HISTOGRAM-VALUE 0 1))")
        self.assertLess(after, before - 5)

    def test_opacity_and_mode_hold_on_the_active_layer(self):
        self.gimp.run("(gimp-drawable-edit-fill (active image) FILL-BACKGROUND)")
        self.restyle("hand=anna; mode=pose; size=40; opacity=50; result=active-layer")
        middle = self.colour(150, 100)
        # Half of red (180, 20, 20) over white, in linear light as GIMP's normal mode blends: 188 for green.
        self.assertAlmostEqual(middle[1], 188, delta=4)

    def test_an_image_of_ten_thousand_pixels_a_side(self):
        self.image(10000, 10000)
        self.curve("long", 200, 5000, 9800, 5200)
        layer = self.restyle("hand=eve; size=60")
        self.gimp.run("(gimp-image-select-rectangle image CHANNEL-OP-REPLACE 4000 4000 1500 2000)")
        self.assertGreater(self.painted(layer), 20000)


if __name__ == "__main__":
    session.require("gimp")
    unittest.main()
