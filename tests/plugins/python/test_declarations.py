# SPDX-License-Identifier: GPL-3.0-or-later
"""The generated declarations against what a compiler makes of the same headers: layouts and types of all structs,
values of all constants, results and arguments of all functions.

The compiler is a C++ one, because its templates tell the types; it reads the headers by itself, so that a fault of the
generator is seen as well as headers that have changed."""

import ctypes
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from ductus import _declarations as c

SOURCE = pathlib.Path(os.environ["DUCTUS_SOURCE"])
BUILD = pathlib.Path(os.environ["DUCTUS_BUILD"])
HEADERS = [*sorted((SOURCE / "core/include/ductus").glob("*.h")), BUILD / "include/ductus/version.h"]
STRUCTS = {name: kind for name, kind in vars(c).items()
           if isinstance(kind, type) and issubclass(kind, ctypes.Structure) and kind is not ctypes.Structure}
CALLBACKS = {name: kind for name, kind in vars(c).items()
             if name.startswith("duct_") and hasattr(kind, "_argtypes_")}
CONSTANTS = {name: value for name, value in vars(c).items() if name.startswith("DUCT_") and isinstance(value, int)}

# kind<T>() spells a type as kind() below spells one of ctypes: numbers by their sort and size, pointers by what they
# point to. What Python sees as an address alone (opaque structs, void, text that the caller frees) is one kind.
PROBE = r"""
#include <ductus/ductus.h>
#include <cstddef>
#include <cstdio>
#include <string>
#include <type_traits>

template <class T> struct Named;
template <class T, class = void> struct Complete : std::false_type {};
template <class T> struct Complete<T, decltype(void(sizeof(T)))> : std::true_type {};

template <class T> struct Kind {
    static std::string text()
    {
        if constexpr (std::is_void_v<T>)
            return "void";
        else if constexpr (std::is_same_v<T, bool>)
            return "bool";
        else if constexpr (std::is_same_v<T, char>)
            return "char";
        else if constexpr (std::is_enum_v<T>)
            return "i" + std::to_string(sizeof(T));
        else if constexpr (std::is_floating_point_v<T>)
            return "f" + std::to_string(sizeof(T));
        else if constexpr (std::is_integral_v<T>)
            return (std::is_signed_v<T> ? "i" : "u") + std::to_string(sizeof(T));
        else
            return Named<T>::text();
    }
};
template <class T> struct Kind<const T> : Kind<T> {};
template <class T, std::size_t N> struct Kind<T[N]> {
    static std::string text() { return Kind<T>::text() + "[" + std::to_string(N) + "]"; }
};
template <class T> struct Kind<T *> {
    static std::string text()
    {
        if constexpr (std::is_same_v<T, const char>)
            return "text";
        else if constexpr (std::is_same_v<T, char> || std::is_void_v<T> || !Complete<T>::value)
            return "address";
        else
            return "*" + Kind<T>::text();
    }
};
template <class R, class... A> struct Kind<R (*)(A...)> {
    static std::string text()
    {
        std::string arguments;
        ((arguments += " " + Kind<A>::text()), ...);
        return Kind<R>::text() + " (" + arguments + " )";
    }
};
"""


def kind(declared):
    """How a type of ctypes is spelled."""
    if declared is None:
        return "void"
    if hasattr(declared, "_argtypes_"):
        arguments = "".join(" " + kind(argument) for argument in declared._argtypes_)
        return f"{kind(declared._restype_)} ({arguments} )"
    if issubclass(declared, ctypes.Structure):
        return declared.__name__
    if issubclass(declared, ctypes.Array):
        return f"{kind(declared._type_)}[{declared._length_}]"
    code = declared._type_
    if not isinstance(code, str):
        return "*" + kind(code)
    fixed = {"?": "bool", "c": "char", "z": "text", "P": "address"}
    return fixed.get(code) or f"{'f' if code in 'fd' else 'u' if code.isupper() or code == 'B' else 'i'}" \
                              f"{ctypes.sizeof(declared)}"


def declared_facts():
    facts = {name: str(value) for name, value in CONSTANTS.items()}
    for name, struct in STRUCTS.items():
        facts[name] = str(ctypes.sizeof(struct))
        for field, of in struct._fields_:
            facts[f"{name}.{field}"] = f"{getattr(struct, field).offset} {kind(of)}"
    facts.update({name: kind(callback) for name, callback in CALLBACKS.items()})
    for name, (result, arguments) in c.FUNCTIONS.items():
        facts[name] = f"{kind(result)} ({''.join(' ' + kind(argument) for argument in arguments)} )"
    return facts


def compiled_facts(include, folder):
    """What the compiler says of the same names, with the headers in `include`."""
    lines = []
    for name in CONSTANTS:
        lines.append(f'std::printf("{name}|%lld\\n", (long long){name});')
    for name, struct in STRUCTS.items():
        lines.append(f'std::printf("{name}|%zu\\n", sizeof({name}));')
        for field, _ in struct._fields_:
            lines.append(f'std::printf("{name}.{field}|%zu %s\\n", offsetof({name}, {field}), '
                         f"Kind<decltype({name}::{field})>::text().c_str());")
    for name in CALLBACKS:
        lines.append(f'std::printf("{name}|%s\\n", Kind<{name}>::text().c_str());')
    for name in c.FUNCTIONS:
        lines.append(f'std::printf("{name}|%s\\n", Kind<decltype(&{name})>::text().c_str());')
    named = "".join(f'template <> struct Named<{name}> {{ static std::string text() {{ return "{name}"; }} }};\n'
                    for name in STRUCTS)
    source = pathlib.Path(folder, "probe.cpp")
    source.write_text(PROBE + named + "int main()\n{\n" + "\n".join(lines) + "\n}\n")
    subprocess.run([os.environ.get("CXX", "c++"), "-std=c++17", *(f"-I{place}" for place in include), source, "-o",
                    f"{folder}/probe"], check=True)
    printed = subprocess.run([f"{folder}/probe"], capture_output=True, text=True, check=True).stdout
    return dict(line.split("|") for line in printed.splitlines())


