# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines on curved surfaces, unrolled into the plane.

Along the line goes a frame that turns as little as it can (a rotation-minimising frame: each turn of the tangent is
the only turn that the frame makes). On a sphere it is the frame of tangent, side and surface normal that goes along
with it, on other surfaces nearly so. How the frame is turned about the line at its beginning is what the line itself
tells of the surface: so that the bending out of the surface changes least. What is left of the bending turns the
unrolled line, whose lengths are the line's own.

Rotations are quaternions (w, x, y, z); their products along all lines are made by doubling, not point by point.
"""

import numpy as np

from .planes import unit


def _multiply(a, b):
    """Quaternion products, row by row: b first, then a."""
    aw, av, bw, bv = a[:, :1], a[:, 1:], b[:, :1], b[:, 1:]
    w = aw * bw - (av * bv).sum(axis=1, keepdims=True)
    return np.concatenate((w, aw * bv + bw * av + np.cross(av, bv)), axis=1)


def _inverse(q):
    return q * np.array([1.0, -1, -1, -1])


def _rotate(q, vectors):
    t = 2 * np.cross(q[:, 1:], vectors)
    return vectors + q[:, :1] * t + np.cross(q[:, 1:], t)


def _running_products(turns):
    """q[i] = turns[i] * turns[i-1] * ... * turns[0]."""
    result = turns.copy()
    reach = 1
    while reach < len(result):
        result[reach:] = unit(_multiply(result[reach:], result[:-reach]))
        reach *= 2
    return result


def _turn_between(a, b):
    """The smallest turn from unit vectors a to b."""
    w = 1 + (a * b).sum(axis=1, keepdims=True)
    q = np.concatenate((w, np.cross(a, b)), axis=1)
    back = w[:, 0] < 1e-9
    if back.any():
        side = np.cross(a[back], np.eye(3)[np.abs(a[back]).argmin(axis=1)])
        q[back] = np.concatenate((np.zeros((back.sum(), 1)), unit(side)), axis=1)
    return unit(q)


def _tangents(lines, points):
    """A direction for each position: its segment's, or the nearest one before or behind that has a length."""
    steps = lines.steps(points)
    lengths = np.linalg.norm(steps, axis=1)
    tangent = unit(steps)
    rows = np.arange(len(steps))
    valid = np.where(lengths > 0, rows, -1)
    before = np.maximum.accumulate(valid)
    after = np.minimum.accumulate(np.where(lengths > 0, rows, len(rows))[::-1])[::-1]
    from_before = (before >= 0) & (before >= lines.first[lines.line])
    source = np.where(from_before, before, np.minimum(after, len(rows) - 1))
    tangent = tangent[source]
    stray = np.linalg.norm(tangent, axis=1) < 0.5
    tangent[stray] = [1.0, 0, 0]
    return tangent, lengths


def unroll(lines, points, right, down):
    """Unrolls open lines.

    `points` in space; `right` and `down` (lines x 3) are the axes of the plane that fits each line best: the unrolled
    line is turned and moved to lie over the line's projection on it, and what the line leaves open about its surface
    is settled so that it faces as that plane does. Returns plane (positions of `lines` x 2), across (x 3) and along
    (x 3): the unrolled points and, in space, the directions of the drawing's axes x and y at each.
    """
    tangent, lengths = _tangents(lines, points)
    first = lines.first[lines.line]
    rows = np.arange(len(lines.index))
    previous = np.maximum(rows - 1, first)
    turns = _turn_between(tangent[previous], tangent)
    products = _running_products(turns)
    frame = unit(_multiply(products, _inverse(products[first])))

    # The bending at each point, brought back to the line's beginning, where it lies across the first tangent.
    axis = np.cross(tangent[previous], tangent)
    sine = np.linalg.norm(axis, axis=1)
    angle = np.arctan2(sine, (tangent[previous] * tangent).sum(axis=1))
    bending = unit(axis) * angle[:, None]
    bending = _rotate(_inverse(frame), bending)
    start = tangent[lines.first]
    behind = np.cross(right, down)
    u = unit(behind - (behind * start).sum(axis=1, keepdims=True) * start,
             unit(np.cross(start, np.eye(3)[np.abs(start).argmin(axis=1)])))
    v = np.cross(start, u)
    bend = np.stack(((bending * u[lines.line]).sum(axis=1), (bending * v[lines.line]).sum(axis=1)), axis=1)

    weight = np.maximum((lengths + lengths[previous]) / 2, 1e-30)
    weight[rows == first] = 0
    rate = bend / np.maximum(weight, 1e-30)[:, None]
    rate[weight == 0] = 0
    total = np.maximum(lines.sums(weight), 1e-30)
    mean = lines.sums(rate * weight[:, None]) / total[:, None]
    second = lines.sums(rate[:, :, None] * rate[:, None, :] * weight[:, None, None]) / total[:, None, None]
    spread = second - mean[:, :, None] * mean[:, None, :] + 0.05 * second
    # The surface's normal n turns the line within the surface; about e, across n, it bends out of it: e is the
    # direction in which the bending is most even. Where none is, n stays as near to `behind` (1, 0) as it can.
    size = np.trace(second, axis1=1, axis2=2)[:, None, None]
    spread = spread / np.where(size > 0, size, 1) + 0.02 * np.diag([1.0, 0.0])
    _, vectors = np.linalg.eigh(spread)
    e = vectors[:, :, 0]
    n = np.stack((e[:, 1], -e[:, 0]), axis=1)
    normal0 = n[:, :1] * u + n[:, 1:] * v
    normal = _rotate(frame, normal0[lines.line])
    facing = lines.sums((normal * behind[lines.line]).sum(axis=1) * np.maximum(lengths, 1e-30))
    flip = np.where(facing < 0, -1.0, 1.0)
    normal *= flip[lines.line][:, None]
    n *= flip[:, None]

    heading = lines.running((bend * n[lines.line]).sum(axis=1))
    heading = heading + (bend * n[lines.line]).sum(axis=1)
    heading -= heading[first]
    along = tangent
    side = np.cross(normal, along)
    course = np.stack((np.cos(heading), np.sin(heading)), axis=1) * lengths[:, None]
    flat = lines.running(course)

    # Laid over the projection by the turn and shift that fit best: complex numbers do both.
    placed = points[lines.index]
    wanted = (placed * right[lines.line]).sum(axis=1) + 1j * (placed * down[lines.line]).sum(axis=1)
    made = flat[:, 0] + 1j * flat[:, 1]
    many = np.maximum(lines.last - lines.first + 1, 1)
    wanted_mean, made_mean = lines.sums(wanted) / many, lines.sums(made) / many
    cross = lines.sums((wanted - wanted_mean[lines.line]) * np.conj(made - made_mean[lines.line]))
    turn = np.where(np.abs(cross) > 0, cross / np.where(np.abs(cross) > 0, np.abs(cross), 1), 1)
    laid = (made - made_mean[lines.line]) * turn[lines.line] + wanted_mean[lines.line]
    heading = heading + np.angle(turn)[lines.line]

    cosine, sine = np.cos(heading)[:, None], np.sin(heading)[:, None]
    return (np.stack((laid.real, laid.imag), axis=1),
            cosine * along - sine * side,
            sine * along + cosine * side)
