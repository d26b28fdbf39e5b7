# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel in the sidebar of the 3D viewport, and presets: for each operation, made from its table."""

import bpy
from bl_operators.presets import AddPresetBase

from . import binding, properties
from .operators import groups, operator_name, settings_name
from .own import OWN

CATEGORY = "Ductus"


def settings_for(operation):
    """The class of the operation's group in the scene."""
    return type(f"DUCTUS_PG_{settings_name(operation)}", (bpy.types.PropertyGroup,), {
        "__doc__": operation.summary,
        "__annotations__": properties.annotations(OWN + operation.params),
        "__module__": __name__,
    })


def presets_for(operation):
    """The menu of presets and the operator that saves one."""
    name = settings_name(operation)
    saver = type(f"DUCTUS_OT_{name}_preset_add", (AddPresetBase, bpy.types.Operator), {
        "__doc__": "Save the values as a preset, or remove it",
        "__module__": __name__,
        "bl_idname": f"ductus.{name}_preset_add",
        "bl_label": "Save Preset",
        "preset_menu": f"DUCTUS_MT_{name}_presets",
        "preset_defines": [f"group = bpy.context.scene.ductus.{name}"],
        "preset_values": [f"group.{one}" for one in properties.names(OWN + operation.params)],
        "preset_subdir": f"ductus/{name}",
    })

    def draw(self, context):
        for preset in operation.presets:
            one = self.layout.operator("ductus.table_preset", text=preset.label)
            one.operation, one.preset = operation.id, preset.id
        self.layout.separator()
        bpy.types.Menu.draw_preset(self, context)

    menu = type(f"DUCTUS_MT_{name}_presets", (bpy.types.Menu,), {
        "__module__": __name__,
        "bl_label": "Presets",
        "preset_subdir": f"ductus/{name}",
        "preset_operator": "script.execute_preset",
        "draw": draw,
    })
    return [saver, menu]


class _Sidebar:
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = CATEGORY


def panels_for(operation):
    """The operation's panel, and a closed one below it for its own values and each group of advanced ones."""
    name = settings_name(operation)
    parent = f"DUCTUS_PT_{name}"

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        group = getattr(context.scene.ductus, name)
        row = layout.row(align=True)
        row.menu(f"DUCTUS_MT_{name}_presets", text="Presets")
        row.operator(f"ductus.{name}_preset_add", text="", icon="ADD")
        row.operator(f"ductus.{name}_preset_add", text="", icon="REMOVE").remove_active = True
        for param in operation.params:
            if param.type == "hand":
                row = layout.row(align=True)
                row.prop(group, properties.identifier(param))
                chooser = row.operator("ductus.choose_file", text="", icon="FILE_FOLDER")
                chooser.group, chooser.setting = name, properties.identifier(param)
        properties.draw(layout, group, [param for param in operation.params if param.type != "hand"], False)
        layout.separator()
        properties.draw(layout, group, [own for own in OWN if own.group == OWN[0].group], False)
        column = layout.column()
        column.scale_y = 1.4
        column.operator(operator_name(operation), icon="GREASEPENCIL").from_panel = True
        layout.operator("ductus.restore_original", icon="LOOP_BACK")

    def panel(suffix, label, body, closed=True):
        return type(f"{parent}_{suffix}", (_Sidebar, bpy.types.Panel), {
            "__module__": __name__, "bl_label": label, "bl_parent_id": parent,
            "bl_options": {"DEFAULT_CLOSED"} if closed else set(), "draw": body})

    def body_of(params, advanced_too):
        def body(self, context):
            self.layout.use_property_split = True
            self.layout.use_property_decorate = False
            group = getattr(context.scene.ductus, name)
            properties.draw(self.layout, group, params, False)
            if advanced_too:
                properties.draw(self.layout, group, params, True)
        return body

    main = type(parent, (_Sidebar, bpy.types.Panel), {
        "__module__": __name__, "bl_label": operation.label, "draw": draw})
    made = [main]
    own_groups = []
    for own in OWN:
        if own.group not in own_groups:
            own_groups.append(own.group)
    for k, group in enumerate(own_groups[1:]):
        made.append(panel(f"own{k}", group, body_of([own for own in OWN if own.group == group], True)))
    for k, group in enumerate(groups(operation.params)):
        params = [param for param in operation.params if param.group == group and param.advanced]
        made.append(panel(f"more{k}", f"{group}: More" if any(
            param.group == group and not param.advanced for param in operation.params) else group,
            body_of(params, True)))
    return made


class DUCTUS_PT_missing(_Sidebar, bpy.types.Panel):
    """In the place of the operations' panels where there are none."""

    bl_label = CATEGORY

    @classmethod
    def poll(cls, context):
        return bool(binding.problem())

    def draw(self, context):
        draw_sentence(self.layout, binding.problem())
        self.layout.operator("preferences.addon_show", text="Preferences of the Add-on").module = __package__


def draw_sentence(layout, sentence, width=48):
    """A long sentence in lines."""
    import textwrap

    column = layout.column(align=True)
    column.scale_y = 0.8
    for number, line in enumerate(textwrap.wrap(sentence, width, break_long_words=True)):
        column.label(text=line, icon="ERROR" if number == 0 else "BLANK1")