def declare(headers):
    return subprocess.run([sys.executable, SOURCE / "plugins/python/declare.py", *headers], capture_output=True,
                          text=True, check=False)


class Declarations(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="ductus-declarations-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def changed_headers(self, changes):
        """A copy of the headers with the text of some changed: (file, old text, new text)."""
        place = self.folder / "include/ductus"
        place.mkdir(parents=True)
        for header in HEADERS:
            shutil.copy(header, place)
        for name, old, new in changes:
            text = (place / name).read_text()
            self.assertEqual(text.count(old), 1, old)
            (place / name).write_text(text.replace(old, new))
        return sorted(place.glob("*.h"))

    def test_they_are_what_the_compiler_makes_of_the_headers(self):
        declared = declared_facts()
        self.assertGreater(len(STRUCTS), 15)
        self.assertGreater(len(CONSTANTS), 40)
        self.assertGreater(len(CALLBACKS), 1)
        self.assertEqual(declared, compiled_facts([SOURCE / "core/include", BUILD / "include"], self.folder))

    def test_every_exported_function_is_declared_and_no_other(self):
        symbols = subprocess.run(["nm", "-D", "--defined-only", BUILD / "lib" / "libductus.so"], capture_output=True,
                                 text=True, check=True).stdout.split()
        self.assertEqual({name for name in symbols if name.startswith("duct_")}, set(c.FUNCTIONS))

    def test_every_constant_and_type_is_declared(self):
        words = set()
        for header in HEADERS:
            text = re.sub(r"/\*.*?\*/", " ", header.read_text(), flags=re.S)
            words.update(re.findall(r"\b(?:DUCT_[A-Z0-9_]+|duct_\w+)\b", re.sub(r"^\s*#.*$", " ", text, flags=re.M)))
        constants = {word for word in words if word.startswith("DUCT_")} - {"DUCT_API"}
        self.assertEqual(constants, set(CONSTANTS))
        # The rest are opaque structs, of which the declarations know no more than that they are addresses.
        rest = words - constants - {"DUCT_API"} - set(c.FUNCTIONS) - set(STRUCTS) - set(CALLBACKS) - set(c.ENUMS)
        headers = "".join(header.read_text() for header in HEADERS)
        self.assertEqual([name for name in sorted(rest) if f"typedef struct {name} {name};" not in headers], [])

    def test_the_generator_gives_the_package_its_declarations(self):
        self.assertEqual(declare(HEADERS).stdout, pathlib.Path(c.__file__).read_text())

    def test_a_header_that_changes_is_noticed(self):
        headers = self.changed_headers([
            ("path.h", "duct_path_line(duct_path *path, double x, double y)",
             "duct_path_line(duct_path *path, float x, double y)"),
            ("path.h", "duct_path_clear(duct_path *path)", "duct_path_clear(duct_path *path, int how)"),
            ("path.h", "size_t duct_path_nodes", "int duct_path_nodes"),
            ("status.h", "DUCT_IO, ", "DUCT_NEW, DUCT_IO, "),
            ("image.h", "int bits;", "float bits;"),
            ("context.h", "duct_progress)(void *user, double", "duct_progress)(void *user, float"),
        ])
        declared, compiled = declared_facts(), compiled_facts([self.folder / "include"], self.folder)
        changed = {name for name in declared if declared[name] != compiled[name]}
        self.assertGreaterEqual(changed, {"duct_path_line", "duct_path_clear", "duct_path_nodes", "DUCT_IO",
                                          "duct_image_options.bits", "duct_progress"})
        self.assertNotIn("duct_path_move", changed)
        # And the generator follows.
        made = declare(headers)
        self.assertEqual(made.returncode, 0, made.stderr)
        self.assertIn('"duct_path_line": (None, [c_void_p, c_float, c_double])', made.stdout)
        self.assertIn("DUCT_NEW = 4", made.stdout)

    def test_what_the_generator_does_not_understand_stops_it(self):
        for old, new, word in (
                ("DUCT_API void duct_path_clear(duct_path *path);", "extern int duct_path_colour;", "duct_path_colour"),
                ("DUCT_API void duct_path_clear(duct_path *path);", "DUCT_API void duct_path_clear(complex *path);",
                 "complex"),
                ("DUCT_API void duct_path_clear(duct_path *path);", "union duct_path_union { int a; };", "union"),
                ("double width; /* full width, drawing pixels */", "double width[2][2];", "width")):
            with self.subTest(new):
                made = declare(self.changed_headers([("path.h", old, new)]))
                self.assertNotEqual(made.returncode, 0)
                self.assertEqual(made.stdout, "")
                self.assertEqual(len(made.stderr.splitlines()), 1, made.stderr)
                self.assertIn(word, made.stderr)
                shutil.rmtree(self.folder / "include")


if __name__ == "__main__":
    unittest.main()
