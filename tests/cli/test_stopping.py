# SPDX-License-Identifier: GPL-3.0-or-later
"""Signals, progress and what appears on a terminal."""

import os
import pty
import signal
import subprocess
import time
import unittest

from program import ENVIRONMENT, PROGRAM, ProgramTest, operations, svg, waves


class StoppingTest(ProgramTest):
    def start(self, *words, **options):
        return subprocess.Popen(
            [PROGRAM, *map(str, words)],
            cwd=self.work,
            env={**ENVIRONMENT, **self.environment},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            **options,
        )

    def stop(self, number, process):
        """Sends a signal once the work has begun (its first line of progress) and gives code and stderr."""
        first = process.stderr.readline()
        process.send_signal(number)
        _, rest = process.communicate(timeout=120)
        return process.returncode, first + rest

    def test_signals_stop_the_work_and_leave_nothing(self):
        self.file("in.svg", waves(2000))
        before = self.listing()
        for operation in operations():
            words = [operation["id"], *self.needed(operation), "in.svg", "--progress"]
            for number, out in ((signal.SIGINT, "out.svg"), (signal.SIGTERM, "out.inkml"), (signal.SIGINT, "out.png")):
                process = self.start(*words, "-o", out, "--trace", "trace.json")
                code, text = self.stop(number, process)
                self.assertEqual(code, 128 + number, text)
                self.assertEqual(text.splitlines()[-1], b"ductus: stopped; nothing was written")
                self.assertEqual(self.listing(), before)

    def test_waiting_for_standard_input_can_be_stopped(self):
        process = self.start("convert", "-", "-o", "out.svg")
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        process.wait(timeout=60)
        self.assertEqual(process.returncode, 130)
        process.communicate()
        self.assertEqual(self.listing(), {})

    def test_a_reader_that_goes_away(self):
        self.file("in.svg", waves(3000))
        process = self.start("convert", "in.svg", "-o", "-", "--to", "csv")
        process.stdout.read(10)
        process.stdout.close()
        self.assertEqual(process.wait(timeout=60), 1)
        self.assertIn(b"standard output", process.stderr.read())
        process.stderr.close()
        process.stdin.close()

    def test_progress_without_a_terminal_is_lines(self):
        self.file("in.svg", waves(300))
        for operation in operations():
            done = self.run_program(
                operation["id"], *self.needed(operation), "in.svg", "-o", "out.svg", "--progress"
            )
            self.assertEqual(done.returncode, 0)
            lines = done.stderr.decode().splitlines()
            percents = [int(l.split(": ")[1].split()[0]) for l in lines if l.startswith(operation["id"] + ": ")]
            self.assertEqual(percents, sorted(percents))
            self.assertTrue(percents)


class TerminalTest(ProgramTest):
    def on_terminal(self, *words):
        """Runs the program with a terminal as stderr and gives the exit code and what the terminal got."""
        control, terminal = pty.openpty()
        process = subprocess.Popen(
            [PROGRAM, *map(str, words)],
            cwd=self.work,
            env={**ENVIRONMENT, **self.environment},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=terminal,
        )
        os.close(terminal)
        text = b""
        while True:
            try:
                piece = os.read(control, 4096)
            except OSError:
                break
            if not piece:
                break
            text += piece
        os.close(control)
        process.communicate(timeout=60)
        return process.returncode, text.decode().replace("\r\n", "\n")

    def test_one_summary_line(self):
        self.file("in.svg", svg("M10 10 L90 50"))
        code, text = self.on_terminal("convert", "in.svg", "-o", "out.svg")
        self.assertEqual(code, 0)
        self.assertRegex(text, r"\Ain\.svg -> out\.svg: 1 strokes?, [0-9.]+ s\n\Z")

    def test_quiet_is_quiet(self):
        self.file("in.svg", svg("M10 10 L90 50"))
        self.assertEqual(self.on_terminal("convert", "in.svg", "-o", "out.svg", "--quiet"), (0, ""))
        self.assertEqual(self.on_terminal("convert", "in.svg", "-o", "out.svg", "-q"), (0, ""))

    def test_progress_is_drawn_and_erased(self):
        self.file("in.svg", waves(200))
        for operation in operations():
            words = [operation["id"], *self.needed(operation), "in.svg", "-o", "out.svg"]
            code, text = self.on_terminal(*words, "--progress")
            self.assertEqual(code, 0)
            self.assertIn("%", text)
            # What stays is behind the last erasing.
            self.assertRegex(text.split("\033[K")[-1], r"\A(in\.svg -> out\.svg: [^\n]*\n)\Z")
            code, text = self.on_terminal(*words, "--no-progress")
            self.assertNotIn("%", text)

    def test_errors_stand_on_a_clean_line(self):
        code, text = self.on_terminal("convert", "none.svg", "-o", "out.svg", "--progress")
        self.assertEqual(code, 1)
        self.assertTrue(text.split("\033[K")[-1].startswith("ductus: none.svg: "))


if __name__ == "__main__":
    unittest.main()
