# SPDX-License-Identifier: GPL-3.0-or-later
"""Many polylines in one array: arc lengths, places along them, and values read off at places."""

import numpy as np


class Lines:
    """Polylines that stand one behind the other in one array.

    `counts` are the lines' numbers of points, `closed` tells which of them run back to their first point. For
    arithmetic every closed line gets its first point once more at its end: `index` are the rows of the callers'
    arrays in that order, `first` and `last` the positions in `index` where each line begins and ends, and `line` the
    line that each position belongs to. Empty lines have `last` = `first` - 1.
    """

    def __init__(self, counts, closed):
        self.counts = np.asarray(counts, dtype=np.intp)
        self.closed = np.asarray(closed, dtype=bool) & (self.counts > 2)
        self.offset = np.concatenate(([0], np.cumsum(self.counts)))[:-1]
        sizes = self.counts + self.closed
        self.first = np.concatenate(([0], np.cumsum(sizes)))[:-1].astype(np.intp)
        self.last = self.first + sizes - 1
        self.line = np.repeat(np.arange(len(self.counts)), sizes)
        self.index = np.arange(int(sizes.sum())) - np.repeat(self.first - self.offset, sizes)
        ends = self.last[self.closed]
        self.index[ends] = self.offset[self.closed]

    def __len__(self):
        return len(self.counts)

    @property
    def inner(self):
        """True at each position that has a next one on the same line: the segments, by where they begin."""
        inner = np.ones(len(self.index), dtype=bool)
        inner[self.last[self.counts > 0]] = False
        return inner

    def steps(self, points):
        """The vector to the next point of the same line, for each position; 0 at a line's end."""
        steps = np.zeros((len(self.index), points.shape[1]))
        placed = points[self.index]
        if len(placed) > 1:
            steps[:-1] = placed[1:] - placed[:-1]
        steps[~self.inner] = 0
        return steps

    def sums(self, values):
        """The sum of `values` (one for each position) over each line; what it is does not depend on other lines."""
        sums = np.zeros((len(self),) + values.shape[1:], dtype=values.dtype)
        full = self.last >= self.first
        if full.any():
            sums[full] = np.add.reduceat(values, self.first[full], axis=0)
        return sums

    def running(self, values):
        """The sum of the values before each position on its own line."""
        total = np.cumsum(values, axis=0) - values
        start = np.zeros((len(self),) + values.shape[1:])
        full = self.last >= self.first
        start[full] = total[self.first[full]]
        return total - start[self.line]


class Course:
    """How far along its line each point lies, and what is found at other places.

    A place is a distance along the line that it belongs to; all lines share one axis, on which they follow each other
    with gaps, so that one search serves them all. `plane` are the points in drawing pixels; where they coincide there
    though they differ in depth (a line seen end on), a trace of `spatial` lengths keeps their order.
    """

    def __init__(self, lines, plane, spatial=None):
        self.lines = lines
        lengths = np.linalg.norm(lines.steps(plane), axis=1)
        if spatial is not None:
            lengths = lengths + 1e-9 * np.linalg.norm(lines.steps(spatial), axis=1)
        self.along = lines.running(lengths)
        self.length = np.zeros(len(lines))
        full = lines.last >= lines.first
        self.length[full] = self.along[lines.last[full]]
        self.base = np.concatenate(([0], np.cumsum(self.length + 1)))[:-1]
        self.axis = self.along + self.base[lines.line]

    def shares(self):
        """For each of the callers' points: its place as a share of its line's length, 0..1; evenly from point to point
        on lines without length."""
        lines = self.lines
        length = self.length[lines.line]
        even = (np.arange(len(lines.line)) - lines.first[lines.line]) / np.maximum(lines.last - lines.first, 1)[lines.line]
        share = np.where(length > 0, self.along / np.where(length > 0, length, 1), even)
        at_points = np.zeros(int(self.lines.counts.sum()))
        # Backwards, so that a closed line's first point keeps the 0 and not the 1 of its repetition.
        at_points[self.lines.index[::-1]] = share[::-1]
        return at_points

    def find(self, line, share):
        """Positions and weights (see `read`) of the places at these shares of these lines."""
        return self.find_along(line, share * self.length[line])

    def find_along(self, line, distance):
        """The same for distances along the lines."""
        lines = self.lines
        place = self.base[line] + np.clip(distance, 0, self.length[line])
        before = np.searchsorted(self.axis, place, side="right") - 1
        before = np.clip(before, lines.first[line], np.maximum(lines.last[line] - 1, lines.first[line]))
        after = np.minimum(before + 1, lines.last[line])
        gap = self.axis[after] - self.axis[before]
        weight = np.where(gap > 0, (place - self.axis[before]) / np.where(gap > 0, gap, 1), 0)
        return before, after, np.clip(weight, 0, 1)

    def read(self, values, found):
        """Values of the callers' points, read off at places that `find` found."""
        rows = self.lines.index
        return between(values[rows[found[0]]], values[rows[found[1]]], found[2])


