# SPDX-License-Identifier: GPL-3.0-or-later
"""From the user's wishes to the drawings that are worked on, and from a job's results back to these.

A Piece is a drawing that gets results. Most have one part: the lines themselves. On a layer that is a result already,
lines are made anew from their originals, and those that the user has drawn or edited there from themselves.
"""

from typing import NamedTuple

import bpy
import numpy as np

from . import originals
from .geometry import planes, views
from .grease_pencil import Addition, Change, FramePlan, LayerPlan, Refused
from .job import Part


class Piece(NamedTuple):
    ob: object
    layer: str  # the layer that exists
    target: str  # the layer that gets the result
    number: int  # the frame of the drawing that gets the result
    base: int  # the drawing that it begins as
    parts: tuple  # numbers of its parts in the job
    sources: tuple  # fingerprints of the lines it comes from, by place; None for a layer in place


class Work(NamedTuple):
    pieces: list
    parts: list
    drops: dict  # (object's name, layer): frames whose drawings go
    method: str


def gather(context, host, own):
    """What is to be worked on. Raises Refused where there is nothing, or something stands in the way."""
    objects = _objects(context, host, own)
    view = _view(context) if own["plane"] in ("view", "drawing") else None
    method, direction = _plane(context, own, view)
    work = Work([], [], {}, method)
    reasons = []
    sequence = 0
    for ob in objects:
        reason = host.refuses(ob)
        if reason:
            raise Refused(reason)
        entries = originals.Originals(host, ob)
        layers = host.layers(ob)
        for layer in _layers(host, ob, layers, own, reasons):
            _gather_layer(context, host, own, ob, layer, layers, entries, direction, sequence, work)
            sequence += 1
    if not work.pieces:
        raise Refused(_nothing(objects, own, reasons))
    return work


def _objects(context, host, own):
    active = context.object
    if own["apply-to"] == "objects":
        objects = [ob for ob in context.selected_objects if ob.type == host.OBJECT_TYPE]
        if not objects:
            raise Refused("no Grease Pencil object is selected: select one")
        # Objects that share their lines are worked on once.
        return list({ob.data: ob for ob in objects[::-1]}.values())[::-1]
    if active is None or active.type != host.OBJECT_TYPE:
        raise Refused("the active object is no Grease Pencil object: click on one first")
    return [active]


def _layers(host, ob, layers, own, reasons):
    active = host.active_layer(ob)
    chosen = []
    for layer in layers:
        if own["apply-to"] == "layer" and layer.name != active:
            continue
        if layer.locked or layer.hidden:
            reasons.append(f"layer '{layer.name}' of '{ob.name}' is {'locked' if layer.locked else 'hidden'}")
            continue
        chosen.append(layer)
    if own["apply-to"] == "layer" and active is None:
        reasons.append(f"'{ob.name}' has no layer")
    return chosen


def _nothing(objects, own, reasons):
    if reasons:
        return f"there is nothing to work on: {reasons[0]}; unlock or show it, or choose other lines"
    names = ", ".join(f"'{ob.name}'" for ob in objects)
    if own["apply-to"] == "selected":
        return f"no line of {names} is selected: select some in Edit Mode, or choose other lines"
    if own["frames"] == "current":
        return f"{names} has no lines in the drawing at this frame: go to another frame, or choose other frames"
    return f"{names} has no lines in these frames: choose other frames"


# Frames ---------------------------------------------------------------------------------------------------------------


def _range(context, own, numbers):
    scene = context.scene
    if own["frames"] == "range":
        if own["frame-end"] < own["frame-start"]:
            raise Refused(f"the range ends at frame {own['frame-end']}, before it starts at {own['frame-start']}: "
                          "change one of them")
        return own["frame-start"], own["frame-end"]
    if own["frames"] == "scene":
        if scene.use_preview_range:
            return scene.frame_preview_start, scene.frame_preview_end
        return scene.frame_start, scene.frame_end
    if not numbers:
        return 0, -1
    return min(numbers), max(max(numbers), scene.frame_end)


def _held(numbers, number):
    """The drawing that is shown at a frame, or None."""
    before = [n for n in numbers if n <= number]
    return max(before) if before else None


