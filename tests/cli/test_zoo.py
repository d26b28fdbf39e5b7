# SPDX-License-Identifier: GPL-3.0-or-later
"""Hostile and odd files, as drawings and as hands: each ends in a result or in one clear sentence, and leaves nothing half
done."""

import gzip
import unittest

import program
from program import ProgramTest, recording, svg

LAUGHS = (
    '<!DOCTYPE svg [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;">'
    '<!ENTITY c "&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;"><!ENTITY d "&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;">'
    '<!ENTITY e "&d;&d;&d;&d;&d;&d;&d;&d;&d;&d;"><!ENTITY f "&e;&e;&e;&e;&e;&e;&e;&e;&e;&e;">'
    '<!ENTITY g "&f;&f;&f;&f;&f;&f;&f;&f;&f;&f;"><!ENTITY h "&g;&g;&g;&g;&g;&g;&g;&g;&g;&g;">]>'
)
NAMESPACE = 'xmlns="http://www.w3.org/2000/svg"'
INK = 'xmlns="http://www.w3.org/2003/InkML"'


def cyn(strokes, count=None):
    """A recording in .cyn's form without header; `count` lies about the strokes."""
    text = f"{len(strokes) if count is None else count}\n"
    for i, samples in enumerate(strokes):
        text += f"stroke {i}\n{len(samples)}\n"
        for k, (x, y, p) in enumerate(samples):
            text += f"{k} {0.007 * k} {x} {y} {p} 0 0 0\n"
    return text


LINE = [(0.1 + 0.001 * k, 0.1, 0.5) for k in range(100)]

# Name, content, and whether a result is expected (None: either will do).
ZOO = [
    ("empty.svg", "", False),
    ("blank.svg", " \n", False),
    ("word.svg", "hello", False),
    ("noise.svg", bytes(range(256)) * 40, False),
    ("png.svg", b"\x89PNG\r\n\x1a\n" + b"\0" * 100, False),
    ("truncated.svg", svg("M0 0 L100 50")[:-20], False),
    ("packed.svg", gzip.compress(svg("M0 0 L100 50").encode()), False),
    ("laughs.svg", LAUGHS + f"<svg {NAMESPACE}><text>&h;</text><path d='M0 0L9 9' stroke='red' id='&h;'/></svg>", None),
    ("outside.svg", f"<!DOCTYPE svg [<!ENTITY x SYSTEM '/etc/passwd'>]><svg {NAMESPACE}><title>&x;</title></svg>", None),
    ("deep.svg", f"<svg {NAMESPACE}>" + "<g>" * 100000 + "</g>" * 100000 + "</svg>", False),
    ("nothing.svg", f"<svg {NAMESPACE} width='10' height='10'/>", True),
    ("nan.svg", svg("M0 0 L nan inf L 5 5"), None),
    ("huge.svg", svg("M0 0 L 1e308 1e308 L -1e308 1e308"), None),
    ("large.svg", svg("M0 0 L 1e7 1e7"), None),
    ("points.svg", svg("M0 0 " + "l1 0.5 l1 -0.5 " * 100000), True),
    ("dots.svg", svg("M1 1", "M2 2 L2 2", "M3 3 Z", "M4 4 L4 4 Z"), True),
    ("many.svg", svg(*["M0 0 L9 9"] * 3000), True),
    ("singular.svg", f"<svg {NAMESPACE}><g transform='scale(0)'><path d='M0 0L9 9' stroke='red'/></g></svg>", True),
    ("empty.inkml", "", False),
    ("rootless.inkml", f"<ink {INK}>", False),
    ("nothing.inkml", f"<ink {INK}/>", True),
    ("letters.inkml", f"<ink {INK}><trace>1 2, x y, 5 6</trace></ink>", False),
    ("one.inkml", f"<ink {INK}><trace>1 2</trace></ink>", True),
    ("nan.inkml", f"<ink {INK}><trace>1 nan, inf 3</trace></ink>", False),
    ("huge.inkml", f"<ink {INK}><trace>1 2, 1e400 3</trace></ink>", False),
    ("deep.inkml", f"<ink {INK}>" + "<traceGroup>" * 50000 + "</traceGroup>" * 50000 + "</ink>", False),
    ("long.inkml", f"<ink {INK}><trace>" + ",".join(f"{k} {k % 7}" for k in range(300000)) + "</trace></ink>", True),
    ("empty.cyn", "", False),
    ("count.cyn", cyn([LINE], 10**18), False),
    ("samples.cyn", "1\nstroke 0\n999999999999\n0 0 0 0 0 0 0 0\n", False),
    ("negative.cyn", "-1\n", False),
    ("short.cyn", cyn([LINE])[:-300], False),
    ("nan.cyn", cyn([[("nan", "inf", 0.5), (0, 0, 0)]]), False),
    ("dot.cyn", cyn([[(0.5, 0.5, 0.5)]]), True),
    ("none.cyn", cyn([[]]), None),
    ("empty.csv", "", False),
    ("header.csv", "stroke,x,y\n", True),
    ("letters.csv", "stroke,x,y\n1,a,b\n", False),
    ("short.csv", "stroke,x,y\n1,2\n", False),
]


