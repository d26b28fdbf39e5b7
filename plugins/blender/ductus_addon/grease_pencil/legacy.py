# SPDX-License-Identifier: GPL-3.0-or-later
"""Grease Pencil up to Blender 4.2. See the package for what each name means."""

import zlib

import bpy
import numpy as np
from mathutils import Matrix

from . import Layer, Refused, Strokes

OBJECT_TYPE = "GPENCIL"
RECORD = "ductus"

# The add-on's names of point attributes: Blender's name and how many numbers a point has. Those that a version of
# Blender lacks are left out.
_ATTRIBUTES = {
    "position": ("co", 3),
    "thickness": ("pressure", 1),
    "strength": ("strength", 1),
    "rotation": ("uv_rotation", 1),
    "color": ("vertex_color", 4),
    "time": ("time", 1),
    "select": ("select", 1),
}
ATTRIBUTES = {name: what for name, what in _ATTRIBUTES.items()
              if what[0] in bpy.types.GPencilStrokePoint.bl_rna.properties}

# points.add() takes time that grows with the square of a line's length, most of it while the new points lie all in
# one place: long lines grow in pieces of this many points.
PIECE = 128


def layers(ob):
    return [_layer(ob, layer) for layer in ob.data.layers]


def _layer(ob, layer):
    numbers = tuple(frame.frame_number for frame in layer.frames)
    now = bpy.context.scene.frame_current
    shown = None
    if layer.lock_frame and layer.active_frame is not None:
        shown = layer.active_frame.frame_number
    else:
        before = [number for number in numbers if number <= now]
        shown = max(before) if before else None
    selected = frozenset(frame.frame_number for frame in layer.frames if frame.select)
    return Layer(layer.info, layer.lock, layer.hide, numbers, selected, shown, _matrix(ob, layer))


def _matrix(ob, layer):
    """From a layer's points to the world, as Blender draws them."""
    own = layer.matrix_layer
    parent = layer.parent
    if parent is None:
        return ob.matrix_world @ own
    above = parent.matrix_world
    if layer.parent_type == "BONE":
        bone = parent.pose.bones.get(layer.parent_bone) if parent.pose else None
        above = above @ bone.matrix if bone is not None else None
    # A layer with a parent follows that one alone, but the object's place is added.
    moved = above @ layer.matrix_inverse if above is not None else Matrix()
    if above is not None:
        moved.translation += ob.matrix_world.translation
    return moved @ own


def refuses(ob):
    if ob.library is not None or ob.data.library is not None:
        return f"'{ob.name}' is linked from another file: make it local (Object > Relations > Make Local) and try again"
    if ob.data.use_curve_edit:
        return f"the lines of '{ob.name}' are being edited as curves: turn Curve Editing off and try again"
    return None


def multiframe(ob):
    return ob.data.use_multiedit and ob.mode in {"EDIT_GPENCIL", "SCULPT_GPENCIL", "VERTEX_GPENCIL", "WEIGHT_GPENCIL"}


def selecting(ob):
    # Sculpting and painting show no selection, but for their masks.
    return ob.mode == "EDIT_GPENCIL"


def any_selected(ob):
    for layer in layers(ob):
        numbers = layer.selected if multiframe(ob) else {layer.shown}
        if layer.hidden or layer.locked:
            continue
        for frame in ob.data.layers[layer.name].frames:
            if frame.frame_number in numbers and any(stroke.select for stroke in frame.strokes):
                return True
    return False


def pixel(ob):
    return 0.001 * ob.data.pixel_factor


def _find(ob, layer, number):
    found = ob.data.layers.get(layer)
    if found is None:
        raise Refused(f"'{ob.name}' has no layer '{layer}' any more: nothing was changed")
    for frame in found.frames:
        if frame.frame_number == number:
            return found, frame
    raise Refused(f"layer '{layer}' of '{ob.name}' has no drawing at frame {number} any more: nothing was changed")


def _get(points, name, size):
    values = np.empty(len(points) * size, dtype=np.float32 if name != "select" else bool)
    points.foreach_get(name, values)
    return values


def _srgb(linear):
    return tuple(12.92 * v if v <= 0.0031308 else 1.055 * v ** (1 / 2.4) - 0.055 for v in linear[:3])


def _linear(encoded):
    return tuple(v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in encoded)


