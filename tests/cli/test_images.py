# SPDX-License-Identifier: GPL-3.0-or-later
"""Images: brushes, sizes, backgrounds, formats."""

import json
import struct
import unittest
import zlib

from program import DRAWINGS, ProgramTest, svg


def read_png(data):
    """Width, height, bits, channels and the pixels' rows of a PNG without interlace."""
    assert data.startswith(b"\x89PNG\r\n\x1a\n")
    at, packed, head = 8, b"", None
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at : at + 8])
        if kind == b"IHDR":
            head = struct.unpack(">IIBBBBB", data[at + 8 : at + 8 + size])
        if kind == b"IDAT":
            packed += data[at + 8 : at + 8 + size]
        at += 12 + size
    width, height, bits, colour = head[:4]
    channels = {0: 1, 2: 3, 4: 2, 6: 4}[colour]
    step = channels * bits // 8
    raw, rows, before = zlib.decompress(packed), [], bytes(width * step)
    for y in range(height):
        start = y * (width * step + 1)
        rows.append(unfilter(raw[start], raw[start + 1 : start + 1 + width * step], before, step))
        before = rows[-1]
    return width, height, bits, channels, rows


def unfilter(kind, line, before, step):
    out = bytearray(line)
    for i in range(len(out)):
        left = out[i - step] if i >= step else 0
        up, corner = before[i], before[i - step] if i >= step else 0
        if kind == 1:
            guess = left
        elif kind == 2:
            guess = up
        elif kind == 3:
            guess = (left + up) // 2
        elif kind == 4:
            p = left + up - corner
            guess = min((abs(p - left), 0, left), (abs(p - up), 1, up), (abs(p - corner), 2, corner))[2]
        else:
            guess = 0
        out[i] = (out[i] + guess) & 0xFF
    return bytes(out)


class ImageTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.file("in.svg", svg("M20 50 C60 10 140 90 180 50"))

    def brushes(self):
        return json.loads(self.succeed("brushes", "--json"))

    def render(self, *words):
        self.succeed("render", "in.svg", "-o", "out.png", *words)
        return read_png((self.work / "out.png").read_bytes())

    def test_brushes_are_listed(self):
        self.assertEqual(self.succeed("brushes").decode().split(), self.brushes())
        self.assertGreaterEqual(len(self.brushes()), 2)

    def test_every_brush_leaves_a_mark(self):
        for brush in self.brushes():
            width, height, _, channels, rows = self.render("--brush", brush, "--size", "8", "--background", "white")
            self.assertEqual((width, height), (200, 100))
            self.assertTrue(any(min(row[::channels]) < 128 for row in rows), brush)
            self.assertTrue(all(set(rows[y]) == {255} for y in (0, 99)), brush)

    def test_resolution_scales_the_image(self):
        self.assertEqual(self.render("--dpi", "192")[:2], (400, 200))
        self.assertEqual(self.render("--dpi", "48")[:2], (100, 50))

    def test_backgrounds(self):
        _, _, _, channels, rows = self.render("--background", "none")
        self.assertEqual(channels, 4)
        self.assertEqual(rows[0][3], 0)
        self.assertTrue(any(max(row[3::4]) > 200 for row in rows))
        _, _, _, _, rows = self.render("--background", "#ff8000")
        self.assertEqual(tuple(rows[0][:3]), (255, 128, 0))
        _, _, _, _, rows = self.render("--background", "#0f0")
        self.assertEqual(tuple(rows[0][:3]), (0, 255, 0))

    def test_size_makes_a_thicker_line(self):
        def dark(size):
            _, _, _, channels, rows = self.render("--brush", "ink", "--size", str(size))
            return sum(value < 128 for row in rows for value in row[::channels])

        self.assertGreater(dark(16), 2 * dark(4))

    def test_bits(self):
        self.assertEqual(self.render("--bits", "16")[2], 16)
        self.assertEqual(self.render("--bits", "8")[2], 8)

    def test_formats(self):
        for name, begin in (("o.tif", (b"II", b"MM")), ("o.tiff", (b"II", b"MM")), ("o.exr", (b"\x76\x2f\x31\x01",))):
            self.succeed("render", "in.svg", "-o", name)
            self.assertTrue((self.work / name).read_bytes().startswith(begin))

    def test_the_same_bytes_again(self):
        self.assertEqual(self.render("--brush", self.brushes()[0])[4], self.render("--brush", self.brushes()[0])[4])

    def test_what_is_not_painted_is_named(self):
        def said(inside, *words):
            line = '<path d="M10 10C50 90 90 10 150 90" fill="none" stroke="black"/><path d="M0 0h5v5z" fill="none"/>'
            size = 'xmlns="http://www.w3.org/2000/svg" width="200" height="100"'
            self.file("more.svg", f"<svg {size}>{line}{inside}</svg>")
            done = self.run_program("render", "more.svg", "-o", "more.png", *words)
            self.assertEqual(done.returncode, 0)
            return done.stderr.decode()

        fill, text, image = '<rect width="9" height="9"/>', '<text y="20">A</text>', '<image width="9" height="9"/>'
        begin = "ductus: more.png: only lines are painted; the drawing's "
        self.assertEqual(said(""), "")
        self.assertEqual(said(fill), begin + "fills are not\n")
        self.assertEqual(said(f"<g>{image}</g>{text}"), begin + "text and images are not\n")
        self.assertEqual(said(fill + text + image), begin + "fills, text and images are not\n")
        self.assertEqual(said(fill + text + image, "--quiet"), "")
        self.assertEqual(said(f'<g display="none">{fill + text}</g><defs>{image}</defs>'), "")
        self.assertEqual(self.run_program("convert", "more.svg", "-o", "again.svg").stderr, b"")

    def test_standard_output(self):
        self.succeed("render", "in.svg", "-o", "out.png")
        data = self.succeed("render", "in.svg", "-o", "-", "--to", "png")
        self.assertEqual(read_png(data), read_png((self.work / "out.png").read_bytes()))

    def test_several_images(self):
        self.file("b.svg", svg("M20 50 L180 60"))
        self.succeed("render", "in.svg", "b.svg", "-o", "pictures", "--to", "png")
        self.assertEqual(sorted(p.name for p in (self.work / "pictures").iterdir()), ["b.png", "in.png"])

    def test_convert_paints_too(self):
        self.succeed("convert", "in.svg", "-o", "out.png")
        read_png((self.work / "out.png").read_bytes())

    def test_a_brush_that_is_not_there_lists_those_that_are(self):
        line = self.refuse(1, "render", "in.svg", "-o", "out.png", "--brush", "no-such-brush")
        for brush in self.brushes():
            self.assertIn(brush, line)
        self.file("bad.myb", "{ not a brush")
        self.assertIn("bad.myb", self.refuse(1, "render", "in.svg", "-o", "out.png", "--brush", "./bad.myb"))

    def test_too_large(self):
        self.file("huge.svg", svg("M0 0 L9 9", width=1000000, height=1000000))
        self.refuse(1, "render", "huge.svg", "-o", "out.png")

    def test_our_own_drawings(self):
        for source in sorted(DRAWINGS.glob("*.svg")):
            self.succeed("render", source, "-o", "out.png", "--brush", "ink")


if __name__ == "__main__":
    unittest.main()
