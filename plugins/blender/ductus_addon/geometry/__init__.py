# SPDX-License-Identifier: GPL-3.0-or-later
"""Geometry of drawn lines with numpy alone: nothing here knows Blender.

Many lines are worked on at once: their points stand one line behind the other in one array (`Lines`), so that no
step loops over points in Python.
"""
