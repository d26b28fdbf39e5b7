# SPDX-License-Identifier: GPL-3.0-or-later
"""The same line in successive drawings.

Lines have no names in Grease Pencil: which line of one drawing is which of the next is told by where they lie. A line
keeps its name through the drawings, and while its shape hardly changes also the choices that a hand made for it.
"""

import numpy as np

PLACES = 16  # where a line is compared


def shapes(layout):
    """Each line at PLACES even places, as complex numbers: lines x PLACES. Empty lines are NaN."""
    count = len(layout.lines)
    result = np.full((count, PLACES), np.nan + 0j)
    full = np.flatnonzero(layout.lines.counts > 0)
    line = np.repeat(full, PLACES)
    share = np.tile(np.linspace(0, 1, PLACES), len(full))
    at = layout.course.read(layout.plane, layout.course.find(line, share))
    result[full] = (at[:, 0] + 1j * at[:, 1]).reshape(-1, PLACES)
    return result


def extents(lines):
    """The size of each shape: the root mean square distance from its centre."""
    return np.sqrt((np.abs(lines - lines.mean(axis=1, keepdims=True)) ** 2).mean(axis=1))


def match(before, after, kinds_before, kinds_after):
    """For each shape of `after` the index of the same line in `before`, or -1.

    A pair has to be of one kind (layer, material, closed) and lie nearer to each other than their size. Lines at the
    same index are taken first where they lie near; of the others those that are each other's nearest.
    """
    result = np.full(len(after), -1)
    if len(before) == 0 or len(after) == 0:
        return result
    size_before, size_after = extents(before), extents(after)
    common = min(len(before), len(after))
    apart = np.sqrt((np.abs(before[:common] - after[:common]) ** 2).mean(axis=1))
    near = 0.5 * (size_before[:common] + size_after[:common])
    same = (apart <= np.maximum(0.3 * near, 1e-9)) & (kinds_before[:common] == kinds_after[:common])
    result[:common][same] = np.flatnonzero(same)
    left_before = np.setdiff1d(np.arange(len(before)), result[result >= 0])
    left_after = np.flatnonzero(result < 0)
    if len(left_before) == 0 or len(left_after) == 0:
        return result
    # A few places are enough to tell lines apart, and the table of all pairs stays small.
    some = slice(None, None, 5)
    a, b = after[left_after][:, some], before[left_before][:, some]
    nearest, nearest_back, distance = _mutual(a, b)
    for k in np.flatnonzero(nearest_back[nearest] == np.arange(len(left_after))):
        i, j = left_after[k], left_before[nearest[k]]
        if kinds_before[j] == kinds_after[i] and distance[k] <= size_before[j] + size_after[i]:
            result[i] = j
    return result


def _mutual(a, b):
    """The nearest of `b` for each of `a` and of `a` for each of `b`, and the distances of the former."""
    nearest, distance = np.empty(len(a), dtype=int), np.empty(len(a))
    back, back_distance = np.zeros(len(b), dtype=int), np.full(len(b), np.inf)
    block = max(1, 2_000_000 // max(1, len(b) * a.shape[1]))
    for start in range(0, len(a), block):
        rows = a[start:start + block]
        table = np.sqrt((np.abs(rows[:, None] - b[None]) ** 2).mean(axis=2))
        table = np.where(np.isnan(table), np.inf, table)
        nearest[start:start + block] = table.argmin(axis=1)
        distance[start:start + block] = table.min(axis=1)
        best = table.argmin(axis=0)
        better = table[best, np.arange(len(b))] < back_distance
        back[better] = best[better] + start
        back_distance[better] = table[best, np.arange(len(b))][better]
    return nearest, back, distance


def change(key, now):
    """How the shapes `now` came from the shapes `key`, row by row.

    Returns the turn and growth (a complex number a: now = a * key + shift) and how far the shapes differ apart from
    that, as a share of the size of `key`.
    """
    a0 = key - key.mean(axis=1, keepdims=True)
    b0 = now - now.mean(axis=1, keepdims=True)
    power = (np.abs(a0) ** 2).sum(axis=1)
    safe = np.where(power > 0, power, 1)
    a = np.where(power > 0, (b0 * np.conj(a0)).sum(axis=1) / safe, 1)
    rest = np.abs(b0 - a[:, None] * a0)
    size = np.sqrt(safe / key.shape[1])
    return a, np.where(power > 0, rest.max(axis=1) / size, 0)


class Tracks:
    """Names and keys of lines through a sequence of drawings.

    Call `follow` for the drawings in order. `tolerance` is how much a line may change (as a share of its size) and keep
    what was chosen for it at its key: the line that it is compared with. 0 keeps nothing but exact copies.
    """

    # Beyond these, a hand would draw the line otherwise: letters do not stand on their heads.
    MOST_TURN, MOST_GROWTH = np.radians(30), 1.25

    def __init__(self, tolerance):
        self.tolerance = tolerance
        self.names, self.keys = [], []
        self._shapes = self._kinds = None
        self._taken, self._highest = set(), -1
        self._step = None

    def follow(self, shape, kinds, proposed, first, step):
        """One more drawing. `proposed` are names (integers) for its lines, used where a line appears for the first
        time and the name is free. `first` is the number of its first line among all lines of all drawings, `step` its
        number in a boil: with another step nothing is kept. Returns names, keys (the number of the line whose result
        each follows, often its own) and the turn and growth from there."""
        count = len(shape)
        own = first + np.arange(count)
        names, keys = np.full(count, -1), own.copy()
        turn = np.ones(count, dtype=complex)
        if self._shapes is not None:
            found = match(self._shapes, shape, self._kinds, kinds)
            known = np.flatnonzero(found >= 0)
            names[known] = self.names[-1][found[known]]
            if step == self._step and len(known):
                key = self.keys[-1][found[known]]
                a, apart = change(self._key_shapes[found[known]], shape[known])
                small = ((apart <= self.tolerance) & (np.abs(np.angle(a)) <= self.MOST_TURN)
                         & (np.abs(a) <= self.MOST_GROWTH) & (np.abs(a) >= 1 / self.MOST_GROWTH))
                keys[known[small]] = key[small]
                turn[known[small]] = a[small]
        for i in np.flatnonzero(names < 0):
            names[i] = proposed[i] if proposed[i] not in self._taken else self._highest + 1
            self._taken.add(int(names[i]))
            self._highest = max(self._highest, int(names[i]))
        key_shapes = shape.copy()
        if self._shapes is not None:
            followers = np.flatnonzero(keys != own)
            key_shapes[followers] = self._key_shapes[found[followers]]
        self._shapes, self._kinds, self._key_shapes, self._step = shape, kinds, key_shapes, step
        self.names.append(names)
        self.keys.append(keys)
        return names, keys, turn
