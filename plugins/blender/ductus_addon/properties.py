# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender properties made from tables of parameters, and settings read back from them.

One parameter becomes one property, except "auto": a switch `x_auto` and the number `x`. The names are the parameters'
ids with underscores.
"""

import keyword

import bpy

from . import binding
from .own import OWN

# Names that mean something else to Blender.
_RESERVED = {"name", "rna_type", "bl_rna", "type", "id_data", "properties", "layout", "options", "macros", "report",
             "execute", "invoke", "modal", "draw", "check", "cancel", "poll", "has_reports", "show_advanced", "from_panel"}
_OWN_NAMES = {own.id.replace("-", "_") for own in OWN}

# Blender's integers have 32 bits.
_LIMIT = 2**31 - 1


def identifier(param):
    """The property's name."""
    name = param.id.replace("-", "_")
    own = any(param is one for one in OWN)
    if keyword.iskeyword(name) or name in _RESERVED or (name in _OWN_NAMES and not own) or not name.isidentifier():
        name = ("p_" if not name[:1].isalpha() else "") + name + "_"
    return name


def switch(param):
    """The name of the property that says "auto"."""
    return identifier(param) + "_auto"


def _tooltip(param):
    # Blender adds a full stop.
    text = param.tooltip.rstrip()
    text = text[:-1] if text.endswith(".") else text
    return f"{text} ({param.unit})" if param.unit else text


def _hand_names(self, context, text):
    names = binding.hands()
    # A field that holds a hand's name already offers them all.
    found = [] if text in names else [name for name in names if text.lower() in name.lower()]
    return found or names


def _number(param, default):
    precision = max(2, min(6, len(f"{param.step:.6f}".rstrip("0").split(".")[-1]))) if param.step else 3
    return bpy.props.FloatProperty(
        name=param.label, description=_tooltip(param), default=default, min=param.minimum, max=param.maximum,
        step=max(1, min(100, round(param.step * 100))), precision=precision)


def _whole(param, low, high):
    return bpy.props.IntProperty(name=param.label, description=_tooltip(param), default=int(param.default),
                                 min=int(max(low, -_LIMIT)), max=int(min(high, _LIMIT)), step=max(1, int(param.step)))


def annotations(params):
    """The annotations of a class with a property for each parameter."""
    made = {}
    for param in params:
        name = identifier(param)
        if param.type == "bool":
            made[name] = bpy.props.BoolProperty(name=param.label, description=_tooltip(param),
                                                default=param.default == "true")
        elif param.type == "int":
            made[name] = _whole(param, param.minimum, param.maximum)
        elif param.type == "seed":
            made[name] = _whole(param, 0, _LIMIT)
        elif param.type == "real":
            made[name] = _number(param, float(param.default))
        elif param.type == "auto":
            automatic = param.default == "auto"
            made[switch(param)] = bpy.props.BoolProperty(
                name=f"{param.label}: Auto", description=_tooltip(param), default=automatic)
            made[name] = _number(param, min(max(1.0, param.minimum), param.maximum) if automatic
                                 else float(param.default))
        elif param.type == "choice":
            made[name] = bpy.props.EnumProperty(
                name=param.label, description=_tooltip(param), default=param.default,
                items=[(choice.id, choice.label, choice.tooltip.rstrip(".")) for choice in param.choices])
        elif param.type == "hand":
            names = binding.hands()
            made[name] = bpy.props.StringProperty(
                name=param.label, description=_tooltip(param), default=names[0] if names else "",
                search=_hand_names, search_options={"SUGGESTION"})
        else:
            # A style, a list of strokes, or what a later version brings: text that the core checks.
            made[name] = bpy.props.StringProperty(name=param.label, description=_tooltip(param),
                                                  default=param.default)
    return made


def names(params):
    """The names of all properties of these parameters, in the order of the table."""
    return list(annotations(params))


def value(group, param):
    """A parameter's value as the core takes it."""
    if param.type == "auto" and getattr(group, switch(param)):
        return "auto"
    found = getattr(group, identifier(param))
    if isinstance(found, float):
        # A property holds the nearest float of 32 bits; its user wrote the shortest number that stands for it.
        return float(f"{found:.7g}")
    if isinstance(found, str) and found.startswith("//"):
        return bpy.path.abspath(found)
    return found


def assign(group, param, text):
    """Sets a parameter from the text of a preset or default."""
    name = identifier(param)
    if param.type == "auto":
        setattr(group, switch(param), text == "auto")
        if text != "auto":
            setattr(group, name, float(text))
    elif param.type == "bool":
        setattr(group, name, text == "true")
    elif param.type in ("int", "seed"):
        setattr(group, name, min(int(text), _LIMIT))
    elif param.type == "real":
        setattr(group, name, float(text))
    else:
        setattr(group, name, text)


def own_values(group):
    """The add-on's own values by their ids."""
    return {own.id: value(group, own) for own in OWN}


def is_active(group, own):
    """Whether an own value matters beside the others."""
    while own.needs:
        other = next(one for one in OWN if one.id == own.needs[0])
        if getattr(group, identifier(other)) not in own.needs[1]:
            return False
        own = other
    return True


def draw(layout, group, params, advanced):
    """Draws the parameters that are advanced, or those that are not."""
    column = layout.column()
    for param in params:
        if param.advanced != advanced:
            continue
        if param.type == "auto":
            row = column.row(align=True, heading=param.label)
            row.prop(group, switch(param), text="Auto", toggle=True)
            number = row.row(align=True)
            number.active = not getattr(group, switch(param))
            number.prop(group, identifier(param), text="")
            continue
        row = column.row(align=True)
        if hasattr(param, "needs"):
            row.active = is_active(group, param)
        row.prop(group, identifier(param))
