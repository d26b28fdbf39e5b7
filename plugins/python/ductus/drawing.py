# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings and strokes: <ductus/drawing.h>, <ductus/stroke.h>, <ductus/format.h>."""
import ctypes
from collections import namedtuple

from . import _declarations as c
from ._library import Error, Handle, call, load, string, text
from ._numbers import copied, doubles

CHANNELS = tuple(name[len("DUCT_"):].lower()
                 for name in c.ENUMS["duct_channel"] if name != "DUCT_CHANNEL_COUNT")
LINE_STYLES = tuple(name[len("DUCT_LINE_"):].lower() for name in c.ENUMS["duct_line_style"])

Format = namedtuple("Format", "id label extensions reads writes")


def channel_number(name):
    try:
        return CHANNELS.index(name)
    except ValueError:
        raise Error(f"there is no channel '{name}'; there are {', '.join(CHANNELS)}", "bad-argument") from None


def formats():
    """The formats that drawings are read from and written to."""
    found = []
    while True:
        pointer = load().duct_format_at(len(found))
        if not pointer:
            return found
        f = pointer.contents
        found.append(Format(string(f.id), string(f.label), tuple(string(f.extensions).split()), f.reads, f.writes))


def _options(flatten_tolerance=None, fit_tolerance=None, line_style=None):
    made = load().duct_format_options_default()
    if flatten_tolerance is not None:
        made.flatten_tolerance = flatten_tolerance
    if fit_tolerance is not None:
        made.fit_tolerance = fit_tolerance
    if line_style is not None:
        if line_style not in LINE_STYLES:
            raise Error(f"there is no line style '{line_style}'; there are {', '.join(LINE_STYLES)}", "bad-argument")
        made.line_style = LINE_STYLES.index(line_style)
    return ctypes.byref(made)


def _style(color, opacity, width):
    red, green, blue = color
    return c.duct_stroke_style(red, green, blue, opacity, width)


class Stroke:
    """A line drawn without lifting the pen. It belongs to its drawing; see <ductus/stroke.h> for units."""

    def __init__(self, drawing, pointer, index):
        self._drawing = drawing         # keeps it
        self._pointer = pointer
        self._index = index

    def __len__(self):
        return load().duct_stroke_size(self._pointer)

    def has(self, channel):
        return bool(load().duct_stroke_values(self._pointer, channel_number(channel)))

    def channel(self, name):
        """A copy of the channel's numbers (a float64 numpy array, array.array('d') without numpy), or None where the
        stroke has no such channel."""
        values = load().duct_stroke_values(self._pointer, channel_number(name))
        return copied(values, len(self)) if values else None

    def set(self, name, values):
        """Sets a channel, one number for each sample; None takes it away."""
        channel = channel_number(name)
        if values is None:
            load().duct_stroke_drop(self._editable(), channel)
            return
        kept, address, size = doubles(values)
        if size != len(self):
            raise Error(f"channel '{name}' has {size} numbers, but the stroke has {len(self)} samples", "bad-argument")
        self._fill(name, address)
        del kept        # not before

    def _fill(self, name, address):
        into = load().duct_stroke_edit(self._editable(), channel_number(name))
        if not into and len(self):
            raise Error("out of memory", "no-memory")
        ctypes.memmove(into, address, len(self) * ctypes.sizeof(ctypes.c_double))

    def _editable(self):
        """The stroke for writing, which counts as changed from then on."""
        return load().duct_drawing_edit_stroke(self._drawing._pointer, self._index)

    @property
    def id(self):
        return string(load().duct_stroke_id(self._pointer))

    @property
    def group(self):
        """The groups that hold the stroke, outermost first, joined by '/'."""
        return string(load().duct_stroke_group(self._pointer))

    @property
    def closed(self):
        """Whether the last sample is joined to the first, which is not repeated."""
        return load().duct_stroke_closed(self._pointer)

    @property
    def color(self):
        style = load().duct_stroke_get_style(self._pointer)
        return style.red, style.green, style.blue

    @property
    def opacity(self):
        return load().duct_stroke_get_style(self._pointer).opacity

    @property
    def width(self):
        """Full width of the line; 0 where the source says none."""
        return load().duct_stroke_get_style(self._pointer).width


