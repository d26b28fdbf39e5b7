# SPDX-License-Identifier: GPL-3.0-or-later
"""Small SVG plots: grouped bars, lines, a matrix. No library is needed for them."""

import html

COLOURS = ["#30638e", "#d1495b", "#66a182", "#edae49", "#8d96a3", "#5b2a86"]
FONT = 'font-family="sans-serif" font-size="12"'


def _head(width, height, title):
    return [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
        f'viewBox="0 0 {width} {height}">',
        f'<rect width="{width}" height="{height}" fill="#ffffff"/>',
        f'<text x="12" y="20" {FONT} font-weight="bold">{html.escape(title)}</text>',
    ]


def _text(x, y, text, anchor="middle", extra=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" {FONT} text-anchor="{anchor}" {extra}>{html.escape(str(text))}</text>'


def _write(path, parts):
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(parts + ["</svg>", ""]))


def _axis(parts, left, right, top, bottom, low, high, ticks):
    for i in range(ticks + 1):
        value = low + (high - low) * i / ticks
        y = bottom - (bottom - top) * i / ticks
        parts.append(f'<line x1="{left}" y1="{y:.1f}" x2="{right}" y2="{y:.1f}" stroke="#dddddd"/>')
        parts.append(_text(left - 6, y + 4, f"{value:.2f}", "end"))


def _legend(parts, names, left, y):
    x = left
    for i, name in enumerate(names):
        parts.append(f'<rect x="{x}" y="{y - 9}" width="10" height="10" fill="{COLOURS[i % len(COLOURS)]}"/>')
        parts.append(_text(x + 15, y, name, "start"))
        x += 30 + 7 * len(name)


def bars(path, title, groups, series, values, high=1.0, line=None):
    """values[series][group]; `line` draws a level across, such as chance."""
    width, height, left, top = max(360, 70 + 110 * len(groups)), 300, 52, 56
    right, bottom = width - 12, height - 40
    parts = _head(width, height, title)
    _legend(parts, series, left, 42)
    _axis(parts, left, right, top, bottom, 0, high, 5)
    slot = (right - left) / len(groups)
    each = 0.8 * slot / len(series)
    for g, group in enumerate(groups):
        for s in range(len(series)):
            value = values[s][g]
            if value is None or value != value:
                continue
            tall = max(0, min(value, high)) / high * (bottom - top)
            x = left + slot * g + 0.1 * slot + each * s
            parts.append(
                f'<rect x="{x:.1f}" y="{bottom - tall:.1f}" width="{each * 0.92:.1f}" height="{tall:.1f}" '
                f'fill="{COLOURS[s % len(COLOURS)]}"/>'
            )
        parts.append(_text(left + slot * (g + 0.5), bottom + 16, group))
    if line is not None:
        y = bottom - line / high * (bottom - top)
        parts.append(f'<line x1="{left}" y1="{y:.1f}" x2="{right}" y2="{y:.1f}" stroke="#000" stroke-dasharray="5 4"/>')
    _write(path, parts)


def matrix(path, title, names, values):
    cell, left, top = 34, 130, 130
    size = cell * len(names)
    parts = _head(left + size + 20, top + size + 20, title)
    for r, row in enumerate(values):
        parts.append(_text(left - 6, top + cell * r + 22, names[r], "end"))
        x = left + cell * r + 20
        parts.append(_text(x, top - 8, names[r], "start", f'transform="rotate(-60 {x} {top - 8})"'))
        for c, value in enumerate(row):
            share = max(0.0, min(1.0, value))
            shade = [int(255 + (rgb - 255) * share) for rgb in (48, 99, 142)]
            parts.append(
                f'<rect x="{left + cell * c}" y="{top + cell * r}" width="{cell - 1}" height="{cell - 1}" '
                f'fill="rgb({shade[0]},{shade[1]},{shade[2]})"/>'
            )
            ink = "#ffffff" if share > 0.55 else "#000000"
            parts.append(_text(left + cell * c + 17, top + cell * r + 21, f"{value:.2f}"[1:], "middle", f'fill="{ink}"'))
    _write(path, parts)


def small_lines(path, title, panels, low, high):
    """panels: (name, x labels, {series: values}, index of the default) each, beside one another."""
    wide, per_row = 210, 4
    rows = (len(panels) + per_row - 1) // per_row
    parts = _head(20 + wide * per_row, 60 + 190 * rows, title)
    _legend(parts, list(panels[0][2]), 52, 42)
    for n, (name, labels, series, default) in enumerate(panels):
        left, top = 52 + wide * (n % per_row), 70 + 190 * (n // per_row)
        right, bottom = left + wide - 64, top + 110
        _axis(parts, left, right, top, bottom, low, high, 4)
        parts.append(_text((left + right) / 2, bottom + 34, name))
        step = (right - left) / max(1, len(labels) - 1)
        for i, label in enumerate(labels):
            bold = 'font-weight="bold"' if i == default else ""
            parts.append(_text(left + step * i, bottom + 16, label, "middle", bold))
        for s, values in enumerate(series.values()):
            points = " ".join(
                f"{left + step * i:.1f},{bottom - (min(max(v, low), high) - low) / (high - low) * (bottom - top):.1f}"
                for i, v in enumerate(values)
            )
            parts.append(
                f'<polyline points="{points}" fill="none" stroke="{COLOURS[s % len(COLOURS)]}" stroke-width="2"/>'
            )
    _write(path, parts)


def log_lines(path, title, xlabel, ylabel, series):
    """series: {name: [(x, y), ...]}, both axes logarithmic."""
    import math

    width, height, left, right, top, bottom = 640, 380, 70, 470, 40, 330
    points = [p for values in series.values() for p in values]
    x0, x1 = (f(math.log10(p[0]) for p in points) for f in (min, max))
    y0, y1 = (f(math.log10(p[1]) for p in points) for f in (min, max))
    y0, y1 = math.floor(y0), math.ceil(y1)
    parts = _head(width, height, title)
    for e in range(y0, y1 + 1):
        y = bottom - (e - y0) / (y1 - y0) * (bottom - top)
        parts.append(f'<line x1="{left}" y1="{y:.1f}" x2="{right}" y2="{y:.1f}" stroke="#dddddd"/>')
        parts.append(_text(left - 6, y + 4, f"{10.0 ** e:g}", "end"))
    for e in range(math.ceil(x0), math.floor(x1) + 1):
        x = left + (e - x0) / (x1 - x0) * (right - left)
        parts.append(_text(x, bottom + 18, f"{10.0 ** e:g}"))
    parts.append(_text((left + right) / 2, bottom + 38, xlabel))
    parts.append(_text(18, (top + bottom) / 2, ylabel, "middle", f'transform="rotate(-90 18 {(top + bottom) / 2})"'))
    for s, (name, values) in enumerate(series.items()):
        colour = COLOURS[s % len(COLOURS)]
        line = " ".join(
            f"{left + (math.log10(x) - x0) / (x1 - x0) * (right - left):.1f},"
            f"{bottom - (math.log10(y) - y0) / (y1 - y0) * (bottom - top):.1f}"
            for x, y in values
        )
        parts.append(f'<polyline points="{line}" fill="none" stroke="{colour}" stroke-width="2"/>')
        parts.append(f'<rect x="{right + 16}" y="{top + 22 * s}" width="10" height="10" fill="{colour}"/>')
        parts.append(_text(right + 32, top + 22 * s + 9, name, "start"))
    _write(path, parts)
