# SPDX-License-Identifier: GPL-3.0-or-later
"""SVG's basic shapes as path data (SVG 1.1, chapter 9). By tag and attributes alone: an element that was given its old tag
back is still an object of its former class in inkex."""
from .styles import length


def _numbers(element, *names):
    return [length(element.get(name), 0.0) if element.get(name) else 0.0 for name in names]


def _rect(element):
    x, y, width, height, rx, ry = _numbers(element, "x", "y", "width", "height", "rx", "ry")
    if not (width > 0 and height > 0):
        return ""
    rx = rx if element.get("rx") else ry
    ry = ry if element.get("ry") else rx
    rx, ry = min(max(rx, 0), width / 2), min(max(ry, 0), height / 2)
    if not (rx > 0 and ry > 0):
        return f"M {x} {y} h {width} v {height} h {-width} Z"
    arc = f"a {rx} {ry} 0 0 1"
    return (f"M {x + rx} {y} h {width - 2 * rx} {arc} {rx} {ry} v {height - 2 * ry} {arc} {-rx} {ry} "
            f"h {2 * rx - width} {arc} {-rx} {-ry} v {2 * ry - height} {arc} {rx} {-ry} Z")


def _ellipse_of(cx, cy, rx, ry):
    if not (rx > 0 and ry > 0):
        return ""
    arcs = "".join(f" A {rx} {ry} 0 0 1 {x} {y}" for x, y in ((cx, cy + ry), (cx - rx, cy), (cx, cy - ry), (cx + rx, cy)))
    return f"M {cx + rx} {cy}{arcs} Z"


def _circle(element):
    cx, cy, r = _numbers(element, "cx", "cy", "r")
    return _ellipse_of(cx, cy, r, r)


def _ellipse(element):
    return _ellipse_of(*_numbers(element, "cx", "cy", "rx", "ry"))


def _line(element):
    return "M {} {} L {} {}".format(*_numbers(element, "x1", "y1", "x2", "y2"))


def _polyline(element):
    points = element.get("points", "").replace(",", " ").strip()
    return f"M {points}" if points else ""


def _polygon(element):
    points = _polyline(element)
    return points + " Z" if points else ""


_SHAPES = {"rect": _rect, "circle": _circle, "ellipse": _ellipse, "line": _line, "polyline": _polyline,
           "polygon": _polygon}


def path_data(element, name):
    """The value of `d` that draws the same; "" for a shape without a size."""
    return _SHAPES[name](element)
