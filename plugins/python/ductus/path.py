# SPDX-License-Identifier: GPL-3.0-or-later
"""Bezier paths: <ductus/path.h>."""
import ctypes

from . import _declarations as c
from ._library import Handle, call, load, take_text, text
from ._numbers import copied

MOVE, LINE, CUBIC, CLOSE = c.DUCT_PATH_MOVE, c.DUCT_PATH_LINE, c.DUCT_PATH_CUBIC, c.DUCT_PATH_CLOSE


class Nib:
    """A nib that follows a stroke's pose; see duct_nib_options."""

    def __init__(self, width=0, thinnest=0.3, thickest=1.7, aspect=1.5, fit_tolerance=0.1):
        self._options = c.duct_nib_options(width, thinnest, thickest, aspect, fit_tolerance)


def _nib(nib):
    return ctypes.byref(nib._options) if nib is not None else None


class Path(Handle):
    """Subpaths of straight lines and cubic curves."""
    _free = "duct_path_free"

    def __init__(self, d=None):
        super().__init__(self._make("duct_path_new", None))
        if d is not None:
            self.add_svg(d)

    def add_svg(self, d):
        """Appends the value of an SVG `d` attribute; an error in it ends the path there."""
        call("duct_path_add_svg", self._pointer, text(d))

    def move(self, x, y):
        load().duct_path_move(self._pointer, x, y)

    def line(self, x, y):
        load().duct_path_line(self._pointer, x, y)

    def cubic(self, x1, y1, x2, y2, x, y):
        load().duct_path_cubic(self._pointer, x1, y1, x2, y2, x, y)

    def close(self):
        load().duct_path_close(self._pointer)

    def clear(self):
        load().duct_path_clear(self._pointer)

    def map(self, matrix):
        """Maps all points by (a, b, c, d, e, f), SVG's matrix."""
        a, b, c_, d, e, f = matrix
        load().duct_path_map(self._pointer, (ctypes.c_double * 6)(a, b, c_, d, e, f))

    def flatten(self, id, tolerance, drawing):
        """Appends a stroke to the drawing for each subpath that draws something: `id`, `id`/2 ..."""
        call("duct_path_flatten", self._pointer, text(id), tolerance, drawing._pointer)

    def fit(self, stroke, tolerance):
        """Appends the stroke's line as one subpath with few nodes."""
        call("duct_path_fit", self._pointer, stroke._pointer, tolerance)

    def outline(self, stroke, nib=None):
        """Appends the outline of what the nib covers along the stroke."""
        call("duct_path_outline", self._pointer, stroke._pointer, _nib(nib))

    def widths(self, subpath, stroke, nib=None, tolerance=0.05):
        """The widths along subpath `subpath`, which fit() made of the stroke: a list of (place, full width)."""
        list_ = ctypes.POINTER(c.duct_width)()
        count = ctypes.c_size_t()
        call("duct_path_widths", None, self._pointer, subpath, stroke._pointer, _nib(nib), tolerance,
             ctypes.byref(list_), ctypes.byref(count))
        try:
            return [(place.at, place.width) for place in list_[:count.value]]
        finally:
            load().duct_memory_free(None, ctypes.cast(list_, ctypes.c_void_p))

    def svg(self, decimals=3):
        """The value of a `d` attribute."""
        return take_text("duct_path_svg", None, self._pointer, decimals)

    @property
    def nodes(self):
        """How many nodes an editor shows."""
        return load().duct_path_nodes(self._pointer)

    @property
    def verbs(self):
        """MOVE, LINE, CUBIC and CLOSE, one a step: unsigned bytes."""
        count = ctypes.c_size_t()
        return copied(load().duct_path_verbs(self._pointer, ctypes.byref(count)), count.value, "B")

    @property
    def points(self):
        """x, y, x, y ... of the points that the verbs take."""
        count = ctypes.c_size_t()
        return copied(load().duct_path_points(self._pointer, ctypes.byref(count)), 2 * count.value)
