# SPDX-License-Identifier: GPL-3.0-or-later
"""gimp.py [STROKES [SIDE]]: strokes along paths on a layer, by GIMP's own paintbrush with dynamics and by Ductus, both
through the PDB in one GIMP session. Prints the times, and what part of ours the brush engine takes. Only the ratios
within one run mean anything."""

import os
import re
import statistics
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "tests", "plugins", "gimp"))
import session  # noqa: E402

SIZE = 10
REPEATS = 2


def make_paths(gimp, strokes, side):
    """One path of curves of some 200 pixels, all over the image, the same in every run."""
    gimp.run("(define image (make-image %d %d RGB PRECISION-U8-GAMMA RGBA-IMAGE))"
             '(define path (car (gimp-vectors-new image "strokes")))' % (side, side))
    state, lines = 1, []
    for _ in range(strokes):
        numbers = []
        for _ in range(6):
            state = (state * 1103515245 + 12345) % 2**31
            numbers.append(state / 2**31)
        x, y = 100 + numbers[0] * (side - 300), 100 + numbers[1] * (side - 300)
        a, b, c, d = [x + 180 * numbers[2], y + 180 * numbers[3], x + 180 * numbers[4], y + 180 * numbers[5]]
        points = [x, y, x, y, a, b, c, d, x + 150, y + 60, x + 150, y + 60]
        lines.append("(gimp-vectors-stroke-new-from-points path VECTORS-STROKE-TYPE-BEZIER 12 #(%s) FALSE)"
                     % " ".join("%.1f" % value for value in points))
    for index in range(0, strokes, 50):
        gimp.run("(begin %s #t)" % " ".join(lines[index:index + 50]))
    gimp.run("(gimp-image-insert-vectors image path 0 0)")


def timed(gimp, text):
    begun = time.monotonic()
    gimp.run(text)
    return time.monotonic() - begun


def main():
    strokes = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    side = int(sys.argv[2]) if len(sys.argv) > 2 else 4000
    session.require("gimp")
    os.environ["G_MESSAGES_DEBUG"] = "ductus"
    gimp = session.Gimp(data=True)
    try:
        make_paths(gimp, strokes, side)
        gimp.run("(gimp-context-set-stroke-method STROKE-PAINT-METHOD)(gimp-context-set-paint-method \"gimp-paintbrush\")"
                 "(gimp-context-set-brush \"2. Hardness 100\")(gimp-context-set-brush-size %d)"
                 "(gimp-context-set-dynamics \"Pressure Size\")" % SIZE)
        rows = {"GIMP, paintbrush with Pressure Size": "(gimp-drawable-edit-stroke-item (active image) path)"}
        for brush in ("ink", "classic/pencil"):
            rows["Ductus, " + brush] = ('(restyle image (active image) "hand=eve; brush=%s; size=%d; '
                                        'result=active-layer")' % (brush, SIZE))
        print("%d strokes on %d x %d pixels, %d runs each (median)\n" % (strokes, side, side, REPEATS))
        print("| | seconds | of these: lines | operation | brush engine | into the image |")
        print("| --- | --- | --- | --- | --- | --- |")
        for name, text in rows.items():
            timed(gimp, text)  # once to warm up
            before = len(gimp.output())
            seconds = statistics.median(timed(gimp, text) for _ in range(REPEATS))
            parts = re.findall(r"seconds: lines ([\d.]+), operation ([\d.]+), brush ([\d.]+), image ([\d.]+)",
                               gimp.output()[before:])
            medians = ["%.2f" % statistics.median(float(part[k]) for part in parts) if parts else "" for k in range(4)]
            print("| %s | %.2f | %s |" % (name, seconds, " | ".join(medians)), flush=True)
    finally:
        gimp.close()


if __name__ == "__main__":
    main()
