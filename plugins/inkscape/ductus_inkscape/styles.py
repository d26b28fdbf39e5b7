# SPDX-License-Identifier: GPL-3.0-or-later
"""What an element looks like: the few style properties that matter here, with inheritance."""
import re

import inkex

SVG = "{http://www.w3.org/2000/svg}"

# Property -> its value where nobody says anything; those that children do not inherit are marked.
INITIAL = {
    "stroke": "none", "stroke-width": "1", "stroke-opacity": "1", "stroke-dasharray": "none", "fill": "black",
    "fill-opacity": "1", "fill-rule": "nonzero", "visibility": "visible", "display": "inline",
    "marker-start": "none", "marker-mid": "none", "marker-end": "none", "vector-effect": "none",
}
SOUGHT = tuple(INITIAL) + ("marker",)
NOT_INHERITED = {"display", "vector-effect"}


def parse(text):
    """A style attribute as a dict, in its order."""
    made = {}
    for part in (text or "").split(";"):
        name, colon, value = part.partition(":")
        if colon:
            made[name.strip()] = value.strip()
    return made


def print_style(style):
    return ";".join(f"{name}:{value}" for name, value in style.items())


class Styles:
    """Looks styles up for one document."""

    def __init__(self, svg):
        # Rules of style sheets are inkex's to match; most drawings have none that hold anything.
        sheets = [element for element in svg.iter(SVG + "style") if (element.text or "").strip()]
        self._sheets = bool(sheets)
        self._known = {}

    def of(self, element):
        found = self._known.get(element)
        if found is not None:
            return found
        parent = element.getparent()
        base = self.of(parent) if parent is not None else INITIAL
        own = {name: element.get(name) for name in SOUGHT if element.get(name) is not None}
        if self._sheets and isinstance(element, inkex.BaseElement):
            cascaded = element.cascaded_style()
            own.update({name: str(cascaded[name]) for name in SOUGHT if name in cascaded})
        else:
            written = parse(element.get("style"))
            own.update({name: re.sub(r"\s*!important$", "", written[name]) for name in SOUGHT if name in written})
        if "marker" in own:
            own = {"marker-start": own["marker"], "marker-mid": own["marker"], "marker-end": own["marker"], **own}
        made = {}
        for name, initial in INITIAL.items():
            value = own.get(name)
            if value is None or value == "inherit":
                value = base[name] if value == "inherit" or name not in NOT_INHERITED else initial
            made[name] = value
        self._known[element] = made
        return made

    def shown(self, element):
        """False where the element or a group around it is not displayed."""
        at = element
        while at is not None and isinstance(at.tag, str):
            if self.of(at)["display"] == "none":
                return False
            at = at.getparent()
        return self.of(element)["visibility"] not in ("hidden", "collapse")


def number(text, fallback):
    """The leading number of a length."""
    match = re.match(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)", text or "")
    return float(match.group(1)) if match else fallback


def length(text, fallback):
    """A length in user units."""
    try:
        value = inkex.units.convert_unit(text, "px")
    except (ValueError, TypeError):
        value = 0
    return value if value else number(text, fallback)