def _frames(context, host, own, ob, layer, origin, entry):
    """Pairs (frame, the frame of the drawing it begins as, step of the boil), and frames to drop."""
    if own["frames"] == "current":
        if host.multiframe(ob):
            return [(n, n, 0) for n in layer.numbers if n in layer.selected], frozenset()
        return [(layer.shown, layer.shown, 0)] if layer.shown is not None else [], frozenset()
    first, last = _range(context, own, layer.numbers)
    drop = frozenset()
    if origin is not None:
        drop = frozenset(n for n in layer.numbers if first <= n <= last and n not in origin.numbers
                         and _is_ours(host, ob, layer, n, origin, entry))
    kept = [n for n in layer.numbers if n not in drop]
    if own["seeds"] != "boil":
        return [(n, n, 0) for n in kept if first <= n <= last], drop
    every = own["boil-frames"]
    frames = []
    for number in sorted({n for n in kept if first <= n <= last} | set(range(first, last + 1, every))):
        base = _held(kept, number)
        if base is not None:
            frames.append((number, base, (number - first) // every))
    return frames, drop - {number for number, _, _ in frames}


def _is_ours(host, ob, layer, number, origin, entry):
    """True where nothing in a drawing is the user's own work."""
    held = _held(origin.numbers, number)
    if held is None:
        return False
    there = host.fingerprints(ob, layer.name, number)
    found = originals.sources(entry, number, there, host.fingerprints(ob, origin.name, held))
    return all(place is not None for place in found)


# Planes ---------------------------------------------------------------------------------------------------------------


def _view(context):
    """The view's matrix (its directions to the world's): of the viewport, else of the camera, else from the front."""
    region = context.region_data if context.space_data and context.space_data.type == "VIEW_3D" else None
    if region is None and context.window is not None:
        for area in context.window.screen.areas:
            if area.type == "VIEW_3D":
                region = area.spaces.active.region_3d
                break
    camera = context.scene.camera
    if region is not None and not (region.view_perspective == "CAMERA" and camera is not None):
        return np.array(region.view_rotation.to_matrix())
    if camera is not None:
        return np.array(camera.matrix_world)
    return np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])


def _plane(context, own, view):
    """The layout's method, and for planes a function from an object's turn to the axes."""
    plane = own["plane"]
    if plane in ("auto", "fit", "surface"):
        return plane, None
    if plane == "drawing":
        axis = context.scene.tool_settings.gpencil_sculpt.lock_axis
        plane = {"AXIS_Y": "front", "AXIS_X": "side", "AXIS_Z": "top", "CURSOR": "cursor"}.get(axis, "view")
    if plane in planes.FIXED:
        axes = planes.FIXED[plane]
        return "plane", lambda turn: axes
    if plane == "cursor":
        normal = np.array(context.scene.cursor.matrix)[:3, 2]
        return "plane", lambda turn: views.axes_across(normal, turn)
    return "plane", lambda turn: views.axes_from_view(view, turn)


# Lines ----------------------------------------------------------------------------------------------------------------


def _selected_only(host, ob, own):
    if own["apply-to"] == "selected":
        return True
    if own["apply-to"] != "auto" or not host.selecting(ob):
        return False
    return host.any_selected(ob)


def _gather_layer(context, host, own, ob, layer, layers, entries, direction, sequence, work):
    by_name = {other.name: other for other in layers}
    entry = entries.of(layer.name, by_name)
    origin = by_name[entry["original"]] if entry else None
    frames, drop = _frames(context, host, own, ob, layer, origin, entry)
    selected = _selected_only(host, ob, own)
    target = layer.name
    if own["result"] == "new-layer" and entry is None:
        target = _free_name(layer.name, by_name)
    turn, stretch = planes.stretch(np.array(layer.matrix))
    scale = abs(np.linalg.det(np.array(ob.matrix_world.to_3x3()))) ** (1 / 3)
    pixel = host.pixel(ob) * (scale if scale > 1e-9 else 1)
    axes = direction(turn) if direction is not None else None
    prefix = f"{ob.name}/{originals.Originals.prefix(entry, layer.name)}"
    any_work = False
    for number, base, step in frames:
        here = host.read(ob, layer.name, base, selected)
        if not here.index:
            continue
        if not np.isfinite(here.points["position"]).all():
            raise Refused(f"layer '{layer.name}' of '{ob.name}' has a line at frame {base} whose points are no numbers: "
                          "delete it and try again")
        readings = [(here, here.index, here.index)]
        marks = host.fingerprints(ob, layer.name, base)
        if origin is not None:
            readings, marks = _from_original(host, ob, layer, number, base, origin, entry, here, marks)
        parts = []
        for strokes, targets, names in readings:
            if not strokes.index:
                continue
            parts.append(len(work.parts))
            work.parts.append(Part(strokes, targets, names, prefix, step, stretch, pixel, axes, 2 * sequence
                                   + (names is not strokes.index), targets is not strokes.index))
        if parts:
            work.pieces.append(Piece(ob, layer.name, target, number, base, tuple(parts),
                                     tuple(marks) if entry or target != layer.name else None))
            any_work = True
    if drop and any_work:
        work.drops[ob.name, layer.name] = drop


