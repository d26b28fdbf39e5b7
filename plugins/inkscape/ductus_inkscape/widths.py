# SPDX-License-Identifier: GPL-3.0-or-later
"""How a line with pressure becomes elements: as an outline, as a PowerStroke path effect, as segments of one width each,
or as the path alone. Each function takes a Result and changes its element."""
import ductus
from lxml import etree

from . import memory
from .elements import GEOMETRY, INKSCAPE, SODIPODI, SVG, has_path_effect
from .styles import parse, print_style


class Result:
    """One element's new lines."""

    def __init__(self, element, style, strokes, pair, decimals, line, new_id):
        self.element = element
        self.style = style              # as it looks
        self.strokes = strokes          # of the operation's drawing, in order
        self.to_page, self.to_local, self.factor = pair
        self.decimals = decimals
        self.line = line                # the values of table.LINE; stroke_width, in pixels of the page
        self.new_id = new_id            # makes an id that the document does not have
        self.change = memory.Change(element)
        self.spine = ductus.Path()
        for stroke in strokes:
            self.spine.fit(stroke, line["tolerance"])

    def nib(self, **more):
        width = self.line["width"] or self.line["stroke_width"]
        values = {"width": width, "thinnest": self.line["thinnest"], "thickest": self.line["thickest"],
                  "aspect": self.line["aspect"], "fit_tolerance": self.line["tolerance"] / 2, **more}
        return ductus.Nib(**values)

    def data(self, path):
        """A path of page pixels as the value of `d` in the element's coordinates."""
        path.map(self.to_local)
        return path.svg(self.decimals)

    def restyle(self, **properties):
        style = parse(self.element.get("style"))
        for name, value in properties.items():
            name = name.replace("_", "-")
            style.pop(name, None)
            style[name] = value
        self.change.set("style", print_style(style))

    def become(self, tag):
        """Makes another kind of element of it, without what gave the old one its form."""
        for name in list(GEOMETRY) + [name for name in self.element.attrib if name.startswith(SODIPODI)
                                      and name not in (SODIPODI + "insensitive", SODIPODI + "nodetypes")]:
            if self.element.get(name) is not None:
                self.change.set(name, None)
        if self.element.get(SODIPODI + "nodetypes") is not None:
            self.change.set(SODIPODI + "nodetypes", None)
        self.element.tag = tag

    def id(self):
        """The element's id, made where it has none, for others to refer to."""
        if not self.element.get("id"):
            self.element.set("id", self.new_id("ductus"))
        return self.element.get("id")


def line_in_place(result, spine):
    """What the line's outline is put on: a function that takes attributes and a style. An element without a fill is
    the line itself; one with a fill becomes a group of the fill and, above it, the line, so that both stay together."""
    element = result.element
    if result.style["fill"] == "none":
        result.become(SVG + "path")

        def put(style, **attributes):
            for name, value in attributes.items():
                result.change.set(ATTRIBUTES.get(name, name), value)
            result.restyle(**style)
        return put
    drop_path_effect(result)
    result.become(SVG + "g")
    fill = etree.SubElement(element, SVG + "path")
    fill.set("d", spine)
    fill.set("style", print_style({"fill": result.style["fill"], "fill-opacity": result.style["fill-opacity"],
                                   "fill-rule": result.style["fill-rule"], "stroke": "none"}))
    fill.set(memory.PART, "true")

    def put(style, **attributes):
        line = etree.SubElement(element, SVG + "path")
        for name, value in attributes.items():
            line.set(ATTRIBUTES.get(name, name), value)
        line.set("style", print_style({name.replace("_", "-"): value for name, value in style.items()}))
        line.set(memory.PART, "true")
    return put


ATTRIBUTES = {"original_d": INKSCAPE + "original-d", "path_effect": INKSCAPE + "path-effect"}


def drop_path_effect(result):
    for name in ATTRIBUTES.values():
        if result.element.get(name) is not None:
            result.change.set(name, None)


