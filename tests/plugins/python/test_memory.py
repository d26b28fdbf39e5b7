# SPDX-License-Identifier: GPL-3.0-or-later
"""Whatever libductus hands out is freed with its Python object, after errors too."""

import ctypes
import gc
import subprocess
import sys
import unittest

from binding import drawing, ductus, settings, wave


class Used(ctypes.Structure):
    """struct mallinfo2 of the C library."""
    _fields_ = [(name, ctypes.c_size_t) for name in
                "arena ordblks smblks hblks hblkhd usmblks fsmblks uordblks fordblks keepcost".split()]


LIBC = ctypes.CDLL(None)
LIBC.mallinfo2.restype = Used
LIBRARY = ductus.Library(ductus.hands()[0].name)


def used():
    """Bytes that malloc has given out. Python's own small objects do not come from there."""
    gc.collect()
    info = LIBC.mallinfo2()
    return info.uordblks + info.hblkhd


def refused(call, *arguments, **keywords):
    try:
        call(*arguments, **keywords)
    except (ductus.Error, ValueError, TypeError):
        return
    raise AssertionError(f"{call} was not refused")


class Memory(unittest.TestCase):
    def check(self, work, times=100):
        for _ in range(min(20, times)):
            work()
        grown = []
        for _ in range(3):
            before = used()
            for _ in range(times):
                work()
            grown.append(used() - before)
        # Python's own dicts and lists grow now and then; what leaks grows each time, and is some hundred bytes for each
        # handle at least, some thousand for a drawing or canvas.
        self.assertLess(min(grown), 4096)

    def test_of_drawings(self):
        def work():
            made = drawing(3)
            made.copy().add_copy(made[0]).set("pressure", wave()[1])
            ductus.Drawing.from_bytes(made.like().to_bytes("inkml"))
            ductus.Drawing.from_bytes(made.to_bytes("svg"))
            list(made), made.annotations, made.bounds, made[0].channel("x")
        self.check(work)

    def test_of_drawings_that_are_refused(self):
        def work():
            refused(ductus.Drawing.from_bytes, b"<svg><path d='M 0,0 L 5,5'")
            refused(ductus.Drawing.read, "/no/such/file.svg")
            refused(drawing().to_bytes, "no-format")
            refused(drawing().add_stroke, "s", [1, 2], [1])
        self.check(work)

    def test_of_paths(self):
        stroke = drawing()[0]

        def work():
            path = ductus.Path("M 0,0 C 40,-60 80,60 120,0")
            path.flatten("p", 0.05, ductus.Drawing())
            fitted = ductus.Path()
            fitted.fit(stroke, 0.1)
            fitted.outline(stroke, ductus.Nib(width=3))
            fitted.svg(), fitted.points, fitted.verbs, fitted.widths(0, stroke)
            refused(fitted.widths, 9, stroke)
        self.check(work)

    def test_of_tables_and_settings(self):
        def work():
            made = settings(LIBRARY)
            refused(made.__setitem__, "no-such", 1)
            refused(ductus.Settings, "no-such")
            ductus.operations(), ductus.hands(), ductus.brushes(), ductus.formats()
        self.check(work, times=40)

    def test_of_libraries(self):
        recording = drawing(2)
        for stroke in recording:
            stroke.set("pressure", [0.5] * 60)

        def work():
            library = ductus.Library.build([recording, recording], name="n", scales=[1, 2], weights=[1, 2])
            library.drawing(), library.name
            refused(ductus.Library.build, [])
            refused(ductus.Library, "no such hand")
        self.check(work, times=40)

    def test_of_runs(self):
        def fail(_):
            raise ValueError
        made, given = settings(LIBRARY), ductus.Drawing()
        given.add_stroke("s", *wave(12))

        def work():
            ductus.run(made, given, threads=1, progress=lambda _: True, trace=lambda _: None)
            refused(ductus.run, made, given, threads=1, progress=lambda _: False)
            refused(ductus.run, made, given, threads=1, progress=fail)
            refused(ductus.run, made, given, threads=1, trace=fail)
        self.check(work, times=4)

    def test_of_canvases(self):
        def work():
            canvas = ductus.render(drawing(), "ink" if "ink" in ductus.brushes() else ductus.brushes()[0])
            canvas.tile(0, 0), canvas.pixels()
            refused(canvas.write, "/no/such/folder/a.png")
            refused(ductus.render, drawing(), "no such brush")
        self.check(work, times=10)

    def test_what_is_alive_at_the_end_is_freed_in_peace(self):
        program = ("import ductus, threading\n"
                   "d = ductus.Drawing(); s = d.add_stroke('s', [1, 2], [1, 2]); p = ductus.Path('M 0,0 L 1,1')\n"
                   "l = ductus.Library(ductus.hands()[0].name); t = ductus.Settings(ductus.operations()[0].id)\n"
                   "c = ductus.render(d, ductus.brushes()[0]); c.circle = c\n"
                   "d.me = d; s.me = s\n")
        run = subprocess.run([sys.executable, "-X", "faulthandler", "-c", program], capture_output=True, text=True,
                             check=False)
        self.assertEqual((run.returncode, run.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
