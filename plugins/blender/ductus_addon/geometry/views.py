# SPDX-License-Identifier: GPL-3.0-or-later
"""The directions right and down of whoever looks at an object, in the object's own directions."""

import numpy as np

from .planes import axes_for, unit


def axes_from_view(view, turn):
    """Right and down of a view (a 3 x 3 or larger matrix that maps the view's directions to the world's: x right,
    y up, z towards who looks) for an object that `turn` (3 x 3) turns from its own directions to the world's."""
    turned = np.asarray(turn).T @ np.asarray(view, dtype=float)[:3, :3]
    return unit(turned[:, 0]), unit(-turned[:, 1])


def axes_across(normal, turn):
    """The axes of the plane across a direction of the world, seen against that direction."""
    away = unit(-(np.asarray(turn).T @ np.asarray(normal, dtype=float)))
    right, down = axes_for(away[None])
    return right[0], down[0]
