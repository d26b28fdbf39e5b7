# SPDX-License-Identifier: GPL-3.0-or-later
"""Finding libductus and calling it: errors become exceptions, handles are freed when nothing refers to them."""
import ctypes
import os
import sys
import weakref

from . import _declarations as c

_FILES = {"darwin": "libductus.dylib", "win32": "ductus.dll"}
FILE = _FILES.get(sys.platform, "libductus.so")


class Error(Exception):
    """What libductus could not do: str() is its sentence (what, where, what to do), `status` a word such as
    "not-found" (ductus/status.h)."""

    def __init__(self, message, status="unsupported"):
        super().__init__(message)
        self.status = status


class Cancelled(Error):
    """A progress function said stop; nothing was changed."""


class Missing(Error):
    """libductus itself is not there, or does not fit."""


_STATUS = {value: name[len("DUCT_"):].lower().replace("_", "-")
           for name, value in vars(c).items()
           if name in ("DUCT_OK", "DUCT_BAD_ARGUMENT", "DUCT_BAD_SETTING", "DUCT_NOT_FOUND", "DUCT_IO",
                       "DUCT_BAD_FORMAT", "DUCT_UNSUPPORTED", "DUCT_LIMIT", "DUCT_NO_MEMORY", "DUCT_CANCELLED")}

_loaded = None


def _places():
    """Where the library may lie, the likeliest first: named by the user, carried by the package, beside it in an
    installed or build tree, where the system looks."""
    given = os.environ.get("DUCTUS_LIBRARY")
    if given:
        yield given
        return
    here = os.path.dirname(os.path.abspath(__file__))
    names = (FILE, f"{FILE}.{soversion()}")
    for folder in ("lib", "../lib", "../../lib"):
        for name in names:
            yield os.path.join(here, folder, name)
    # share/ductus/python/ductus -> lib, lib/<architecture>
    above = os.path.normpath(os.path.join(here, "../../../.."))
    folders = [os.path.join(above, "lib")]
    try:
        folders += sorted(entry.path for entry in os.scandir(folders[0])
                          if entry.is_dir() and entry.name.endswith("-gnu"))
    except OSError:
        pass
    for folder in folders:
        for name in names:
            yield os.path.join(folder, name)
    yield from names[::-1]


def soversion():
    """The version of the library's interface that the declarations were made for."""
    return int(c.VERSION.split(".")[0])


def _open(path):
    library = ctypes.CDLL(path)
    for name, (result, arguments) in c.FUNCTIONS.items():
        function = getattr(library, name)
        function.restype = result
        function.argtypes = arguments
    theirs = library.duct_version().decode()
    if theirs.split(".")[:2] != c.VERSION.split(".")[:2]:
        raise Missing(f"{path} is libductus {theirs}; this package needs {c.VERSION}: install both together")
    return library


def load(path=None):
    """Loads libductus from `path`, or from where it is found; every other call does this by itself. Raises Missing."""
    global _loaded
    if _loaded is not None and path is None:
        return _loaded
    reasons = []
    for place in [path] if path is not None else _places():
        if os.path.sep in place and not os.path.exists(place):
            reasons.append(f"{place}: there is no such file")
            continue
        try:
            _loaded = _open(place)
            return _loaded
        except OSError as error:
            reasons.append(str(error))
        except AttributeError as error:
            reasons.append(f"{place} is not this version of libductus ({error})")
    # A file that is there and does not load tells more than one that is not.
    reasons.sort(key=lambda reason: "no such file" in reason.lower())
    raise Missing(f"libductus cannot be loaded: {reasons[0] if reasons else 'it was not found'}; install Ductus, or set "
                  "DUCTUS_LIBRARY to the path of " + FILE)


def text(value):
    """Text for C."""
    encoded = os.fsencode(value) if isinstance(value, os.PathLike) else str(value).encode("utf-8", "surrogateescape")
    if b"\0" in encoded:
        raise Error(f"'{value}' holds a zero character", "bad-argument")
    return encoded


def string(value):
    """Text from C."""
    return "" if value is None else value.decode("utf-8", "surrogateescape")


def call(name, *arguments):
    """Calls a function that returns a duct_status and takes a duct_error last."""
    error = c.duct_error()
    status = getattr(load(), name)(*arguments, ctypes.byref(error))
    if status != c.DUCT_OK:
        kind = Cancelled if status == c.DUCT_CANCELLED else Error
        raise kind(string(error.message), _STATUS.get(status, "unsupported"))


def take_text(name, *arguments):
    """The text that a function hands out through its last argument but the error, freed here."""
    pointer = ctypes.c_void_p()
    call(name, *arguments, ctypes.byref(pointer))
    try:
        return ctypes.cast(pointer, ctypes.c_char_p).value.decode("utf-8", "surrogateescape")
    finally:
        load().duct_memory_free(None, pointer)


class Handle:
    """An opaque struct of the library, freed with its Python object."""
    _free = None        # the name of the function that frees it

    def __init__(self, pointer):
        self._pointer = pointer
        self._finalizer = weakref.finalize(self, getattr(load(), self._free), pointer)

    @classmethod
    def _make(cls, name, *arguments):
        """What a function hands out through its last argument but the error."""
        pointer = ctypes.c_void_p()
        call(name, *arguments, ctypes.byref(pointer))
        return pointer


def context(threads=0, progress=None, raised=None):
    """The surroundings of a call. What `progress` raises ends up in the list `raised`, and cancels."""
    made = load().duct_context_default()
    made.threads = threads
    if progress is not None:
        def report(_user, fraction):
            try:
                return progress(fraction) is not False
            except BaseException as error:      # must not pass through C
                raised.append(error)
                return False
        made.progress = c.duct_progress(report)
    return made
