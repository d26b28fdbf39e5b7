# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings and strokes."""

import array
import gc
import pathlib
import struct
import tempfile
import unittest

from binding import DRAWINGS, PLAIN, drawing, ductus, wave


class Channels(unittest.TestCase):
    def test_come_back_as_they_went_in(self):
        made = ductus.Drawing()
        x, y = wave(5)
        given = {name: [0.1 * place + i for i in range(5)] for place, name in enumerate(ductus.CHANNELS[2:])}
        stroke = made.add_stroke("é", x, array.array("d", y), closed=True, color=(1, 0.5, 0), opacity=0.5, width=3,
                                 group="a/b", **given)
        for name, values in {"x": x, "y": y, **given}.items():
            self.assertEqual(list(stroke.channel(name)), values)
            self.assertEqual(list(made[0].channel(name)), values)
        self.assertEqual((made[0].id, made[0].closed, made[0].color, made[0].opacity, made[0].width, made[0].group),
                         ("é", True, (1, 0.5, 0), 0.5, 3, "a/b"))

    def test_absent_is_not_zero(self):
        made = drawing()
        self.assertIsNone(made[0].channel("twist"))
        self.assertFalse(made[0].has("twist") or made.has("twist"))
        made[0].set("twist", [0] * 60)
        self.assertEqual(list(made[0].channel("twist")), [0] * 60)
        self.assertTrue(made[0].has("twist") and made.has("twist"))
        made[0].set("twist", None)
        self.assertFalse(made[0].has("twist"))

    def test_the_numbers_are_a_copy(self):
        stroke = drawing()[0]
        taken = stroke.channel("x")
        taken[0] = 1000
        self.assertEqual(stroke.channel("x")[0], 0)
        kind = array.array if PLAIN else __import__("numpy").ndarray
        self.assertIsInstance(taken, kind)

    def test_any_buffer_or_sequence_is_taken(self):
        doubles = [0.0, 1.5, -2.0]
        strided = memoryview(array.array("d", [0.0, 9, 1.5, 9, -2.0, 9]))[::2]
        for values in (doubles, tuple(doubles), array.array("d", doubles), array.array("f", doubles), strided,
                       memoryview(struct.pack("3d", *doubles)).cast("d"), bytearray([0, 1, 2]), range(3)):
            with self.subTest(type(values)):
                stroke = ductus.Drawing().add_stroke("s", values, values)
                self.assertEqual(list(stroke.channel("y")), list(values))

    @unittest.skipIf(PLAIN, "numpy is put away")
    def test_numpy_arrays_of_any_layout(self):
        import numpy
        points = numpy.arange(12, dtype=numpy.float32).reshape(6, 2)
        for x, y in ((points[:, 0], points[:, 1]), (points[::-1, 0], points[::-1, 1]),
                     (points[:, 0].astype(">i4"), points[:, 1].astype(numpy.float16))):
            stroke = ductus.Drawing().add_stroke("s", x, y)
            self.assertEqual(stroke.channel("x").tolist(), x.tolist())
            self.assertEqual(stroke.channel("y").tolist(), y.tolist())
            self.assertEqual(stroke.channel("y").dtype, numpy.float64)

    def test_no_samples_are_none(self):
        stroke = ductus.Drawing().add_stroke("s", [], [], pressure=[])
        self.assertEqual((len(stroke), list(stroke.channel("x"))), (0, []))


def made_bounds(drawing):
    columns = [sorted(value for stroke in drawing for value in stroke.channel(name)) for name in ("x", "y")]
    return columns[0][0], columns[1][0], columns[0][-1], columns[1][-1]


class BadInput(unittest.TestCase):
    def test_adds_nothing(self):
        made = ductus.Drawing()
        good = ([1, 2], [1, 2])
        for error, arguments, keywords in (
                (ductus.Error, ([1, 2], [1]), {}),
                (ductus.Error, good, {"pressure": [1]}),
                (ValueError, good, {"color": (1, 2, 3, 4)}),
                (TypeError, good, {"width": "wide"}),
                (TypeError, good, {"opacity": None}),
                (TypeError, (None, None), {}),
                (TypeError, ("12", "12"), {}),
                ((TypeError, ValueError), (["a", "b"], [1, 2]), {}),
                (ductus.Error, good, {"group": "a\0b"})):
            with self.subTest(arguments=arguments, **keywords):
                with self.assertRaises(error):
                    made.add_stroke("s", *arguments, **keywords)
                self.assertEqual(len(made), 0)
        for name in ("a\0b", "\ud800"):
            with self.assertRaises(ductus.Error) as caught:
                made.add_stroke(name, *good)
            self.assertEqual(caught.exception.status, "bad-argument")
            str(caught.exception).encode()
        self.assertEqual(len(made), 0)

    def test_says_what_there_is(self):
        made = drawing()
        with self.assertRaisesRegex(ductus.Error, "'tilt'.*tilt_x"):
            made[0].channel("tilt")
        with self.assertRaisesRegex(ductus.Error, "3 numbers.*60 samples"):
            made[0].set("pressure", [1, 2, 3])
        self.assertFalse(made[0].has("pressure"))
        with self.assertRaises(IndexError):
            made[1]
        with self.assertRaises(IndexError):
            made.style(-2)
        with self.assertRaisesRegex(ductus.Error, "line style 'x'.*outline"):
            made.to_bytes("svg", line_style="x")


