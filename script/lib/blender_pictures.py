# SPDX-License-Identifier: GPL-3.0-or-later
"""blender -b --addons ductus_addon --python blender_pictures.py -- FOLDER: renders the pictures of docs/blender.md."""
import os
import sys

import bpy
import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import blender_scene as scene

folder = sys.argv[sys.argv.index("--") + 1]


def run(ob, **values):
    bpy.context.view_layer.objects.active = ob
    bpy.ops.ductus.restyle("EXEC_DEFAULT", **values)


def beside():
    """The same drawing as it is and in a hand, in one frame."""
    scene.empty()
    for x, values in ((-3.7, None), (3.7, {"hand": "clara", "nib_aspect": 2.5, "strength": 0.05})):
        ob, frame = scene.pencil("Bicycle", (x, 0, 0))
        scene.drawing("bicycle.svg", frame)
        if values:
            run(ob, **values)
    scene.look((0, -10, 0), (90, 0, 0), 15)
    scene.render(os.path.join(folder, "render.png"), 1280, 440)


def wrapped(radius):
    """Bends the plane around a ball, a little smaller than it is."""
    def wrap(points):
        east, north = 0.72 * points[:, 0] / radius, 0.72 * points[:, 2] / radius
        return radius * np.stack((np.sin(east) * np.cos(north), -np.cos(east) * np.cos(north), np.sin(north)), axis=1)
    return wrap


def ball():
    """Lettering on a ball: drawn, and in a hand, seen from the side. Unrolled, the lines stay on the ball."""
    scene.empty()
    for x, hand in ((-3.1, None), (3.1, "bruno")):
        bpy.ops.mesh.primitive_uv_sphere_add(radius=2.57, location=(x, 0, 0), segments=64, ring_count=32)
        bpy.ops.object.shade_smooth()
        ob, frame = scene.pencil("Letters", (x, 0, 0))
        ob.rotation_euler[2] = -0.25
        scene.drawing("lettering.svg", frame, wrap=wrapped(2.6))
        bpy.context.view_layer.update()
        if hand:
            run(ob, hand=hand, variation=0.5, nib_aspect=2.0)
    scene.look((0, -12, 2), (80.5, 0, 0), 12.4)
    shading = bpy.context.scene.display.shading
    shading.light, shading.color_type, shading.single_color = "STUDIO", "SINGLE", (1, 1, 1)
    scene.render(os.path.join(folder, "ball.png"), 1280, 580)


def boil():
    """One held drawing that boils: three of its frames in a row."""
    for number in (1, 3, 5):
        scene.empty()
        ob, frame = scene.pencil("Cat")
        scene.drawing("cat.svg", frame)
        run(ob, hand="david", variation=1.0, frames="range", frame_start=1, frame_end=6, seeds="boil", boil_frames=2)
        bpy.context.scene.frame_set(number)
        scene.look((0, -10, 0), (90, 0, 0), 6.4)
        scene.render(os.path.join(folder, f"boil-{number}.png"), 430, 300)


beside()
ball()
boil()
