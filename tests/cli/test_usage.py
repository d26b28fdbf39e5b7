# SPDX-License-Identifier: GPL-3.0-or-later
"""Help, the tables, and command lines that were typed wrong."""

import json
import re
import unittest

from program import SOURCE, ProgramTest, operations, svg

COMMANDS = ["render", "convert", "show", "brushes", "styles", "ops", "completion", "library", "library build", "library report", "library list"]


class HelpTest(ProgramTest):
    def test_version_is_one_line(self):
        self.assertRegex(self.succeed("--version").decode(), r"\Aductus \d+\.\d+\.\d+\n\Z")

    def test_help_lists_operations_and_commands(self):
        text = self.succeed("--help").decode()
        self.assertEqual(text, self.succeed("help").decode())
        for name in [o["id"] for o in operations()] + ["render", "convert", "show", "library", "brushes", "styles", "ops", "completion"]:
            self.assertRegex(text, rf"(?m)^  {name}( |$)")

    def test_every_command_has_help(self):
        for command in COMMANDS:
            text = self.succeed(*command.split(), "--help").decode()
            self.assertTrue(text.startswith(f"Usage: ductus {command}"), text)

    def test_operation_help_is_made_from_its_table(self):
        for operation in operations():
            text = " ".join(self.succeed(operation["id"], "--help").decode().split())
            self.assertEqual(text, " ".join(self.succeed("help", operation["id"]).decode().split()))
            self.assertIn(operation["summary"], text)
            for parameter in operation["parameters"]:
                name = "--[no-]" if parameter["type"] == "bool" else "--"
                self.assertIn(name + parameter["id"], text)
                self.assertIn(parameter["tooltip"], text)
                for choice in parameter["choices"]:
                    self.assertIn(choice["tooltip"], text)
            for preset in operation["presets"]:
                self.assertIn(preset["tooltip"], text)

    def test_help_fits_the_width(self):
        for command in COMMANDS + [o["id"] for o in operations()]:
            for columns in (60, 100):
                environment = {"COLUMNS": str(columns)}
                self.environment.update(environment)
                for line in self.succeed(*command.split(), "--help").decode().splitlines():
                    if not line.startswith("Usage:"):
                        self.assertLessEqual(len(line), columns, line)

    def test_ops_json_holds_what_hosts_need(self):
        table = json.loads(self.succeed("ops", "--json"))["operations"]
        self.assertTrue(table)
        for operation in table:
            self.assertLessEqual({"id", "label", "summary", "parameters", "presets"}, set(operation))
            for parameter in operation["parameters"]:
                self.assertLessEqual(
                    {"id", "label", "tooltip", "type", "unit", "default", "choices", "group"}, set(parameter)
                )
                if parameter["type"] in ("int", "real"):
                    self.assertLessEqual({"range", "step"}, set(parameter))

    def test_ops_names_every_parameter(self):
        text = self.succeed("ops").decode()
        for operation in operations():
            for parameter in operation["parameters"]:
                self.assertIn(f"--{parameter['id']}", text)

    def test_the_program_names_no_operation(self):
        """Operations come from the tables: the command line's sources hold no id of any."""
        code = "".join(path.read_text() for path in sorted((SOURCE / "cli").glob("*.[ch]")))
        for operation in operations():
            self.assertIsNone(re.search(rf'"{re.escape(operation["id"])}"', code))


class MisuseTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.file("in.svg", svg("M10 10 L90 50"))

    def test_nothing_at_all(self):
        self.assertIn("--help", self.refuse(2))

    def test_a_mistyped_command_gets_the_nearest(self):
        self.assertIn("did you mean 'render'?", self.refuse(2, "redner", "in.svg"))
        self.assertIn("did you mean 'library'?", self.refuse(2, "libary"))
        for operation in operations():
            name = operation["id"]
            typed = name[1] + name[0] + name[2:]
            self.assertIn(f"did you mean '{name}'?", self.refuse(2, typed, "in.svg"))

    def test_a_strange_command_gets_no_guess(self):
        self.assertNotIn("did you mean", self.refuse(2, "qqqqqqqqqqqq"))
        self.assertNotIn("did you mean", self.refuse(2, "x" * 5000))

    def test_library_commands(self):
        self.assertIn("build, report or list", self.refuse(2, "library"))
        self.assertIn("did you mean 'build'?", self.refuse(2, "library", "biuld"))
        self.assertIn("-o", self.refuse(2, "library", "build", "in.svg"))
        self.assertIn("recordings", self.refuse(2, "library", "build", "-o", "x.inkml"))

    def test_a_mistyped_option_gets_the_nearest(self):
        self.assertIn("did you mean --background?", self.refuse(2, "render", "in.svg", "--backgruond", "red"))
        self.assertIn("did you mean --quiet?", self.refuse(2, "convert", "in.svg", "--queit"))
        self.assertIn("-x", self.refuse(2, "convert", "in.svg", "-x"))

    def test_values_that_are_missing_or_too_many(self):
        self.assertIn("needs a value", self.refuse(2, "convert", "in.svg", "-o"))
        self.assertIn("takes no value", self.refuse(2, "convert", "in.svg", "--quiet=3"))
        self.assertIn("neither true nor false", self.refuse(2, "convert", "in.svg", "--progress=maybe"))

    def test_numbers_are_checked(self):
        for value in ("", "x", "nan", "inf", "1e999", "0x10", "3,5", " 3", "3 "):
            self.assertIn("not a", self.refuse(2, "render", "in.svg", "-o", "o.png", "--dpi", value), value)
        self.assertIn("outside", self.refuse(2, "render", "in.svg", "-o", "o.png", "--dpi", "-3"))
        self.assertIn("whole", self.refuse(2, "convert", "in.svg", "-o", "o.svg", "--threads=1.5"))

    def test_choices_and_colours_are_checked(self):
        self.assertIn("outline path", self.refuse(2, "convert", "in.svg", "-o", "o.svg", "--line", "line"))
        for colour in ("#12", "#gggggg", "nocolour", "#", ""):
            self.assertIn("colour", self.refuse(2, "render", "in.svg", "-o", "o.png", "--background", colour))

    def test_a_drawing_and_a_place_are_needed(self):
        self.assertIn("drawing", self.refuse(2, "convert", "-o", "o.svg"))
        self.assertIn("-o OUT", self.refuse(2, "convert", "in.svg"))

    def test_formats_that_are_not(self):
        self.assertIn("svg", self.refuse(2, "convert", "in.svg", "-o", "o.xyz"))
        self.assertIn("svg", self.refuse(2, "convert", "in.svg", "-o", "o"))
        self.assertIn("--to", self.refuse(2, "convert", "in.svg", "-o", "-"))
        self.assertIn("--to", self.refuse(2, "convert", "in.svg", "-o", "-", "--to", "xyz"))
        self.assertIn("--to", self.refuse(2, "convert", "in.svg", "-o", "o.svg", "--to", "csv"))
        self.assertIn("--from", self.refuse(2, "convert", "in.svg", "-o", "o.svg", "--from", "xyz"))
        self.assertIn("no image", self.refuse(2, "render", "in.svg", "-o", "o.svg"))

    def test_control_characters_stay_off_the_terminal(self):
        line = self.refuse(2, "a\x1b[31mb\nc")
        self.assertNotIn("\x1b", line)


class ParameterTest(ProgramTest):
    """Every parameter of every operation refuses what its table does not allow."""

    def setUp(self):
        super().setUp()
        self.file("in.svg", svg("M10 10 L90 50"))

    def test_values_outside_the_table(self):
        for operation in operations():
            for parameter in operation["parameters"]:
                wrong = {
                    "bool": [],
                    "int": ["x", "1.5", "nan", ""],
                    "real": ["x", "nan", "inf", ""],
                    "choice": ["no-such-choice", ""],
                    "auto-or-real": ["x", "nan"],
                    "seed": ["-1", "x", "1.5"],
                    "hand": [],
                    "style": [""],
                    "strokes": [],
                }[parameter["type"]]
                if "range" in parameter:
                    low, high = parameter["range"]
                    wrong += [f"{low - 1:.17g}", f"{high + 1 + abs(high):.17g}"]
                for value in wrong:
                    line = self.refuse(2, operation["id"], "in.svg", "-o", "o.svg", f"--{parameter['id']}={value}")
                    self.assertIn(parameter["id"], line)

    def test_a_mistyped_parameter_gets_the_nearest(self):
        for operation in operations():
            for parameter in operation["parameters"]:
                name = parameter["id"]
                if len(name) > 5:
                    typed = name[:2] + name[3] + name[2] + name[4:]
                    if typed != name:
                        line = self.refuse(2, operation["id"], "in.svg", f"--{typed}", "1")
                        self.assertIn(f"did you mean --{name}?", line)

    def test_presets_are_checked(self):
        for operation in operations():
            line = self.refuse(2, operation["id"], "in.svg", "-o", "o.svg", "--preset", "no-such-preset")
            self.assertIn("no-such-preset", line)

    def test_a_hand_has_to_be_given_and_those_there_are_are_listed(self):
        for operation in operations():
            if self.needed(operation):
                line = self.refuse(2, operation["id"], "in.svg", "-o", "o.svg")
                self.assertIn(self.hands()[0], line)


if __name__ == "__main__":
    unittest.main()
