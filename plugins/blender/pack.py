# SPDX-License-Identifier: GPL-3.0-or-later
"""pack.py FOLDER ZIP: packs an add-on's folder. The same files make the same bytes, whenever they were made."""
import os
import sys
import zipfile


def main(folder, path):
    top = os.path.dirname(folder)
    found = []
    for place, folders, files in os.walk(folder):
        folders[:] = [name for name in folders if name != "__pycache__"]
        found += [os.path.join(place, name) for name in files if not name.endswith(".pyc")]
    with zipfile.ZipFile(path + ".new", "w", zipfile.ZIP_DEFLATED) as made:
        for file in sorted(found):
            entry = zipfile.ZipInfo(os.path.relpath(file, top))
            entry.external_attr = 0o644 << 16
            with open(file, "rb") as stream:
                made.writestr(entry, stream.read(), zipfile.ZIP_DEFLATED)
    os.replace(path + ".new", path)


if __name__ == "__main__":
    main(os.path.abspath(sys.argv[1]), sys.argv[2])
