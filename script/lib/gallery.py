# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the gallery with the command line, as a user would: gallery.py PROGRAM FOLDER DRAWINGS [DRAWING...]

DRAWINGS is the folder of our own drawings; further drawings are the user's and come first.
"""

import csv
import html
import io
import json
import math
import pathlib
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

# For each drawing: the file's ending, what it is, the options.
VERSIONS = [
    ("pose.png", "its lines kept, with the hand's pose: brush 'flat-nib'",
     ["--mode", "pose", "--brush", "flat-nib", "--dpi", "192"]),
    ("bristle.png", "redrawn by the hand: brush 'bristle'", ["--brush", "bristle", "--dpi", "192"]),
    ("flat-nib.png", "redrawn by the hand: brush 'flat-nib'", ["--brush", "flat-nib", "--dpi", "192"]),
    ("hand.svg", "redrawn by the hand, as an SVG of filled outlines", []),
]

PAGE = """<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Ductus: a gallery</title>
<style>
body {{ font: 16px/1.5 system-ui, sans-serif; color: #26283a; background: #faf9f6; margin: 2rem auto; max-width: 84rem;
  padding: 0 1.5rem }}
h1, h2 {{ font-weight: 500 }}
h2 {{ margin: 3rem 0 .5rem }}
.row {{ display: grid; grid-template-columns: repeat(auto-fit, minmax(24rem, 1fr)); gap: 1rem }}
figure {{ margin: 0; background: #fff; border: 1px solid #e2dfd6; border-radius: 4px; padding: .75rem }}
figure img {{ width: 100%; display: block }}
figcaption {{ font-size: .85rem; color: #6b6a72; margin-top: .5rem }}
code {{ font-size: .85em; background: #f0eee7; padding: .1em .3em; border-radius: 3px }}
</style>
<h1>Ductus: a gallery</h1>
<p>On the left the plain vector drawing; beside it the same drawing after <code>ductus restyle</code> with the hand
<b>{hand}</b>, which is synthetic: a program made it, nobody recorded it. The brushes answer to pressure, tilt and the
rotation of the pen's barrel.</p>
{sections}
</html>
"""


def run(program, *words):
    """Runs the program and gives its output; ends with its sentence where it fails."""
    done = subprocess.run([program, *map(str, words)], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{done.stderr.strip()}\nfailed: ductus {' '.join(map(str, words))}")
    return done.stdout


def figure(picture, caption):
    return (
        f'<figure><a href="{html.escape(picture, quote=True)}"><img src="{html.escape(picture, quote=True)}" alt=""></a>'
        f"<figcaption>{html.escape(caption)}</figcaption></figure>"
    )


def pose_diagram(rows, width, height):
    """The strokes as nibs: at every few pixels a short line, turned as the pen's barrel is, longer with pressure and
    coloured by the tilt, from blue (the most upright) to red (the most slanted)."""
    nibs, last = [], {}
    for row in rows:
        x, y, pressure, tilt_x, tilt_y, twist = (
            float(row.get(key) or 0) for key in ("x", "y", "pressure", "tilt_x", "tilt_y", "twist")
        )
        at = last.get(row["stroke"])
        if at is None or math.hypot(x - at[0], y - at[1]) >= 3:
            last[row["stroke"]] = (x, y)
            reach = 1 + 8 * pressure
            nibs.append((x, y, reach * math.cos(twist), reach * math.sin(twist), math.hypot(tilt_x, tilt_y)))
    least = min((nib[4] for nib in nibs), default=0)
    spread = max((nib[4] for nib in nibs), default=0) - least or 1
    marks = "".join(
        f'<path d="M{x - dx:.2f} {y - dy:.2f} L{x + dx:.2f} {y + dy:.2f}" '
        f'stroke="hsl({220 * (1 - (tilt - least) / spread):.0f}, 75%, 45%)"/>'
        for x, y, dx, dy, tilt in nibs
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:g} {height:g}">'
        f'<g stroke-width="1" stroke-linecap="round">{marks}</g></svg>\n'
    )


def page_size(svg):
    """The drawing's page as its viewBox, or its strokes' reach, says."""
    box = (ElementTree.parse(svg).getroot().get("viewBox") or "").replace(",", " ").split()
    return (float(box[2]), float(box[3])) if len(box) == 4 else (None, None)


def show(program, hand, folder, source, name, with_pose):
    """One drawing's row of the gallery."""
    print(f"    {name}", flush=True)
    plain = folder / f"{name}.svg"
    shutil.copyfile(source, plain)
    figures = [figure(plain.name, "the plain drawing")]
    for ending, caption, options in VERSIONS:
        result = folder / f"{name}-{ending}"
        run(program, "restyle", "--hand", hand, source, "-o", result, *options)
        figures.append(figure(result.name, caption))
    width, height = page_size(source)
    if with_pose and width:
        ink = run(program, "restyle", "--hand", hand, source, "-o", "-", "--to", "csv", "--mode", "pose")
        diagram = folder / f"{name}-diagram.svg"
        diagram.write_text(pose_diagram(csv.DictReader(io.StringIO(ink)), width, height), encoding="utf-8")
        caption = "the pose: marks turned as the barrel is, longer with pressure, blue upright to red slanted"
        figures.append(figure(diagram.name, caption))
    return f'<h2>{html.escape(name)}</h2>\n<div class="row">{"".join(figures)}</div>\n'


def main():
    program, folder, ours = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    drawings = [(pathlib.Path(path), f"yours-{i + 1}") for i, path in enumerate(sys.argv[4:])]
    drawings += [(path, path.stem) for path in sorted(ours.glob("*.svg"))]
    folder.mkdir(parents=True, exist_ok=True)
    hands = [hand["name"] for hand in json.loads(run(program, "library", "list", "--json")) if hand["builtin"]]
    if not hands:
        sys.exit("there is no built-in hand: build the project first (script/bootstrap)")
    sections = [
        show(program, hands[0], folder, path, name, with_pose=name == "lettering") for path, name in drawings
    ]
    page = PAGE.format(hand=html.escape(hands[0]), sections="".join(sections))
    (folder / "index.html").write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main()
