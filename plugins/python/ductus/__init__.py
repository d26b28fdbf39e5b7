# SPDX-License-Identifier: GPL-3.0-or-later
"""Ductus: drawing with somebody's hand. The Python binding of libductus.

    import ductus
    settings = ductus.Settings(ductus.operations()[0].id)
    settings["hand"] = ductus.hands()[0].name
    ductus.run(settings, ductus.Drawing.read("drawing.svg")).write("out.svg")

The C headers are the manual for meaning, units and limits; what can fail raises Error with the library's sentence.
numpy is used where it is there and not needed.
"""
from ._library import Cancelled, Error, Missing, load, string as _string
from .drawing import CHANNELS, LINE_STYLES, Drawing, Format, Stroke, formats
from .library import Hand, Library, hands
from .operation import Choice, Operation, Param, Preset, Settings, operations, run
from .path import CLOSE, CUBIC, LINE, MOVE, Nib, Path
from .render import TILE_SIZE, Brush, Canvas, brushes, render


def version():
    """The version of libductus."""
    return _string(load().duct_version())


__all__ = ["Brush", "CHANNELS", "CLOSE", "CUBIC", "Cancelled", "Canvas", "Choice", "Drawing", "Error", "Format",
           "Hand", "LINE", "LINE_STYLES", "Library", "MOVE", "Missing", "Nib", "Operation", "Param", "Path", "Preset",
           "Settings", "Stroke", "TILE_SIZE", "brushes", "formats", "hands", "load", "operations", "render", "run",
           "version"]
