# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes for the pictures and the test in a window: drawings of the project as Grease Pencil objects."""
import math
import os

import bpy
import numpy as np

UNIT = 0.01  # Blender units a drawing pixel


def binding():
    from ductus_addon import binding

    return binding.ductus()


def empty():
    """Nothing in the scene; a light background."""
    for ob in list(bpy.data.objects):
        bpy.data.objects.remove(ob)


def pencil(name, location=(0, 0, 0)):
    """A Grease Pencil object with one layer and a drawing at frame 1. Returns the object and its drawing."""
    data = bpy.data.grease_pencils.new(name)
    ob = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(ob)
    ob.location = location
    material = bpy.data.materials.new("Ink")
    bpy.data.materials.create_gpencil_data(material)
    data.materials.append(material)
    data.layers.new("Lines", set_active=True).use_lights = False
    bpy.context.view_layer.objects.active = ob
    ob.select_set(True)
    return ob, data.layers[0].frames.new(1)


def line(frame, points, width=12, closed=False, color=None):
    stroke = frame.strokes.new()
    points = np.ascontiguousarray(points, dtype=np.float32)
    stroke.line_width, stroke.use_cyclic = width, closed
    stroke.points.add(len(points))
    stroke.points.foreach_set("co", points.ravel())
    for name in ("pressure", "strength"):
        stroke.points.foreach_set(name, np.ones(len(points), dtype=np.float32))
    if color is not None:
        color = [v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in color]
        stroke.points.foreach_set("vertex_color", np.tile(np.float32(color + [1]), len(points)))
    stroke.points.update()
    return stroke


def drawing(name, frame, width=None, wrap=lambda points: points):
    """Puts a drawing of data/drawings into a Grease Pencil drawing, its middle in the origin, upright."""
    source = binding().Drawing.read(os.path.join(os.environ["DUCTUS_SOURCE"], "data/drawings", name))
    across, down = source.size
    for stroke in source:
        x = (stroke.channel("x") - across / 2) * UNIT
        z = (down / 2 - stroke.channel("y")) * UNIT
        line(frame, wrap(np.stack((x, 0 * x, z), axis=1)), width or max(1, round(stroke.width * UNIT * 1000)),
             stroke.closed, stroke.color)
    return across * UNIT, down * UNIT


def look(location, angles, size):
    """A camera without perspective, and the colours as they are."""
    scene = bpy.context.scene
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    scene.collection.objects.link(camera)
    camera.location, camera.rotation_euler = location, [math.radians(angle) for angle in angles]
    camera.data.type, camera.data.ortho_scale = "ORTHO", size
    scene.camera = camera
    scene.view_settings.view_transform = "Standard"


def render(path, width, height):
    """Renders with Workbench on white."""
    scene = bpy.context.scene
    world = bpy.data.worlds.new("White")
    world.color = (1, 1, 1)
    scene.world = world
    scene.display.shading.background_type = "WORLD"
    scene.render.engine = "BLENDER_WORKBENCH"
    scene.render.resolution_x, scene.render.resolution_y = width, height
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "RGB"
    scene.render.filepath = path
    bpy.ops.render.render(write_still=True)


def view(area, size):
    """Turns a 3D viewport to look from the front at what is around the origin."""
    space = area.spaces.active
    space.show_region_ui = True
    space.overlay.show_overlays = False
    space.shading.background_type, space.shading.background_color = "VIEWPORT", (0.8, 0.8, 0.8)
    region = space.region_3d
    region.view_perspective = "ORTHO"
    region.view_rotation = (math.sqrt(0.5), math.sqrt(0.5), 0, 0)
    region.view_location, region.view_distance = (0, 0, 0), size