def _from_original(host, ob, layer, number, base, origin, entry, here, marks):
    """The lines of a result's drawing as readings (strokes, their places in the drawing, their names), and for each
    place the fingerprint of the line it comes from."""
    held = _held(origin.numbers, number)
    theirs = host.fingerprints(ob, origin.name, held) if held is not None else []
    found = originals.sources(entry, base, marks, theirs)
    chosen = set(here.index)
    place_of = {source: place for place, source in enumerate(found) if source is not None and place in chosen}
    readings = []
    if place_of:
        strokes = host.read(ob, origin.name, held, index=set(place_of))
        readings.append((strokes, tuple(place_of[source] for source in strokes.index), strokes.index))
    users = {place for place in chosen if found[place] is None}
    if users:
        strokes = host.read(ob, layer.name, base, index=users)
        # Names of their own, beyond those of the original's lines.
        readings.append((strokes, strokes.index, tuple(place + (1 << 20) for place in strokes.index)))
    marks = [theirs[source] if source is not None else mark for mark, source in zip(marks, found)]
    return readings, marks


def _free_name(name, taken):
    wanted, k = f"{name} Ductus", 1
    while wanted in taken:
        k += 1
        wanted = f"{name} Ductus {k}"
    return wanted


# Back -----------------------------------------------------------------------------------------------------------------


def write(host, work, job):
    """Puts a job's results in their places. Returns how many lines and drawings have changed."""
    changes, additions, removals = {}, {}, {}
    for (part, target), (points, color) in job.changes.items():
        changes.setdefault(part, []).append(Change(target, points, color))
    for part, made in job.additions.items():
        additions[part] = [Addition(*one) for one in made]
    for part, target in job.removals:
        removals.setdefault(part, []).append(target)

    plans = {}
    for piece in work.pieces:
        changed = [change for part in piece.parts for change in changes.get(part, [])]
        added = [one for part in piece.parts for one in additions.get(part, [])]
        gone = [one for part in piece.parts for one in removals.get(part, [])]
        plans.setdefault(piece.ob.name, {}).setdefault((piece.layer, piece.target), []).append(
            (piece, FramePlan(piece.number, piece.base, changed, added, gone)))

    lines = drawings = 0
    todo, after = [], []
    for by_layer in plans.values():
        ob = next(iter(by_layer.values()))[0][0].ob
        entries = originals.Originals(host, ob)
        hidden = {layer.name: layer.hidden for layer in host.layers(ob)}
        layer_plans = []
        for (layer, target), frames in by_layer.items():
            drop = work.drops.get((ob.name, layer), frozenset())
            touched = [frame for _, frame in frames
                       if frame.changes or frame.additions or frame.removals or frame.number != frame.base]
            lines += sum(len(frame.changes) + len(frame.additions) for frame in touched)
            drawings += len(touched)
            if touched or drop or target != layer:
                layer_plans.append(LayerPlan(layer, target, [frame for _, frame in frames], drop))
        todo.append((ob, layer_plans))
        after.append((ob, entries, by_layer, hidden))
    host.write(todo)
    for one in after:
        _remember(host, *one)
    return lines, drawings


def _remember(host, ob, entries, by_layer, hidden):
    for (layer, target), frames in by_layer.items():
        names = {other.name for other in host.layers(ob)}
        entry = entries.of(target, names)
        if entry is None and target != layer:
            entry = entries.start(target, layer, hidden[layer])
        if entry is None:
            continue
        for piece, frame in frames:
            now = host.fingerprints(ob, target, piece.number)
            made = [change.index for change in frame.changes]
            if not frame.removals:
                originals.remember(entry, piece.number, [now[i] for i in made],
                                   [piece.sources[i] for i in made], now)
    entries.save()


def restore(context, host, ob):
    """Brings originals back: of the active layer where it is one or has one, else all. Returns how many."""
    entries = originals.Originals(host, ob)
    layers = {layer.name for layer in host.layers(ob)}
    active = host.active_layer(ob)
    there = [entry for entry in entries.results if entry["original"] in layers]
    chosen = [entry for entry in there if active in (entry["result"], entry["original"])] or there
    for entry in chosen:
        host.hide_layer(ob, entry["original"], entry["hidden"])
        host.set_active_layer(ob, entry["original"])
        if entry["result"] in layers:
            host.remove_layer(ob, entry["result"])
        entries.drop(entry)
    entries.save()
    bpy.context.view_layer.update()
    return len(chosen)
