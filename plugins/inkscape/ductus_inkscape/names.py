# SPDX-License-Identifier: GPL-3.0-or-later
"""The names of the operations' parameters in Inkscape's dialogs and on the extension's command line."""

PREFIX = "p_"       # so that none is taken for one of Inkscape's own


def argument(param_id):
    return PREFIX + param_id.replace("-", "_")
