# SPDX-License-Identifier: GPL-3.0-or-later
"""The parameters that are Inkscape's own: how the result of an operation becomes an element again. Everything else in the
dialogs comes from the operations' tables."""
from collections import namedtuple

# As ductus.Param, with the fields that a dialog needs.
LineParam = namedtuple("LineParam", "id label tooltip type minimum maximum default choices")
LineChoice = namedtuple("LineChoice", "id label tooltip")

WIDTHS = (
    LineChoice("outline", "Outline: a filled path that follows the pen",
               "The mark of a pen as one clean filled path: its size follows pressure, its angle and aspect the pen's "
               "tilt and rotation."),
    LineChoice("powerstroke", "PowerStroke: stays editable",
               "Inkscape's own Power Stroke path effect: the widths can be dragged with the node tool."),
    LineChoice("segments", "Segments: pieces of different width",
               "A group of plain strokes, each of one width: for plotters and programs without variable widths."),
    LineChoice("none", "Path shape only", "Keeps the stroke as it is; only the shape of the path changes."),
)

LINE = (
    LineParam("width_kind", "Width from the hand", "What becomes of the pressure that the hand gives to a line. Dashed "
              "lines keep their stroke and only change their shape.", "choice", 0, 0, "outline", WIDTHS),
    LineParam("width", "Line width (px, 0: the stroke's own)", "Full width at half pressure.", "real", 0, 10000, 0, ()),
    LineParam("thinnest", "Width at no pressure (share)", "Share of the line width where the pen is not pressed.", "real",
              0, 10, 0.3, ()),
    LineParam("thickest", "Width at full pressure (share)", "Share of the line width where the pen is pressed most.",
              "real", 0, 10, 1.7, ()),
    LineParam("aspect", "Nib: length over breadth", "1 is a round nib; more is a flat one that turns with the pen.",
              "real", 1, 20, 1.5, ()),
    LineParam("tolerance", "Tolerance (px)", "How far the fitted curves may lie from the hand's line: more gives fewer "
              "nodes.", "real", 0.001, 100, 0.2, ()),
    LineParam("report", "Report the number of nodes", "Says in a message how many nodes there were and are, and what "
              "text was left alone.", "bool", 0, 0, False, ()),
)

LINE_IDS = tuple(param.id for param in LINE)
