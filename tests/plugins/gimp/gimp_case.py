# SPDX-License-Identifier: GPL-3.0-or-later
"""The common ground of tests in GIMP without a window: one GIMP for all of a file's tests, an image for each."""

import atexit
import json
import os
import subprocess
import unittest

import session


class GimpCase(unittest.TestCase):
    gimp = None

    @classmethod
    def setUpClass(cls):
        if GimpCase.gimp is None:
            GimpCase.gimp = session.Gimp()
            atexit.register(GimpCase.gimp.close)

    def image(self, width=300, height=200, kind="RGB", precision="PRECISION-U8-GAMMA", layer="RGBA-IMAGE"):
        self.gimp.run("(define image (make-image %d %d %s %s %s))" % (width, height, kind, precision, layer))

    def curve(self, name="curve", x0=30, y0=100, x1=270, y1=100):
        self.gimp.run('(define path (add-curve image "%s" %g %g %g %g))' % (name, x0, y0, x1, y1))

    def restyle(self, settings, drawable="(active image)"):
        """Runs an operation; the new layer's number."""
        self.gimp.run('(define answer (restyle image %s "%s"))' % (drawable, settings))
        return int(self.gimp.number("(car answer)"))

    def refused(self, settings, words, drawable="(active image)"):
        """Runs one that must fail with a sentence that has these words, and leave the image as it was."""
        layers, paths = self.gimp.value("(layers image)"), self.gimp.value("(paths image)")
        self.gimp.run("(gimp-image-clean-all image)")
        with self.assertRaises(session.Failed) as caught:
            self.restyle(settings, drawable)
        self.assertIn(words, str(caught.exception))
        self.assertIn("Ductus: ", str(caught.exception))
        self.assertEqual((layers, paths), (self.gimp.value("(layers image)"), self.gimp.value("(paths image)")))
        self.assertEqual(self.gimp.value("(car (gimp-image-is-dirty image))"), "0", "the image was changed")
        self.no_open_group()

    def no_open_group(self):
        """GIMP closes undo groups that a plug-in leaves open, and says so."""
        self.assertNotIn("inconsistent state", self.gimp.output())

    def painted(self, layer):
        return self.gimp.number("(painted %d)" % layer)

    def colour(self, x, y):
        return self.gimp.numbers("(colour-at image %d %d)" % (x, y))


def operations():
    """The tables, as programs read them."""
    program = os.environ.get("DUCTUS_PROGRAM", os.path.join(session.BUILD, "bin", "ductus"))
    text = subprocess.run([program, "ops", "--json"], check=True, capture_output=True, text=True).stdout
    return json.loads(text)["operations"]
