# SPDX-License-Identifier: GPL-3.0-or-later
"""One run: lines of any number of drawings to the core and back to points in space.

A Job is made of pieces (see gather.py). `compute` may run in a thread of its own: it touches nothing of Blender. What it
leaves in `changes`, `additions` and `removals` is carried out by write.py.
"""

from collections import defaultdict, deque
from typing import NamedTuple

import numpy as np

from .geometry import pens, tracks
from .geometry.layout import lay_out
from .geometry.lines import Course, Lines, correspondence

CHANNELS = ("pressure", "tilt_x", "tilt_y", "twist")
# Points that are put back at a time, which bounds memory.
CHUNK = 400_000


class Stopped(Exception):
    """The run was given up after the core was done."""


class Part(NamedTuple):
    """Lines of one drawing that are worked on, and where their results go."""

    strokes: object  # grease_pencil.Strokes
    targets: tuple  # each line's place in the drawing that gets the result
    names: tuple  # integers that stay the same with each line
    prefix: str  # what the lines' ids begin with
    step: int  # number of the boil
    stretch: object  # 3 x 3: from the layer's points to sizes in the world (see planes.stretch)
    pixel: float  # the same sizes, of a drawing pixel
    axes: object  # right and down of the plane (2 x 3), or None
    sequence: int  # parts with the same number follow each other in time
    anew: bool  # the drawing holds other lines in their places: they are written even if the core changes nothing