# Too slow for a build with sanitizers, in which nothing is vectorised.
LARGE = ("points.svg", "long.inkml", "large.svg", "many.svg")


class Zoo(ProgramTest):
    """Every animal, in every part."""

    def animals(self):
        return [animal for animal in ZOO if not (program.SANITIZED and animal[0] in LARGE)]

    def expect(self, name, result, good, *outputs):
        where = f"{name}: {result.stderr[-300:]!r}"
        self.assertIn(result.returncode, (0, 1), where)
        if good is not None:
            self.assertEqual(result.returncode, 0 if good else 1, where)
        if result.returncode == 1:
            self.assertEqual(result.stderr.count(b"\n"), 1, where)
            self.assertIn(name.encode(), result.stderr, where)
            for output in outputs:
                self.assertFalse(output.exists(), where)
        left = [path.name for path in self.folder.iterdir() if path.name.startswith(".ductus")]
        self.assertEqual(left, [], where)

    def put(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def test_as_drawings(self):
        hand = self.put("hand.inkml", recording())
        for name, content, good in self.animals():
            path = self.put(name, content)
            output = self.folder / "out.inkml"
            output.unlink(missing_ok=True)
            result = program.program("restyle", "--hand", hand, path, "-o", output, "--quiet")
            self.expect(name, result, good, output)

    def test_back_into_their_own_format(self):
        hand = self.put("hand.inkml", recording())
        for name, content, good in self.animals():
            path = self.put(name, content)
            output = self.folder / ("out." + name.split(".")[1])
            output.unlink(missing_ok=True)
            result = program.program("restyle", "--hand", hand, path, "-o", output, "--line", "path", "--quiet")
            self.expect(name, result, good, output)

    def test_as_hands(self):
        drawing = self.put("drawing.svg", svg("M10 50 C60 10 120 90 180 40"))
        for name, content, _ in self.animals():
            path = self.put(name, content)
            output = self.folder / "out.csv"
            output.unlink(missing_ok=True)
            result = program.program("restyle", "--hand", path, "--mode", "trajectory", drawing, "-o", output, "--quiet")
            self.expect(name, result, None, output)

    def test_painted(self):
        for name, content, good in self.animals():
            path = self.put(name, content)
            output = self.folder / "out.png"
            output.unlink(missing_ok=True)
            result = program.program("render", path, "-o", output, "--brush", "ink", "--dpi", "20", "--quiet")
            # A drawing without strokes has nothing to paint; a huge one has no page that could be.
            self.expect(name, result, None if good else good, output)

    def test_outputs_that_cannot_be(self):
        hand = self.put("hand.inkml", recording())
        drawing = self.put("drawing.svg", svg("M10 50 C60 10 120 90 180 40"))
        result = program.program("restyle", "--hand", hand, drawing, "-o", self.folder / "no" / "such" / "folder.svg")
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stderr.count(b"\n"), 1)
        before = drawing.read_bytes()
        result = program.program("restyle", "--hand", self.folder / "nobody.inkml", drawing, "-o", drawing)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(drawing.read_bytes(), before)
        # Onto itself is allowed, since the output appears whole.
        result = program.program("restyle", "--hand", hand, drawing, "-o", drawing)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertNotEqual(drawing.read_bytes(), before)


if __name__ == "__main__":
    unittest.main()
