# SPDX-License-Identifier: GPL-3.0-or-later
"""The Inkscape adapter of Ductus: elements to drawings and back. It knows operations by their tables only."""
