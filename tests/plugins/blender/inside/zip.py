# SPDX-License-Identifier: GPL-3.0-or-later
"""Installs, uses or removes the add-on's zip as the preferences do."""
import os
import sys

import bpy

step, path = sys.argv[sys.argv.index("--") + 1:]
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

if step == "install":
    bpy.ops.preferences.addon_install(filepath=path)
    bpy.ops.preferences.addon_enable(module="ductus_addon")
    bpy.ops.wm.save_userpref()
if step in ("install", "use"):
    from helpers import Scene, positions

    import ductus_addon
    from ductus_addon import binding

    scripts = os.path.realpath(os.environ["BLENDER_USER_SCRIPTS"])
    assert os.path.realpath(ductus_addon.__file__).startswith(scripts), ductus_addon.__file__
    assert binding.problem() == "", binding.problem()
    assert os.path.realpath(binding.library_path()).startswith(scripts), binding.library_path()
    assert binding.hands(), "there are no hands"
    scene = Scene()
    before = positions(scene.wave())
    for operation in binding.operations():
        run = getattr(bpy.ops.ductus, operation.id.replace("-", "_"))
        assert run("EXEC_DEFAULT") == {"FINISHED"}
    after = positions(scene.frame.strokes[0])
    assert after.shape != before.shape or (after != before).any(), "nothing has changed"
else:
    bpy.ops.preferences.addon_disable(module="ductus_addon")
    assert not hasattr(bpy.types.Scene, "ductus")
    # It draws the preferences anew, and wants an area for that.
    with bpy.context.temp_override(area=bpy.context.window_manager.windows[0].screen.areas[0]):
        bpy.ops.preferences.addon_remove(module="ductus_addon")
print(f"{step}: done")