def between(a, b, weight):
    """From `a` (weight 0) to `b` (weight 1), row by row; exact at both ends and where both are equal."""
    if a.ndim > 1:
        weight = weight[:, None]
    return a + weight * (b - a)


def varies(lines, values):
    """Whether `values` (one for each of the callers' points, or a row of them) are not all the same on a line."""
    result = np.zeros(len(lines), dtype=bool)
    full = lines.counts > 0
    if full.any():
        begin = lines.offset[full]
        spread = np.maximum.reduceat(values, begin, axis=0) - np.minimum.reduceat(values, begin, axis=0)
        result[full] = spread.reshape(len(begin), -1).max(axis=1) > 0
    return result


def correspondence(course, plane, lines, moved, exact=None):
    """Where on its old line each point of a redrawn one belongs.

    `course` and `plane` are the old lines', `lines` and `moved` the new ones (the same number of lines, in the same
    order). Points correspond by their share of arc length first; then each looks for the nearest point of the old
    line a little before and behind, since a hand's detours lengthen one part of a line more than another. The result
    never runs backwards. Where it does not matter (`exact`, for each line, is False) the share is taken as it is.
    Returns distances along the old lines.
    """
    line = np.repeat(np.arange(len(lines)), lines.counts)
    share = Course(lines, moved).shares()
    if len(line) == 0:
        return np.zeros(0)
    length = course.length[line]
    guess = share * length
    if exact is not None and not exact.any():
        return guess
    offsets = np.linspace(-0.05, 0.05, 5)
    costs = np.empty((len(offsets), len(line)))
    for k, offset in enumerate(offsets):
        there = course.read(plane, course.find_along(line, guess + offset * length))
        # Without any pull to the first guess, points beside a straight or coinciding piece would wander along it.
        costs[k] = ((there - moved) ** 2).sum(axis=1) + (0.3 * offset * length) ** 2
    best = costs.argmin(axis=0)
    # Between the grid's places: the vertex of the parabola through the best one and its neighbours.
    inner = np.clip(best, 1, len(offsets) - 2)
    column = np.arange(len(line))
    low, mid, high = costs[inner - 1, column], costs[inner, column], costs[inner + 1, column]
    bend = low - 2 * mid + high
    shift = np.where(bend > 1e-12, 0.5 * (low - high) / np.where(bend > 1e-12, bend, 1), 0)
    correction = (offsets[inner] + np.clip(shift, -1, 1) * (offsets[1] - offsets[0])) * length
    correction[length <= 0] = 0
    correction = _smooth(correction, lines, line)
    if exact is not None:
        correction[~exact[line]] = 0
    # Ends stay ends.
    correction *= np.minimum(1, 10 * np.minimum(share, 1 - share))
    place = np.clip(guess + correction, 0, length)
    ordered = np.maximum.accumulate(place + course.base[line]) - course.base[line]
    return np.clip(ordered, 0, length)


def _smooth(values, lines, line):
    """The mean of each value and its neighbours on the same line."""
    if len(values) < 3:
        return values
    before, after = values.copy(), values.copy()
    same = line[1:] == line[:-1]
    before[1:][same] = values[:-1][same]
    after[:-1][same] = values[1:][same]
    return (before + 2 * values + after) / 4
