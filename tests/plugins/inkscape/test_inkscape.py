# SPDX-License-Identifier: GPL-3.0-or-later
"""The extensions in the real Inkscape, without a window but with a display: through its actions, with the parameters that
its dialogs would give."""

import os
import re
import shutil
import signal
import subprocess
import unittest

from lxml import etree

from extension import BUILD, DATA, EXTENSION, INKSCAPE, LINE, OURS, SVG, Case, document, find
from test_elements import STROKE


class InInkscape(Case):
    def inkscape(self, svg, *actions, preferences=None, export="out.svg", patience=60):
        """The exported file."""
        profile = self.folder / "profile"
        extensions = profile / "extensions"
        if not extensions.exists():
            extensions.mkdir(parents=True)
            shutil.copytree(EXTENSION, extensions / "ductus")
        values = " ".join(f'{name}="{value}"' for name, value in (preferences or {}).items())
        (profile / "preferences.xml").write_text(
            '<inkscape version="1" xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd" '
            f'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"><group id="extensions" {values}/></inkscape>')
        source, target = self.folder / "source.svg", self.folder / export
        source.write_bytes(svg if isinstance(svg, bytes) else svg.encode())
        target.unlink(missing_ok=True)
        environment = {**os.environ, "INKSCAPE_PROFILE_DIR": str(profile),
                       "DUCTUS_PYTHON": str(BUILD / "share" / "ductus" / "python")}
        environment.pop("PYTHONPATH", None)
        log = self.folder / "log"
        with open(log, "wb") as output:
            run = subprocess.Popen(
                ["xvfb-run", "-a", "inkscape", "--batch-process", source,
                 "--actions=" + ";".join([*actions, f"export-filename:{target}", "export-do"])],
                stdin=subprocess.DEVNULL, stdout=output, stderr=output, env=environment, start_new_session=True)
            try:
                run.wait(timeout=patience)
            except subprocess.TimeoutExpired:
                # A message window that nobody closes; xvfb-run alone would leave Inkscape behind.
                os.killpg(run.pid, signal.SIGKILL)
                run.wait()
                self.fail(f"Inkscape did not come to an end: {log.read_text(errors='replace')}")
        self.assertTrue(target.exists(), log.read_text(errors="replace"))
        return target

    def colours(self, png):
        done = subprocess.run(["convert", png, "-background", "white", "-flatten", "-colorspace", "Gray", "-format",
                               "%[fx:mean]", "info:"], capture_output=True, check=True)
        return 1 - float(done.stdout)

    def test_apply_and_remove_through_actions(self):
        svg = document(f'<path id="a" d="{LINE}" {STROKE}/><rect id="b" x="20" y="20" width="60" height="40" {STROKE}/>')
        applied = self.inkscape(svg, "select-by-id:a,b", "org.ductus.restyle.noprefs",
                                preferences={"org.ductus.restyle.p_hand": "bruno", "org.ductus.restyle.width_kind": "none"})
        root = etree.parse(str(applied)).getroot()
        self.assertEqual(find(root, "b").tag, SVG + "path")
        self.assertIn('"hand": "bruno"', find(root, "a").get(OURS + "settings"))
        removed = self.inkscape(applied.read_bytes(), "select-all", "org.ductus.remove.noprefs", export="removed.svg")
        root = etree.parse(str(removed)).getroot()
        self.assertEqual(find(root, "a").get("d"), LINE)
        self.assertEqual((find(root, "b").tag, find(root, "b").get("width")), (SVG + "rect", "60"))

    def test_all_kinds_of_width_draw_about_the_same_ink(self):
        svg = document(f'<path id="a" d="{LINE}" style="fill:none;stroke:#000;stroke-width:6"/>')
        inks = {}
        for kind in ("outline", "powerstroke", "segments"):
            png = self.inkscape(svg, "select-by-id:a", "org.ductus.restyle.noprefs", export=f"{kind}.png",
                                preferences={"org.ductus.restyle.width_kind": kind})
            inks[kind] = self.colours(png)
        for kind, ink in inks.items():
            self.assertAlmostEqual(ink / inks["outline"], 1, delta=0.12, msg=str(inks))

    def difference(self, png, other):
        """The mean distance of two pictures, as a share of the first one's ink."""
        done = subprocess.run(["convert", png, other, "-background", "white", "-alpha", "remove", "-compose",
                               "difference", "-composite", "-colorspace", "Gray", "-format", "%[fx:mean]", "info:"],
                              capture_output=True, check=True)
        return float(done.stdout) / self.colours(png)

    def test_inkscape_computes_the_powerstroke_as_we_draw_it(self):
        """Inkscape computes the effect anew where `d` is missing, as it does as soon as somebody edits it."""
        style = 'style="fill:none;stroke:#000;stroke-width:6"'
        for name, body in (("open", f'<path id="s" d="{LINE}" {style}/>'),
                           ("closed", f'<circle id="s" cx="60" cy="50" r="30" {style}/>'),
                           ("corners", f'<rect id="s" x="30" y="20" width="120" height="60" {style}/>')):
            with self.subTest(name):
                root = self.apply(document(body), width_kind="powerstroke", aspect="1")
                ours = self.inkscape(etree.tostring(root), export="ours.png")
                del find(root, "s").attrib["d"]
                theirs = self.inkscape(etree.tostring(root), export="theirs.png")
                self.assertGreater(self.colours(ours), 0.01)
                self.assertLess(self.difference(ours, theirs), 0.15)

    def test_what_inkscape_moved_comes_back_moved(self):
        """Inkscape folds the move into the points, and computes a path effect's line anew."""
        svg = document(f'<path id="a" d="{LINE}" {STROKE}/><circle id="b" cx="60" cy="50" r="30" {STROKE}/>'
                       f'<rect id="c" x="20" y="20" width="60" height="40" style="fill:#fe8;stroke:#000"/>')
        for kind in ("powerstroke", "outline"):
            with self.subTest(kind):
                self.apply(svg, width_kind=kind)
                moved = self.inkscape(self.output, "select-by-id:a,b,c", "transform-translate:40,25", export="moved.svg")
                root = self.apply(moved.read_bytes(), task="remove")
                for name in "abc":
                    values = find(root, name).get("transform").replace("translate(", "matrix(1,0,0,1,")
                    values = [float(v) for v in re.findall(r"[-+.\de]+", values.partition("(")[2])]
                    for got, expected in zip(values, (1, 0, 0, 1, 40, 25)):
                        self.assertAlmostEqual(got, expected, delta=0.05)

    def test_drawings_of_others(self):
        drawings = sorted((DATA / "svg_lineart").glob("*.svg")) if DATA.is_dir() else []
        if not drawings:
            self.skipTest("no real drawings here (set DUCTUS_DATA to their folder)")
        for drawing in drawings[:2]:
            with self.subTest(drawing.name):
                # Inkscape asks about the resolution of drawings that an older version made.
                data = re.sub(rb'inkscape:version="[^"]*"', b'inkscape:version="1.2"', drawing.read_bytes())
                out = self.inkscape(data, "select-all:all", "org.ductus.restyle.noprefs")
                root = etree.parse(str(out)).getroot()
                changed = [element for element in root.iter() if isinstance(element.tag, str)
                           and element.get(OURS + "original")]
                self.assertGreater(len(changed), 0)
                back = self.inkscape(out.read_bytes(), "org.ductus.remove.noprefs", export="back.svg")
                back = etree.parse(str(back)).getroot()
                self.assertFalse([1 for element in back.iter() if isinstance(element.tag, str)
                                  and element.get(OURS + "original")])
                plain = {element.get("id"): element.get("d") for element in etree.fromstring(drawing.read_bytes()).iter()
                         if isinstance(element.tag, str) and element.get("id") and element.get("d")}
                for name, d in plain.items():
                    element = find(back, name)
                    if element is not None and element.tag == SVG + "path":
                        self.assertEqual(element.get("d"), d, name)


if __name__ == "__main__":
    unittest.main()
