# SPDX-License-Identifier: GPL-3.0-or-later
"""A GIMP of our own to talk to: a profile in a temporary folder that holds only our plug-in, and GIMP's Script-Fu
server, which evaluates what it is sent while GIMP runs. `gimp -b` itself exits with 0 whatever happens."""

import os
import shutil
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time

SOURCE = os.environ.get("DUCTUS_SOURCE", os.path.abspath(os.path.join(os.path.dirname(__file__), "..", "..", "..")))
BUILD = os.environ.get("DUCTUS_BUILD", os.path.join(SOURCE, "build", "release"))
PLUGIN = os.path.join(BUILD, "lib", "gimp", "2.0", "plug-ins", "ductus-gimp")


def require(*programs):
    """Ends the test where a program is missing: skipped for a developer, failed for the builds that must have it."""
    missing = [name for name in programs if shutil.which(name) is None]
    if not os.path.exists(os.path.join(PLUGIN, "ductus-gimp")):
        missing.append("the built plug-in")
    if missing:
        text = "not here: " + ", ".join(missing)
        if os.environ.get("CI") == "true":
            sys.exit(text)
        print("skipped: " + text)
        sys.exit(77)


# Whoever stops a test (CTest, after a time) must not leave its GIMP behind.
signal.signal(signal.SIGTERM, lambda *_: sys.exit("stopped"))


class Failed(Exception):
    """What GIMP or the plug-in said."""


def prepare_profile(folder):
    """A GIMP profile that knows our plug-in, and where it keeps things."""
    profile = os.path.join(folder, "gimp")
    for name in ("plug-ins", "gradients", "tmp"):
        os.makedirs(os.path.join(profile, name))
    os.symlink(PLUGIN, os.path.join(profile, "plug-ins", "ductus-gimp"))
    environment = dict(os.environ, GIMP2_DIRECTORY=profile, XDG_DATA_HOME=os.path.join(folder, "data"),
                       HOME=folder, LC_ALL="C.UTF-8")
    # The plug-in finds hands and brushes from its own place, as an installed one does.
    environment.pop("DUCTUS_DATA_FOLDER", None)
    return profile, environment


class Gimp:
    """One running GIMP. With `display` it has a window there; with `data` its own brushes and dynamics."""

    def __init__(self, display=None, data=False):
        self.folder = tempfile.mkdtemp(prefix="ductus-gimp-")
        self.profile, environment = prepare_profile(self.folder)
        self.prepare()
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            self.port = probe.getsockname()[1]
        command = ["gimp", "-s", "-f"] + ([] if data else ["-d"])
        if display is None:
            command.append("-i")
            environment.pop("DISPLAY", None)
        else:
            environment["DISPLAY"] = display
        server = '(plug-in-script-fu-server RUN-NONINTERACTIVE "127.0.0.1" %d "%s")' % (
            self.port, os.path.join(self.folder, "server.log"))
        self.log = open(os.path.join(self.folder, "log"), "w+")
        self.process = subprocess.Popen(command + ["-b", server], env=environment, stdin=subprocess.DEVNULL,
                                        stdout=self.log, stderr=subprocess.STDOUT, start_new_session=True)
        self.socket = self._connect()
        with open(os.path.join(os.path.dirname(__file__), "helpers.scm")) as helpers:
            self.run(helpers.read())

    def prepare(self):
        """What else the profile is to hold before GIMP starts."""

    def _connect(self):
        for _ in range(600):
            try:
                return socket.create_connection(("127.0.0.1", self.port), timeout=120)
            except OSError:
                if self.process.poll() is not None:
                    break
                time.sleep(0.1)
        self.log.seek(0)
        text = self.log.read()
        self.close()
        raise Failed("GIMP did not start: " + text)

    def run(self, text):
        """Evaluates Scheme; the value where it is a string. Raises what the plug-in or GIMP said."""
        data = text.encode()
        self.socket.sendall(b"G" + struct.pack(">H", len(data)) + data)
        head = self._receive(4)
        answer = self._receive(struct.unpack(">H", head[2:])[0]).decode()
        if head[1] != 0:
            raise Failed(answer)
        return answer[1:-1] if len(answer) > 1 and answer[0] == answer[-1] == '"' else answer

    def _receive(self, size):
        data = b""
        while len(data) < size:
            more = self.socket.recv(size - len(data))
            if not more:
                raise Failed("GIMP closed the connection")
            data += more
        return data

    def value(self, text):
        """The value of a Scheme expression as text, of whatever kind it is."""
        return self.run("(as-text %s)" % text)

    def number(self, text):
        return float(self.value(text))

    def numbers(self, text):
        return [float(word) for word in self.value(text).strip("()#").split()]

    def output(self):
        """What GIMP and its plug-ins have printed."""
        self.log.flush()
        with open(self.log.name) as log:
            return log.read()

    def close(self):
        if getattr(self, "socket", None) is not None:
            self.socket.close()
        # Only what was started here: GIMP and its plug-ins are a process group of their own.
        for number in (signal.SIGTERM, signal.SIGKILL):
            try:
                os.killpg(self.process.pid, number)
            except ProcessLookupError:
                break
            for _ in range(30):
                if self.process.poll() is not None:
                    break
                time.sleep(0.1)
        self.log.close()
        shutil.rmtree(self.folder, ignore_errors=True)
