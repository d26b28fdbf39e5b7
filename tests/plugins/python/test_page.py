# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples of docs/python.md, as a reader would run them: one after the other in one folder."""

import contextlib
import io
import os
import pathlib
import re
import shutil
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

SOURCE = pathlib.Path(os.environ["DUCTUS_SOURCE"])


class Page(unittest.TestCase):
    def test_its_examples_work(self):
        page = SOURCE / "docs/python.md"
        examples = [(match.start(), match[1]) for match in re.finditer(r"```python\n(.*?)```", page.read_text(), re.S)]
        self.assertGreater(len(examples), 6)
        said, names, before = io.StringIO(), {}, os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(SOURCE / "data/drawings/branch.svg", pathlib.Path(folder, "drawing.svg"))
            os.chdir(folder)
            try:
                with contextlib.redirect_stdout(said):
                    for place, example in examples:
                        line = page.read_text()[:place].count("\n") + 1
                        exec(compile("\n" * line + example, str(page), "exec"), names)
            finally:
                os.chdir(before)
            paths = list(ElementTree.parse(f"{folder}/in-a-hand.svg").iter("{http://www.w3.org/2000/svg}path"))
            self.assertGreater(len(paths), 5)
            self.assertTrue(pathlib.Path(folder, "painted.png").read_bytes().startswith(b"\x89PNG"))
        self.assertIn("100%", said.getvalue())
        self.assertIn("not-found - no-such-drawing.svg", said.getvalue())
        self.assertIn("nodes: M ", said.getvalue())


if __name__ == "__main__":
    unittest.main()
