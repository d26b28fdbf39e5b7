# SPDX-License-Identifier: GPL-3.0-or-later
"""make_page.py PAGE.md PAGE.html: a page of docs/ for a browser, with its pictures inside. It knows what our pages use:
headings, paragraphs, lists, tables, code, pictures, links, bold and emphasis."""

import base64
import html
import os
import re
import sys

STYLE = ("body{max-width:56em;margin:2em auto;padding:0 1em;font:16px/1.5 sans-serif}"
         "pre,code{background:#eee;font-family:monospace}pre{padding:.7em;overflow-x:auto}"
         "img{max-width:100%}table{border-collapse:collapse}td,th{border:1px solid #bbb;padding:.3em .6em;text-align:left}")


def picture(folder, match):
    path = os.path.join(folder, match.group(2))
    if not os.path.exists(path):
        return "<em>%s</em>" % match.group(1)
    with open(path, "rb") as file:
        data = base64.b64encode(file.read()).decode()
    return '<img alt="%s" src="data:image/png;base64,%s">' % (match.group(1), data)


def inline(text, folder):
    """The marks inside of a line; what is in code is left alone."""
    parts = re.split(r"`([^`]+)`", html.escape(text, quote=False))
    for index in range(0, len(parts), 2):
        part = re.sub(r"!\[([^]]*)\]\(([^)]+)\)", lambda match: picture(folder, match), parts[index])
        part = re.sub(r"\[([^]]+)\]\((https?:[^)]+)\)", r'<a href="\2">\1</a>', part)
        part = re.sub(r"\[([^]]+)\]\([^)]+\)", r"\1", part)  # other pages are not installed with this one
        part = re.sub(r"\*\*([^*]+)\*\*", r"<strong>\1</strong>", part)
        parts[index] = re.sub(r"\*([^*]+)\*", r"<em>\1</em>", part)
    for index in range(1, len(parts), 2):
        parts[index] = "<code>%s</code>" % parts[index]
    return "".join(parts)


def table(lines, folder):
    rows = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in lines]
    text = []
    for number, row in enumerate(rows):
        if number != 1:
            tag = "th" if number == 0 else "td"
            text.append("<tr>%s</tr>" % "".join("<%s>%s</%s>" % (tag, inline(cell, folder), tag) for cell in row))
    return "<table>%s</table>" % "".join(text)


def block(lines, folder):
    """What stands between empty lines."""
    heading = re.match(r"(#+) (.*)", lines[0])
    if heading:
        level = len(heading.group(1))
        return "<h%d>%s</h%d>" % (level, inline(heading.group(2), folder), level)
    if lines[0].startswith("|"):
        return table(lines, folder)
    marker = re.match(r"(- |\d+\. )", lines[0])
    if marker:
        items = re.split(r"\n(?:- |\d+\. )", "\n" + "\n".join(lines))[1:]
        tag = "ul" if marker.group(1) == "- " else "ol"
        return "<%s>%s</%s>" % (tag, "".join("<li>%s</li>" % inline(item, folder) for item in items), tag)
    return "<p>%s</p>" % inline("\n".join(lines), folder)


def page(text, folder):
    out, lines, code = [], [], None
    for line in text.split("\n") + [""]:
        if line.startswith("```"):
            if code is None:
                code = []
            else:
                out.append("<pre>%s</pre>" % html.escape("\n".join(code), quote=False))
                code = None
        elif code is not None:
            code.append(line)
        elif line.strip() == "":
            if lines:
                out.append(block(lines, folder))
            lines = []
        else:
            lines.append(line)
    title = html.escape(text.split("\n")[0].lstrip("# "))
    return ("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>%s</title><style>%s</style></head>"
            "<body>\n%s\n</body></html>\n" % (title, STYLE, "\n".join(out)))


def main():
    source, target = sys.argv[1:]
    with open(source, encoding="utf-8") as file:
        text = page(file.read(), os.path.dirname(source))
    with open(target, "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main()
