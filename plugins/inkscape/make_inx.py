#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes Inkscape's descriptions of the extensions from the operations' tables: make_inx.py PYTHON FOLDER

PYTHON is the folder of the package `ductus`. FOLDER gets one .inx file for each operation, and those of the companions
that take an operation away or make it final."""
import os
import sys
from xml.etree import ElementTree as xml

SPACE = "http://www.inkscape.org/namespace/inkscape/extension"
MENU = "Ductus"
SEED_LIMIT = 2147483647     # of whole numbers in a dialog
COMPANIONS = (
    ("remove", "Remove hand", "Gives the selected paths (or all, where none is selected) back as they were before Ductus "
     "changed them. What was moved since stays where it was moved to."),
    ("bake", "Bake hand", "Makes what Ductus did to the selected paths (or all, where none is selected) final: the "
     "original is forgotten, and the file becomes smaller."),
)


def add(parent, tag, text=None, **attributes):
    made = xml.SubElement(parent, tag, {name.replace("_", "-"): str(value) for name, value in attributes.items()})
    made.text = text
    return made


def hidden(parent, name, value):
    add(parent, "param", value, name=name, type="string", gui_hidden="true")


def combo(parent, name, label, tooltip, choices, default):
    group = add(parent, "param", name=name, type="optiongroup", appearance="combo", gui_text=label + ":",
                gui_description=tooltip)
    # What stands first is the default of the dialog.
    for choice_id, choice_label in sorted(choices, key=lambda choice: choice[0] != default):
        add(group, "option", choice_label, value=choice_id)


def tooltip_of(param):
    """The parameter's own sentences, and those of its choices."""
    lines = [param.tooltip] + [f"{choice.label}: {choice.tooltip}" for choice in param.choices if choice.tooltip]
    return "\n".join(lines)


def label_of(param):
    return f"{param.label} ({param.unit})" if getattr(param, "unit", "") else param.label


def digits(step):
    """Digits behind the point that a number with this step needs."""
    text = f"{step:g}"
    return min(6, max(2, len(text.partition(".")[2]))) if step else 3


def add_number(page, name, param, default):
    whole = param.type in ("int", "seed")
    low, high = (0, SEED_LIMIT) if param.type == "seed" else (param.minimum, param.maximum)
    more = {} if whole else {"precision": digits(getattr(param, "step", 0.001))}
    add(page, "param", default, name=name, type="int" if whole else "float", min=f"{low:g}", max=f"{high:.10g}",
        gui_text=label_of(param) + ":", gui_description=tooltip_of(param), **more)


def add_param(page, name, param, hands):
    """A parameter of any type of the tables."""
    if param.type == "bool":
        add(page, "param", str(param.default).lower(), name=name, type="bool", gui_text=param.label,
            gui_description=tooltip_of(param))
    elif param.type == "choice":
        combo(page, name, param.label, tooltip_of(param), [(choice.id, choice.label) for choice in param.choices],
              param.default)
    elif param.type == "auto":
        add(page, "param", "true" if param.default == "auto" else "false", name=name + "_auto", type="bool",
            gui_text=f"{param.label}: automatic", gui_description=tooltip_of(param))
        add_number(page, name, param, "1" if param.default == "auto" else param.default)
    elif param.type in ("int", "real", "seed"):
        add_number(page, name, param, str(param.default))
    elif param.type == "hand":
        combo(page, name, param.label, tooltip_of(param), [(hand, hand) for hand in hands],
              hands[0] if hands else None)
        add(page, "param", "", name=name + "_file", type="path", mode="file",
            gui_text="or my own (file or name):",
            gui_description="A library or recording of your own, or the name of one in your folder of hands. Leave it "
                            "empty to use the hand above.")
    else:
        # A type of a later version: text that the operation checks.
        add(page, "param", str(param.default), name=name, type="string", gui_text=param.label + ":",
            gui_description=tooltip_of(param))


def document(title, identity):
    root = xml.Element("inkscape-extension", {"xmlns": SPACE})
    add(root, "name", title)
    add(root, "id", identity)
    return root


def finish(root, path, tip):
    effect = add(root, "effect", needs_live_preview="true")
    add(effect, "object-type", "all")
    add(add(effect, "effects-menu"), "submenu", name=MENU)
    add(effect, "menu-tip", tip)
    add(add(root, "script"), "command", "ductus_effect.py", location="inx", interpreter="python")
    xml.indent(root, "  ")
    with open(path + ".new", "wb") as file:
        file.write(b'<?xml version="1.0" encoding="UTF-8"?>\n')
        file.write(xml.tostring(root, encoding="utf-8"))
        file.write(b"\n")
    os.replace(path + ".new", path)


def groups_of(params):
    """[(group, [param])] in the table's order."""
    found = {}
    for param in params:
        found.setdefault(param.group, []).append(param)
    return found.items()


def operation_inx(operation, hands, table, argument, folder):
    root = document(operation.label, f"org.ductus.{operation.id}")
    hidden(root, "task", "apply")
    hidden(root, "operation", operation.id)
    tabs = add(root, "param", name="tab", type="notebook")
    common = add(tabs, "page", name="common", gui_text=operation.params[0].group if operation.params else "Settings")
    add(common, "label", operation.summary)
    if len(operation.presets) > 1:
        told = "\n".join(f"{preset.label}: {preset.tooltip}" for preset in operation.presets)
        combo(common, "preset", "Preset", f"{told}\nWhat you change in this dialog wins over the preset.",
              [(preset.id, preset.label) for preset in operation.presets], operation.presets[0].id)
    for param in operation.params:
        if not param.advanced:
            add_param(common, argument(param.id), param, hands)
    line = add(tabs, "page", name="line", gui_text="Line")
    for param in table:
        add_param(line, param.id, param, hands)
    advanced = [param for param in operation.params if param.advanced]
    if advanced:
        page = add(tabs, "page", name="advanced", gui_text="Advanced")
        inner = add(page, "param", name="advanced_tab", type="notebook")
        for number, (group, params) in enumerate(groups_of(advanced)):
            inside = add(inner, "page", name=f"group{number}", gui_text=group)
            for param in params:
                add_param(inside, argument(param.id), param, hands)
    notes = add(tabs, "page", name="help", gui_text="Help")
    for text in (
            f"{operation.summary} Works on the selected paths and shapes, or on all of them where nothing is selected.",
            "Apply it again with other settings whenever you like: it starts from the original, which is kept in the file. "
            "Extensions > Ductus > Remove hand gives the original back; Bake hand forgets it.",
            "Locked and hidden layers, clones, images and what is inside clip paths, masks and symbols stay as they are. "
            "Turn text into paths first (Path > Object to Path)."):
        add(notes, "label", text)
    finish(root, os.path.join(folder, f"ductus_{operation.id.replace('-', '_')}.inx"), operation.summary)


def companion_inx(task, title, text, folder):
    """Without anything to set, Inkscape runs it at once."""
    root = document(title, f"org.ductus.{task}")
    hidden(root, "task", task)
    finish(root, os.path.join(folder, f"ductus_{task}.inx"), text)


def main():
    python, folder = sys.argv[1:3]
    sys.path[:0] = [python, os.path.dirname(os.path.abspath(__file__))]
    import ductus
    from ductus_inkscape.names import argument
    from ductus_inkscape.table import LINE
    hands = [hand.name for hand in ductus.hands() if hand.builtin]
    for operation in ductus.operations():
        operation_inx(operation, hands, LINE, argument, folder)
    for companion in COMPANIONS:
        companion_inx(*companion, folder)


if __name__ == "__main__":
    main()
