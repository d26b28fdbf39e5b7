# SPDX-License-Identifier: GPL-3.0-or-later
"""The example in docs/gimp.md, as it stands there, by `gimp -i -b`."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest

import session


def run_example(test, folder, environment):
    """Runs the page's script beside a drawing; the picture must be there afterwards."""
    with open(os.path.join(session.SOURCE, "docs", "gimp.md")) as page:
        script = re.search(r"```scheme\n(.*?)```", page.read(), re.S).group(1)
    environment.pop("DISPLAY", None)
    work = os.path.join(folder, "work")
    os.mkdir(work)
    shutil.copyfile(os.path.join(session.SOURCE, "data", "drawings", "teapot.svg"), os.path.join(work, "drawing.svg"))
    # GIMP's exit code says nothing: what counts is what was written.
    done = subprocess.run(["gimp", "-i", "-d", "-f", "-b", script, "-b", "(gimp-quit 0)"], cwd=work, env=environment,
                          stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120, check=False)
    said = done.stdout + done.stderr
    test.assertNotIn("execution error", said, said)
    picture = os.path.join(work, "drawing.png")
    test.assertTrue(os.path.exists(picture), said)
    test.assertGreater(os.path.getsize(picture), 10000)


class Example(unittest.TestCase):
    def test_the_documented_script_writes_its_picture(self):
        with tempfile.TemporaryDirectory(prefix="ductus-example-") as folder:
            _, environment = session.prepare_profile(folder)
            run_example(self, folder, environment)

    def test_the_plugin_works_from_the_users_folder_alone(self):
        with tempfile.TemporaryDirectory(prefix="ductus-example-") as folder:
            profile, environment = session.prepare_profile(folder)
            plugins = os.path.join(profile, "plug-ins")
            os.remove(os.path.join(plugins, "ductus-gimp"))
            subprocess.run(["cmake", "--install", session.BUILD, "--component", "gimp-zip", "--prefix", plugins],
                           check=True, capture_output=True)
            for needed in ("ductus-gimp", "libductus.so.0", "gimp.html", "share/ductus/hands", "share/ductus/brushes"):
                self.assertTrue(os.path.exists(os.path.join(plugins, "ductus-gimp", needed)), needed)
            linked = subprocess.run(["ldd", os.path.join(plugins, "ductus-gimp", "ductus-gimp")], capture_output=True,
                                    text=True, check=True).stdout
            self.assertIn(os.path.join(plugins, "ductus-gimp", "libductus.so.0"), linked)
            run_example(self, folder, environment)


if __name__ == "__main__":
    session.require("gimp")
    unittest.main()