class Job:
    """`own` are the add-on's own values (see own.py), `method` how lines are laid out (see layout.py)."""

    def __init__(self, parts, own, method):
        self.parts, self.own, self.method = parts, own, method
        sizes = [len(part.targets) for part in parts]
        self.part = np.repeat(np.arange(len(parts)), sizes)
        self.start = np.concatenate(([0], np.cumsum(sizes))).astype(int)
        self.counts = np.array([n for part in parts for n in part.strokes.counts], dtype=np.intp)
        closed = np.array([c for part in parts for c in part.strokes.closed], dtype=bool)
        self.lines = Lines(self.counts, closed)
        self.names = ["position"] + [n for n in self._attributes() if n != "position"]
        self.points = {name: self._joined(name) for name in self.names}
        self.changes, self.additions, self.removals = {}, {}, []
        self.alike = False

    def _attributes(self):
        names = []
        for part in self.parts:
            names += [name for name in part.strokes.points if name not in names]
        return names

    def _joined(self, name):
        """An attribute of all points; drawings that lack it (weights) count as having none."""
        joined = []
        for part in self.parts:
            values = part.strokes.points.get(name)
            joined.append(values if values is not None else
                          np.full(sum(part.strokes.counts), -1, dtype=np.float32))
        return np.concatenate(joined) if joined else np.zeros((0,))

    def __len__(self):
        return len(self.counts)

    def _lay_out(self):
        line_part = np.repeat(self.part, self.counts)
        position = self.points["position"].astype(float)
        placed = np.empty_like(position)
        axes = np.zeros((len(self), 2, 3))
        for number, part in enumerate(self.parts):
            rows = line_part == number if len(self.parts) > 1 else slice(None)
            placed[rows] = position[rows] @ part.stretch.T / part.pixel
            if part.axes is not None:
                axes[self.part == number] = part.axes
        return lay_out(self.counts, self.lines.closed, placed, self.method, axes)

    def _follow(self, layout):
        """Each line's name, the line whose result it follows and the turn from there."""
        names = np.array([name for part in self.parts for name in part.names], dtype=int)
        keys, turns = np.arange(len(self)), np.ones(len(self), dtype=complex)
        sequences = defaultdict(list)
        for number, part in enumerate(self.parts):
            sequences[part.sequence].append(number)
        if all(len(numbers) == 1 for numbers in sequences.values()):
            return names, keys, turns
        shapes = tracks.shapes(layout)
        kinds = np.array([kind * 2 + closed for part in self.parts
                          for kind, closed in zip(part.strokes.kinds, part.strokes.closed)], dtype=int)
        for numbers in sequences.values():
            track = tracks.Tracks(self.own["coherence"])
            for number in numbers:
                rows = slice(self.start[number], self.start[number + 1])
                named, keys[rows], turns[rows] = track.follow(
                    shapes[rows], kinds[rows], names[rows], self.start[number], self.parts[number].step)
                names[rows] = named
        return names, keys, turns

    def compute(self, run, progress=lambda fraction: True):
        """`run(fill, progress)` lets the core work: `fill(drawing)` adds the lines, the result is the core's drawing.
        `progress` returns False to give up. Raises what `run` raises, and Stopped."""
        layout = self._lay_out()
        names, keys, turns = self._follow(layout)
        own = np.flatnonzero(keys == np.arange(len(self)))
        ids = [f"{self.parts[p].prefix}/{n}" + (f"~{self.parts[p].step}" if self.parts[p].step else "")
               for p, n in zip(self.part[own].tolist(), names[own].tolist())]
        pen = self._pens(layout)
        output = run(lambda drawing: self._fill(drawing, own, ids, layout, pen), progress)
        self._progress = progress
        self._take(output, own, ids, keys, turns, layout, pen)

    # What the core gets -----------------------------------------------------------------------------------------------

    def _pens(self, layout):
        own = self.own
        line = np.repeat(np.arange(len(self)), self.counts)
        thickness = pens.Thickness(self.lines, self.points["thickness"], own["thinnest"], own["thickest"])
        pressure = thickness.to_pressure(self.points["thickness"], line)
        rotation = self.points["rotation"].astype(float)
        turned = np.zeros(len(self), dtype=bool)
        turned[line[np.abs(rotation) > 1e-6]] = True
        alignment = np.array([a for part in self.parts for a in part.strokes.alignment], dtype=object)
        if turned.any():
            for i in np.flatnonzero(turned):
                rows = slice(self.lines.offset[i], self.lines.offset[i] + self.counts[i])
                rotation[rows] = np.unwrap(rotation[rows], period=np.pi)
        along = alignment == "path"
        direction = pens.directions(self.lines, layout.plane) if along.any() else None
        return {"line": line, "thickness": thickness, "pressure": pressure, "rotation": rotation, "turned": turned,
                "along": along, "direction": direction}

    def _fill(self, drawing, own, ids, layout, pen):
        thickness, line = pen["thickness"], pen["line"]
        strength = self._means(self.points["strength"])
        widths = np.array([w for part in self.parts for w in part.strokes.widths], dtype=float)
        colors = [color for part in self.parts for color in part.strokes.colors]
        x, y = np.ascontiguousarray(layout.plane[:, 0]), np.ascontiguousarray(layout.plane[:, 1])
        # Blender turns points clockwise, as the drawing does, whose y runs down.
        twist = pen["rotation"]
        if pen["direction"] is not None:
            twist = np.where(pen["along"][line], twist + pen["direction"], twist)
        times = self.points.get("time")
        for i, name in zip(own.tolist(), ids):
            rows = slice(self.lines.offset[i], self.lines.offset[i] + self.counts[i])
            drawing.add_stroke(
                name, x[rows], y[rows], closed=bool(self.lines.closed[i]), color=colors[i],
                opacity=min(max(float(strength[i]), 0.0), 1.0), width=float(widths[i] * thickness.base[i]),
                pressure=pen["pressure"][rows] if thickness.recorded[i] else None,
                twist=twist[rows] if pen["turned"][i] else None,
                t=_clock(times[rows]) if times is not None else None)
        self.inputs = {"x": x, "y": y, "twist": twist, "strength": strength}

    def _means(self, values):
        full = self.counts > 0
        means = np.zeros(len(self))
        if full.any():
            means[full] = np.add.reduceat(values.astype(float), self.lines.offset[full]) / self.counts[full]
        return means

    # What comes back --------------------------------------------------------------------------------------------------

    def _take(self, output, own, ids, keys, turns, layout, pen):
        waiting = defaultdict(deque)
        for line, name in zip(own.tolist(), ids):
            waiting[name].append(line)
        changed, strokes, same, last = [], [], set(), None
        for stroke in output:
            queue = waiting.get(stroke.id)
            if not queue:
                if last is not None:
                    self._add(stroke, last, layout, pen)
                continue
            last = queue.popleft()
            channels = {name: stroke.channel(name) for name in ("x", "y") + CHANNELS}
            if self._same(last, channels, pen):
                same.add(last)
                continue
            changed.append(last)
            strokes.append((channels, stroke.color, stroke.opacity))
        gone = {line for queue in waiting.values() for line in queue}
        self.removals = [(int(self.part[line]), self._target(line))
                         for line in range(len(self)) if int(keys[line]) in gone]
        self._put_back(changed, strokes, keys, turns, layout, pen)
        self._repeat([line for line, key in enumerate(keys.tolist()) if key in same])
        self._compare_steps()

    def _target(self, line):
        part = int(self.part[line])
        return self.parts[part].targets[line - self.start[part]]

    def _same(self, line, channels, pen):
        """True where the core left the line as it was given."""
        rows = slice(self.lines.offset[line], self.lines.offset[line] + self.counts[line])
        given = {"x": self.inputs["x"][rows], "y": self.inputs["y"][rows],
                 "pressure": pen["pressure"][rows] if pen["thickness"].recorded[line] else None,
                 "twist": self.inputs["twist"][rows] if pen["turned"][line] else None}
        for name, values in channels.items():
            before = given.get(name)
            if (values is None) != (before is None) or (values is not None and not np.array_equal(values, before)):
                return False
        return True

    def _repeat(self, lines):
        """Lines that stay as they are, but stand in for others."""
        for line in lines:
            if self.parts[int(self.part[line])].anew:
                rows = slice(self.lines.offset[line], self.lines.offset[line] + self.counts[line])
                piece = {name: array[rows] for name, array in self.points.items() if name != "time"}
                self.changes[int(self.part[line]), self._target(line)] = (_without_empty_weights(piece), None)

    def _put_back(self, changed, strokes, keys, turns, layout, pen):
        """All lines that follow a changed one get its result, each in its own place."""
        sizes = np.cumsum([len(channels["x"]) for channels, _, _ in strokes]) if strokes else np.zeros(0, dtype=int)
        begin = 0
        for end in np.append(np.flatnonzero(np.diff(sizes // CHUNK)) + 1, len(strokes)).tolist():
            if end > begin:
                self._put_back_results(changed[begin:end], strokes[begin:end], keys, turns, layout, pen)
                strokes[begin:end] = [None] * (end - begin)
            begin = end

    def _put_back_results(self, changed, strokes, keys, turns, layout, pen):
        # Which line's result (by its number among `changed`) each line gets.
        number = np.full(len(self), -1)
        number[changed] = np.arange(len(changed))
        source = number[keys]
        new_counts = np.array([len(channels["x"]) for channels, _, _ in strokes], dtype=np.intp)
        begin = np.concatenate(([0], np.cumsum(new_counts)))
        joined = {}
        for name in ("x", "y") + CHANNELS:
            joined[name] = np.concatenate([
                channels[name] if channels[name] is not None else np.full(len(channels["x"]), np.nan)
                for channels, _, _ in strokes])
        moved = np.stack((joined.pop("x"), joined.pop("y")), axis=1)
        # Where on their own lines the points belong, and how far away they are.
        changed = np.array(changed)
        closed = self.lines.closed[changed]
        place = self._places(changed, new_counts, closed, moved, layout)
        kept = self._kept(changed, new_counts, place[0], joined["pressure"], layout, pen)
        receivers = np.flatnonzero(source >= 0)
        sizes = np.cumsum(new_counts[source[receivers]])
        for cut in np.split(receivers, np.flatnonzero(np.diff(sizes // CHUNK)) + 1):
            if not self._progress(1.0):
                raise Stopped
            self._put_back_some(cut, source[cut], strokes, changed, begin, moved, place, joined, kept, turns, layout, pen)

    def _kept(self, changed, new_counts, share, pressure, layout, pen):
        """For each changed line whether the core has left the pressure that it was drawn with."""
        number = np.repeat(np.arange(len(changed)), new_counts)
        before = layout.course.read(pen["pressure"], layout.course.find(changed[number], share))
        apart = np.zeros(len(changed))
        np.maximum.at(apart, number, np.where(np.isnan(pressure), 1, np.abs(pressure - before)))
        return pen["thickness"].recorded[changed] & (apart <= 0.02)

    @staticmethod
    def _places(changed, new_counts, closed, moved, layout):
        """Shares of the old lines' lengths, and offsets from there."""
        old = layout.lines
        fresh = Lines(new_counts, closed)
        if len(changed) == len(old):
            part, plane, course = old, layout.plane, layout.course
            order = np.arange(len(old)) if (changed == np.arange(len(old))).all() else None
        else:
            order = None
        if order is None:
            rows = np.concatenate([np.arange(old.offset[i], old.offset[i] + old.counts[i]) for i in changed])
            part = Lines(old.counts[changed], old.closed[changed])
            plane = layout.plane[rows]
            course = Course(part, plane, layout.points[rows])
        along = correspondence(course, plane, fresh, moved)
        line = np.repeat(np.arange(len(changed)), new_counts)
        there = course.read(plane, course.find_along(line, along))
        length = course.length[line]
        return np.where(length > 0, along / np.where(length > 0, length, 1), 0), moved - there

    def _put_back_some(self, lines, source, strokes, changed, begin, moved, place, joined, kept, turns, layout, pen):
        counts = (begin[1:] - begin[:-1])[source]
        ends = np.cumsum(counts)
        rows = np.arange(int(ends[-1])) + np.repeat(begin[source] - (ends - counts), counts)
        line = np.repeat(lines, counts)
        share, offset = place[0][rows], place[1][rows]
        turn = turns[line]
        offset = np.stack((turn.real * offset[:, 0] - turn.imag * offset[:, 1],
                           turn.imag * offset[:, 0] + turn.real * offset[:, 1]), axis=1)
        course = layout.course
        found = course.find(line, share)
        values = {name: course.read(array, found) for name, array in self.points.items()
                  if name not in ("position", "select", "time")}
        if "select" in self.points:
            values["select"] = course.read(self.points["select"].astype(np.float32), found) >= 0.5
        if "time" in self.points:
            values["time"] = course.read(self.points["time"], found)
        spatial = layout.put_back(found, offset)
        channels = {name: array[rows] for name, array in joined.items()}
        channels["twist"] = channels["twist"] + np.angle(turn)
        fresh = Lines(counts, self.lines.closed[lines])
        own_pressure = np.repeat(kept[source] & pen["thickness"].recorded[lines], counts)
        self._apply_pen(values, channels, line, own_pressure, found, course, fresh, moved[rows], pen)
        part_of = self.part[line]
        for number in np.unique(part_of):
            part = self.parts[number]
            mine = part_of == number
            spatial[mine] = spatial[mine] * part.pixel @ np.linalg.inv(part.stretch).T
        values["position"] = spatial
        values = {name: array.astype(np.float32) if name != "select" else array for name, array in values.items()}
        strength = self.inputs["strength"]
        colors = [color for part in self.parts for color in part.strokes.colors]
        for i, first, last, origin in zip(lines.tolist(), (ends - counts).tolist(), ends.tolist(), source.tolist()):
            piece = {name: array[first:last] for name, array in values.items()}
            piece = _without_empty_weights(piece)
            _, color, opacity = strokes[origin]
            given = min(max(float(strength[changed[origin]]), 0.0), 1.0)
            if abs(opacity - given) > 1e-6 and given > 0:
                piece["strength"] = np.clip(piece["strength"] * np.float32(opacity / given), 0, 1)
            differs = max(abs(a - b) for a, b in zip(color, colors[i])) > 1e-3
            self.changes[int(self.part[i]), self._target(i)] = (piece, color if differs else None)

    def _apply_pen(self, values, channels, line, own_pressure, found, course, fresh, moved, pen):
        """Pressure to thickness and strength, the nib's angle to rotation. Where the core has kept the pressure that a
        line was drawn with (`own_pressure`), thickness and strength stay the line's own."""
        own = self.own
        pressure = np.nan_to_num(channels["pressure"])
        has = ~np.isnan(channels["pressure"]) & ~own_pressure
        if has.any():
            new = np.where(has, pen["thickness"].from_pressure(pressure, line), values["thickness"])
            fade = np.where(has, 1 - own["strength"] * (1 - pressure), 1)
            values["thickness"] = np.maximum(new, 0)
            values["strength"] = np.clip(values["strength"] * fade, 0, 1)
        posed = ~np.isnan(channels["twist"]) | ~np.isnan(channels["tilt_x"])
        values["rotation"] = pens.half_turns(course.read(pen["rotation"], found))
        if posed.any():
            angle, ratio = pens.nib(channels["twist"], channels["tilt_x"], channels["tilt_y"], own["nib-aspect"])
            direction = None
            if own["nib-aspect"] > 1 or pen["along"].any():
                direction = pens.directions(fresh, moved)
            if own["nib-aspect"] > 1:
                broad = pens.breadth(angle, ratio, direction)
                values["thickness"] = np.where(posed, values["thickness"] * broad, values["thickness"])
            if own["rotation"]:
                turned = angle if direction is None else np.where(pen["along"][line], angle - direction, angle)
                values["rotation"] = np.where(posed, pens.half_turns(turned), values["rotation"])

    def _add(self, stroke, like, layout, pen):
        """A line that the core has made anew lies in the plane of the one before it and looks like it."""
        part_number = int(self.part[like])
        part = self.parts[part_number]
        row = self.lines.offset[like]
        if self.counts[like] == 0:
            return
        x, y = stroke.channel("x"), stroke.channel("y")
        offset = np.stack((x, y), axis=1) - layout.plane[row]
        space = layout.points[row] + offset[:, :1] * layout.along[row] + offset[:, 1:] * layout.across[row]
        many = len(x)
        points = {"position": (space * part.pixel @ np.linalg.inv(part.stretch).T).astype(np.float32)}
        pressure = stroke.channel("pressure")
        own, base = self.own, pen["thickness"].base[like]
        if stroke.width > 0:
            widths = [w for p in self.parts for w in p.strokes.widths]
            base = stroke.width / widths[like]
        shares = own["thinnest"] + (own["thickest"] - own["thinnest"]) * pressure if pressure is not None else 1
        points["thickness"] = np.full(many, base, dtype=np.float32) * np.float32(shares)
        points["strength"] = np.full(many, stroke.opacity, dtype=np.float32)
        self.additions.setdefault(part_number, []).append(
            (self._target(like), points, stroke.closed, stroke.color))

    def _compare_steps(self):
        """Whether a boil came out alike at every step, so that nothing moves."""
        last = {}
        self.alike = False
        if not any(part.step for part in self.parts):
            return
        different = False
        for (number, target), (points, _) in self.changes.items():
            part = self.parts[number]
            where = (part.sequence, target)
            other = last.get(where)
            if other is not None and other[0] != part.step:
                different = different or not np.array_equal(other[1], points["position"]) \
                    or not np.array_equal(other[2], points["thickness"])
            last[where] = (part.step, points["position"], points["thickness"])
        self.alike = not different


def _without_empty_weights(piece):
    """A line's values without the groups that it has no weight in."""
    return {name: array for name, array in piece.items() if not isinstance(name, tuple) or (array >= 0).any()}


def _clock(values):
    """Seconds that never run back, or None where there is no time."""
    times = np.maximum.accumulate(np.asarray(values, dtype=float)) if len(values) else np.zeros(0)
    return times if len(times) and times[-1] > times[0] else None