def read(ob, layer, number, selected=False, index=None):
    """Lines whose material is locked or hidden are left out, and with `selected` those that are not selected. `index`
    (a set) limits to lines at these places."""
    found, frame = _find(ob, layer, number)
    looks = [_look(slot.material) for slot in ob.material_slots] or [_look(None)]
    chosen = []
    for place, stroke in enumerate(frame.strokes):
        look = looks[stroke.material_index] if 0 <= stroke.material_index < len(looks) else _look(None)
        if look["hidden"] or (look["locked"] and found.lock_material) or (selected and not stroke.select) \
                or (index is not None and place not in index):
            continue
        chosen.append((place, stroke, look))
    parts = {name: [] for name in ATTRIBUTES}
    for _, stroke, _ in chosen:
        for name, (theirs, size) in ATTRIBUTES.items():
            parts[name].append(_get(stroke.points, theirs, size))
    points = {}
    for name, (_, size) in ATTRIBUTES.items():
        joined = np.concatenate(parts[name]) if chosen else np.zeros(0, dtype=np.float32)
        points[name] = joined.reshape(-1, size) if size > 1 else joined
    points.update(_read_weights(ob, [stroke for _, stroke, _ in chosen]))
    return Strokes(
        index=tuple(place for place, _, _ in chosen),
        counts=tuple(len(stroke.points) for _, stroke, _ in chosen),
        closed=tuple(stroke.use_cyclic for _, stroke, _ in chosen),
        kinds=tuple(stroke.material_index for _, stroke, _ in chosen),
        widths=tuple(max(1, stroke.line_width + found.line_change) for _, stroke, _ in chosen),
        colors=tuple(look["color"] for _, _, look in chosen),
        alignment=tuple(look["alignment"] for _, _, look in chosen),
        points=points)


def _look(material):
    style = material.grease_pencil if material is not None else None
    if style is None:
        return {"hidden": False, "locked": False, "color": (0.0, 0.0, 0.0), "alignment": "none"}
    alignment = {"PATH": "path", "OBJECT": "object"}.get(style.alignment_mode, "none")
    if style.mode == "LINE" and style.stroke_style == "SOLID":
        alignment = "object"  # not seen, but kept for when the material changes
    return {"hidden": style.hide, "locked": style.lock, "color": _srgb(style.color), "alignment": alignment}


def _read_weights(ob, strokes):
    """Vertex weights of lines that have any. Blender gives them out one by one only."""
    if not ob.vertex_groups:
        return {}
    weights = {}
    for group in range(len(ob.vertex_groups)):
        parts, any_there = [], False
        for stroke in strokes:
            get = stroke.points.weight_get
            values = np.array([get(vertex_group_index=group, point_index=i) for i in range(len(stroke.points))],
                              dtype=np.float32)
            any_there = any_there or bool((values >= 0).any())
            parts.append(values)
        if any_there:
            weights["weight", group] = np.concatenate(parts)
    return weights


def fingerprints(ob, layer, number):
    _, frame = _find(ob, layer, number)
    return [_fingerprint(stroke) for stroke in frame.strokes]


def _fingerprint(stroke):
    value = zlib.crc32(_get(stroke.points, "co", 3).tobytes(), len(stroke.points))
    return value - (1 << 32) if value >= 1 << 31 else value


def write(todo):
    undo, backups = [], []
    try:
        for ob, plans in todo:
            _write_object(ob, plans, undo, backups)
    except BaseException:
        for back in reversed(undo):
            back()
        raise
    finally:
        for layers, name in backups:
            layers.remove(layers[name])
        for ob, _ in todo:
            ob.data.update_tag()


def _write_object(ob, plans, undo, backups):
    """Carries out an object's plans; appends to `undo` what takes it all back, and to `backups` layers to be removed."""
    layers = ob.data.layers
    active = active_layer(ob)
    undo.append(lambda: set_active_layer(ob, active))
    for plan in plans:
        layer = layers[plan.layer]
        if plan.target != plan.layer:
            hidden = layer.hide
            layer = _duplicate(ob, layer, plan.target)
            undo.append(lambda name=plan.target: layers.remove(layers[name]))
            undo.append(lambda name=plan.layer, hidden=hidden: setattr(layers[name], "hide", hidden))
            layers[plan.layer].hide = True
        backup = layers.new("ductus backup", set_active=False)
        backup.hide = True
        backups.append((layers, backup.info))
        for frame in layers[plan.target].frames:
            backup.frames.copy(frame)
        if plan.target == plan.layer:
            undo.append(lambda name=plan.layer, backup=backup.info: _bring_back(layers, name, backup))
        _carry_out(ob, layers[plan.target], layers[backup.info], plan)
    if active is not None:
        set_active_layer(ob, {plan.layer: plan.target for plan in plans}.get(active, active))


