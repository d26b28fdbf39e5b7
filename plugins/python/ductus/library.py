# SPDX-License-Identifier: GPL-3.0-or-later
"""Hands and libraries of recorded strokes: <ductus/library.h>."""
import ctypes
from collections import namedtuple

from . import _declarations as c
from ._library import Handle, call, load, string, text
from ._numbers import doubles
from .drawing import Drawing, channel_number

Hand = namedtuple("Hand", "name path builtin")


def hands():
    """The hands that can be opened by name."""
    list_ = ctypes.POINTER(c.duct_hand)()
    count = ctypes.c_size_t()
    call("duct_library_list", None, ctypes.byref(list_), ctypes.byref(count))
    try:
        return [Hand(string(ctypes.string_at(hand.name)), string(ctypes.string_at(hand.path)), hand.builtin)
                for hand in list_[:count.value]]
    finally:
        load().duct_hands_free(None, list_, count)


class Library(Handle):
    """Somebody's recorded strokes: a hand by name, or the path of a library or recording."""
    _free = "duct_library_free"

    def __init__(self, name_or_path=None, *, _pointer=None):
        super().__init__(_pointer if _pointer is not None else
                         self._make("duct_library_open", None, text(name_or_path)))

    @classmethod
    def build(cls, recordings, *, name=None, artist=None, licence=None, unit=0, remove_position=False, scales=(),
              weights=None):
        """A library of one or more drawings; see duct_library_options."""
        recordings = list(recordings)       # keeps them
        pointers = (ctypes.c_void_p * len(recordings))(*(recording._pointer.value for recording in recordings))
        options = c.duct_library_options()
        options.unit = unit
        for field, value in (("name", name), ("artist", artist), ("licence", licence)):
            setattr(options, field, None if value is None else text(value))
        options.remove_position = bool(remove_position)
        kept = []

        def numbers(values):
            held, address, size = doubles(values)
            kept.append(held)
            return ctypes.cast(address, ctypes.POINTER(ctypes.c_double)), size

        if len(scales):
            options.scales, options.scale_count = numbers(scales)
        if weights is not None:
            options.weights, size = numbers(weights)
            if size != len(recordings):
                raise ValueError(f"{size} weights for {len(recordings)} recordings")
        made = cls._take("duct_library_build", None, pointers, len(recordings), ctypes.byref(options))
        del kept        # not before
        return made

    def save(self, path):
        """Writes the library as InkML, with its index beside it; both appear whole or not at all."""
        call("duct_library_save", None, self._pointer, text(path))

    name = property(lambda self: string(load().duct_library_name(self._pointer)))
    artist = property(lambda self: string(load().duct_library_artist(self._pointer)))
    licence = property(lambda self: string(load().duct_library_licence(self._pointer)))
    stroke_count = property(lambda self: load().duct_library_stroke_count(self._pointer))
    sample_count = property(lambda self: load().duct_library_sample_count(self._pointer))
    unit = property(lambda self: load().duct_library_unit(self._pointer), doc="Recording pixels a sampling unit.")

    def has(self, channel):
        return load().duct_library_has(self._pointer, channel_number(channel))

    def drawing(self):
        """The strokes, in the recording's pixels."""
        return Drawing._take("duct_library_drawing", None, self._pointer)
