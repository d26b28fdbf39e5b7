# SPDX-License-Identifier: GPL-3.0-or-later
"""Both ways of installing the extensions: the installed tree, and the zip in the user's folder."""

import os
import subprocess
import unittest
from xml.etree import ElementTree

import ductus
from extension import BUILD, EXTENSION, LINE, Case, document, find
from test_elements import STROKE

SPACE = "{http://www.inkscape.org/namespace/inkscape/extension}"


class Install(Case):
    def works(self, folder):
        svg = document(f'<path id="s" d="{LINE}" {STROKE}/>')
        root = self.apply(svg, folder=folder, environment={"PYTHONPATH": "/usr/share/inkscape/extensions"})
        self.assertNotEqual(find(root, "s").get("d"), LINE)
        self.assertEqual(list(folder.rglob("__pycache__")), [])

    def test_installed_tree(self):
        subprocess.run(["cmake", "--install", BUILD, "--prefix", self.folder / "usr"], capture_output=True, check=True)
        self.works(self.folder / "usr" / "share" / "inkscape" / "extensions" / "ductus")

    def test_zip_in_the_users_folder(self):
        subprocess.run(["cmake", "--build", BUILD, "--target", "inkscape-user-install"], check=True, capture_output=True,
                       env={**os.environ, "INKSCAPE_PROFILE_DIR": str(self.folder / "profile")})
        folder = self.folder / "profile" / "extensions" / "ductus"
        self.works(folder)
        self.assertTrue((folder / "lib" / "libductus.so").exists())

    def test_each_operation_has_a_dialog_with_all_its_parameters(self):
        for operation in ductus.operations():
            path = EXTENSION / f"ductus_{operation.id.replace('-', '_')}.inx"
            names = {param.get("name"): param for param in ElementTree.parse(path).iter(SPACE + "param")}
            for param in operation.params:
                name = "p_" + param.id.replace("-", "_")
                self.assertIn(name, names)
                self.assertIn(param.tooltip, names[name].get("gui-description"))
                if param.type == "choice":
                    options = [option.get("value") for option in names[name]]
                    self.assertEqual(sorted(options), sorted(choice.id for choice in param.choices))
                    self.assertEqual(options[0], param.default)     # what stands first is the default
                if param.type in ("real", "int"):
                    self.assertEqual(float(names[name].get("min")), param.minimum)
                    self.assertEqual(float(names[name].get("max")), param.maximum)
                    self.assertEqual(float(names[name].text), float(param.default))

    def test_no_operation_is_named_in_the_code(self):
        for path in [EXTENSION / "ductus_effect.py", *(EXTENSION / "ductus_inkscape").glob("*.py")]:
            for operation in ductus.operations():
                self.assertNotIn(f'"{operation.id}"', path.read_text())


if __name__ == "__main__":
    unittest.main()
