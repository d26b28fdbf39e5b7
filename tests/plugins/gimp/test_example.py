# SPDX-License-Identifier: GPL-3.0-or-later
"""The example in docs/gimp.md, as it stands there, by `gimp -i -b`."""

import os
import re
import subprocess
import tempfile
import unittest

import session


class Example(unittest.TestCase):
    def test_the_documented_script_writes_its_picture(self):
        with open(os.path.join(session.SOURCE, "docs", "gimp.md")) as page:
            script = re.search(r"```scheme\n(.*?)```", page.read(), re.S).group(1)
        with tempfile.TemporaryDirectory(prefix="ductus-example-") as folder:
            _, environment = session.prepare_profile(folder)
            environment.pop("DISPLAY", None)
            work = os.path.join(folder, "work")
            os.mkdir(work)
            with open(os.path.join(session.SOURCE, "data", "drawings", "teapot.svg")) as drawing:
                text = drawing.read()
            with open(os.path.join(work, "drawing.svg"), "w") as copy:
                copy.write(text)
            # GIMP's exit code says nothing: what counts is what was written.
            done = subprocess.run(["gimp", "-i", "-d", "-f", "-b", script, "-b", "(gimp-quit 0)"], cwd=work,
                                  env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                                  timeout=120, check=False)
            self.assertNotIn("error", done.stdout.lower().replace("gimp-error", ""), done.stdout + done.stderr)
            picture = os.path.join(work, "drawing.png")
            self.assertTrue(os.path.exists(picture), done.stdout + done.stderr)
            self.assertGreater(os.path.getsize(picture), 10000)


if __name__ == "__main__":
    session.require("gimp")
    unittest.main()
