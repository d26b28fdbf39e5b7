# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python binding and, behind it, libductus: carried by the add-on, named in its preferences, or the system's."""

import importlib
import os
import sys

# In the add-on's own folder stands the binding's package; in a source tree it is wherever Python finds it.
CARRIED = os.path.join(os.path.dirname(__file__), "ductus")

_state = {"module": None, "problem": "", "operations": [], "hands": []}


def load(path=""):
    """Loads the library (from `path` where one is given). Returns "", or the sentence that says what is wrong; then
    there are no operations."""
    _state.update(operations=[], hands=[], problem="")
    try:
        if os.path.isdir(CARRIED):
            module = importlib.import_module(".ductus", __package__)
        else:
            module = importlib.import_module("ductus")
    except ImportError as error:
        _state["problem"] = f"the Python package of Ductus is not there ({error}): install the add-on's zip again"
        return _state["problem"]
    try:
        module.load(path or None)
        _state.update(module=module, operations=list(module.operations()))
    except module.Error as error:
        _state["problem"] = str(error)
    return _state["problem"]


def problem():
    """Why there are no operations, as a sentence; "" where there are."""
    return _state["problem"]


def ductus():
    """The binding; only where problem() is ""."""
    return _state["module"]


def operations():
    return _state["operations"]


def version():
    return ductus().version() if ductus() and not problem() else ""


def library_path():
    """Where the loaded library's file lies, or ""."""
    if ductus() is None or problem():
        return ""
    return getattr(ductus().load(), "_name", "")


def hands():
    """Names of the hands; read anew each time, since recordings may be added while Blender runs."""
    if ductus() is None or problem():
        return []
    try:
        _state["hands"] = [hand.name for hand in ductus().hands()]
    except ductus().Error as error:
        print(f"Ductus: {error}", file=sys.stderr)
    return _state["hands"]