class Drawings(unittest.TestCase):
    def test_are_sequences_of_strokes(self):
        made = drawing(3)
        self.assertEqual([stroke.id for stroke in made], ["wave0", "wave1", "wave2"])
        self.assertEqual((made[-1].id, len(made), made.size), ("wave2", 3, (200, 100)))
        self.assertEqual(made.bounds, made_bounds(made))
        self.assertIsNone(ductus.Drawing().bounds)

    def test_copies_share_nothing(self):
        made = drawing()
        made.annotate("artist", "Änne")
        made.resolution = 300
        copy, like = made.copy(), made.like()
        copy.add_copy(made[0]).set("x", [7] * 60)
        copy.style(0, color=(1, 0, 0), width=5)
        self.assertEqual((len(made), len(copy), len(like)), (1, 2, 0))
        self.assertEqual((made[0].width, copy[0].width, copy[1].width), (0, 5, 0))
        self.assertEqual((made[0].channel("x")[1], copy[1].channel("x")[1]), (3, 7))
        self.assertEqual((like.annotation("artist"), like.size, copy.resolution), ("Änne", (200, 100), 300))

    def test_annotations(self):
        made = ductus.Drawing()
        made.annotate("artist", "A")
        made.annotate("licence", "CC0")
        self.assertEqual(made.annotations, {"artist": "A", "licence": "CC0"})
        made.annotate("artist", None)
        self.assertIsNone(made.annotation("artist"))
        self.assertEqual(made.annotations, {"licence": "CC0"})

    def test_a_stroke_keeps_its_drawing(self):
        stroke = drawing()[0]
        gc.collect()
        self.assertEqual(len(stroke.channel("x")), 60)

    def test_all_strokes_of_one_place_see_a_change(self):
        made = drawing()
        first, second = made[0], made[0]
        first.set("pressure", [0.5] * 60)
        self.assertEqual(second.channel("pressure")[59], 0.5)


class Files(unittest.TestCase):
    def test_are_read_and_written_in_every_format(self):
        with tempfile.TemporaryDirectory() as folder:
            for format in ductus.formats():
                if not (format.reads and format.writes):
                    continue
                path = pathlib.Path(folder, "ä b." + format.extensions[0])
                drawing().write(path)
                self.assertEqual(len(ductus.Drawing.read(path)), 1, format.id)
                self.assertEqual(len(ductus.Drawing.read(str(path))), 1, format.id)
                data = drawing().to_bytes(format.id)
                self.assertEqual(data, path.read_bytes())
                self.assertEqual(len(ductus.Drawing.from_bytes(data, path.name)), 1, format.id)

    def test_how_closely_curves_are_followed_can_be_said(self):
        data = (DRAWINGS / "cat.svg").read_bytes()
        fine, coarse = (sum(len(stroke) for stroke in ductus.Drawing.from_bytes(data, flatten_tolerance=tolerance))
                        for tolerance in (0.01, 1))
        self.assertGreater(fine, 2 * coarse)
        made = drawing()
        made[0].set("pressure", [i / 60 for i in range(60)])
        self.assertIn(b"fill:#000000", made.to_bytes("svg"))
        self.assertIn(b"fill:none", made.to_bytes("svg", line_style="path"))
        self.assertLess(len(made.to_bytes("svg", fit_tolerance=2)), len(made.to_bytes("svg")))

    def test_errors_begin_with_the_files_name(self):
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaises(ductus.Error) as caught:
                ductus.Drawing.read(pathlib.Path(folder, "none.svg"))
            self.assertIn("none.svg", str(caught.exception))
            self.assertEqual(caught.exception.status, "not-found")
            path = pathlib.Path(folder, "a.svg")
            path.write_text("<svg><path d='M")
            with self.assertRaisesRegex(ductus.Error, "a.svg") as caught:
                ductus.Drawing.read(path)
            self.assertEqual(caught.exception.status, "bad-format")
            # A name that is no UTF-8 can be opened, and printed where it cannot.
            odd = bytes(pathlib.Path(folder)) + b"/\xff.svg"
            with self.assertRaises(ductus.Error) as caught:
                ductus.Drawing.read(odd)
            str(caught.exception).encode()
            drawing().write(odd)
            self.assertEqual(len(ductus.Drawing.read(odd)), 1)
        with self.assertRaises(TypeError):
            drawing().write(None)


if __name__ == "__main__":
    unittest.main()
