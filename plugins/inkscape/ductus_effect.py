#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What Inkscape runs for every extension of Ductus. A failure is one sentence in Inkscape's message window, and the
document stays as it was."""
import os
import sys


def find_binding():
    """The package `ductus` lies in this folder (the zip) or beside the installed data."""
    here = os.path.dirname(os.path.abspath(__file__))
    for folder in (os.environ.get("DUCTUS_PYTHON"), os.path.join(here, "python"),
                   os.path.join(here, "../../../ductus/python"), os.path.join(here, "../../../../share/ductus/python")):
        if folder and os.path.isfile(os.path.join(folder, "ductus", "__init__.py")):
            sys.path.insert(0, folder)
            return
    # It may still be installed where Python looks.


def main():
    sys.dont_write_bytecode = True      # the folder may be the system's
    find_binding()
    try:
        import ductus
    except ImportError:
        sys.exit("Ductus: the Python package 'ductus' is missing; install Ductus again, whole")
    try:
        from ductus_inkscape.effect import Effect
        Effect().run()
    except ductus.Error as error:
        sys.exit(f"Ductus: {error}")
    except ImportError as error:
        sys.exit(f"Ductus: Inkscape's Python lacks the module '{error.name}'; install Inkscape's extensions whole")
    except RecursionError:
        sys.exit("Ductus: the drawing's groups are nested too deeply; ungroup some of them")
    except MemoryError:
        sys.exit("Ductus: out of memory; select less of the drawing")
    except Exception as error:      # no traceback ever reaches a user
        if os.environ.get("DUCTUS_TRACEBACK"):
            raise
        sys.exit(f"Ductus: something that should not happen happened ({type(error).__name__}: {error}); the drawing is "
                 "unchanged. Please report it")


if __name__ == "__main__":
    main()
