# SPDX-License-Identifier: GPL-3.0-or-later
"""blender -b --factory-startup --addons ductus_addon --python bench/blender.py [-- LINES POINTS]

How much of a run in Blender is the core's, and how it compares with Blender's own modifiers applied to the same object.
Seconds are processor time, all threads together, which a busy machine disturbs least; only ratios within one run mean
anything. bench/blender starts it with the add-on from the build.
"""
import sys
import time

import bpy
import numpy as np

from ductus_addon import binding, operators

arguments = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
LINES, POINTS = (int(value) for value in (arguments + ["2000", "50"][len(arguments):])[:2])
TIMES = 3


def scene():
    """LINES lines of POINTS points each: handwriting-like arcs and waves in rows."""
    for ob in list(bpy.data.objects):
        bpy.data.objects.remove(ob)
    for data in list(bpy.data.grease_pencils):
        bpy.data.grease_pencils.remove(data)
    data = bpy.data.grease_pencils.new("Bench")
    ob = bpy.data.objects.new("Bench", data)
    bpy.context.collection.objects.link(ob)
    bpy.context.view_layer.objects.active = ob
    ob.select_set(True)
    material = bpy.data.materials.new("Ink")
    bpy.data.materials.create_gpencil_data(material)
    data.materials.append(material)
    frame = data.layers.new("Lines", set_active=True).frames.new(1)
    random = np.random.default_rng(1)
    t = np.linspace(0, 1, POINTS)
    for k in range(LINES):
        turns, height, phase = random.uniform(1, 4), random.uniform(0.05, 0.2), random.uniform(0, 6)
        points = np.stack((k % 50 + 0.8 * t, 0 * t, k // 50 + height * np.sin(turns * t + phase)), axis=1)
        stroke = frame.strokes.new()
        stroke.line_width = 20
        stroke.points.add(POINTS)
        stroke.points.foreach_set("co", points.astype(np.float32).ravel())
        stroke.points.foreach_set("pressure", np.ones(POINTS, dtype=np.float32))
        stroke.points.foreach_set("strength", np.ones(POINTS, dtype=np.float32))
        stroke.points.update()
    return ob


def timed(work):
    start = time.process_time()
    work()
    return time.process_time() - start


def ours(**values):
    """Seconds: all, and the core's; and the points that come out."""
    ob = scene()
    core = []
    ductus = binding.ductus()
    real = ductus.run

    def run(*positional, **named):
        start = time.process_time()
        result = real(*positional, **named)
        core.append(time.process_time() - start)
        return result
    ductus.run = run
    operator = getattr(bpy.ops.ductus, operators.settings_name(binding.operations()[0]))
    total = timed(lambda: operator("EXEC_DEFAULT", **values))
    ductus.run = real
    return total, core[0], sum(len(stroke.points) for stroke in ob.data.layers[0].frames[0].strokes)


def modifier(kind):
    ob = scene()
    made = ob.grease_pencil_modifiers.new("One", kind)
    if kind == "GP_THICK":
        made.thickness_factor = 0.5
    return timed(lambda: bpy.ops.object.gpencil_modifier_apply(modifier="One"))


def best(measure):
    return min((measure() for _ in range(TIMES)), key=lambda found: found[0] if isinstance(found, tuple) else found)


print(f"{LINES} lines of {POINTS} points: {LINES * POINTS} points")
rows = []
for label, values in (("all at defaults", {}), ("pose only", {"mode": "pose"})):
    total, core, points = best(lambda: ours(**values))
    rows.append((label, total, core, points))
noise, thick = best(lambda: modifier("GP_NOISE")), best(lambda: modifier("GP_THICK"))
print(f"{'':24}{'seconds':>9}{'core':>9}{'add-on':>9}{'share':>8}{'points':>10}")
for label, total, core, points in rows:
    print(f"{label:24}{total:9.2f}{core:9.2f}{total - core:9.2f}{(total - core) / core:8.3f}{points:10}")
for label, seconds in (("Noise modifier applied", noise), ("Thickness applied", thick)):
    print(f"{label:24}{seconds:9.3f}")
for label, total, core, points in rows:
    print(f"{label}: the add-on's part takes {(total - core) / noise:.1f} times as long as applying Noise, "
          f"{(total - core) / thick:.1f} times as long as applying Thickness; for {points / (LINES * POINTS):.1f} "
          "times the points")
