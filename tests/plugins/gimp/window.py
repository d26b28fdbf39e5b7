# SPDX-License-Identifier: GPL-3.0-or-later
"""GIMP in a window on a screen of its own (Xvfb): keys, clicks and screenshots."""

import os
import subprocess
import tempfile
import time

import session

KEYS = {"plug-in-ductus-restyle": "F9", "plug-in-ductus-restyle-line-art": "F11"}
PROGRAMS = ("gimp", "Xvfb", "openbox", "xdotool", "import")


class Screen:
    """A virtual screen with a window manager, without which GIMP's dialogs get no keys."""

    def __init__(self, size="1280x960"):
        read, write = os.pipe()
        self.folder = tempfile.TemporaryDirectory(prefix="ductus-screen-")
        quiet = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", size + "x24"],
                                       pass_fds=[write], **quiet)
        os.close(write)
        with os.fdopen(read) as answer:
            self.name = ":" + answer.readline().strip()
        self.environment = dict(os.environ, DISPLAY=self.name)
        self.manager = subprocess.Popen(["openbox"], env=dict(self.environment, HOME=self.folder.name), **quiet)

    def tool(self, *words):
        """Runs xdotool; what it prints."""
        return subprocess.run(["xdotool", *map(str, words)], env=self.environment, capture_output=True, text=True,
                              timeout=60, check=False).stdout.strip()

    def find(self, title):
        """The newest visible window whose title has these words; "" where there is none."""
        return (self.tool("search", "--onlyvisible", "--name", title).split("\n") or [""])[-1]

    def wait(self, title, there=True, seconds=60):
        for _ in range(seconds * 5):
            window = self.find(title)
            if bool(window) == there:
                return window
            time.sleep(0.2)
        raise session.Failed("no window '%s'" % title if there else "the window '%s' stays" % title)

    def keys(self, window, *keys):
        self.tool("windowactivate", "--sync", window)
        for key in keys:
            self.tool("key", "--clearmodifiers", key)
            time.sleep(0.15)

    def type(self, text):
        self.tool("type", "--delay", "30", text)

    def click(self, window, x, y):
        self.tool("windowactivate", "--sync", window)
        self.tool("mousemove", "--window", window, x, y, "click", "1")

    def picture(self, path, window="root"):
        subprocess.run(["import", "-window", window, path], env=self.environment, check=True, timeout=60)

    def close(self):
        for process in (self.manager, self.server):
            process.terminate()
            process.wait(timeout=20)
        self.folder.cleanup()


class Window(session.Gimp):
    """A GIMP on a screen of its own."""

    def __init__(self, size="1280x960", values=None):
        """`values`: a procedure's name and the settings that it is to begin with."""
        self.screen = Screen(size)
        self.values = values
        try:
            super().__init__(self.screen.name)
        except BaseException:
            self.screen.close()
            raise

    def prepare(self):
        # Keys for menu entries, as a user may set them: how far down a menu an entry stands is GIMP's business.
        with open(os.path.join(self.profile, "menurc"), "w") as file:
            for procedure, key in KEYS.items():
                file.write('(gtk_accel_path "<Actions>/plug-in/%s" "<Primary><Shift>%s")\n' % (procedure, key))
        if self.values is not None:
            folder = os.path.join(self.profile, "plug-in-settings")
            os.makedirs(folder, exist_ok=True)
            for name, text in self.values.items():
                with open(os.path.join(folder, name + ".values"), "w") as file:
                    file.write(text.replace(";", "\n"))

    def image_window(self):
        return self.screen.wait("GIMP$")

    def command(self, procedure):
        """Runs a procedure's menu entry."""
        self.screen.keys(self.image_window(), "ctrl+shift+" + KEYS[procedure])

    def close(self):
        super().close()
        self.screen.close()
