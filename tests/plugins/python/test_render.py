# SPDX-License-Identifier: GPL-3.0-or-later
"""Painting."""

import pathlib
import tempfile
import unittest

from binding import PLAIN, drawing, ductus

SIZE = ductus.TILE_SIZE


def flat(values):
    return list(values) if PLAIN else values.reshape(-1).tolist()


class Render(unittest.TestCase):
    def setUp(self):
        self.drawing = drawing()
        self.drawing.style(0, color=(1, 0, 0), width=4)
        self.canvas = ductus.render(self.drawing, ductus.brushes()[0])

    def test_pixels_are_those_of_the_tiles(self):
        self.assertEqual((self.canvas.width, self.canvas.height), (200, 100))
        pixels = flat(self.canvas.pixels())
        self.assertEqual(len(pixels), 200 * 100 * 4)
        if not PLAIN:
            self.assertEqual(self.canvas.pixels().shape, (100, 200, 4))
        painted = 0
        for row in range(2):
            for column in range(4):
                tile = self.canvas.tile(column, row)
                tile = flat(tile) if tile is not None else [0] * (SIZE * SIZE * 4)
                painted += any(tile)
                for y in range(row * SIZE, min(100, (row + 1) * SIZE)):
                    left, right = column * SIZE, min(200, (column + 1) * SIZE)
                    start = (y - row * SIZE) * SIZE * 4
                    self.assertEqual(pixels[(y * 200 + left) * 4:(y * 200 + right) * 4],
                                     tile[start:start + (right - left) * 4])
        self.assertGreater(painted, 2)
        self.assertIsNone(self.canvas.tile(100, 100))
        red, green, blue, alpha = (max(pixels[i::4]) for i in range(4))
        self.assertTrue(2 * green < red <= alpha <= 32768 and green == blue)

    def test_is_written_as_an_image(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "a.png")
            canvas = ductus.render(self.drawing, ductus.Brush(ductus.brushes()[0]), resolution=192, path=path)
            self.assertEqual((canvas.width, canvas.height), (400, 200))
            self.assertTrue(path.read_bytes().startswith(b"\x89PNG"))
            opaque = path.read_bytes()
            canvas.write(path, background=(0, 0, 0, 0), resolution=192)
            self.assertNotEqual(path.read_bytes(), opaque)
            with self.assertRaisesRegex(ductus.Error, "png"):
                canvas.write(pathlib.Path(folder, "a.xyz"))
            with self.assertRaises(ValueError):
                canvas.write(path, background=(1, 1))

    def test_brushes_are_found_by_name(self):
        for name in ductus.brushes():
            self.assertEqual(ductus.Brush(name).name, name)
        with self.assertRaisesRegex(ductus.Error, ductus.brushes()[0]) as caught:
            ductus.render(self.drawing, "no such brush")
        self.assertEqual(caught.exception.status, "not-found")

    def test_can_be_stopped(self):
        with self.assertRaises(ductus.Cancelled):
            ductus.render(self.drawing, ductus.brushes()[0], progress=lambda fraction: False)

        def fail(_):
            raise ZeroDivisionError
        with self.assertRaises(ZeroDivisionError):
            ductus.render(self.drawing, ductus.brushes()[0], progress=fail)


if __name__ == "__main__":
    unittest.main()
