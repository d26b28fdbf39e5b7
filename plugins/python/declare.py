#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the ctypes declarations of libductus from its public headers: declare.py HEADER... > _declarations.py

The headers are plain C of a few forms (see docs/contributing.md): enums, structs, opaque structs, function types and
functions that begin with DUCT_API. Anything else in them stops the build with the line that was not understood, so the
binding cannot drift from the library.
"""
import re
import sys

SCALARS = {
    "bool": "c_bool", "char": "c_char", "unsigned char": "c_ubyte", "int": "c_int", "long": "c_long",
    "float": "c_float", "double": "c_double", "size_t": "c_size_t",
    "uint8_t": "c_ubyte", "uint16_t": "c_uint16", "uint64_t": "c_uint64",
}


class Header:
    """What the headers declare, in order."""

    def __init__(self):
        self.constants = []   # (name, value)
        self.enums = {}       # name -> [(enumerator, value)]
        self.opaque = set()
        self.structs = {}     # name -> [(field, type)]
        self.callbacks = {}   # name -> (result, [argument])
        self.functions = {}   # name -> (result, [argument])

    def ctype(self, text, argument=False):
        """The ctypes expression of a C type; `argument`: where an array is a pointer to its first element."""
        text = re.sub(r"\s+", " ", text).strip()
        array = re.search(r"\[(\w+)\]$", text)
        if array:
            inner = self.ctype(text[:array.start()])
            return f"POINTER({inner})" if argument else f"{inner} * {array.group(1)}"
        stars = text.count("*")
        constant = text.startswith("const ")
        base = re.sub(r"\bconst\b|\bstruct\b|\*", " ", text)
        base = re.sub(r"\s+", " ", base).strip()
        if base == "void" and stars == 0:
            return "None"
        if base == "char" and stars:
            # Text that the caller has to free keeps its address; other text arrives as bytes.
            owned = stars > 1 and not constant
            made = "c_void_p" if owned or (stars == 1 and not constant) else "c_char_p"
            stars -= 1
        elif base == "void" or base in self.opaque:
            made = "c_void_p"
            stars -= 1
        elif base in self.enums:
            made = "c_int"
        elif base in self.callbacks or base in self.structs:
            made = base
        elif base in SCALARS:
            made = SCALARS[base]
        else:
            raise SystemExit(f"declare.py: no ctypes type is known for '{text}'")
        for _ in range(stars):
            made = f"POINTER({made})"
        return made


def split_declarator(text):
    """'const double *points[4]' -> ('const double *[4]', 'points')."""
    match = re.match(r"(.*?)(\w+)\s*((?:\[\w*\])?)$", text.strip(), re.S)
    if not match:
        raise SystemExit(f"declare.py: '{text}' is no declaration")
    kind, name, array = match.groups()
    if not kind.strip():            # a type without a name
        return text.strip() + array, ""
    return kind.strip() + array, name


def arguments(header, text):
    text = text.strip()
    if text in ("", "void"):
        return []
    found = []
    for part in text.split(","):
        kind, _ = split_declarator(part)
        found.append(header.ctype(kind, argument=True))
    return found


def fields(header, text):
    found = []
    for line in text.split(";"):
        line = line.strip()
        if not line:
            continue
        pointer = re.match(r"(.*?)\(\*(\w+)\)\((.*)\)$", line, re.S)
        if pointer:
            result, name, args = pointer.groups()
            signature = ", ".join([header.ctype(result)] + arguments(header, args))
            found.append((name, f"CFUNCTYPE({signature})"))
            continue
        first, *more = line.split(",")
        kind, name = split_declarator(first)
        found.append((name, header.ctype(kind)))
        base = re.sub(r"\*|\[\w+\]", "", kind)
        for other in more:
            stars, other_name = re.match(r"\s*(\**)\s*(\w+)$", other).groups()
            found.append((other_name, header.ctype(base + stars)))
    return found


def enumerators(header, text):
    """Takes up the constants of an enum's body and returns them."""
    value, found = -1, []
    for part in text.split(","):
        part = part.strip()
        if not part:
            continue
        name, _, given = (piece.strip() for piece in part.partition("="))
        value = eval(given, {"__builtins__": {}}, dict(header.constants)) if given else value + 1
        header.constants.append((name, value))
        found.append((name, value))
    return found


