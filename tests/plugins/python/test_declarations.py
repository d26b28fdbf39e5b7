# SPDX-License-Identifier: GPL-3.0-or-later
"""The generated declarations against what the C compiler makes of the same headers: sizes and offsets of all structs,
values of all constants, and the types of all functions."""

import ctypes
import os
import pathlib
import subprocess
import tempfile
import unittest

from ductus import _declarations as c

SOURCE = pathlib.Path(os.environ["DUCTUS_SOURCE"])
BUILD = pathlib.Path(os.environ["DUCTUS_BUILD"])
INCLUDE = [f"-I{SOURCE}/core/include", f"-I{BUILD}/include"]
STRUCTS = {name: kind for name, kind in vars(c).items()
           if isinstance(kind, type) and issubclass(kind, ctypes.Structure) and kind is not ctypes.Structure}
CONSTANTS = {name: value for name, value in vars(c).items() if name.startswith("DUCT_") and isinstance(value, int)}


def compiled(body):
    """What a program with the headers prints."""
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder, "probe.c")
        source.write_text("#include <ductus/ductus.h>\n#include <stddef.h>\n#include <stdio.h>\n"
                          "int main(void)\n{\n" + body + "return 0;\n}\n")
        subprocess.run([os.environ.get("CC", "cc"), "-std=c11", *INCLUDE, source, "-o", f"{folder}/probe"], check=True)
        return subprocess.run([f"{folder}/probe"], capture_output=True, text=True, check=True).stdout.splitlines()


class Declarations(unittest.TestCase):
    def test_structs_have_the_compilers_layout(self):
        self.assertGreater(len(STRUCTS), 15)
        lines, expected = [], []
        for name, kind in STRUCTS.items():
            lines.append(f'printf("{name} %zu\\n", sizeof({name}));')
            expected.append(f"{name} {ctypes.sizeof(kind)}")
            for field, _ in kind._fields_:
                lines.append(f'printf("{name}.{field} %zu %zu\\n", offsetof({name}, {field}), '
                             f"sizeof((({name} *)0)->{field}));")
                place = getattr(kind, field)
                expected.append(f"{name}.{field} {place.offset} {place.size}")
        self.assertEqual(compiled("\n".join(lines)), expected)

    def test_constants_have_the_compilers_values(self):
        self.assertGreater(len(CONSTANTS), 40)
        lines = [f'printf("%lld\\n", (long long){name});' for name in CONSTANTS]
        self.assertEqual([int(line) for line in compiled("\n".join(lines))], list(CONSTANTS.values()))

    def test_every_exported_function_is_declared_and_no_other(self):
        symbols = subprocess.run(["nm", "-D", "--defined-only", BUILD / "lib" / "libductus.so"], capture_output=True,
                                 text=True, check=True).stdout.split()
        exported = {name for name in symbols if name.startswith("duct_")}
        self.assertEqual(exported, set(c.FUNCTIONS))

    def test_functions_take_what_the_compiler_takes(self):
        """Each is called in a sizeof with arguments of the declared types: the compiler counts and checks them."""
        names = {ctypes.c_bool: "bool", ctypes.c_int: "int", ctypes.c_double: "double", ctypes.c_size_t: "size_t",
                 ctypes.c_uint64: "uint64_t", ctypes.c_char_p: "char *", ctypes.c_void_p: "void *"}

        def spelled(kind):
            if kind in names:
                return names[kind]
            if issubclass(kind, ctypes.Structure):
                return kind.__name__
            return "void *"

        lines = []
        for name, (result, arguments) in c.FUNCTIONS.items():
            values = ", ".join(f"*({spelled(kind)} *)0" for kind in arguments)
            call = f"{name}({values})"
            if result is None:
                lines.append(f"_Static_assert(_Generic(&{name}, default: 1), \"\"); if (0) {{ {call}; }}")
            else:
                lines.append(f'printf("{name} %zu\\n", sizeof({call}));')
        printed = dict(line.split() for line in compiled("\n".join(lines)))
        for name, (result, _) in c.FUNCTIONS.items():
            if result is not None:
                self.assertEqual(int(printed[name]), ctypes.sizeof(result), name)


if __name__ == "__main__":
    unittest.main()
