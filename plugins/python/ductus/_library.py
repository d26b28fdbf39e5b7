# SPDX-License-Identifier: GPL-3.0-or-later
"""Finding libductus and calling it: errors become exceptions, handles are freed when nothing refers to them."""
import contextlib
import ctypes
import os
import signal
import sys
import threading
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


_STATUS = {value: name[len("DUCT_"):].lower().replace("_", "-") for name, value in c.ENUMS["duct_status"].items()}

_loaded = None


def soversion():
    """The version of the library's interface that the declarations were made for."""
    return int(c.VERSION.split(".")[0])


def _places():
    """Where the library may lie, the likeliest first: named by the user, carried by the package, beside it in an
    installed or build tree, where the system looks."""
    given = os.environ.get("DUCTUS_LIBRARY")
    if given:
        yield given
        return
    here = os.path.dirname(os.path.abspath(__file__))
    # PREFIX/share/ductus/python/ductus -> PREFIX/lib, PREFIX/lib64, PREFIX/lib/ARCHITECTURE
    prefix = os.path.normpath(os.path.join(here, "../../../.."))
    folders = [os.path.normpath(os.path.join(here, folder)) for folder in ("lib", "../lib", "../../lib")]
    folders += [os.path.join(prefix, "lib"), os.path.join(prefix, "lib64")]
    try:
        folders += sorted(entry.path for entry in os.scandir(os.path.join(prefix, "lib"))
                          if entry.is_dir() and "-linux-" in entry.name)
    except OSError:
        pass
    names = (FILE, f"{FILE}.{soversion()}")
    for folder in folders:
        for name in names:
            yield os.path.join(folder, name)
    yield from names[::-1]


def _open(path):
    """The library with its functions declared. Raises OSError where it does not load, Missing where it does not fit."""
    library = ctypes.CDLL(path)
    try:
        library.duct_version.restype = ctypes.c_char_p
        theirs = library.duct_version().decode()
    except AttributeError:
        raise Missing(f"{path} is another library") from None
    if theirs.split(".")[:2] != c.VERSION.split(".")[:2]:
        raise Missing(f"{path} is libductus {theirs}, and this package needs {c.VERSION}")
    try:
        for name, (result, arguments) in c.FUNCTIONS.items():
            function = getattr(library, name)
            function.restype = result
            function.argtypes = arguments
    except AttributeError:
        raise Missing(f"{path} is not the libductus {theirs} of this package: it has no {name}()") from None
    return library


def load(path=None):
    """Loads libductus from `path`, or from where it is found; every other call does this by itself. Raises Missing."""
    global _loaded
    if path is None and _loaded is not None:
        return _loaded
    if path is not None:
        path = os.path.abspath(os.fspath(path))
    reasons = []
    for place in _places() if path is None else [path]:
        named = os.path.sep in place
        if named and not os.path.exists(place):
            if path is not None or os.environ.get("DUCTUS_LIBRARY"):
                reasons.append(f"{place}: there is no such file")
            continue
        try:
            library = _open(place)
        except OSError as error:
            # That the system does not know the name says nothing; why a file that is there does not load, a lot.
            if named or place not in str(error):
                reasons.append(f"{place}: {error}" if place not in str(error) else str(error))
        except Missing as error:
            reasons.append(str(error))
        else:
            _loaded = library
            return library
    what = (f"libductus cannot be loaded: {reasons[0]}; install it and this package together" if reasons else
            f"{FILE} was not found, neither beside the package nor where the system has its libraries; install Ductus")
    raise Missing(f"{what}, or set DUCTUS_LIBRARY to the path of {FILE}")


def text(value):
    """Text, or a path, for C: numbers are written as in Python."""
    value = os.fspath(value) if isinstance(value, os.PathLike) else value
    if value is None:
        raise TypeError("a text is needed, not None")
    try:
        encoded = value if isinstance(value, bytes) else str(value).encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        raise Error(f"{value!r} is no text: it holds half a character", "bad-argument") from None
    if b"\0" in encoded:
        raise Error(f"{value!r} holds a zero character", "bad-argument")
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
        # What is shown to people has to be printable, whatever a file's name was made of.
        raise kind(error.message.decode("utf-8", "replace"), _STATUS.get(status, "unsupported"))


def take_text(name, *arguments):
    """The text that a function hands out through its last argument but the error, freed here."""
    pointer = ctypes.c_void_p()
    call(name, *arguments, ctypes.byref(pointer))
    try:
        return string(ctypes.string_at(pointer))
    finally:
        load().duct_memory_free(None, pointer)


class Handle:
    """An opaque struct of the library, freed with its Python object."""
    _free = None        # the name of the function that frees it

    def __init__(self, pointer):
        self._pointer = pointer
        weakref.finalize(self, getattr(load(), self._free), pointer)

    @classmethod
    def _make(cls, name, *arguments):
        """What a function hands out through its last argument but the error."""
        pointer = ctypes.c_void_p()
        call(name, *arguments, ctypes.byref(pointer))
        return pointer

    @classmethod
    def _take(cls, name, *arguments):
        """The same as an object that owns it."""
        return cls(_pointer=cls._make(name, *arguments))


class Callbacks:
    """Python functions for C to call during one call into the library.

    An exception must not pass through C: the first one is kept, the work is told to stop, and during() raises it
    after C has returned, instead of the library's own error, which is only that the work was stopped."""

    def __init__(self):
        self._raised = None

    def made(self, kind, function):
        """`function`, which says with True that the work goes on, as a C function of type `kind`."""
        def called(_user, *arguments):
            if self._raised is not None:
                return False
            try:
                goes_on = bool(function(*arguments))
            except BaseException as error:
                self._raised = error
            return self._raised is None and goes_on
        return kind(called)

    def context(self, threads=0, progress=None):
        """The surroundings of the call. `progress(fraction)` stops the work by returning False (not by None)."""
        made = load().duct_context_default()
        made.threads = threads
        if progress is None and threading.current_thread() is threading.main_thread():
            # Python sees Ctrl-C when one of its functions runs.
            def progress(_fraction):
                return True
        if progress is not None:
            made.progress = self.made(c.duct_progress, lambda fraction: progress(fraction) is not False)
        return made

    def during(self, function, *arguments):
        """What function(*arguments), which calls into the library, returns or raises; what was raised on the way comes
        first, as it was raised."""
        try:
            with self._ctrl_c():
                made = function(*arguments)
        except Error:
            if self._raised is None:
                raise
        raised, self._raised = self._raised, None
        if raised is None:
            return made
        try:
            raise raised
        finally:
            del raised      # its traceback holds this frame

    @contextlib.contextmanager
    def _ctrl_c(self):
        """Keeps Ctrl-C as an exception of a callback. Python's own handler raises where a callback begins, before it can
        catch anything, and ctypes drops what comes out of a callback. Handlers of others stay."""
        def interrupted(_signal, _frame):
            if self._raised is None:
                self._raised = KeyboardInterrupt()
        own = signal.default_int_handler
        try:
            watched = signal.getsignal(signal.SIGINT) is own and signal.signal(signal.SIGINT, interrupted) is own
        except ValueError:      # not the main thread
            watched = False
        try:
            yield
        finally:
            if watched:
                signal.signal(signal.SIGINT, own)