STATEMENTS = [
    (r"typedef enum (?P<name>\w+) \{(?P<body>[^}]*)\} (?P=name);", "enum"),
    (r"enum \{(?P<body>[^}]*)\};", "constants"),
    (r"typedef struct (?P<name>\w+) \{(?P<body>[^}]*)\} (?P=name);", "struct"),
    (r"typedef struct (?P<name>\w+) (?P=name);", "opaque"),
    (r"typedef (?P<result>[^;()]*)\(\*(?P<name>\w+)\)\((?P<args>[^;]*?)\);", "callback"),
    (r"DUCT_API (?P<result>[^;()]*?)(?P<name>duct_\w+)\((?P<args>[^;]*?)\);", "function"),
]


def read(header, text, path):
    text = re.sub(r"/\*.*?\*/", " ", text, flags=re.S)
    text = re.sub(r"^\s*#(?:[^\n]*\\\n)*[^\n]*$", " ", text, flags=re.M)
    text = re.sub(r'extern "C" \{', " ", text)
    text = re.sub(r"\s+", " ", text).strip()
    while text and text != "}":
        for pattern, kind in STATEMENTS:
            match = re.match(pattern, text)
            if match:
                break
        else:
            raise SystemExit(f"declare.py: {path}: not understood: {text[:100]}")
        name = match.groupdict().get("name")
        if kind == "enum":
            header.enums[name] = enumerators(header, match["body"])
        elif kind == "constants":
            enumerators(header, match["body"])
        elif kind == "struct":
            header.structs[name] = []    # a struct may point to itself
            header.structs[name] = fields(header, match["body"])
        elif kind == "opaque":
            header.opaque.add(name)
        else:
            table = header.callbacks if kind == "callback" else header.functions
            table[name] = (header.ctype(match["result"]), arguments(header, match["args"]))
        text = text[match.end():].strip()


def ordered(paths):
    """The headers, each after those that it includes."""
    texts = {re.sub(r".*/|\.in$", "", path): (path, open(path, encoding="utf-8").read()) for path in paths}
    done = []

    def visit(name):
        if name in texts and name not in done:
            for other in re.findall(r"#include <ductus/(\w+\.h)>", texts[name][1]):
                visit(other)
            if name not in done:
                done.append(name)

    for name in sorted(texts):
        visit(name)
    return [texts[name] for name in done]


def main():
    header = Header()
    version = ""
    for path, text in ordered(sys.argv[1:]):
        given = re.search(r'#define DUCT_VERSION "(.*)"', text)
        version = given.group(1) if given else version
        if path.endswith("export.h"):
            continue    # macros alone
        read(header, text, path)
    out = ["# SPDX-License-Identifier: GPL-3.0-or-later",
           '"""Generated from the headers of libductus by declare.py; not to be edited."""',
           "from ctypes import (CFUNCTYPE, POINTER, Structure, c_bool, c_char, c_char_p, c_double, c_float, c_int,",
           "                    c_long, c_size_t, c_ubyte, c_uint16, c_uint64, c_void_p)", ""]
    if not version:
        raise SystemExit("declare.py: no header defines DUCT_VERSION")
    out.append(f'VERSION = "{version}"')
    out += [f"{name} = {value}" for name, value in header.constants]
    out += ["", "ENUMS = {"]
    for name, values in header.enums.items():
        out.append(f'    "{name}": {{')
        out.extend(f'        "{enumerator}": {value},' for enumerator, value in values)
        out.append("    },")
    out.append("}")
    declared = set()

    def needed(text):
        return [word for word in re.findall(r"\w+", text)
                if (word in header.structs or word in header.callbacks) and word not in declared]

    def emit_callback(name):
        result, args = header.callbacks[name]
        for other in needed(" ".join(args + [result])):
            emit(other)
        out.append("")
        out.append(f"{name} = CFUNCTYPE({', '.join([result] + args)})")

    def emit_struct(name):
        for _, kind in header.structs[name]:
            for other in needed(kind):
                if other != name:
                    emit(other)
        out.extend(["", "", f"class {name}(Structure):", "    _fields_ = ["])
        out.extend(f'        ("{field}", {kind}),' for field, kind in header.structs[name])
        out.append("    ]")

    def emit(name):
        if name in declared:
            return
        if name in header.callbacks:
            emit_callback(name)
        else:
            emit_struct(name)
        declared.add(name)

    for name in list(header.callbacks) + list(header.structs):
        emit(name)
    out.extend(["", "", "FUNCTIONS = {"])
    for name, (result, args) in sorted(header.functions.items()):
        out.append(f'    "{name}": ({result}, [{", ".join(args)}]),')
    out.extend(["}", ""])
    print("\n".join(out))


if __name__ == "__main__":
    main()
