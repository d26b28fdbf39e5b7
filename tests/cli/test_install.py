# SPDX-License-Identifier: GPL-3.0-or-later
"""A real installation into a folder, and programs of others that use it."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

from program import DRAWINGS, SOURCE, operations

BUILD = pathlib.Path(os.environ["DUCTUS_BUILD"])


class InstallTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="ductus-install-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.prefix = cls.folder / "prefix"
        # What the build folder's data would hide must not be found.
        cls.environment = {k: v for k, v in os.environ.items() if not k.startswith("DUCTUS_")}
        cls.environment["XDG_DATA_HOME"] = str(cls.folder / "home")
        cls.call("cmake", "--install", BUILD, "--prefix", cls.prefix)
        cls.libraries = next(cls.prefix.rglob("libductus.so")).parent

    @classmethod
    def call(cls, *words, **environment):
        done = subprocess.run(
            [str(word) for word in words],
            capture_output=True,
            text=True,
            env={**cls.environment, **environment},
            check=False,
            timeout=300,
        )
        if done.returncode != 0:
            raise AssertionError(f"{words}: {done.returncode}\n{done.stdout}\n{done.stderr}")
        return done.stdout

    def first_hand(self):
        return sorted((self.prefix / "share" / "ductus" / "hands").glob("*.inkml"))[0].stem

    def check_example(self, program):
        operation = operations()[0]["id"]
        out = self.folder / "out.svg"
        environment = {"LD_LIBRARY_PATH": str(self.libraries)}
        text = self.call(program, operation, self.first_hand(), out, **environment)
        for parameter in operations()[0]["parameters"]:
            self.assertIn(parameter["id"], text)
        self.assertTrue(list(ElementTree.parse(out).iter("{http://www.w3.org/2000/svg}path")))
        out.unlink()
        self.call(program, operation, self.first_hand(), out, DRAWINGS / "teapot.svg", **environment)
        ElementTree.parse(out)
        out.unlink()

    def check_replay(self, program):
        recording = next((self.prefix / "share" / "ductus" / "hands").glob("*.inkml"))
        environment = {"LD_LIBRARY_PATH": str(self.libraries)}
        text = self.call(program, self.first_hand(), recording, "--fast", **environment)
        poses = [line for line in text.splitlines() if "pressure" in line]
        self.assertGreater(len(poses), 1000)
        self.assertEqual(text.count("stroke "), text.count("end:"))
        # Far below what a tablet leaves.
        self.assertLess(float(text.splitlines()[-1].split(": ")[1].split()[0]), 1e6 / 140 / 4)
        again = self.call(program, self.first_hand(), recording, "--fast", **environment)
        untimed = [line.split(" (")[0] for line in again.splitlines() if "pressure" in line]
        self.assertEqual([line.split(" (")[0] for line in poses], untimed)

    def test_the_installed_program_finds_its_data(self):
        program = self.prefix / "bin" / "ductus"
        self.assertIn(self.first_hand(), self.call(program, "library", "list"))
        self.assertTrue(self.call(program, "brushes").split())
        out = self.folder / "out.png"
        self.call(program, "render", DRAWINGS / "cat.svg", "-o", out)
        self.assertTrue(out.read_bytes().startswith(b"\x89PNG"))

    def test_the_manual_and_the_shells_completion_are_in_their_places(self):
        page = (self.prefix / "share" / "man" / "man1" / "ductus.1").read_text()
        self.assertEqual(page, self.call(self.prefix / "bin" / "ductus", "help", "--man"))
        for place in ("bash-completion/completions/ductus", "zsh/site-functions/_ductus",
                      "fish/vendor_completions.d/ductus.fish"):
            self.assertIn("ductus", (self.prefix / "share" / place).read_text())

    def test_the_installed_tree_can_be_moved(self):
        moved = self.folder / "moved"
        shutil.copytree(self.prefix, moved, symlinks=True)
        self.addCleanup(shutil.rmtree, moved)
        self.assertIn(str(moved), self.call(moved / "bin" / "ductus", "library", "list", "--json"))

    def test_a_program_found_by_pkg_config(self):
        build = self.folder / "example-make"
        shutil.copytree(SOURCE / "examples", build)
        path = str(self.libraries / "pkgconfig")
        self.assertTrue(self.call("pkg-config", "--modversion", "ductus", PKG_CONFIG_PATH=path).strip())
        self.call("make", "-C", build, "CFLAGS=-std=c11 -Wall -Wextra -Werror", PKG_CONFIG_PATH=path)
        self.check_example(build / "with_a_hand")
        self.check_replay(build / "replay")

    def test_a_program_found_by_cmake(self):
        build = self.folder / "example-cmake"
        self.call("cmake", "-S", SOURCE / "examples", "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}")
        self.call("cmake", "--build", build)
        self.check_example(build / "with_a_hand")
        self.check_replay(build / "replay")

    def test_headers_compile_alone_and_in_cxx(self):
        for header in sorted((self.prefix / "include" / "ductus").glob("*.h")):
            source = self.folder / "header.c"
            source.write_text(f"#include <ductus/{header.name}>\nint main(void) {{ return 0; }}\n")
            for compiler in (["cc", "-x", "c", "-std=c11"], ["c++", "-x", "c++", "-std=c++17"]):
                warnings = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"]
                self.call(*compiler, *warnings, "-fsyntax-only", "-I", self.prefix / "include", source)


if __name__ == "__main__":
    unittest.main()
