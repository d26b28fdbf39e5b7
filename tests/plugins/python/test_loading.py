# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the package finds libductus, and what it says where it does not; the package by itself."""

import ast
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["DUCTUS_SOURCE"])
BUILD = pathlib.Path(os.environ["DUCTUS_BUILD"])
PACKAGE = BUILD / "share/ductus/python/ductus"
LIBRARY = BUILD / "lib/libductus.so"
CLEAN = {name: value for name, value in os.environ.items()
         if not name.startswith(("DUCTUS_", "PYTHON", "LD_LIBRARY_PATH"))}
# Tries a program, or tells why the library is missing.
TRY = "try:\n    {}\nexcept ductus.Missing as error:\n    print('missing:', error)\n"


def python(program, path, **environment):
    run = subprocess.run([sys.executable, "-B", "-c", program], capture_output=True, text=True, check=False, cwd="/",
                         env={**CLEAN, "PYTHONPATH": str(path), **environment})
    if run.returncode or run.stderr:
        raise AssertionError(run.stderr)
    return run.stdout


class Loading(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="ductus-python-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def copy(self, place="package"):
        """The package where no library is near, as one finds the source of others."""
        shutil.copytree(PACKAGE, self.folder / place / "ductus", ignore=shutil.ignore_patterns("__pycache__"))
        return self.folder / place

    def sentence(self, path, action="ductus.version()", **environment):
        out = python("import ductus\n" + TRY.format(action), path, **environment)
        self.assertEqual(len(out.splitlines()), 1, out)
        self.assertTrue(out.startswith("missing: "), out)
        return out

    def test_in_the_build_folder(self):
        self.assertIn("0.", python("import ductus; print(ductus.version())", PACKAGE.parent))

    def test_installed_wherever_it_is_put(self):
        subprocess.run(["cmake", "--install", BUILD, "--prefix", self.folder / "first"], check=True,
                       stdout=subprocess.DEVNULL, env=CLEAN)
        os.rename(self.folder / "first", self.folder / "second place")
        out = python("import ductus; print(ductus.load()._name, len(ductus.hands()), ductus.brushes())",
                     self.folder / "second place/share/ductus/python")
        self.assertIn("second place/lib", out)
        self.assertNotIn(" 0 ", out)

    def test_carried_by_the_package(self):
        path = self.copy()
        (path / "ductus/lib").mkdir()
        shutil.copy(LIBRARY, path / "ductus/lib/libductus.so")
        self.assertIn(str(path), python("import ductus; print(ductus.load()._name)", path))

    def test_as_a_part_of_another_package(self):
        path = self.copy("outer")
        (path / "__init__.py").touch()
        out = python("import outer.ductus as d; print(d.version(), d.Drawing.__module__)", self.folder,
                     DUCTUS_LIBRARY=str(LIBRARY))
        self.assertIn("outer.ductus", out)

    def test_named_by_the_environment_or_the_caller(self):
        path = self.copy()
        show = "import ductus; {}; print(ductus.load()._name)"
        self.assertIn(str(LIBRARY), python(show.format("pass"), path, DUCTUS_LIBRARY=str(LIBRARY)))
        self.assertIn(str(LIBRARY), python(show.format(f"ductus.load({str(LIBRARY)!r})"), path))
        self.assertIn(str(LIBRARY), python(
            show.format(f"import os, pathlib; os.chdir({str(LIBRARY.parent)!r}); ductus.load(pathlib.Path('libductus.so'))"),
            path))

    def test_nowhere(self):
        if "libductus" in subprocess.run(["/sbin/ldconfig", "-p"], capture_output=True, text=True, check=False).stdout:
            self.skipTest("this system has a libductus of its own")
        self.assertRegex(self.sentence(self.copy()), "was not found.*install Ductus, or set DUCTUS_LIBRARY")

    def test_not_there_where_it_was_named(self):
        for environment, action in (({"DUCTUS_LIBRARY": "/nowhere/libductus.so"}, "ductus.version()"),
                                    ({}, "ductus.load('/nowhere/libductus.so')")):
            self.assertIn("/nowhere/libductus.so: there is no such file",
                          self.sentence(PACKAGE.parent, action, **environment))

    def test_no_library_at_all(self):
        self.assertIn("LICENSE", self.sentence(PACKAGE.parent, DUCTUS_LIBRARY=str(SOURCE / "LICENSE")))
        other = self.library("int other(void) { return 0; }")
        self.assertIn("another library", self.sentence(PACKAGE.parent, DUCTUS_LIBRARY=str(other)))

    def test_another_version_is_passed_over_and_named(self):
        other = self.library('const char *duct_version(void) { return "99.1.0"; }')
        self.assertRegex(self.sentence(PACKAGE.parent, DUCTUS_LIBRARY=str(other)), "libductus 99.1.0.*needs 0.")
        # In the place where it is looked for first, while a fitting one stands further on.
        path = self.folder / "prefix/share/ductus/python"
        shutil.copytree(PACKAGE, path / "ductus")
        (path / "ductus/lib").mkdir()
        shutil.copy(other, path / "ductus/lib/libductus.so")
        self.assertIn("99.1.0", self.sentence(path))
        (self.folder / "prefix/lib").mkdir()
        shutil.copy(LIBRARY, self.folder / "prefix/lib/libductus.so")
        self.assertIn("prefix/lib/", python("import ductus; print(ductus.load()._name)", path))

    def test_a_library_without_what_it_needs_says_what(self):
        needed = self.library("int needed(void) { return 0; }", "libneeded.so")
        path = self.copy()
        (path / "ductus/lib").mkdir()
        self.library('extern int needed(void); const char *duct_version(void) { return needed() ? "" : "0"; }',
                     path / "ductus/lib/libductus.so", needed)
        needed.unlink()
        self.assertRegex(self.sentence(path), "ductus/lib/libductus.so.*libneeded.so")

    def library(self, text, name="libother.so", *others):
        source = self.folder / "other.c"
        source.write_text(text)
        subprocess.run([os.environ.get("CXX", "c++"), "-x", "c", "-shared", "-fPIC", source, "-x", "none", "-o",
                        self.folder / name, *others], check=True)
        return self.folder / name


class Source(unittest.TestCase):
    def test_is_python_3_9(self):
        for module in sorted(PACKAGE.glob("*.py")):
            ast.parse(module.read_text(), feature_version=(3, 9))

    def test_names_no_operation(self):
        names = python("import ductus; print(*(o.id for o in ductus.operations()))", PACKAGE.parent).split()
        self.assertTrue(names)
        for module in PACKAGE.glob("*.py"):
            for name in names:
                self.assertNotIn(name, module.read_text())

    def test_imports_nothing_that_python_does_not_bring_but_numpy(self):
        allowed = {"__future__", "array", "collections", "contextlib", "ctypes", "numpy", "os", "signal", "sys",
                   "threading", "weakref"}
        for module in PACKAGE.glob("*.py"):
            for node in ast.walk(ast.parse(module.read_text())):
                if isinstance(node, ast.Import):
                    self.assertLessEqual({alias.name.split(".")[0] for alias in node.names}, allowed)
                elif isinstance(node, ast.ImportFrom) and not node.level:
                    self.assertIn(node.module.split(".")[0], allowed)

    def test_everything_public_has_a_docstring(self):
        program = ("import ductus, inspect\n"
                   "for name in ductus.__all__:\n"
                   "    thing = getattr(ductus, name)\n"
                   "    if callable(thing) and not inspect.getdoc(thing): print(name)\n")
        self.assertEqual(python(program, PACKAGE.parent), "")


if __name__ == "__main__":
    unittest.main()
