# SPDX-License-Identifier: GPL-3.0-or-later
"""The manual page and the shells' completion, as the shells themselves see them."""

import json
import re
import shutil
import subprocess
import unittest

from program import ENVIRONMENT, PROGRAM, ProgramTest, operations

COMMANDS = ["render", "convert", "show", "library", "brushes", "styles", "ops", "completion"]


class ManualTest(ProgramTest):
    def page(self):
        return self.succeed("help", "--man")

    def test_it_holds_every_command_and_parameter(self):
        text = self.page().decode().replace("\\-", "-")
        for command in COMMANDS + [o["id"] for o in operations()]:
            self.assertIn(f"ductus {command}", text)
        for operation in operations():
            for parameter in operation["parameters"]:
                self.assertIn(parameter["id"], text)
                for choice in parameter["choices"]:
                    self.assertRegex(text, rf"(?m)^\.I {re.escape(choice['id'])}$")
        for section in ("NAME", "SYNOPSIS", "DESCRIPTION", "COMMON OPTIONS", "EXIT STATUS", "FILES", "ENVIRONMENT"):
            self.assertIn(f".SH {section}\n", text)
        self.assertEqual(text.count("--threads N\n"), 1)

    def test_no_line_is_a_mistaken_request(self):
        for line in self.page().decode().splitlines():
            if line.startswith((".", "'")):
                self.assertRegex(line, r'^\.(\\"|TH |SH |SS |TP|PP$|RS$|RE$|br$|B |I )')

    def test_it_is_the_same_again(self):
        self.assertEqual(self.page(), self.page())

    @unittest.skipUnless(shutil.which("groff"), "groff is not installed")
    def test_groff_has_nothing_to_say(self):
        done = subprocess.run(
            ["groff", "-man", "-Tutf8", "-Kutf8", "-wall"], input=self.page(), capture_output=True, check=True
        )
        self.assertEqual(done.stderr, b"")
        self.assertIn("draw with somebody", done.stdout.decode())


