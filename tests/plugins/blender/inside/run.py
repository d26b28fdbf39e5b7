# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a module of unit tests inside Blender; an exception, and with it the exit code, says that something failed."""
import os
import sys
import unittest

import addon_utils

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
addon_utils.enable("ductus_addon", default_set=True, handle_error=lambda error: (_ for _ in ()).throw(error))

module = sys.argv[sys.argv.index("--") + 1]
names = [f"{module}.{name}" for name in sys.argv[sys.argv.index("--") + 2:]] or [module]
result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(unittest.defaultTestLoader.loadTestsFromNames(names))
if not result.wasSuccessful() or result.testsRun == 0:
    raise SystemExit(3)
