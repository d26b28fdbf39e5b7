# SPDX-License-Identifier: GPL-3.0-or-later
"""Grease Pencil objects for the tests, and what is read off them."""
import contextlib
import math
import unittest

import bpy
import mathutils
import numpy as np


class Scene:
    """An empty file with one Grease Pencil object that has one layer, one material and a drawing at frame 1."""

    def __init__(self, name="Lines", clear=True):
        if clear:
            bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=False)
            bpy.ops.ed.undo_push(message="start")
        self.data = bpy.data.grease_pencils.new(name)
        self.ob = bpy.data.objects.new(name, self.data)
        bpy.context.collection.objects.link(self.ob)
        bpy.context.view_layer.objects.active = self.ob
        self.ob.select_set(True)
        self.material = self.add_material("Ink")
        self.layer = self.data.layers.new("Layer", set_active=True)
        self.frame = self.layer.frames.new(1)

    def add_material(self, name):
        material = bpy.data.materials.new(name)
        bpy.data.materials.create_gpencil_data(material)
        self.data.materials.append(material)
        return material

    def stroke(self, points, frame=None, width=20, closed=False, **channels):
        """A line through `points` (n x 3)."""
        stroke = (frame or self.frame).strokes.new()
        points = np.asarray(points, dtype=np.float32).reshape(-1, 3)
        stroke.line_width, stroke.use_cyclic = width, closed
        if len(points):
            stroke.points.add(len(points))
            stroke.points.foreach_set("co", points.ravel())
            channels = {"pressure": 1.0, "strength": 1.0, **channels}
            for name, values in channels.items():
                width = 4 if name == "vertex_color" else 1
                values = np.broadcast_to(np.asarray(values, dtype=np.float32).reshape(-1, width), (len(points), width))
                stroke.points.foreach_set(name, np.ascontiguousarray(values).ravel())
            stroke.points.update()
        return stroke

    def wave(self, frame=None, x=0.0, z=0.0, phase=0.0, count=40, **more):
        return self.stroke(wave(x, z, phase, count), frame, **more)


def wave(x=0.0, z=0.0, phase=0.0, count=40):
    t = np.linspace(0, 1, count)
    return np.stack((x + t, 0 * t, z + 0.15 * np.sin(9 * t + phase)), axis=1)


def helix(count=80):
    t = np.linspace(0, 1, count)
    return np.stack((np.cos(4 * t), np.sin(4 * t), t), axis=1)


def read(stroke, name, size=1):
    values = np.empty(len(stroke.points) * size, dtype=np.float32)
    stroke.points.foreach_get(name, values)
    return values.reshape(-1, size) if size > 1 else values


def positions(stroke):
    return read(stroke, "co", 3)


def snapshot(data):
    """All that the add-on could change in a Grease Pencil."""
    layers = []
    for layer in data.layers:
        frames = []
        for frame in layer.frames:
            strokes = [(stroke.use_cyclic, stroke.material_index, stroke.line_width, stroke.select,
                        positions(stroke).tobytes(), read(stroke, "pressure").tobytes(),
                        read(stroke, "strength").tobytes(), read(stroke, "uv_rotation").tobytes(),
                        read(stroke, "vertex_color", 4).tobytes()) for stroke in frame.strokes]
            frames.append((frame.frame_number, frame.keyframe_type, strokes))
        layers.append((layer.info, layer.hide, layer.lock, frames))
    active = data.layers.active
    return layers, active.info if active else None, {key: data[key].to_dict() for key in data.keys()}


def restyle(**values):
    return bpy.ops.ductus.restyle("EXEC_DEFAULT", **{"hand": "anna", **values})


class Case(unittest.TestCase):
    def setUp(self):
        self.scene = Scene()

    @contextlib.contextmanager
    def assertRefused(self, *words):
        """The operator reports an error whose sentence holds these words, and nothing is changed."""
        before = {data.name: snapshot(data) for data in bpy.data.grease_pencils}
        with self.assertRaises(RuntimeError) as caught:
            yield
        sentence = str(caught.exception)
        for word in words:
            self.assertIn(word, sentence)
        self.assertNotIn("Traceback", sentence)
        self.assertEqual(before, {data.name: snapshot(data) for data in bpy.data.grease_pencils})

    def assertNear(self, a, b, tolerance=1e-5):
        a, b = np.asarray(a, dtype=float), np.asarray(b, dtype=float)
        self.assertEqual(a.shape, b.shape)
        self.assertLessEqual(float(np.abs(a - b).max(initial=0)), tolerance)

    def assertMoved(self, stroke, before):
        after = positions(stroke)
        self.assertFalse(after.shape == before.shape and np.allclose(after, before, atol=1e-6), "the line did not move")

    def assertNearLine(self, stroke, line, share):
        """Every point of the stroke lies near the polyline `line`: within that share of its extent."""
        fine = np.concatenate([a + np.linspace(0, 1, 20)[:, None] * (b - a) for a, b in zip(line[:-1], line[1:])])
        apart = np.sqrt(((positions(stroke)[:, None] - fine[None]) ** 2).sum(axis=2)).min(axis=1)
        self.assertLessEqual(apart.max(), share * np.ptp(line, axis=0).max())


def look_from(angles):
    """Turns the 3D viewports' views."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                region = area.spaces.active.region_3d
                region.view_perspective = "ORTHO"
                region.view_rotation = mathutils.Euler(angles).to_quaternion()


def turned(x=0.0, y=0.0, z=0.0):
    return tuple(math.radians(v) for v in (x, y, z))
