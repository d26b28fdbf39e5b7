# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on's preferences: which libductus, and what is wrong with it."""

import bpy

from . import binding
from .panels import draw_sentence


def _changed(self, context):
    from . import reload_operations

    reload_operations(self.library)


class DUCTUS_OT_look_again(bpy.types.Operator):
    """Look for libductus and its operations again"""

    bl_idname = "ductus.look_again"
    bl_label = "Look Again"
    bl_options = {"INTERNAL"}

    def execute(self, context):
        from . import reload_operations

        problem = reload_operations(library_path(context))
        if problem:
            self.report({"ERROR"}, problem[:1].upper() + problem[1:] + ".")
            return {"CANCELLED"}
        return {"FINISHED"}


class DuctusPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    library: bpy.props.StringProperty(
        name="Library", subtype="FILE_PATH", update=_changed,
        description="The file libductus.so; empty for the one that came with the add-on, or the system's")

    def draw(self, context):
        layout = self.layout
        row = layout.row()
        row.prop(self, "library")
        row.operator("ductus.look_again", text="", icon="FILE_REFRESH")
        if binding.problem():
            draw_sentence(layout, binding.problem(), 90)
            return
        layout.label(text=f"libductus {binding.version()}: {binding.library_path()}", icon="CHECKMARK")
        layout.label(text=f"Hands: {', '.join(binding.hands()) or 'none'}")
        layout.label(text="Operations: " + ", ".join(operation.label for operation in binding.operations()))


def library_path(context):
    """The path that the user has given, or ""."""
    addon = context.preferences.addons.get(__package__)
    given = addon.preferences.library if addon is not None and addon.preferences is not None else ""
    return bpy.path.abspath(given) if given else ""


CLASSES = (DUCTUS_OT_look_again, DuctusPreferences)
