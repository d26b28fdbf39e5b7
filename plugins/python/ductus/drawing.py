# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings and strokes: <ductus/drawing.h>, <ductus/stroke.h>, <ductus/format.h>."""
import ctypes

from . import _declarations as c
from ._library import Error, Handle, call, context, load, string, text
from ._numbers import copied, doubles

CHANNELS = ("x", "y", "t", "pressure", "tilt_x", "tilt_y", "twist")


def _channel(name):
    try:
        return CHANNELS.index(name)
    except ValueError:
        raise Error(f"there is no channel '{name}'; there are {', '.join(CHANNELS)}", "bad-argument") from None


class Stroke:
    """A line drawn without lifting the pen. It belongs to its drawing; see <ductus/stroke.h> for units."""

    def __init__(self, drawing, pointer, index=None):
        self._drawing = drawing         # keeps it
        self._pointer = pointer
        self._index = index

    def __len__(self):
        return load().duct_stroke_size(self._pointer)

    def has(self, channel):
        return bool(load().duct_stroke_values(self._pointer, _channel(channel)))

    def channel(self, name):
        """A copy of the channel's numbers (a float64 numpy array, array.array('d') without numpy), or None where the
        stroke has no such channel."""
        values = load().duct_stroke_values(self._pointer, _channel(name))
        return copied(values, len(self)) if values else None

    def set(self, name, values):
        """Sets a channel, one number for each sample; None takes it away."""
        channel = _channel(name)
        if values is None:
            load().duct_stroke_drop(self._editable(), channel)
            return
        kept, address, size = doubles(values)
        if size != len(self):
            raise Error(f"channel '{name}' has {size} numbers, but the stroke has {len(self)} samples", "bad-argument")
        into = load().duct_stroke_edit(self._editable(), channel)
        if not into:
            raise Error("out of memory", "no-memory")
        ctypes.memmove(into, address, size * ctypes.sizeof(ctypes.c_double))
        del kept

    def _editable(self):
        if self._index is not None:
            self._pointer = load().duct_drawing_edit_stroke(self._drawing._pointer, self._index)
        return self._pointer

    @property
    def id(self):
        return string(load().duct_stroke_id(self._pointer))

    @property
    def group(self):
        return string(load().duct_stroke_group(self._pointer))

    @property
    def closed(self):
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
        return load().duct_stroke_get_style(self._pointer).width


class Drawing(Handle):
    """An ordered list of strokes on a page of drawing pixels, y down."""
    _free = "duct_drawing_free"

    def __init__(self, width=0, height=0, *, _pointer=None):
        super().__init__(_pointer if _pointer is not None else self._make("duct_drawing_new", None))
        if _pointer is None:
            load().duct_drawing_set_page(self._pointer, width, height)

    @classmethod
    def read(cls, path):
        """Reads any format that Ductus reads; SVG curves are flattened."""
        return cls(_pointer=cls._make("duct_drawing_read", None, text(path), None))

    def write(self, path):
        """Writes the format of the path's ending; the file appears whole or not at all."""
        call("duct_drawing_write", None, self._pointer, text(path), None)

    def add_stroke(self, id, x, y, *, closed=False, color=(0, 0, 0), opacity=1, width=0, t=None, pressure=None,
                   tilt_x=None, tilt_y=None, twist=None):
        """Appends a stroke; each channel is one buffer or sequence of numbers, as long as x."""
        x, y = doubles(x), doubles(y)
        if x[2] != y[2]:
            raise Error(f"stroke '{id}' has {x[2]} numbers x and {y[2]} numbers y", "bad-argument")
        pointer = ctypes.c_void_p()
        channels = {"t": t, "pressure": pressure, "tilt_x": tilt_x, "tilt_y": tilt_y, "twist": twist}
        channels = {name: doubles(values) for name, values in channels.items() if values is not None}
        for name, values in channels.items():
            if values[2] != x[2]:
                raise Error(f"stroke '{id}' has {x[2]} samples and {values[2]} numbers '{name}'", "bad-argument")
        call("duct_drawing_add_stroke", self._pointer, text(id), x[2], ctypes.byref(pointer))
        stroke = Stroke(self, pointer)
        stroke.set("x", x[0])
        stroke.set("y", y[0])
        for name, values in channels.items():
            stroke.set(name, values[0])
        library = load()
        library.duct_stroke_set_closed(pointer, closed)
        library.duct_stroke_set_style(pointer, c.duct_stroke_style(*color, opacity, width))
        return Stroke(self, pointer, len(self) - 1)

    def style(self, index, *, color=(0, 0, 0), opacity=1, width=0):
        """Sets how a stroke is drawn, as add_stroke() does."""
        pointer = load().duct_drawing_edit_stroke(self._pointer, index)
        if not pointer:
            raise IndexError(index)
        load().duct_stroke_set_style(pointer, c.duct_stroke_style(*color, opacity, width))

    def __len__(self):
        return load().duct_drawing_stroke_count(self._pointer)

    def __getitem__(self, index):
        count = len(self)
        if not -count <= index < count:
            raise IndexError(index)
        index %= count
        return Stroke(self, load().duct_drawing_stroke(self._pointer, index), index)

    @property
    def size(self):
        """Width and height of the page in drawing pixels."""
        library = load()
        return library.duct_drawing_width(self._pointer), library.duct_drawing_height(self._pointer)

    def annotation(self, key):
        value = load().duct_drawing_annotation(self._pointer, text(key))
        return None if value is None else string(value)


def render(drawing, brush, *, size=0, resolution=0, background=(1, 1, 1, 1), seed=0, path=None):
    """Paints a drawing with a brush into an image file, whose ending says which kind."""
    options = load().duct_render_options_default()
    options.paint.brush_size = size
    options.paint.seed = seed
    options.resolution = resolution
    options.background[:] = background
    brush_pointer = ctypes.c_void_p()
    call("duct_brush_load", None, text(brush), ctypes.byref(brush_pointer))
    canvas = ctypes.c_void_p()
    try:
        surroundings = context()
        call("duct_render", ctypes.byref(surroundings), drawing._pointer, brush_pointer, ctypes.byref(options),
             ctypes.byref(canvas))
        image = c.duct_image_options()
        image.background[:] = background
        image.resolution = resolution
        call("duct_image_write", None, canvas, text(path), ctypes.byref(image))
    finally:
        load().duct_canvas_free(canvas)
        load().duct_brush_free(brush_pointer)


def brushes():
    """The names of the brushes that ship with Ductus."""
    library = load()
    names = ctypes.POINTER(ctypes.c_void_p)()
    count = ctypes.c_size_t()
    call("duct_brush_list", None, ctypes.byref(names), ctypes.byref(count))
    found = [ctypes.string_at(names[i]).decode() for i in range(count.value)]
    for i in range(count.value):
        library.duct_memory_free(None, names[i])
    library.duct_memory_free(None, ctypes.cast(names, ctypes.c_void_p))
    return found
