# SPDX-License-Identifier: GPL-3.0-or-later
"""What a pen does to a line: pressure to thickness and strength, the nib's angle to rotation."""

import numpy as np

# A nib's direction means little while the pen leans by less than this (radians).
CLEAR_TILT = 0.2
LEAST_SLANT = 0.2


class Thickness:
    """Between the thickness of a line's points and the pressure of a pen, line by line, without loss.

    A pen of pressure 0 draws `thinnest` times a line's mean thickness, one of pressure 1 `thickest` times. A line whose
    thickness goes beyond these has a wider range of its own, so that thickness turned to pressure and back is as it was.
    A line of even thickness says nothing about a pen: `recorded` is False for it.
    """

    def __init__(self, lines, thickness, thinnest, thickest):
        many = np.maximum(lines.counts, 1)
        ends = lines.offset[lines.counts > 0]
        self.base = np.zeros(len(lines))
        low, high = np.zeros(len(lines)), np.zeros(len(lines))
        full = lines.counts > 0
        if full.any():
            self.base[full] = np.add.reduceat(thickness.astype(float), ends) / many[full]
            low[full] = np.minimum.reduceat(thickness, ends)
            high[full] = np.maximum.reduceat(thickness, ends)
        safe = np.where(self.base > 0, self.base, 1)
        self.recorded = (high - low) > 1e-3 * safe
        self.base[~self.recorded] = high[~self.recorded]
        self.low = np.where(self.recorded, np.minimum(thinnest, low / safe), thinnest)
        self.high = np.where(self.recorded, np.maximum(thickest, high / safe), thickest)

    def to_pressure(self, thickness, line):
        """Pressures 0..1 of points of the lines `line` (only where `recorded`)."""
        base = np.where(self.base > 0, self.base, 1)[line]
        gap = self.high[line] - self.low[line]
        return np.clip((thickness / base - self.low[line]) / np.where(gap > 0, gap, 1), 0, 1)

    def from_pressure(self, pressure, line):
        return self.base[line] * (self.low[line] + (self.high[line] - self.low[line]) * pressure)


def lean(tilt_x, tilt_y):
    """A pen's inclination from upright and the direction it leans in (radians), from its tilts."""
    x = np.tan(np.clip(tilt_x, -1.5, 1.5))
    y = np.tan(np.clip(tilt_y, -1.5, 1.5))
    return np.arctan(np.hypot(x, y)), np.arctan2(y, x)


def nib(twist, tilt_x, tilt_y, aspect):
    """A nib's angle in the drawing (from x towards y) and the ratio of its axes, 1 where it has no direction.

    `twist` NaN: the nib points where the pen leans. `tilt_x`, `tilt_y` NaN: upright.
    """
    inclination, azimuth = lean(np.nan_to_num(tilt_x), np.nan_to_num(tilt_y))
    turned = ~np.isnan(twist)
    trust = np.minimum(inclination / CLEAR_TILT, 1)
    oriented = np.where(turned, 1.0, trust * trust * (3 - 2 * trust))
    slant = np.maximum(np.cos(inclination), LEAST_SLANT)
    angle = np.where(turned, np.nan_to_num(twist), azimuth)
    return angle, 1 + oriented * (aspect / slant - 1)


def breadth(angle, ratio, direction):
    """How broad a nib of that angle draws in a direction, beside a round one of the same area."""
    turn = angle - direction
    return np.sqrt(ratio * np.sin(turn) ** 2 + np.cos(turn) ** 2 / ratio)


def directions(lines, points):
    """The direction of the lines at each of their points: towards the next one and from the one before."""
    steps = lines.steps(points)
    lengths = np.linalg.norm(steps, axis=1, keepdims=True)
    steps = steps / np.where(lengths > 0, lengths, 1)
    both = steps.copy()
    if len(both) > 1:
        both[1:] += np.where(lines.inner[:-1, None], steps[:-1], 0)
    result = np.zeros(len(points))
    result[lines.index[::-1]] = np.arctan2(both[::-1, 1], both[::-1, 0])
    # A closed line's first point comes after its last one.
    ends = lines.last[lines.closed]
    if len(ends):
        begin = lines.first[lines.closed]
        sums = steps[begin] + steps[ends - 1]
        result[lines.index[begin]] = np.arctan2(sums[:, 1], sums[:, 0])
    return result


def half_turns(angle):
    """The same axis at -pi/2 .. pi/2."""
    return angle - np.pi * np.round(angle / np.pi)
