# SPDX-License-Identifier: GPL-3.0-or-later
"""Which elements of a document an operation works on, and their geometry as drawings have it: pixels of the page."""
import inkex

from . import memory, shapes

SVG = "{http://www.w3.org/2000/svg}"
SODIPODI = "{http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd}"
INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}"
HREF = "{http://www.w3.org/1999/xlink}href"

GROUPS = {SVG + "g", SVG + "a", SVG + "switch", SVG + "svg"}
SHAPES = {SVG + name for name in ("path", "rect", "circle", "ellipse", "line", "polyline", "polygon")}
TEXTS = {SVG + "text", SVG + "flowRoot"}
CLONES = {SVG + "use"}

# What gives a shape its form, and means nothing on the path that it becomes.
GEOMETRY = ("d", "x", "y", "width", "height", "rx", "ry", "cx", "cy", "r", "points", "x1", "y1", "x2", "y2")

MAX_DEPTH = 256     # groups in one another


class Found:
    """What a selection holds."""

    def __init__(self):
        self.shapes = []
        self.texts = 0
        self.clones = 0
        self.locked = 0
        self.hidden = 0


def in_page(element):
    """False inside <defs>, symbols, clip paths, masks, markers and patterns, where things are kept, not drawn."""
    at = element.getparent()
    while at is not None:
        if at.tag not in GROUPS:
            return False
        at = at.getparent()
    return True


def is_locked(element):
    at = element
    while at is not None:
        if at.get(SODIPODI + "insensitive") == "true":
            return True
        at = at.getparent()
    return False


def collect(svg, selected, styles):
    """The shapes among the selected elements and inside the selected groups; of the whole page where nothing is
    selected. In document order, each once."""
    found = Found()
    seen = set()

    def add(element, depth):
        if not isinstance(element.tag, str) or element in seen or depth > MAX_DEPTH:
            return
        seen.add(element)
        known = element.tag in GROUPS or element.tag in SHAPES or element.tag in TEXTS or element.tag in CLONES
        if not known:
            return
        if element.get(SODIPODI + "insensitive") == "true":
            found.locked += 1
            return
        style = styles.of(element)
        if style["display"] == "none":
            found.hidden += 1
            return
        if element.tag in GROUPS:
            for child in element:
                add(child, depth + 1)
        elif element.tag in TEXTS:
            found.texts += 1
        elif element.tag in CLONES:
            found.clones += 1
        elif style["visibility"] in ("hidden", "collapse"):
            found.hidden += 1
        else:
            found.shapes.append(element)

    for element in selected or [svg]:
        if not in_page(element):
            continue
        parent = element.getparent()
        if parent is not None and is_locked(parent):
            found.locked += 1
        elif parent is not None and not styles.shown(parent):
            found.hidden += 1
        else:
            add(element, 0)
    order = {element: number for number, element in enumerate(svg.iter())}
    found.shapes.sort(key=lambda element: order[element])
    return found


def result_around(element):
    """The element that was made a group of, where this one is a part that was made in it; else the element itself."""
    parent = element.getparent()
    return parent if element.get(memory.PART) is not None and parent is not None and memory.has(parent) else element


def kept_by(svg, selected):
    """The elements with an original among the selected ones, around them, and inside them; of the whole document where
    nothing is selected."""
    found = []
    seen = set()

    def add(element):
        if element not in seen and memory.has(element):
            seen.add(element)
            found.append(element)

    for element in selected or [svg]:
        at = element
        while at is not None:
            add(at)
            at = at.getparent()
        for child in element.iter():
            if isinstance(child.tag, str):
                add(child)
    return found


def path_data(element):
    """The value of `d` that an element's geometry is; "" where it has none."""
    if element.tag == SVG + "path":
        return element.get(INKSCAPE + "original-d") or element.get("d") or ""
    return shapes.path_data(element, element.tag[len(SVG):])


def followed_by_text(svg):
    """The ids of the paths that text runs along."""
    return {text.get(name, "").lstrip("#") for text in svg.iter(SVG + "textPath") for name in (HREF, "href")}


def has_path_effect(element):
    return bool(element.get(INKSCAPE + "path-effect"))


class Maps:
    """From elements' own coordinates to pixels of the page, as (a, b, c, d, e, f)."""

    def __init__(self, svg):
        scale = svg.scale
        self._scale = scale if scale and scale == scale and abs(scale) != float("inf") else 1.0
        self._known = {}

    def of(self, element):
        """Of what stands inside the element, its own transform included."""
        found = self._known.get(element)
        if found is None:
            parent = element.getparent()
            above = self.of(parent) if parent is not None else inkex.Transform(scale=self._scale)
            # The root's transform is no part of SVG 1.1.
            own = element.get("transform") if parent is not None else None
            found = above @ inkex.Transform(own) if own else above
            self._known[element] = found
        return found

    def pair(self, element):
        """(map, inverse, mean factor of lengths); None where the element has no size."""
        (a, c, e), (b, d, f) = self.of(element).matrix
        determinant = a * d - b * c
        if not abs(determinant) > 1e-12 or abs(determinant) == float("inf"):
            return None
        inverse = (d / determinant, -b / determinant, -c / determinant, a / determinant,
                   (c * f - d * e) / determinant, (b * e - a * f) / determinant)
        return (a, b, c, d, e, f), inverse, abs(determinant) ** 0.5
