# SPDX-License-Identifier: GPL-3.0-or-later
"""Planes in which lines of three dimensions are worked on.

A plane is given by two unit vectors: `right` and `down`, the axes x and y of the drawing on it. The third, right x
down, leads away from who looks at it.
"""

import numpy as np

# Who looks at a line that has a plane of its own: from the front, a little from above and from the right, so that
# lines on a table are seen from above and lines on a side wall from the right, as Blender's own views are.
BEHIND = np.array([-0.2, 1.0, -0.5]) / np.linalg.norm([-0.2, 1.0, -0.5])

FIXED = {
    "front": (np.array([1.0, 0, 0]), np.array([0, 0, -1.0])),
    "side": (np.array([0, 1.0, 0]), np.array([0, 0, -1.0])),
    "top": (np.array([1.0, 0, 0]), np.array([0, -1.0, 0])),
}


def unit(vectors, otherwise=None):
    """Vectors of length 1 in the same directions; `otherwise` for those without one."""
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    safe = np.where(length > 0, length, 1)
    result = vectors / safe
    if otherwise is not None:
        result = np.where(length > 1e-12, result, otherwise)
    return result


def stretch(matrix):
    """The part of a 3 x 3 matrix that stretches, without what turns: matrix = turn @ stretch.

    Lines are worked on stretched but not turned: sizes and angles are those that are seen, and the axes are still the
    object's own. A matrix that flattens space, and so cannot be undone, gives the unit matrix. Returns (turn, stretch).
    """
    left, sizes, right = np.linalg.svd(np.asarray(matrix, dtype=float)[:3, :3])
    if not np.isfinite(sizes).all() or sizes[2] <= 1e-6 * max(sizes[0], 1e-30):
        return np.eye(3), np.eye(3)
    return left @ right, right.T @ np.diag(sizes) @ right


def best_fit(lines, points, behind=BEHIND):
    """The plane nearest to each line, as seen from the side of who looks along `behind`.

    What a line leaves open (all of it for a point, a turn about itself for a straight line) is settled so that the
    plane faces that direction as far as it can. Returns right, down (lines x 3 each), and flatness: the largest
    distance of a line's points from its plane, as a share of the line's extent.
    """
    placed = points[lines.index]
    many = np.maximum(lines.last - lines.first + 1, 1)[:, None]
    centre = lines.sums(placed) / many
    off = placed - centre[lines.line]
    spread = lines.sums(off[:, :, None] * off[:, None, :]) / many[:, :, None]
    trace = np.trace(spread, axis1=1, axis2=2)
    # A little more spread in every direction but `behind` makes it the flattest one where the line does not say.
    open_turn = np.eye(3) - np.outer(behind, behind)
    scale = np.where(trace > 0, trace, 1)[:, None, None]
    _, vectors = np.linalg.eigh(spread / scale + 1e-9 * open_turn)
    away = vectors[:, :, 0]
    away = np.where((away @ behind < 0)[:, None], -away, away)
    right, downward = axes_for(away)
    height = np.abs((off * away[lines.line]).sum(axis=1))
    extent = np.sqrt((off**2).sum(axis=1))
    full = lines.last >= lines.first
    flatness = np.zeros(len(lines))
    if full.any():
        starts = lines.first[full]
        flatness[full] = np.maximum.reduceat(height, starts) / np.maximum(
            np.maximum.reduceat(extent, starts), 1e-30)
    return right, downward, flatness


def axes_for(away):
    """The axes right and down of planes that lie across the directions `away` (n x 3): down is -z, on planes that lie
    flat (within some 25 degrees) more and more -y, as on a table."""
    level = np.clip((np.abs(away[:, 2]) - 0.9) / 0.1, 0, 1)
    level = level * level * (3 - 2 * level)
    wish = np.stack((0 * level, -10 * level, -np.ones(len(away))), axis=1)
    flat = wish - (away * wish).sum(axis=1, keepdims=True) * away
    downward = unit(flat, np.array([0.0, -1.0, 0.0]))
    return np.cross(downward, away), downward
