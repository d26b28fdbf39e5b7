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
    if values is None or isinstance(values, str):       # numpy makes numbers of them
        raise TypeError(f"numbers are needed, not {values!r}")
    if numpy is not None:
        made = numpy.ascontiguousarray(values, dtype=numpy.float64).reshape(-1)
        return made, made.ctypes.data, made.size
    if not (isinstance(values, array.array) and values.typecode == "d"):
        try:
            view = memoryview(values)
        except TypeError:
            values = array.array("d", values)       # a sequence of numbers
        else:
            if view.format == "d":
                values = array.array("d")
                values.frombytes(view.tobytes())
            else:
                values = array.array("d", view.tolist())
    address, length = values.buffer_info()
    return values, address, length


def copied(address, count, code="d", shape=None):
    """A copy of `count` numbers at an address; `shape`: of the numpy array, for those who have it."""
    if numpy is not None:
        made = numpy.empty(count, dtype=numpy.dtype(code))
        into = made.ctypes.data
    else:
        made = array.array(code, bytes(count * array.array(code).itemsize))
        into = made.buffer_info()[0]
    if count:
        ctypes.memmove(into, address, made.nbytes if numpy is not None else count * made.itemsize)
    return made.reshape(shape) if numpy is not None and shape is not None else made