def filled_line(result):
    """The style of an outline that stands for a stroke."""
    return {"fill": result.style["stroke"], "fill_opacity": result.style["stroke-opacity"], "fill_rule": "nonzero",
            "stroke": "none"}


def frame_on(result, points):
    """The frame of an element that is a path; groups move by their transform."""
    return memory.frame_of(points) if result.element.tag == SVG + "path" else None


def shape_only(result):
    element = result.element
    d = result.data(result.spine)
    frame = memory.frame_of(result.spine.points)
    if element.tag == SVG + "path" and element.get(INKSCAPE + "path-effect"):
        # The user's own path effect goes on working on the new line; Inkscape computes it where `d` is missing.
        result.change.set(INKSCAPE + "original-d", d)
        result.change.set("d", None)
    else:
        result.become(SVG + "path")
        result.change.set("d", d)
    return result.spine.nodes, frame


def outline_path(result, nib):
    made = ductus.Path()
    for stroke in result.strokes:
        made.outline(stroke, nib)
    return made


def outline(result):
    made = outline_path(result, result.nib())
    put = line_in_place(result, result.data(result.spine))
    put(filled_line(result), d=result.data(made))
    return made.nodes, frame_on(result, made.points)


def powerstroke(result):
    """The path effect's offset points are half widths in the element's coordinates, at places counted in nodes. Inkscape
    draws `d` as it stands until the effect is edited, so `d` holds the same line as an outline of ours: other programs
    show it too."""
    if len(result.strokes) != 1:
        return outline(result)      # Inkscape's effect takes a compound path for one line
    stroke = result.strokes[0]
    nib = result.nib()
    widths = result.spine.widths(0, stroke, nib, max(result.line["tolerance"], 0.02))
    if stroke.closed and len(widths) > 1:
        widths.pop()            # the same place as the first; Inkscape 1.2 draws nothing where it is given both
    made = outline_path(result, nib)
    nodes = result.spine.nodes
    spine = result.data(result.spine)
    effect = etree.SubElement(result.element.getroottree().getroot().defs, INKSCAPE + "path-effect")
    effect_id = result.new_id(f"path-effect-{result.id()}")
    points = " | ".join(f"{at:.5g},{width / 2 / result.factor:.5g}" for at, width in widths)
    for name, value in (("effect", "powerstroke"), ("id", effect_id), ("is_visible", "true"), ("lpeversion", "1.2"),
                        ("offset_points", points), ("not_jump", "false"), ("sort_points", "true"),
                        ("interpolator_type", "Linear"), ("interpolator_beta", "0.2"),
                        ("start_linecap_type", "round"), ("end_linecap_type", "round"), ("linejoin_type", "round"),
                        ("miter_limit", "4"), ("scale_width", "1"), ("message", ""),
                        (memory.MADE, "true")):
        effect.set(name, value)
    put = line_in_place(result, spine)
    put(filled_line(result), d=result.data(made), original_d=spine, path_effect=f"#{effect_id}")
    return nodes, frame_on(result, result.spine.points)     # Inkscape computes `d` anew when the path is moved


def segments(result):
    """A group of pieces, each stroked with one width. The widths are steps of a tenth of the widest one, so that a
    piece goes on as long as nobody sees the difference."""
    element = result.element
    pieces = []
    for number, stroke in enumerate(result.strokes):
        widths = result.spine.widths(number, stroke, result.nib(), max(result.line["tolerance"], 0.02))
        pieces += split(curves_of(result.spine, number), widths)
    drop_path_effect(result)
    result.become(SVG + "g")
    children = [({"stroke-width": f"{width / result.factor:.5g}"}, piece) for piece, width in pieces]
    if result.style["fill"] != "none":
        fill = ductus.Path()
        for stroke in result.strokes:
            fill.fit(stroke, result.line["tolerance"])
        children.insert(0, ({"fill": result.style["fill"], "stroke": "none"}, fill))
    for style, path in children:
        child = etree.SubElement(element, SVG + "path")
        child.set("d", result.data(path))
        child.set("style", print_style(style))
        child.set(memory.PART, "true")
    result.restyle(fill="none", stroke_linecap="round", stroke_linejoin="round")
    return sum(piece.nodes for piece, _ in pieces), None


