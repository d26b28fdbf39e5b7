# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays of numbers to and from C, as numpy arrays where numpy is there and as array.array where it is not."""
import array
import ctypes

try:
    import numpy
except ImportError:
    numpy = None


def doubles(values):
    """(an object that keeps the memory, its address, its length) of float64 numbers; copied only where they are not
    that already."""
    if numpy is not None:
        made = numpy.ascontiguousarray(values, dtype=numpy.float64).reshape(-1)
        return made, made.ctypes.data, made.size
    if not (isinstance(values, array.array) and values.typecode == "d"):
        try:
            view = memoryview(values)
            if view.format == "d" and view.contiguous:
                made = array.array("d")
                made.frombytes(view.tobytes())
                values = made
            else:
                values = array.array("d", view.tolist())
        except TypeError:
            values = array.array("d", values)
    address, length = values.buffer_info()
    return values, address, length


def copied(address, count, code="d"):
    """A copy of `count` numbers at an address."""
    size = count * array.array(code).itemsize
    raw = ctypes.string_at(address, size) if count else b""
    if numpy is not None:
        return numpy.frombuffer(bytearray(raw), dtype={"d": numpy.float64, "f": numpy.float32, "B": numpy.uint8,
                                                       "H": numpy.uint16}[code])
    made = array.array(code)
    made.frombytes(raw)
    return made
