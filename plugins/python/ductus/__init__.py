# SPDX-License-Identifier: GPL-3.0-or-later
"""Ductus: drawing with somebody's hand. The Python binding of libductus.

    import ductus
    settings = ductus.Settings(ductus.operations()[0].id)
    settings["hand"] = ductus.hands()[0].name
    ductus.run(settings, ductus.Drawing.read("drawing.svg")).write("out.svg")

The C headers are the manual for meaning, units and limits; what can fail raises Error with the library's sentence. numpy
is used where it is there and not needed.
"""
from ._library import Cancelled, Error, Missing, load, string as _string
from .drawing import CHANNELS, Drawing, Stroke, brushes, render
from .operation import (Choice, Hand, Library, Operation, Param, Preset, Settings, hands, operations, run)
from .path import CLOSE, CUBIC, LINE, MOVE, Nib, Path


def version():
    """The version of libductus."""
    return _string(load().duct_version())


__all__ = ["CHANNELS", "CLOSE", "CUBIC", "Cancelled", "Choice", "Drawing", "Error", "Hand", "LINE", "Library", "MOVE",
           "Missing", "Nib", "Operation", "Param", "Path", "Preset", "Settings", "Stroke", "brushes", "hands", "load",
           "operations", "render", "run", "version"]