def _bring_back(layers, name, backup):
    _clear(layers[name])
    for frame in layers[backup].frames:
        layers[name].frames.copy(frame)


def _duplicate(ob, layer, name):
    """A copy of a layer with its drawings, right above it."""
    before = {other.info for other in ob.data.layers}
    ob.data.layers.active = layer
    with bpy.context.temp_override(object=ob, active_object=ob):
        bpy.ops.gpencil.layer_duplicate(mode="ALL")
    copy = next(other for other in ob.data.layers if other.info not in before)
    copy.info = name
    return copy


def _clear(layer):
    for frame in list(layer.frames):
        layer.frames.remove(frame)


def _carry_out(ob, layer, backup, plan):
    there = {frame.frame_number for frame in layer.frames}
    wanted = (there - plan.drop) | {frame.number for frame in plan.frames}
    if wanted != there or any(frame.number != frame.base for frame in plan.frames):
        _rebuild(layer, backup, wanted, {frame.number: frame.base for frame in plan.frames})
    frames = {frame.frame_number: frame for frame in layer.frames}
    for todo in plan.frames:
        strokes = frames[todo.number].strokes
        olds = list(strokes)
        for change in todo.changes:
            _set_points(ob, olds[change.index], change.points, change.color)
        for addition in todo.additions:
            fresh = strokes.new()
            _take_after(fresh, olds[addition.like])
            fresh.use_cyclic = addition.closed
            _set_points(ob, fresh, addition.points, addition.color)
        for place in todo.removals:
            strokes.remove(olds[place])


def _rebuild(layer, backup, wanted, bases):
    """The layer's drawings anew, in the order of their frames, which frames.copy() does not look after itself."""
    sources = {frame.frame_number: frame for frame in backup.frames}
    before = {frame.frame_number for frame in layer.frames}
    _clear(layer)
    for number in sorted(wanted):
        frame = layer.frames.copy(sources[bases.get(number, number)])
        frame.frame_number = number
        frame.select = number in before and frame.select
        if number not in before:
            frame.keyframe_type = "JITTER"


def _take_after(stroke, other):
    for prop in other.bl_rna.properties:
        if not prop.is_readonly and prop.identifier not in {"select", "select_index", "rna_type"}:
            setattr(stroke, prop.identifier, getattr(other, prop.identifier))


def _set_points(ob, stroke, values, color):
    points = stroke.points
    position = np.ascontiguousarray(values["position"], dtype=np.float32)
    while len(points) > len(position):
        points.pop()
    while len(points) < len(position):
        many = min(PIECE, len(position) - len(points))
        points.add(many)
        if len(points) < len(position):
            points.foreach_set("co", position[:len(points)].ravel())
    for name, (theirs, size) in ATTRIBUTES.items():
        if name in values and name != "select":
            points.foreach_set(theirs, np.ascontiguousarray(values[name], dtype=np.float32).ravel())
    chosen = values.get("select")
    if chosen is not None and len(chosen):
        # This sets all points. Blender looks for the line anew for every point whose selection is set by itself.
        stroke.select = bool(chosen.any())
        if chosen.any() and not chosen.all():
            points.foreach_set("select", np.ascontiguousarray(chosen, dtype=bool))
    if color is not None:
        points.foreach_set("vertex_color", np.tile(np.float32(_linear(color) + (1,)), len(points)))
    for name, weights in values.items():
        if isinstance(name, tuple):
            # One by one, as with reading; only for lines that have weights at all.
            for place, weight in enumerate(weights.tolist()):
                if weight >= 0:
                    points.weight_set(vertex_group_index=name[1], point_index=place, weight=weight)
    if len(points):
        points.update()


def active_layer(ob):
    layer = ob.data.layers.active
    return layer.info if layer is not None else None


def set_active_layer(ob, name):
    if name in ob.data.layers:
        ob.data.layers.active = ob.data.layers[name]


def hide_layer(ob, name, hidden):
    ob.data.layers[name].hide = hidden


def remove_layer(ob, name):
    ob.data.layers.remove(ob.data.layers[name])


def record(ob):
    kept = ob.data.get(RECORD)
    return kept.to_dict() if kept is not None else {}


def set_record(ob, dictionary):
    if dictionary:
        ob.data[RECORD] = dictionary
    elif RECORD in ob.data:
        del ob.data[RECORD]