def curves_of(path, number):
    """The cubic curves of one subpath as eight numbers each; straight lines as such curves."""
    curves = []
    point, at, subpath = 0, None, -1
    start = None
    points = [float(v) for v in path.points]
    for verb in path.verbs:
        if verb == ductus.MOVE:
            subpath += 1
            at = start = points[point:point + 2]
            point += 2
            continue
        if verb == ductus.CUBIC:
            curve = at + points[point:point + 6]
            point += 6
        elif verb == ductus.LINE:
            end = points[point:point + 2]
            curve = at + line_controls(at, end) + end
            point += 2
        else:
            if at == start:
                continue
            curve = at + line_controls(at, start) + start
        at = curve[6:]
        if subpath == number:
            curves.append(curve)
    return curves


def line_controls(a, b):
    return [a[0] + (b[0] - a[0]) / 3, a[1] + (b[1] - a[1]) / 3, a[0] + 2 * (b[0] - a[0]) / 3,
            a[1] + 2 * (b[1] - a[1]) / 3]


def part(curve, t0, t1):
    """The curve between two parameters (blossoming)."""
    def blossom(u, v, w, k):
        p = curve[k::2]
        a, b, c = (p[i] + (p[i + 1] - p[i]) * u for i in range(3))
        d, e = a + (b - a) * v, b + (c - b) * v
        return d + (e - d) * w
    made = []
    for u, v, w in ((t0, t0, t0), (t0, t0, t1), (t0, t1, t1), (t1, t1, t1)):
        made += [blossom(u, v, w, 0), blossom(u, v, w, 1)]
    return made


def split(curves, widths):
    """[(path, width)]: the curves cut where the width passes to the next step."""
    widest = max(width for _, width in widths) or 1
    step = widest / 10
    cuts = []
    for (a, wa), (b, wb) in zip(widths, widths[1:]):
        count = max(1, round(abs(wb - wa) / step))
        for k in range(count):
            middle = wa + (wb - wa) * (k + 0.5) / count
            cuts.append((a + (b - a) * k / count, a + (b - a) * (k + 1) / count, round(middle / step) * step or step / 2))
    joined = []
    for begin, end, width in cuts:
        if joined and joined[-1][2] == width:
            joined[-1] = (joined[-1][0], end, width)
        elif end > begin:
            joined.append((begin, end, width))
    made = []
    for begin, end, width in joined:
        path = ductus.Path()
        for number in range(int(begin), min(len(curves), int(end) + 1)):
            t0, t1 = max(0.0, begin - number), min(1.0, end - number)
            if t1 - t0 <= 1e-9:
                continue
            piece = part(curves[number], t0, t1)
            if path.nodes == 0:
                path.move(piece[0], piece[1])
            path.cubic(*piece[2:])
        if path.nodes:
            made.append((path, width))
    return made


KINDS = {"outline": outline, "powerstroke": powerstroke, "segments": segments, "none": shape_only}


def apply(result):
    """Changes the element; returns the number of its nodes and the frame of its points (memory.frame_of)."""
    kind = result.line["width_kind"]
    pressed = any(stroke.has("pressure") for stroke in result.strokes)
    dashed = result.style["stroke-dasharray"] not in ("none", "", "0")
    marked = any(result.style[name] != "none" for name in ("marker-start", "marker-mid", "marker-end"))
    if result.style["stroke"] == "none" or not pressed or dashed or marked or has_path_effect(result.element):
        kind = "none"
    return KINDS[kind](result)
