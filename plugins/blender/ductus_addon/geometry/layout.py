# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines in space laid out in the plane of a drawing, and put back with their depth."""

import numpy as np

from .lines import Course, Lines
from .planes import best_fit
from .ribbons import unroll

# A line whose points are farther from its plane than this share of its extent is not flat.
FLAT = 0.02


class Layout:
    """Where each line's points lie in the drawing, and how a place of the drawing lies in space.

    `plane` are the points in the drawing, `along` and `across` the directions in space of the drawing's axes at each
    point. A place of the drawing near a point of the old line is as far from that point in space as in the drawing,
    in these directions; so depth, and whatever else the drawing cannot hold, stays the old line's.
    """

    def __init__(self, lines, points, plane, along, across):
        self.lines, self.points = lines, points
        self.plane, self.along, self.across = plane, along, across
        self.course = Course(lines, plane, points)

    def put_back(self, found, offsets):
        """Points in space, `offsets` (drawing) away from the places that `course.find` found."""
        read = self.course.read
        return (read(self.points, found) + offsets[:, :1] * read(self.along, found)
                + offsets[:, 1:] * read(self.across, found))


def lay_out(counts, closed, points, method, axes=None):
    """Lays lines out.

    `points` in space, in the drawing's unit, in the object's own directions. `method` is "plane" (`axes`, for each
    line: right and down, lines x 2 x 3), "fit" (each line's own plane), "surface" (lines that are not flat are
    unrolled) or "auto" (the same, and what has to be closed or is flat gets its own plane).
    """
    lines = Lines(counts, closed)
    point_line = np.repeat(np.arange(len(lines)), lines.counts)
    flatness = np.zeros(len(lines))
    if method == "plane":
        right, down = axes[:, 0], axes[:, 1]
    else:
        right, down, flatness = best_fit(lines, points)
    along, across = right[point_line], down[point_line]
    plane = np.stack(((points * along).sum(axis=1), (points * across).sum(axis=1)), axis=1)
    if method in ("surface", "auto"):
        curved = (flatness > FLAT) & ~lines.closed & (lines.counts > 3)
        if curved.any():
            rows = curved[point_line]
            part = Lines(lines.counts[curved], lines.closed[curved])
            plane[rows], along[rows], across[rows] = unroll(part, points[rows], right[curved], down[curved])
    return Layout(lines, points, plane, along, across)
