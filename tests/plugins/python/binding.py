# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the package share: the package with numpy or as if there were none, and drawings and settings."""

import math
import os
import pathlib
import sys

PLAIN = os.environ.get("DUCTUS_TEST_NUMBERS") == "plain"
if PLAIN:
    sys.modules["numpy"] = None     # importing it fails
else:
    try:
        import numpy
    except ImportError:
        if os.environ.get("CI") == "true":
            raise
        print("numpy is not installed: these tests are of the package without it")
        PLAIN = True

import ductus

SOURCE = pathlib.Path(os.environ["DUCTUS_SOURCE"])
BUILD = pathlib.Path(os.environ["DUCTUS_BUILD"])
DRAWINGS = SOURCE / "data/drawings"


def wave(count=60):
    return [3.0 * i for i in range(count)], [20.0 + 8 * math.sin(0.2 * i) for i in range(count)]


def drawing(strokes=1):
    made = ductus.Drawing(200, 100)
    for i in range(strokes):
        made.add_stroke(f"wave{i}", *wave())
    return made


def hand_param(operation):
    return next(param.id for param in operation.params if param.type == "hand")


def settings(library=None, **values):
    """Of an operation that takes a hand."""
    operation = next(o for o in ductus.operations() if any(param.type == "hand" for param in o.params))
    made = ductus.Settings(operation.id)
    made[hand_param(operation)] = ductus.hands()[0].name
    if library is not None:
        made.use_library(hand_param(operation), library)
    for name, value in values.items():
        made[name] = value
    return made
