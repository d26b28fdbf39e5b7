# SPDX-License-Identifier: GPL-3.0-or-later
"""The plug-in as a user has it: in GIMP's window, from the menu, with its dialog, one step of undo."""

import os
import time
import unittest

import session
import window

TITLE = "Restyle with a hand"
DRAWING = os.path.join(session.SOURCE, "data", "drawings", "branch.svg")


class Dialog(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.gimp = window.Window()

    @classmethod
    def tearDownClass(cls):
        cls.gimp.close()

    def setUp(self):
        self.gimp.run("(define image (make-image 760 560 RGB PRECISION-U8-GAMMA RGB-IMAGE))"
                      '(gimp-vectors-import-from-file image "%s" TRUE FALSE)'
                      "(gimp-image-set-active-vectors image (aref (cadr (gimp-image-get-vectors image)) 0))"
                      "(gimp-image-clean-all image)(define view (car (gimp-display-new image)))" % DRAWING)
        time.sleep(2)

    def tearDown(self):
        self.gimp.run("(gimp-image-clean-all image)(gimp-display-delete view)")

    def wait_for(self, expression, value, seconds=40):
        for _ in range(seconds * 5):
            if self.gimp.value(expression) == value:
                return
            time.sleep(0.2)
        self.assertEqual(self.gimp.value(expression), value)

    def open_dialog(self):
        self.gimp.command("plug-in-ductus-restyle")
        return self.gimp.screen.wait(TITLE)

    def test_menu_dialog_result_and_one_step_of_undo(self):
        dialog = self.open_dialog()
        time.sleep(3)  # the preview; OK stops it in any case
        self.gimp.screen.keys(dialog, "Return")
        self.wait_for("(layers image)", "2")
        self.gimp.screen.wait(TITLE, there=False)
        self.assertGreater(self.gimp.number("(painted (active image))"), 3000)
        # What was used last is kept, by GIMP and in the user's folder.
        self.assertTrue(os.path.exists(os.path.join(self.gimp.profile, "plug-in-settings",
                                                    "plug-in-ductus-restyle.values")))
        self.gimp.screen.keys(self.gimp.image_window(), "ctrl+z")
        self.wait_for("(layers image)", "1")
        self.assertEqual(self.gimp.value("(car (gimp-image-is-dirty image))"), "0", "one step of undo is not enough")
        self.gimp.run("(plug-in-ductus-restyle-text RUN-WITH-LAST-VALS image (active image) \"\")")
        self.assertEqual(self.gimp.value("(layers image)"), "2")

    def test_cancel_leaves_nothing(self):
        dialog = self.open_dialog()
        time.sleep(1)
        self.gimp.screen.keys(dialog, "Escape")
        self.gimp.screen.wait(TITLE, there=False)
        self.assertEqual(self.gimp.value("(layers image)"), "1")
        self.assertEqual(self.gimp.value("(car (gimp-image-is-dirty image))"), "0")

    def test_cancel_while_the_work_goes_on_leaves_nothing_and_keeps_the_dialog(self):
        # Much work: the drawing many times over.
        self.gimp.run('(define (more n) (if (> n 0) (begin (gimp-vectors-import-from-file image "%s" FALSE FALSE)'
                      " (more (- n 1)))))(more 12)"
                      "(define (all-visible list n) (if (> n 0) (begin (gimp-item-set-visible (aref list (- n 1)) TRUE)"
                      " (all-visible list (- n 1)))))"
                      "(let ((v (gimp-image-get-vectors image))) (all-visible (cadr v) (car v)))"
                      "(gimp-image-clean-all image)" % DRAWING)
        # GIMP remembers no values before a first run; the tests run in the order of their names.
        folder = os.path.join(self.gimp.profile, "plug-in-settings")
        os.makedirs(folder, exist_ok=True)
        with open(os.path.join(folder, "plug-in-ductus-restyle.values"), "w") as file:
            file.write("lines=visible-paths\nbrush=bristle\nsize=40\nhand=eve\nneighbours=100\n")
        dialog = self.open_dialog()
        os.remove(file.name)
        self.gimp.screen.keys(dialog, "Return")
        time.sleep(1.5)
        self.gimp.screen.keys(dialog, "Escape")
        time.sleep(2)
        self.assertTrue(self.gimp.screen.find(TITLE), "the dialog is gone")
        self.assertEqual(self.gimp.value("(layers image)"), "1")
        # The first Escape may still be at work when the second comes.
        for _ in range(20):
            if not self.gimp.screen.find(TITLE):
                break
            self.gimp.screen.keys(dialog, "Escape")
            time.sleep(1)
        self.assertEqual(self.gimp.screen.find(TITLE), "")
        self.assertEqual(self.gimp.value("(layers image)"), "1")
        self.assertEqual(self.gimp.value("(car (gimp-image-is-dirty image))"), "0")
        self.assertNotIn("inconsistent state", self.gimp.output())


if __name__ == "__main__":
    session.require(*window.PROGRAMS)
    unittest.main()
