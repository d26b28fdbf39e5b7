# SPDX-License-Identifier: GPL-3.0-or-later
"""The extension itself: one class for all operations, which come from their tables."""
import ductus
import inkex

from . import elements, memory, widths
from .names import argument
from .styles import Styles, length, number
from .table import LINE, LINE_IDS


def boolean(text):
    return text.strip().lower() in ("true", "1", "yes")


def plural(count, what):
    return f"{count} {what}" + ("" if count == 1 else "s")


class Effect(inkex.EffectExtension):
    """Applies an operation to the selected paths, or takes operations away again."""

    def add_arguments(self, pars):
        pars.error = self.refuse_arguments
        pars.add_argument("--tab")
        pars.add_argument("--advanced_tab")
        pars.add_argument("--task", default="apply", choices=("apply", "remove", "bake"))
        pars.add_argument("--operation", default="")
        pars.add_argument("--preset", default="")
        for param in LINE:
            kind = {"real": float, "bool": boolean}.get(param.type, str)
            pars.add_argument(f"--{param.id}", type=kind, default=param.default)
        for operation in ductus.operations():
            for param in operation.params:
                for name in (argument(param.id), argument(param.id) + "_auto", argument(param.id) + "_file"):
                    if not any(name == action.dest for action in pars._actions):
                        pars.add_argument(f"--{name}", default=None)

    @staticmethod
    def refuse_arguments(message):
        raise ductus.Error(f"{message}; install the extensions again, whole")

    def effect(self):
        if self.options.task == "apply":
            self.apply()
        else:
            self.take_away(self.options.task == "bake")
        memory.declare(self.svg)
        return True

    # Taking away

    def take_away(self, bake):
        found = elements.kept_by(self.svg, list(self.svg.selection))
        if not found:
            raise ductus.Error("nothing here was made by Ductus; select what was, or nothing for the whole document")
        if bake:
            self.bake(found)
        else:
            self.restore(found)

    def bake(self, found):
        effects = set()
        for element in found:
            effects |= memory.path_effects(element)
            memory.forget(element)
            for child in element:
                child.attrib.pop(memory.PART, None)
        for effect in memory.made_effects(self.svg, effects):
            effect.attrib.pop(memory.MADE, None)

    def restore(self, found):
        effects = set()
        for element in found:
            effects |= memory.path_effects(element)
            is_path = element.tag == elements.SVG + "path"
            memory.restore(element, ductus.Path(elements.path_data(element)).points if is_path else [])
        if effects:
            memory.drop_effects(self.svg, effects)

    # Applying

    def operation(self):
        for operation in ductus.operations():
            if operation.id == self.options.operation:
                return operation
        raise ductus.Error(f"this version of Ductus has no operation '{self.options.operation}'; install the extensions "
                           "again")

    def settings(self, operation):
        """The dialog's values; those of the preset where they were left at their defaults."""
        made = ductus.Settings(operation.id)
        preset = next((preset for preset in operation.presets if preset.id == self.options.preset), None)
        if preset is not None:
            made.preset(preset.id)
        for param in operation.params:
            value = getattr(self.options, argument(param.id))
            if param.type == "hand":
                value = getattr(self.options, argument(param.id) + "_file") or value
                if not value:
                    raise ductus.Error(f"{param.label}: choose one, or a file of your own")
            if param.type == "auto" and boolean(getattr(self.options, argument(param.id) + "_auto") or "false"):
                value = "auto"
            if value is None or (preset is not None and same(param, value) and param.id in preset.values):
                continue
            made[param.id] = value
        return made

    def line_values(self):
        return {name: getattr(self.options, name) for name in LINE_IDS}

    def apply(self):
        operation = self.operation()
        settings = self.settings(operation)
        line = self.line_values()
        if not line["tolerance"] > 0:
            raise ductus.Error(f"tolerance: {line['tolerance']:g} is not allowed; give a number above 0")
        selected = [elements.result_around(element) for element in self.svg.selection]
        self.restore(elements.kept_by(self.svg, selected))
        styles = Styles(self.svg)
        found = elements.collect(self.svg, selected, styles)
        self.refuse_nothing(found, bool(selected))
        jobs, drawing = self.read(found.shapes, styles, line)
        if not jobs:
            raise ductus.Error("the selected paths draw nothing: they are empty, or scaled to nothing")
        result = ductus.run(settings, drawing)
        kept = {param.id: settings[param.id] for param in operation.params}
        kept = {"operation": operation.id, "settings": kept, "line": line}
        before, after = self.write(jobs, result, line, kept, styles)
        # A message is a window to be closed, and stops Inkscape where it runs without one: only who asked gets it.
        if line["report"]:
            left = f"; {plural(found.texts, 'text')} left alone: turn text into paths first (Path > Object to Path)"
            inkex.errormsg(f"{plural(len(jobs), 'path')}: {before} nodes before, {after} after"
                           + (left if found.texts else ""))

    def refuse_nothing(self, found, selected):
        if found.shapes:
            return
        where = "the selection holds" if selected else "the drawing holds"
        if found.texts:
            raise ductus.Error(f"{where} text only: turn it into paths first (Path > Object to Path)")
        if found.clones:
            raise ductus.Error(f"{where} clones only, which follow their originals: select those, or unlink the clones "
                               "(Edit > Clone > Unlink Clone)")
        if found.locked:
            raise ductus.Error(f"{where} nothing that is not locked: unlock the layer or object first")
        if found.hidden:
            raise ductus.Error(f"{where} nothing that is not hidden: show the layer or object first")
        raise ductus.Error(f"{where} no paths or shapes: select some, or nothing for the whole drawing")

    def read(self, shapes, styles, line):
        """All lines in one drawing, in pixels of the page, so that the operation sees the drawing as a whole."""
        maps = elements.Maps(self.svg)
        drawing = ductus.Drawing(self.svg.viewport_width or 0, self.svg.viewport_height or 0)
        jobs = []
        for position, element in enumerate(shapes):
            pair = maps.pair(element)
            if pair is None:
                continue
            path = ductus.Path(elements.path_data(element))
            nodes = path.nodes
            path.map(pair[0])
            first = len(drawing)
            style = styles.of(element)
            try:
                path.flatten(element.get("id") or f"shape {position}", min(0.05, line["tolerance"]), drawing)
            except ductus.Error as error:
                raise ductus.Error(f"{element.get('id') or element.tag.rpartition('}')[2]}: {error}", error.status)
            width = length(style["stroke-width"], 1.0)
            if style["vector-effect"] != "non-scaling-stroke":
                width *= pair[2]
            for index in range(first, len(drawing)):
                drawing.style(index, width=width, opacity=min(1, max(0, number(style["stroke-opacity"], 1))))
            if len(drawing) > first:
                jobs.append((element, style, pair, first, len(drawing), nodes, width))
        return jobs, drawing

    def write(self, jobs, result, line, kept, styles):
        before = after = 0
        ids = Ids(self.svg)
        followed = elements.followed_by_text(self.svg)
        # Everything that can fail is done before the first element changes: a document is changed whole or not at all,
        # and Inkscape takes none that comes with an error.
        for element, style, pair, first, end, nodes, width in jobs:
            strokes = [result[index] for index in range(first, end)]
            values = {**line, "stroke_width": width}
            if element.get("id") in followed:
                values["width_kind"] = "none"       # text on an outline would go around it
            made = widths.Result(element, style, strokes, pair, decimals(pair[2]), values, ids.new)
            count, frame = widths.apply(made)
            made.change.done(kept, frame, (nodes, count))
            before += nodes
            after += count
        return before, after


def same(param, value):
    """True where a dialog's value is the parameter's default."""
    if param.type in ("int", "real", "seed"):
        try:
            return float(value) == float(param.default)
        except ValueError:
            return False
    return str(value).lower() == param.default


def decimals(factor):
    """Digits that keep a thousandth of a pixel; `factor` is the pixels that a unit of the coordinates has."""
    digits = 3
    while factor > 1 and digits < 15:
        factor /= 10
        digits += 1
    return digits


class Ids:
    """Ids that the document does not have, the same ones on every run."""

    def __init__(self, svg):
        self._svg = svg
        self._taken = None

    def new(self, wanted):
        if self._taken is None:
            self._taken = {element.get("id") for element in self._svg.iter() if isinstance(element.tag, str)}
        made, count = wanted, 1
        while made in self._taken:
            count += 1
            made = f"{wanted}-{count}"
        self._taken.add(made)
        return made
