# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the Inkscape extensions share: running an extension as Inkscape does, and small drawings."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from lxml import etree

SOURCE = pathlib.Path(os.environ["DUCTUS_SOURCE"])
BUILD = pathlib.Path(os.environ["DUCTUS_BUILD"])
EXTENSION = pathlib.Path(os.environ["DUCTUS_EXTENSION"])
DATA = pathlib.Path(os.environ.get("DUCTUS_DATA") or SOURCE / ".." / "shared" / "data")
MODULES = pathlib.Path("/usr/share/inkscape/extensions")
OPERATION = "restyle"

SVG = "{http://www.w3.org/2000/svg}"
INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}"
OURS = "{urn:ductus:inkscape}"
NAMESPACES = ('xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
              'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
              'xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"')
LINE = "M 10,50 C 40,10 80,90 120,50"


def need_inkscape(test):
    """Skips, and on CI fails, where there is no Inkscape."""
    if not MODULES.is_dir() or not shutil.which("inkscape"):
        if os.environ.get("CI") == "true":
            test.fail("Inkscape is not installed (script/bootstrap installs it for script/test)")
        test.skipTest("Inkscape is not installed")


def document(body, more='width="200" height="100" viewBox="0 0 200 100"'):
    return f'<svg {NAMESPACES} {more}>{body}</svg>'


class Case(unittest.TestCase):
    def setUp(self):
        need_inkscape(self)
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def run_extension(self, svg, *ids, task="apply", folder=EXTENSION, environment=None, **values):
        """The finished process; svg is text or bytes."""
        path = self.folder / "in.svg"
        path.write_bytes(svg if isinstance(svg, bytes) else svg.encode())
        words = [f"--id={name}" for name in ids] + [f"--task={task}"]
        if task == "apply":
            values = {"operation": OPERATION, "p_hand": "anna", "p_scale_auto": "true", **values}
            words += [f"--{name}={value}" for name, value in values.items()]
        variables = {**os.environ, "PYTHONPATH": str(MODULES), "XDG_DATA_HOME": str(self.folder / "home")}
        variables.pop("DUCTUS_LIBRARY", None)
        variables.update(environment or {})
        return subprocess.run([sys.executable, "-B", folder / "ductus_effect.py", *words, path], capture_output=True,
                              env=variables, timeout=300, check=False)

    def apply(self, svg, *ids, **values):
        """The changed document's root."""
        done = self.run_extension(svg, *ids, **values)
        self.assertEqual(done.returncode, 0, done.stderr.decode())
        self.message = done.stderr.decode()
        self.output = done.stdout
        return etree.fromstring(done.stdout)

    def refused(self, svg, *ids, **values):
        """The sentence of a run that has to fail: one line, no document."""
        done = self.run_extension(svg, *ids, **values)
        self.assertNotEqual(done.returncode, 0)
        self.assertEqual(done.stdout, b"")
        sentence = done.stderr.decode().strip()
        self.assertEqual(len(sentence.splitlines()), 1, sentence)
        self.assertNotIn("Traceback", sentence)
        self.assertTrue(sentence.startswith("Ductus: "), sentence)
        return sentence


def find(root, name):
    return root.find(f".//*[@id='{name}']")


def describe(root):
    """A document without white space and without the order of attributes, to be compared."""
    return [(element.tag, sorted(element.attrib.items()), (element.text or "").strip())
            for element in root.iter() if isinstance(element.tag, str)]
