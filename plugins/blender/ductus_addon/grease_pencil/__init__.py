# SPDX-License-Identifier: GPL-3.0-or-later
"""Grease Pencil, whichever generation Blender has.

All that the add-on knows of Grease Pencil passes through the module that `generation()` gives. Another generation is
one more module with the same names (see `legacy`):

    OBJECT_TYPE                    the type of its objects
    layers(ob)                     a list of Layer
    refuses(ob)                    a sentence where the object is in a state in which lines must not be changed, or None
    multiframe(ob)                 whether several drawings are being edited at once
    selecting(ob)                  whether lines can be selected in the object's mode
    any_selected(ob)               whether a line is, in the drawings that are shown or edited together
    pixel(ob)                      object units a pixel of line width
    read(ob, layer, number, selected, index)   the lines of a drawing that may be worked on, as Strokes
    fingerprints(ob, layer, number)   an integer for each line, which another shape hardly has
    write(todo)                    carries out pairs (object, its LayerPlans): all of them or nothing
    active_layer(ob), set_active_layer(ob, name), hide_layer(ob, name, hidden), remove_layer(ob, name)
    record(ob), set_record(ob, dictionary)   what the add-on remembers of an object, saved with it

`number` is the frame at which a drawing begins. Arrays hold all lines' points one behind the other.
"""

from typing import NamedTuple


class Layer(NamedTuple):
    """A layer, as it is now."""

    name: str
    locked: bool
    hidden: bool
    numbers: tuple  # frames at which drawings begin, ascending
    selected: frozenset  # those of them whose drawings are being edited together
    shown: int  # the frame of the drawing that is shown, or None
    matrix: object  # 4 x 4: from the layer's points to the world


class Strokes(NamedTuple):
    """The lines of a drawing that may be worked on."""

    index: tuple  # each line's place in the drawing
    counts: tuple  # its number of points
    closed: tuple
    kinds: tuple  # its material: lines of different kinds are different lines
    widths: tuple  # line width in pixels
    colors: tuple  # red, green, blue of the line, sRGB-encoded 0..1
    alignment: tuple  # what a point's rotation is measured from: "path", "object" or "none"
    points: dict  # of each attribute: an array of the points' values; at least "position" (n x 3)


class Change(NamedTuple):
    """A line gets other points."""

    index: int  # the line's place in the drawing
    points: dict  # attribute: array, as in Strokes
    color: tuple = None  # a colour for all points, where the line gets another


class Addition(NamedTuple):
    """A line that was not there; it takes after another of the same drawing."""

    like: int
    points: dict
    closed: bool
    color: tuple = None


class FramePlan(NamedTuple):
    """What happens to one drawing."""

    number: int
    base: int  # the drawing that it begins as: its own frame, or another's of which it becomes a copy
    changes: list
    additions: list
    removals: list  # places of lines that go


class LayerPlan(NamedTuple):
    """What happens to one layer."""

    layer: str
    target: str  # the same, or a name for the copy of the layer that is worked on instead
    frames: list  # of FramePlan
    drop: frozenset  # frames whose drawings go


class Refused(Exception):
    """A sentence: what cannot be done, where, and what to do."""


def generation():
    """The module for the Grease Pencil of the running Blender."""
    import bpy

    if hasattr(bpy.data, "grease_pencils_v3"):
        raise Refused("this Blender has Grease Pencil 3, which this add-on does not know yet: use Blender 3.3 to 4.2")
    from . import legacy

    return legacy
