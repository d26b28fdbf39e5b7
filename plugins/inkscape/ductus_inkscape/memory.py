# SPDX-License-Identifier: GPL-3.0-or-later
"""What an element was before: kept on the element itself, in a namespace of ours, so that an operation can be applied
again from the original, taken away, or made final."""
import json

from lxml import etree

NAMESPACE = "urn:ductus:inkscape"
ORIGINAL = f"{{{NAMESPACE}}}original"    # JSON: the tag, and what the attributes were that the operation changed
SETTINGS = f"{{{NAMESPACE}}}settings"    # JSON: operation and settings
FRAME = f"{{{NAMESPACE}}}frame"          # number of nodes of the result, and three of them
NODES = f"{{{NAMESPACE}}}nodes"          # number of nodes before and after
PART = f"{{{NAMESPACE}}}part"            # marks what was made inside an element that became a group
MADE = f"{{{NAMESPACE}}}made"            # marks path effects in <defs> that were made for a result

SVG = "{http://www.w3.org/2000/svg}"
INKSCAPE = "http://www.inkscape.org/namespaces/inkscape"
SODIPODI = "http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"
PATH_EFFECT = f"{{{INKSCAPE}}}path-effect"
DESCRIPTIONS = {SVG + "title", SVG + "desc", SVG + "metadata"}


def has(element):
    return element.get(ORIGINAL) is not None


def declare(root):
    """Declares the namespaces at the document's root under their usual prefixes, so that not each element does it; ours
    only where it is used."""
    prefixes = {"ductus": NAMESPACE, "inkscape": INKSCAPE, "sodipodi": SODIPODI}
    missing = {prefix: name for prefix, name in prefixes.items()
               if prefix not in root.nsmap and name not in root.nsmap.values()}
    kept = [prefix for prefix, name in root.nsmap.items() if prefix and name != NAMESPACE]
    etree.cleanup_namespaces(root, top_nsmap=missing, keep_ns_prefixes=kept)


class Change:
    """Records what an element's tag and attributes were before each of them is changed."""

    def __init__(self, element):
        self.element = element
        self.tag = element.tag
        self.before = {}

    def set(self, name, value):
        if name not in self.before:
            self.before[name] = self.element.get(name)
        if value is None:
            self.element.attrib.pop(name, None)
        else:
            self.element.set(name, value)

    def done(self, settings, frame, nodes):
        """Keeps the record on the element."""
        self.element.set(ORIGINAL, json.dumps({"tag": self.tag, "attributes": self.before}, sort_keys=True))
        self.element.set(SETTINGS, json.dumps(settings, sort_keys=True))
        self.element.set(NODES, "{} {}".format(*nodes))
        if frame:
            self.element.set(FRAME, frame)


def frame_of(points):
    """A summary of a result's points, by which moved results are told: their number and three of them, the first, the
    one farthest from it, and the one farthest from the line through both. None where these lie on a line."""
    count = len(points) // 2
    if count < 3:
        return None
    xs, ys = [float(v) for v in points[0::2]], [float(v) for v in points[1::2]]
    far = max(range(count), key=lambda i: (xs[i] - xs[0]) ** 2 + (ys[i] - ys[0]) ** 2)
    dx, dy = xs[far] - xs[0], ys[far] - ys[0]
    off = max(range(count), key=lambda i: abs((xs[i] - xs[0]) * dy - (ys[i] - ys[0]) * dx))
    if abs((xs[off] - xs[0]) * dy - (ys[off] - ys[0]) * dx) < 1e-6 * (dx * dx + dy * dy):
        return None
    return " ".join([str(count), str(far), str(off)] + [f"{v:.6g}" for i in (0, far, off) for v in (xs[i], ys[i])])


def moved_by(frame, points):
    """The map (a, b, c, d, e, f) by which a result was moved as a whole since then, as Inkscape does to paths whose
    transforms it folds into their points; None where it was not, or was edited."""
    if not frame:
        return None
    try:
        words = frame.split()
        count, far, off = (int(word) for word in words[:3])
        old = [float(word) for word in words[3:9]]
    except ValueError:
        return None
    if len(points) != 2 * count or not 0 <= max(far, off) < count or len(old) != 6:
        return None
    new = [float(points[2 * i + k]) for i in (0, far, off) for k in (0, 1)]
    reach = max(abs(v) for v in old + new) or 1
    if max(abs(a - b) for a, b in zip(old, new)) <= 2e-3 + 1e-5 * reach:
        return None
    ux, uy, vx, vy = old[2] - old[0], old[3] - old[1], old[4] - old[0], old[5] - old[1]
    px, py, qx, qy = new[2] - new[0], new[3] - new[1], new[4] - new[0], new[5] - new[1]
    cross = ux * vy - uy * vx
    if cross == 0:
        return None
    a, c = (px * vy - qx * uy) / cross, (qx * ux - px * vx) / cross
    b, d = (py * vy - qy * uy) / cross, (qy * ux - py * vx) / cross
    if a * d - b * c == 0:
        return None
    return a, b, c, d, new[0] - a * old[0] - c * old[1], new[1] - b * old[0] - d * old[1]


def restore(element, points=None):
    """Gives an element its original tag and attributes back; where the result was moved as a whole, so is the original.
    `points` are those of the result as it is now. Returns False for an element that has no original."""
    if not has(element):
        return False
    try:
        kept = json.loads(element.get(ORIGINAL))
        tag, attributes = kept["tag"], kept["attributes"]
        if not isinstance(tag, str) or not isinstance(attributes, dict):
            raise ValueError
    except (ValueError, KeyError, TypeError):
        return False
    move = moved_by(element.get(FRAME), points) if points is not None else None
    if element.tag == SVG + "g" and tag != SVG + "g":
        empty(element)
    element.tag = tag
    for name, value in attributes.items():
        if value is None:
            element.attrib.pop(name, None)
        else:
            element.set(name, value)
    if move is not None:
        matrix = "matrix({})".format(",".join(f"{v:.8g}" for v in move))
        element.set("transform", f"{element.get('transform', '')} {matrix}".strip())
    forget(element)
    return True


def empty(group):
    """Takes out of a group what was made in it. What somebody else put there goes behind it, where it stays seen."""
    behind = group
    for child in list(group):
        if not isinstance(child.tag, str) or child.tag in DESCRIPTIONS:
            continue
        if child.get(PART) is not None:
            group.remove(child)
            continue
        transform = f"{group.get('transform', '')} {child.get('transform', '')}".strip()
        if transform:
            child.set("transform", transform)
        behind.addnext(child)
        behind = child


def forget(element):
    """Drops the record: what the element is now is final."""
    for name in (ORIGINAL, SETTINGS, FRAME, NODES):
        element.attrib.pop(name, None)


def path_effects(element):
    """The ids of the path effects that an element and what is in it refer to."""
    return {reference.strip().lstrip("#") for inside in element.iter() if isinstance(inside.tag, str)
            for reference in inside.get(PATH_EFFECT, "").split(";") if reference.strip()}


def made_effects(root, ids):
    """The path effects of these ids that were made for a result."""
    return [effect for effect in root.iter(f"{{{INKSCAPE}}}path-effect")
            if effect.get(MADE) is not None and effect.get("id") in ids]


def drop_effects(root, ids):
    """Takes out those path effects that were made for a result and that nothing, such as a copy, refers to any more."""
    for effect in made_effects(root, ids - path_effects(root)):
        effect.getparent().remove(effect)
