# SPDX-License-Identifier: GPL-3.0-or-later
"""Operations, their tables and their runs: <ductus/operation.h>."""
import ctypes
from collections import namedtuple

from . import _declarations as c
from ._library import Callbacks, Handle, call, load, string, text
from .drawing import Drawing

Choice = namedtuple("Choice", "id label tooltip")
Param = namedtuple("Param", "id label tooltip type unit minimum maximum step default choices group advanced")
Preset = namedtuple("Preset", "id label tooltip values")
Operation = namedtuple("Operation", "id label summary params presets")

PARAM_TYPES = {value: name[len("DUCT_PARAM_"):].lower() for name, value in c.ENUMS["duct_param_type"].items()}


def _param(p):
    choices = tuple(Choice(string(p.choices[i].id), string(p.choices[i].label), string(p.choices[i].tooltip))
                    for i in range(p.choice_count))
    return Param(string(p.id), string(p.label), string(p.tooltip), PARAM_TYPES[p.type], string(p.unit), p.minimum,
                 p.maximum, p.step, string(p.fallback), choices, string(p.group), p.advanced)


def _preset(p):
    values = {string(p.values[i].param): string(p.values[i].value) for i in range(p.value_count)}
    return Preset(string(p.id), string(p.label), string(p.tooltip), values)


def _operation(o):
    return Operation(string(o.id), string(o.label), string(o.summary),
                     tuple(_param(o.params[i]) for i in range(o.param_count)),
                     tuple(_preset(o.presets[i]) for i in range(o.preset_count)))


def operations():
    """The operations with their tables, in a fixed order."""
    found = []
    while True:
        pointer = load().duct_operation_at(len(found))
        if not pointer:
            return found
        found.append(_operation(pointer.contents))


class Settings(Handle):
    """Values for one operation's parameters, checked against its table as they are set."""
    _free = "duct_settings_free"

    def __init__(self, operation_id):
        found = ctypes.POINTER(c.duct_operation)()
        call("duct_operation_find", text(operation_id), ctypes.byref(found))
        super().__init__(self._make("duct_settings_new", None, found))
        self._libraries = {}

    def __setitem__(self, param, value):
        if type(value).__module__ == "numpy":
            value = value.item()        # numpy's numbers write themselves in other ways than Python's
        if isinstance(value, bool):
            value = "true" if value else "false"
        call("duct_settings_set", self._pointer, text(param), text(value))

    def __getitem__(self, param):
        value = load().duct_settings_text(self._pointer, text(param))
        if value is None:
            raise KeyError(param)
        return string(value)

    def preset(self, preset):
        """Sets all parameters to a preset's values; a hand stays."""
        call("duct_settings_preset", self._pointer, text(preset))

    def use_library(self, param, library):
        """Gives an opened Library for a parameter of type "hand"; None goes back to opening by name."""
        call("duct_settings_library", self._pointer, text(param), library._pointer if library is not None else None)
        # A new dict: one that a run in another thread keeps stays as it is.
        self._libraries = {**self._libraries, param: library}


def run(settings, drawing, progress=None, threads=0, trace=None):
    """Runs the settings' operation on a drawing, which stays as it is, and returns another one.

    `progress(fraction)` is called now and then; where it returns False the run is given up and Cancelled raised. What
    it raises gives up the run as well and is raised again. `trace(bytes)` takes the run's trace piece by piece.
    Python's lock is free during the run; settings and drawing must not be changed then. Raises Error."""
    kept = settings._libraries      # have to outlive the run
    callbacks = Callbacks()
    surroundings = callbacks.context(threads, progress)
    options = c.duct_run_options()
    if trace is not None:
        def write(data, size):
            trace(ctypes.string_at(data, size))
            return True
        options.trace = callbacks.made(c.duct_trace, write)
    made = callbacks.during(Drawing._take, "duct_operation_run", ctypes.byref(surroundings), settings._pointer,
                            drawing._pointer, ctypes.byref(options))
    del kept        # not before
    return made
