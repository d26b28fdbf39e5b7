# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the whole program share: running it in a folder of its own, and small drawings."""

import json
import math
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

PROGRAM = os.environ.get("DUCTUS_PROGRAM", "ductus")
SOURCE = pathlib.Path(os.environ.get("DUCTUS_SOURCE", pathlib.Path(__file__).parents[2]))
DRAWINGS = SOURCE / "data" / "drawings"
SANITIZED = os.environ.get("DUCTUS_SANITIZED") == "1"

ENVIRONMENT = {
    **os.environ,
    # A sanitizer's report must not look like a clean failure.
    "ASAN_OPTIONS": "exitcode=99",
    "UBSAN_OPTIONS": "print_stacktrace=1",
    "LC_ALL": "C.UTF-8",
}


def program(*words, stdin=None, environment=None, **options):
    """Runs the program; stdin is bytes."""
    return subprocess.run(
        [PROGRAM, *map(str, words)],
        input=stdin if stdin is not None else b"",
        capture_output=True,
        env={**ENVIRONMENT, **(environment or {})},
        timeout=240,
        check=False,
        **options,
    )


def operations():
    """The operations' tables, as the program prints them. With the sanitizers the first one alone: what the others do is
    tested with them in tests of their own, and takes minutes through the whole program."""
    found = json.loads(program("ops", "--json").stdout)["operations"]
    return found[:1] if SANITIZED else found


def svg(*paths, width=200, height=100):
    """A drawing of stroked paths, given as the texts of their d attributes."""
    strokes = "".join(
        f'<path id="p{i}" d="{d}" fill="none" stroke="#102030" stroke-width="2"/>' for i, d in enumerate(paths)
    )
    return f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}">{strokes}</svg>'


def waves(count, width=400):
    """A drawing of that many wavy lines."""
    lines = []
    for i in range(count):
        y = 20 + 3 * (i % 100)
        lines.append(f"M10 {y} C{width / 3} {y - 30} {2 * width / 3} {y + 30} {width - 10} {y}")
    return svg(*lines, width=width, height=340)


def recording(strokes=12, samples=80):
    """A pen recording as InkML with pressure, for libraries of the tests' own."""
    traces = []
    for s in range(strokes):
        points = []
        for i in range(samples):
            u = i / (samples - 1)
            x = 10 + 120 * u
            y = 30 + 40 * s + 15 * math.sin(6 * u + s)
            points.append(f"{x:.3f} {y:.3f} {0.01 * i:.3f} {0.2 + 0.6 * math.sin(math.pi * u):.4f}")
        traces.append('<trace contextRef="#c">' + ", ".join(points) + "</trace>")
    return (
        '<ink xmlns="http://www.w3.org/2003/InkML"><definitions><context xml:id="c">'
        '<inkSource xml:id="pen"><traceFormat><channel name="X" type="decimal"/><channel name="Y" type="decimal"/>'
        '<channel name="T" type="decimal" units="s"/><channel name="F" type="decimal"/></traceFormat></inkSource>'
        "</context></definitions>" + "".join(traces) + "</ink>"
    )


class ProgramTest(unittest.TestCase):
    """A test in an empty folder; data of the user's own are none."""

    maxDiff = None

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="ductus-test-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.work = self.folder / "work"
        self.work.mkdir()
        self.environment = {"XDG_DATA_HOME": str(self.folder / "home")}

    def file(self, name, content):
        """Writes an input file and gives its path."""
        path = self.work / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def run_program(self, *words, **options):
        return program(*words, environment=self.environment, cwd=self.work, **options)

    def succeed(self, *words, **options):
        """Runs the program, which must end well and say nothing on stderr; gives its standard output."""
        done = self.run_program(*words, **options)
        self.assertEqual((done.returncode, done.stderr), (0, b""), words)
        return done.stdout

    def refuse(self, code, *words, **options):
        """Runs the program, which must end with that code and one line, and leave the folder as it was."""
        before = self.listing()
        done = self.run_program(*words, **options)
        text = done.stderr.decode()
        self.assertEqual(done.returncode, code, (words, text))
        self.assertEqual(done.stdout, b"")
        self.assertRegex(text, r"\Aductus: [^\n]+\n\Z")
        self.assertEqual(self.listing(), before)
        return text[len("ductus: ") : -1]

    def listing(self):
        """All files under the work folder and their contents."""
        return {
            str(path.relative_to(self.work)): path.read_bytes() if path.is_file() else None
            for path in self.work.rglob("*")
        }

    def hands(self):
        """The names of the hands there are."""
        return [hand["name"] for hand in json.loads(self.succeed("library", "list", "--json"))]

    def needed(self, operation):
        """The options that an operation cannot do without: its hands."""
        words = []
        for parameter in operation["parameters"]:
            if parameter["type"] == "hand" and parameter["default"] == "":
                words += [f"--{parameter['id']}", self.hands()[0]]
        return words


def strokes_of_csv(text):
    """The number of rows behind a CSV's header."""
    return len(text.decode().strip().splitlines()) - 1


if __name__ == "__main__":
    unittest.main()
