# SPDX-License-Identifier: GPL-3.0-or-later
"""Ductus for Blender: Grease Pencil lines in somebody's hand.

The operators, their settings, panels and presets are made from the tables of the core's operations when the add-on is
registered. Without the core the add-on registers as well, and says in its preferences what is missing.
"""

bl_info = {
    "name": "Ductus",
    "author": "The Ductus project",
    "version": (0, 1, 0),
    "blender": (3, 3, 0),
    "location": "3D Viewport > Sidebar > Ductus",
    "description": "Draws Grease Pencil lines with somebody's hand",
    "category": "Object",
}

import bpy

from . import binding, operators, panels, preferences

_made = []


def _register_operations():
    annotations = {}
    for operation in binding.operations():
        settings = panels.settings_for(operation)
        made = [settings, operators.operator_for(operation)]
        made += panels.presets_for(operation) + panels.panels_for(operation)
        for one in made:
            bpy.utils.register_class(one)
            _made.append(one)
        annotations[operators.settings_name(operation)] = bpy.props.PointerProperty(type=settings)
    root = type("DUCTUS_PG_scene", (bpy.types.PropertyGroup,), {"__annotations__": annotations, "__module__": __name__})
    bpy.utils.register_class(root)
    _made.append(root)
    bpy.types.Scene.ductus = bpy.props.PointerProperty(type=root)


def _unregister_operations():
    if hasattr(bpy.types.Scene, "ductus"):
        del bpy.types.Scene.ductus
    while _made:
        bpy.utils.unregister_class(_made.pop())


def reload_operations(path=""):
    """Loads libductus anew and makes everything that comes from its tables. Returns "", or what is wrong."""
    _unregister_operations()
    problem = binding.load(path)
    _register_operations()
    return problem


_fixed = operators.CLASSES + (panels.DUCTUS_PT_missing,) + preferences.CLASSES


def register():
    for one in _fixed:
        bpy.utils.register_class(one)
    reload_operations(preferences.library_path(bpy.context))


def unregister():
    _unregister_operations()
    for one in reversed(_fixed):
        bpy.utils.unregister_class(one)
