# SPDX-License-Identifier: GPL-3.0-or-later
"""Painting drawings with brushes: <ductus/render.h>, <ductus/image.h>."""
import ctypes

from . import _declarations as c
from ._library import Callbacks, Handle, call, load, string, text
from ._numbers import copied

TILE_SIZE = c.DUCT_TILE_SIZE


class Brush(Handle):
    """A brush by its name (see brushes()) or by the path of a .myb file."""
    _free = "duct_brush_free"

    def __init__(self, name_or_path):
        super().__init__(self._make("duct_brush_load", None, text(name_or_path)))

    name = property(lambda self: string(load().duct_brush_name(self._pointer)))


class Canvas(Handle):
    """What was painted: red, green, blue, alpha, 0..32768 for 0..1, premultiplied; without a background."""
    _free = "duct_canvas_free"

    def __init__(self, *, _pointer):
        super().__init__(_pointer)

    width = property(lambda self: load().duct_canvas_width(self._pointer))
    height = property(lambda self: load().duct_canvas_height(self._pointer))

    def tile(self, column, row):
        """A copy of a tile of TILE_SIZE x TILE_SIZE pixels (a numpy array of rows, columns and colours, a flat
        array.array('H') without numpy), or None where nothing was painted."""
        values = load().duct_canvas_tile(self._pointer, column, row)
        return copied(values, TILE_SIZE * TILE_SIZE * 4, "H", (TILE_SIZE, TILE_SIZE, 4)) if values else None

    def pixels(self):
        """All pixels: a numpy array of height x width x 4, a flat array.array('H') without numpy."""
        width, height = self.width, self.height
        pixel = 4 * ctypes.sizeof(ctypes.c_uint16)
        whole = ctypes.create_string_buffer(width * height * pixel)
        start = ctypes.addressof(whole)
        for top in range(0, height, TILE_SIZE):
            for left in range(0, width, TILE_SIZE):
                tile = load().duct_canvas_tile(self._pointer, left // TILE_SIZE, top // TILE_SIZE)
                if not tile:
                    continue
                source = ctypes.cast(tile, ctypes.c_void_p).value
                used = min(TILE_SIZE, width - left) * pixel
                for row in range(min(TILE_SIZE, height - top)):
                    ctypes.memmove(start + ((top + row) * width + left) * pixel, source + row * TILE_SIZE * pixel, used)
        return copied(start, width * height * 4, "H", (height, width, 4))

    def write(self, path, *, background=(1, 1, 1, 1), resolution=0, bits=0):
        """Writes an image file over a background, whose alpha 0 leaves it transparent; see duct_image_options."""
        options = c.duct_image_options(_color(background), resolution, bits)
        call("duct_image_write", None, self._pointer, text(path), ctypes.byref(options))


def _color(values):
    red, green, blue, alpha = values
    return (ctypes.c_float * 4)(red, green, blue, alpha)


def render(drawing, brush, *, size=0, resolution=0, background=(1, 1, 1, 1), seed=0, path=None, progress=None):
    """Paints a drawing with a Brush, or a brush's name, on a new Canvas, and writes it to `path` where that is given.

    `size`: the brush's diameter in drawing pixels (0: each stroke's width); `resolution`: image pixels an inch (0: the
    drawing's). `progress` as for run()."""
    if not isinstance(brush, Brush):
        brush = Brush(brush)
    resolution = resolution or drawing.resolution
    options = load().duct_render_options_default()
    options.paint.brush_size = size
    options.paint.seed = seed
    options.resolution = resolution
    options.background = _color(background)
    callbacks = Callbacks()
    surroundings = callbacks.context(progress=progress)
    canvas = callbacks.during(Canvas._take, "duct_render", ctypes.byref(surroundings), drawing._pointer, brush._pointer,
                              ctypes.byref(options))
    if path is not None:
        canvas.write(path, background=background, resolution=resolution)
    return canvas


def brushes():
    """The names of the brushes that ship with Ductus."""
    names = ctypes.POINTER(ctypes.c_void_p)()
    count = ctypes.c_size_t()
    call("duct_brush_list", None, ctypes.byref(names), ctypes.byref(count))
    pointers = names[:count.value]
    try:
        return [string(ctypes.string_at(pointer)) for pointer in pointers]
    finally:
        for pointer in pointers:
            load().duct_memory_free(None, pointer)
        load().duct_memory_free(None, ctypes.cast(names, ctypes.c_void_p))
