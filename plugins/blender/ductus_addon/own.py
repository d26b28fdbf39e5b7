# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on's own values: what an operation works on, in which plane, and where the result goes.

They are written down here once, with the same fields as the parameters of the operations; properties, panel and presets
are made from this table as from the operations'.
"""

from typing import NamedTuple


class Choice(NamedTuple):
    id: str
    label: str
    tooltip: str


class Own(NamedTuple):
    id: str
    label: str
    tooltip: str
    type: str
    default: str
    choices: tuple = ()
    minimum: float = 0
    maximum: float = 0
    step: float = 0
    unit: str = ""
    group: str = "Grease Pencil"
    advanced: bool = False
    needs: tuple = ()  # (id, values): shown as active only where that value is one of these


LINES, TIME, PEN = "Grease Pencil", "Animation", "Pen"

OWN = (
    Own("apply-to", "Lines", "Which lines are worked on. Locked and hidden layers and materials are left alone",
        "choice", "auto", (
            Choice("auto", "Selection or Object", "The selected lines in Edit Mode where there are any, else all lines"),
            Choice("selected", "Selected Lines", "The selected lines of all layers"),
            Choice("layer", "Active Layer", "All lines of the active layer"),
            Choice("object", "Object", "All lines of the active object"),
            Choice("objects", "Selected Objects", "All lines of all selected Grease Pencil objects"),
        ), group=LINES),
    Own("result", "Result", "Where the new lines go", "choice", "in-place", (
            Choice("in-place", "In Place", "The lines themselves are changed"),
            Choice("new-layer", "New Layer", "A copy of the layer is changed and the original hidden. Running again "
                   "starts from the original; Restore Original brings it back"),
        ), group=LINES),
    Own("plane", "Plane", "In which plane a line is worked on. Its depth stays", "choice", "auto", (
            Choice("auto", "Own Plane", "The plane that fits each line best; lines on curved surfaces are unrolled"),
            Choice("drawing", "Drawing Plane", "The Drawing Plane of the 3D viewport's header"),
            Choice("view", "View", "As the lines are seen in the 3D viewport, or by the camera"),
            Choice("front", "Front (X-Z)", "The object's own X-Z plane"),
            Choice("side", "Side (Y-Z)", "The object's own Y-Z plane"),
            Choice("top", "Top (X-Y)", "The object's own X-Y plane"),
            Choice("fit", "Best Fit", "The plane that fits each line best, for curved lines as well"),
            Choice("surface", "Surface", "Every line that is not flat is unrolled along itself"),
        ), group=LINES),

    Own("frames", "Frames", "Which drawings are worked on", "choice", "current", (
            Choice("current", "Current Drawing", "The drawing that is shown; with Multiframe, all selected drawings"),
            Choice("scene", "Scene Range", "The drawings that begin within the scene's frame range (the preview range "
                   "where one is set)"),
            Choice("range", "Range", "The drawings that begin within a range of frames"),
            Choice("all", "All Drawings", "All drawings"),
        ), group=TIME),
    Own("frame-start", "Start", "First frame of the range", "int", "1", (), -1048574, 1048574, 1, group=TIME,
        needs=("frames", ("range",))),
    Own("frame-end", "End", "Last frame of the range", "int", "250", (), -1048574, 1048574, 1, group=TIME,
        needs=("frames", ("range",))),
    Own("seeds", "Over Time", "How chance goes along with time", "choice", "still", (
            Choice("still", "Still", "The same choices in all drawings"),
            Choice("boil", "Boil", "New choices every few frames; drawings that are held longer get keyframes for it"),
        ), group=TIME, needs=("frames", ("scene", "range", "all"))),
    Own("boil-frames", "Boil Every", "Frames between new choices", "int", "2", (), 1, 1000, 1, "frames", group=TIME,
        needs=("seeds", ("boil",))),
    Own("coherence", "Coherence", "How much a line may change its shape from drawing to drawing, as a share of its size, "
        "and keep the choices that were made for it", "real", "0.1", (), 0, 1, 0.01, group=TIME,
        needs=("frames", ("scene", "range", "all"))),

    Own("thinnest", "Thinnest", "Line width at no pressure, as a share of the line's own", "real", "0.3", (), 0, 1, 0.05,
        group=PEN, advanced=True),
    Own("thickest", "Thickest", "Line width at full pressure, as a share of the line's own", "real", "1.7", (), 1, 10,
        0.05, group=PEN, advanced=True),
    Own("strength", "Strength", "How far light pressure lowers the strength of a line; 0 leaves it alone", "real", "0.15",
        (), 0, 1, 0.05, group=PEN, advanced=True),
    Own("nib-aspect", "Nib Aspect", "Length of the nib beside its breadth: 1 is round, more makes the width of a line "
        "follow its direction, as a broad nib's does", "real", "1", (), 1, 20, 0.1, group=PEN, advanced=True),
    Own("rotation", "Rotation", "Set the rotation of the points from the nib's angle", "bool", "true", group=PEN,
        advanced=True),
)
