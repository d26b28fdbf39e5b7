# SPDX-License-Identifier: GPL-3.0-or-later
"""pictures.py FOLDER: screenshots of the plug-in at work in GIMP, for docs/gimp.md. script/pictures-of-gimp calls it."""

import os
import subprocess
import sys
import time

import session
import window

TITLE = "Restyle with a hand"
DRAWINGS = os.path.join(session.SOURCE, "data", "drawings")


def paper(gimp, width, height):
    gimp.run("(define image (car (gimp-image-new %d %d RGB)))"
             '(define paper (car (gimp-layer-new image %d %d RGB-IMAGE "Paper" 100 LAYER-MODE-NORMAL)))'
             "(gimp-image-insert-layer image paper 0 0)"
             "(gimp-context-set-background '(252 249 240))(gimp-context-set-foreground '(38 52 96))"
             "(gimp-drawable-fill paper FILL-BACKGROUND)" % (width, height, width, height))


def import_paths(gimp, name):
    gimp.run('(gimp-vectors-import-from-file image "%s" TRUE TRUE)'
             "(gimp-image-set-active-vectors image (aref (cadr (gimp-image-get-vectors image)) 0))"
             % os.path.join(DRAWINGS, name))


def wait_for(gimp, expression, value):
    for _ in range(200):
        if gimp.value(expression) == value:
            return
        time.sleep(0.2)
    raise session.Failed("%s is not %s" % (expression, value))


def of_a_path(gimp, folder):
    paper(gimp, 800, 640)
    import_paths(gimp, "branch.svg")
    gimp.run("(gimp-image-clean-all image)(define view (car (gimp-display-new image)))")
    time.sleep(3)
    screen = gimp.screen
    main = gimp.image_window()
    screen.keys(main, "alt+e")
    time.sleep(1.5)
    screen.picture(os.path.join(folder, "menu.png"))
    screen.tool("key", "Escape")
    screen.tool("key", "Escape")
    gimp.command("plug-in-ductus-restyle")
    dialog = screen.wait(TITLE)
    screen.tool("mousemove", 2, 2)  # no tooltips
    time.sleep(6)
    screen.picture(os.path.join(folder, "dialog.png"), dialog)
    screen.keys(dialog, "Return")
    wait_for(gimp, "(layers image)", "2")
    time.sleep(2)
    screen.picture(os.path.join(folder, "result.png"))
    gimp.run("(gimp-image-clean-all image)(gimp-display-delete view)")


def of_line_art(gimp, folder):
    """A drawing in ink, flattened, and what the filter makes of its pixels."""
    paper(gimp, 720, 560)
    import_paths(gimp, "teapot.svg")
    gimp.run("(gimp-context-set-foreground '(60 60 60))"
             '(plug-in-ductus-restyle-text RUN-NONINTERACTIVE image paper "hand=david; brush=ink; size=4; mode=pose")'
             "(gimp-image-flatten image)"
             '(file-png-save-defaults RUN-NONINTERACTIVE image (active image) "%s" "x")'
             "(gimp-image-clean-all image)(define view (car (gimp-display-new image)))"
             "(gimp-context-set-foreground '(130 40 30))" % os.path.join(folder, "before.png"))
    time.sleep(3)
    gimp.command("plug-in-ductus-restyle-line-art")
    dialog = gimp.screen.wait(TITLE)
    gimp.screen.tool("mousemove", 2, 2)
    time.sleep(6)
    gimp.screen.picture(os.path.join(folder, "line-art-dialog.png"), dialog)
    gimp.screen.keys(dialog, "Return")
    wait_for(gimp, "(layers image)", "2")
    gimp.run('(gimp-image-flatten image)(file-png-save-defaults RUN-NONINTERACTIVE image (active image) "%s" "x")'
             "(gimp-image-clean-all image)(gimp-display-delete view)" % os.path.join(folder, "after.png"))


def main():
    folder = sys.argv[1]
    session.require(*window.PROGRAMS)
    values = {"plug-in-ductus-restyle": "hand=eve; brush=flat-bristle; size=9; mode=two-pass",
              "plug-in-ductus-restyle-line-art": "hand=eve; brush=flat-bristle; size=8; mode=pose"}
    gimp = window.Window(values=values)
    try:
        of_a_path(gimp, folder)
        of_line_art(gimp, folder)
    finally:
        gimp.close()
    subprocess.run(["convert", os.path.join(folder, "before.png"), os.path.join(folder, "after.png"), "+append",
                    os.path.join(folder, "line-art.png")], check=True)


if __name__ == "__main__":
    main()