class Drawing(Handle):
    """An ordered list of strokes on a page of drawing pixels, y down."""
    _free = "duct_drawing_free"

    def __init__(self, width=0, height=0, *, _pointer=None):
        super().__init__(_pointer if _pointer is not None else self._make("duct_drawing_new", None))
        if _pointer is None:
            load().duct_drawing_set_page(self._pointer, width, height)

    @classmethod
    def read(cls, path, *, flatten_tolerance=None):
        """Reads any format that Ductus reads; SVG curves are flattened."""
        return cls._take("duct_drawing_read", None, text(path), _options(flatten_tolerance))

    @classmethod
    def from_bytes(cls, data, name="", format=None, *, flatten_tolerance=None):
        """Reads a file's content; its format is told by itself, or by the ending of `name`, unless given."""
        data = bytes(data)
        return cls._take("duct_drawing_read_memory", None, data, len(data), text(name),
                         None if format is None else text(format), _options(flatten_tolerance))

    def write(self, path, *, fit_tolerance=None, line_style=None):
        """Writes the format of the path's ending; the file appears whole or not at all. `line_style`, for SVG:
        "outline" (as wide as the pen was pressed) or "path"."""
        call("duct_drawing_write", None, self._pointer, text(path), _options(None, fit_tolerance, line_style))

    def to_bytes(self, format, *, fit_tolerance=None, line_style=None):
        """What write() writes, for a format's id."""
        data, size = ctypes.c_void_p(), ctypes.c_size_t()
        call("duct_drawing_write_memory", None, self._pointer, text(format), _options(None, fit_tolerance, line_style),
             ctypes.byref(data), ctypes.byref(size))
        try:
            return ctypes.string_at(data, size.value)
        finally:
            load().duct_memory_free(None, data)

    def copy(self):
        """An equal drawing."""
        return Drawing._take("duct_drawing_copy", None, self._pointer)

    def like(self):
        """An empty drawing with this one's page, annotations and source."""
        return Drawing._take("duct_drawing_like", None, self._pointer)

    def add_stroke(self, id, x, y, *, closed=False, color=(0, 0, 0), opacity=1, width=0, group="", t=None,
                   pressure=None, tilt_x=None, tilt_y=None, twist=None):
        """Appends a stroke; each channel is one buffer or sequence of numbers, as long as x."""
        # All that may be refused comes before the stroke is there.
        channels = {"x": doubles(x), "y": doubles(y)}
        others = {"t": t, "pressure": pressure, "tilt_x": tilt_x, "tilt_y": tilt_y, "twist": twist}
        channels.update((name, doubles(values)) for name, values in others.items() if values is not None)
        size = channels["x"][2]
        for name, (_, _, length) in channels.items():
            if length != size:
                raise Error(f"stroke '{id}' has {size} numbers 'x' and {length} numbers '{name}'", "bad-argument")
        style = _style(color, opacity, width)
        id, group = text(id), text(group)
        pointer = ctypes.c_void_p()
        call("duct_drawing_add_stroke", self._pointer, id, size, ctypes.byref(pointer))
        stroke = Stroke(self, pointer, len(self) - 1)
        for name, (_, address, _) in channels.items():
            stroke._fill(name, address)
        library = load()
        library.duct_stroke_set_closed(pointer, bool(closed))
        library.duct_stroke_set_style(pointer, style)
        if group:
            call("duct_stroke_set_group", pointer, group)
        return stroke

    def add_copy(self, stroke):
        """Appends an equal copy of a stroke of this or another drawing."""
        pointer = ctypes.c_void_p()
        call("duct_drawing_add_copy", self._pointer, stroke._pointer, ctypes.byref(pointer))
        return Stroke(self, pointer, len(self) - 1)

    def style(self, index, *, color=(0, 0, 0), opacity=1, width=0):
        """Sets how a stroke is drawn, as add_stroke() does."""
        style = _style(color, opacity, width)
        load().duct_stroke_set_style(self[index]._editable(), style)

    def __len__(self):
        return load().duct_drawing_stroke_count(self._pointer)

    def __getitem__(self, index):
        count = len(self)
        if not -count <= index < count:
            raise IndexError(f"stroke {index} of a drawing that has {count}")
        index %= count
        return Stroke(self, load().duct_drawing_stroke(self._pointer, index), index)

    def has(self, channel):
        """Whether any stroke has the channel."""
        return load().duct_drawing_has(self._pointer, channel_number(channel))

    @property
    def size(self):
        """Width and height of the page in drawing pixels."""
        library = load()
        return library.duct_drawing_width(self._pointer), library.duct_drawing_height(self._pointer)

    @property
    def bounds(self):
        """x0, y0, x1, y1 of the smallest box around all samples; None where there are none."""
        box = (ctypes.c_double * 4)()
        return tuple(box) if load().duct_drawing_bounds(self._pointer, box) else None

    @property
    def resolution(self):
        """Drawing pixels an inch."""
        return load().duct_drawing_resolution(self._pointer)

    @resolution.setter
    def resolution(self, pixels_per_inch):
        load().duct_drawing_set_resolution(self._pointer, pixels_per_inch)

    @property
    def annotations(self):
        """A dict of what is known about the whole drawing; change it with annotate()."""
        key, value, found = ctypes.c_char_p(), ctypes.c_char_p(), {}
        while load().duct_drawing_annotation_at(self._pointer, len(found), ctypes.byref(key), ctypes.byref(value)):
            found[string(key.value)] = string(value.value)
        return found

    def annotation(self, key):
        value = load().duct_drawing_annotation(self._pointer, text(key))
        return None if value is None else string(value)

    def annotate(self, key, value):
        """Sets a fact such as "artist" or "licence"; None removes it."""
        call("duct_drawing_annotate", self._pointer, text(key), None if value is None else text(value))