class CompletionTest(ProgramTest):
    def setUp(self):
        super().setUp()
        for shell in ("bash", "zsh", "fish"):
            self.file(shell, self.succeed("completion", shell))
        self.file("drawing.svg", "")

    def shell(self, *words):
        done = subprocess.run(
            words,
            cwd=self.work,
            env={**ENVIRONMENT, **self.environment},
            capture_output=True,
            text=True,
            check=False,
            timeout=60,
        )
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout.splitlines()

    def bash(self, *words):
        """What bash offers where these words are typed, the last one being begun."""
        script = (
            'source ./bash; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _ductus; '
            "for word in ${COMPREPLY[@]+\"${COMPREPLY[@]}\"}; do printf '%s\\n' \"$word\"; done"
        )
        return sorted(self.shell("bash", "-c", script, "bash", PROGRAM, *words))

    def test_commands(self):
        offered = self.bash("")
        self.assertLessEqual(set(COMMANDS + [o["id"] for o in operations()]), set(offered))
        self.assertEqual(self.bash("rend"), ["render"])
        self.assertEqual(self.bash("library", "bu"), ["build"])
        self.assertLessEqual({"build", "list", "report"}, set(self.bash("library", "")))
        self.assertEqual(self.bash("completion", ""), ["bash", "fish", "zsh"])
        self.assertIn("--man", self.bash("help", ""))

    def test_options(self):
        for operation in operations():
            offered = self.bash(operation["id"], "--")
            for parameter in operation["parameters"]:
                self.assertIn(f"--{parameter['id']}", offered)
                if parameter["type"] == "bool":
                    self.assertIn(f"--no-{parameter['id']}", offered)
        self.assertIn("--artist", self.bash("library", "build", "--a"))
        self.assertIn("--quiet", self.bash("render", "in.svg", "-"))

    def test_choices(self):
        for operation in operations():
            for parameter in operation["parameters"]:
                if parameter["choices"]:
                    choices = sorted(choice["id"] for choice in parameter["choices"])
                    self.assertEqual(self.bash(operation["id"], f"--{parameter['id']}", ""), choices)
                    self.assertEqual(self.bash(operation["id"], f"--{parameter['id']}", "=", ""), choices)
                    self.assertEqual(self.bash(operation["id"], f"--{parameter['id']}", "="), choices)
            presets = sorted(preset["id"] for preset in operation["presets"])
            self.assertEqual(self.bash(operation["id"], "--preset", ""), presets)
        self.assertEqual(self.bash("show", "--by", "tilt-"), ["tilt-x", "tilt-y"])
        self.assertEqual(self.bash("convert", "--to", "inkm"), ["inkml"])
        self.assertIn("png", self.bash("convert", "--to", ""))

    def test_names_of_hands_and_brushes_and_files(self):
        brushes = self.succeed("brushes").decode().split()
        self.assertLessEqual(set(brushes), set(self.bash("render", "--brush", "")))
        self.assertIn("drawing.svg", self.bash("render", "--brush", "d"))
        for operation in operations():
            for parameter in operation["parameters"]:
                if parameter["type"] == "hand":
                    offered = self.bash(operation["id"], f"--{parameter['id']}", "")
                    self.assertLessEqual(set(self.hands()), set(offered))
                if parameter["type"] == "style":
                    offered = self.bash(operation["id"], f"--{parameter['id']}", "")
                    styles = self.succeed("styles").decode().split()
                    self.assertGreaterEqual(len(styles), 10)
                    self.assertLessEqual(set(styles), set(offered))
        self.assertEqual(self.bash("show", "dr"), ["drawing.svg"])
        self.assertEqual(self.bash("show", "--", "dr"), ["drawing.svg"])
        self.assertEqual(self.bash("render", "-o", "dr"), ["drawing.svg"])

    def test_a_name_with_spaces_stays_whole(self):
        hands = self.folder / "home" / "ductus" / "hands"
        hands.mkdir(parents=True)
        (hands / "my own hand.inkml").write_text("")
        operation = next(o for o in operations() if any(p["type"] == "hand" for p in o["parameters"]))
        name = next(p["id"] for p in operation["parameters"] if p["type"] == "hand")
        self.assertEqual(self.bash(operation["id"], f"--{name}", "my"), ["my own hand"])

    def test_numbers_and_ends_offer_nothing(self):
        self.assertEqual(self.bash("render", "--dpi", ""), [])
        self.assertEqual(self.bash("brushes", ""), [])
        self.assertEqual(self.bash("nosuch", ""), [])

    def test_bash_has_it_for_the_program(self):
        self.assertIn("-F _ductus", " ".join(self.shell("bash", "-c", "source ./bash; complete -p ductus")))

    @unittest.skipUnless(shutil.which("fish"), "fish is not installed")
    def test_fish(self):
        def offered(line):
            script = f"source ./fish; complete -C '{line}'"
            return [row.split("\t")[0] for row in self.shell("fish", "--no-config", "-c", script)]

        operation = operations()[0]
        self.assertIn(operation["id"], offered("ductus "))
        self.assertIn("report", offered("ductus library "))
        self.assertEqual(offered("ductus show --by=tilt-"), ["--by=tilt-x", "--by=tilt-y"])
        self.assertEqual(sorted(offered("ductus completion ")), ["bash", "fish", "zsh"])
        for parameter in operation["parameters"]:
            self.assertIn(f"--{parameter['id']}", offered(f"ductus {operation['id']} --{parameter['id']}"))
        self.assertEqual(set(offered(f"{PROGRAM} render --brush inkk")), set())

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_zsh_understands_the_script(self):
        self.assertEqual(self.shell("zsh", "-f", "-n", "./zsh"), [])
        loaded = self.shell("zsh", "-f", "-c", "autoload -Uz compinit; compinit -u -D; source ./zsh; echo $_comps[ductus]")
        self.assertEqual(loaded, ["_ductus"])

    def test_what_is_no_shell(self):
        self.assertIn("bash", self.refuse(2, "completion"))
        self.assertIn("bash", self.refuse(2, "completion", "csh"))
        self.assertIn("bash", self.refuse(2, "completion", "bash", "zsh"))

    def test_lists_for_the_scripts(self):
        self.assertEqual(self.succeed("completion", "hands").decode().split(), self.hands())
        names = json.loads(self.succeed("brushes", "--json"))
        self.assertEqual(self.succeed("completion", "brushes").decode().split(), names)


if __name__ == "__main__":
    unittest.main()
