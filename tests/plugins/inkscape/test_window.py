# SPDX-License-Identifier: GPL-3.0-or-later
"""The extensions as a user has them: in a window of the real Inkscape, on a display of its own, by keys and mouse."""

import hashlib
import os
import shutil
import subprocess
import time
import unittest

from lxml import etree

from extension import BUILD, EXTENSION, LINE, OURS, SVG, Case, document, find
from test_elements import STROKE

TITLE = "Restyle with a hand"
KEYS = ('<keys name="test"><bind gaction="app.org.ductus.remove" keys="&lt;Primary&gt;F8"/></keys>')
PATIENCE = 90   # seconds, for a busy machine


class Window(Case):
    def setUp(self):
        super().setUp()
        self.environment = {**os.environ, "INKSCAPE_PROFILE_DIR": str(self.folder / "profile"),
                            "XDG_DATA_HOME": str(self.folder / "home"),
                            "DUCTUS_PYTHON": str(BUILD / "share" / "ductus" / "python")}
        self.environment.pop("PYTHONPATH", None)
        shutil.copytree(EXTENSION, self.folder / "profile" / "extensions" / "ductus")
        (self.folder / "profile" / "keys").mkdir()
        (self.folder / "profile" / "keys" / "default.xml").write_text(KEYS)
        self.drawing = self.folder / "drawing.svg"
        self.drawing.write_text(document(f'<path id="a" d="{LINE}" {STROKE}/><rect id="b" x="20" y="20" width="60" '
                                         f'height="40" {STROKE}/>'))
        read, write = os.pipe()
        self.start(["Xvfb", "-displayfd", str(write), "-screen", "0", "1400x900x24", "-nolisten", "tcp"],
                   pass_fds=(write,))
        os.close(write)
        with os.fdopen(read) as numbers:
            self.environment["DISPLAY"] = ":" + numbers.readline().strip()
        self.start(["inkscape", "--with-gui", self.drawing, "--actions=org.ductus.restyle"])
        self.main = self.window("drawing.svg")
        self.xdo("windowmove", self.main, 0, 0)
        self.settle()

    def start(self, words, **more):
        run = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                               env=self.environment, **more)
        self.addCleanup(run.wait)
        self.addCleanup(run.kill)

    def xdo(self, *words):
        return subprocess.run(["xdotool", *map(str, words)], capture_output=True, text=True, env=self.environment,
                              check=False).stdout

    def until(self, what, message):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            found = what()
            if found:
                return found
            time.sleep(0.3)
        self.fail(message)

    def window(self, title):
        found = self.until(lambda: self.xdo("search", "--name", f"^{title}"), f"Inkscape opened no window '{title}'")
        return found.split()[-1]

    def screen(self):
        """A digest of the canvas, where it is clear of the dialog."""
        pixels = subprocess.run(["import", "-window", "root", "-crop", "780x220+80+150", "-depth", "8", "rgb:-"],
                                capture_output=True, env=self.environment, check=True).stdout
        return hashlib.sha256(pixels).hexdigest()

    def settle(self):
        seen = []
        def rests():
            time.sleep(0.5)
            seen.append(self.screen())
            return len(seen) > 2 and len(set(seen[-3:])) == 1
        self.until(rests, "the screen does not come to rest")
        return seen[-1]

    def keys(self, *words):
        self.xdo("windowfocus", "--sync", self.main)
        self.xdo("mousemove", 500, 880)     # so that nothing is highlighted
        self.xdo("key", *words)
        return self.settle()

    def click(self, window, from_left, from_bottom):
        """Clicks in a window; a negative from_left counts from the right."""
        geometry = dict(line.split("=") for line in self.xdo("getwindowgeometry", "--shell", window).splitlines())
        x, y, width, height = (int(geometry[name]) for name in ("X", "Y", "WIDTH", "HEIGHT"))
        self.xdo("mousemove", x + from_left % width, y + height - from_bottom, "click", 1)
        self.xdo("mousemove", 500, 880)

    def saved(self):
        """What the document is now."""
        stamp = self.drawing.stat().st_mtime_ns
        self.xdo("windowfocus", "--sync", self.main)
        self.xdo("key", "ctrl+s")
        self.until(lambda: self.drawing.stat().st_mtime_ns != stamp, "Inkscape did not save")
        self.settle()
        return etree.parse(str(self.drawing)).getroot()

    def test_preview_apply_undo_and_remove(self):
        dialog = self.window(TITLE)
        self.xdo("windowmove", dialog, 880, 60)
        plain = self.settle()
        self.click(dialog, 24, 58)              # live preview
        self.until(lambda: self.screen() != plain, "there is no live preview")
        preview = self.settle()
        self.click(dialog, -45, 25)             # Apply
        self.settle()
        if self.xdo("search", "--name", f"^{TITLE}"):
            self.click(dialog, -130, 25)        # Close
        self.assertEqual(self.settle(), preview, "applied looks different from the preview")
        self.assertEqual(self.keys("ctrl+z"), plain, "one step of undo is not enough")
        self.assertEqual(self.keys("ctrl+shift+z"), preview)
        root = self.saved()
        for name in "ab":
            self.assertEqual(find(root, name).tag, SVG + "path")
            self.assertIsNotNone(find(root, name).get(OURS + "original"))
        self.keys("ctrl+F8")
        self.until(lambda: self.screen() == plain, "the original did not come back")
        root = self.saved()
        self.assertEqual(find(root, "a").get("d"), LINE)
        self.assertEqual((find(root, "b").tag, find(root, "b").get("width")), (SVG + "rect", "60"))


if __name__ == "__main__":
    unittest.main()
