# SPDX-License-Identifier: GPL-3.0-or-later
"""What comes from the operations' tables: operators, properties, panels, presets; and what happens without the core."""
import os
import pathlib
import re
import subprocess

import addon_utils
import bpy
from helpers import Case, Scene, positions, restyle

import ductus_addon
from ductus_addon import binding, operators, properties
from ductus_addon.own import OWN

ADDON = pathlib.Path(os.environ["DUCTUS_SOURCE"]) / "plugins/blender/ductus_addon"


def all_properties(operation):
    """Each operator's and scene group's RNA properties by name, as Blender has them."""
    name = operators.settings_name(operation)
    rna = getattr(bpy.ops.ductus, name).get_rna_type()
    yield {prop.identifier: prop for prop in rna.properties}
    group = getattr(bpy.context.scene.ductus, name)
    yield {prop.identifier: prop for prop in group.bl_rna.properties}


class Tables(Case):
    def test_each_operation_has_an_operator_with_its_label_and_summary(self):
        self.assertGreater(len(binding.operations()), 0)
        for operation in binding.operations():
            rna = getattr(bpy.ops.ductus, operators.settings_name(operation)).get_rna_type()
            self.assertEqual(rna.name, operation.label)
            self.assertEqual(rna.description, operation.summary.rstrip("."))

    def test_each_parameter_is_a_property_with_its_range_default_and_choices(self):
        for operation in binding.operations():
            for found in all_properties(operation):
                for param in list(operation.params) + list(OWN):
                    prop = found[properties.identifier(param)]
                    with self.subTest(param=param.id):
                        self.assertEqual(prop.name, param.label)
                        if param.type in ("real", "auto", "int"):
                            self.assertAlmostEqual(prop.hard_min, param.minimum, delta=1e-6 * max(1, abs(param.minimum)))
                            self.assertAlmostEqual(prop.hard_max, param.maximum, delta=1e-6 * max(1, abs(param.maximum)))
                        if param.type == "auto":
                            self.assertEqual(found[properties.switch(param)].default, param.default == "auto")
                        if param.type in ("real", "int"):
                            self.assertAlmostEqual(prop.default, float(param.default), places=6)
                        if param.type == "bool":
                            self.assertEqual(prop.default, param.default == "true")
                        if param.type == "choice":
                            self.assertEqual([item.identifier for item in prop.enum_items],
                                             [choice.id for choice in param.choices])
                            self.assertEqual(prop.default, param.default)
                        if param.type == "hand":
                            self.assertEqual(prop.default, binding.hands()[0])

    def test_defaults_reach_the_core_as_its_own_defaults(self):
        ductus = binding.ductus()
        for operation in binding.operations():
            settings = ductus.Settings(operation.id)
            group = getattr(bpy.context.scene.ductus, operators.settings_name(operation))
            for param in operation.params:
                if param.type != "hand":
                    before = settings[param.id]
                    settings[param.id] = properties.value(group, param)
                    self.assertEqual(settings[param.id], before)

    def test_each_preset_of_the_tables_sets_all_values(self):
        ductus = binding.ductus()
        for operation in binding.operations():
            group = getattr(bpy.context.scene.ductus, operators.settings_name(operation))
            for preset in operation.presets:
                for param in operation.params:
                    if param.type == "real":
                        setattr(group, properties.identifier(param), param.maximum)
                bpy.ops.ductus.table_preset(operation=operation.id, preset=preset.id)
                wanted, made = ductus.Settings(operation.id), ductus.Settings(operation.id)
                wanted.preset(preset.id)
                for param in operation.params:
                    if param.type != "hand":
                        made[param.id] = properties.value(group, param)
                        self.assertEqual(made[param.id], wanted[param.id], (preset.id, param.id))

    def test_hands_are_offered_by_what_is_typed(self):
        hands = binding.hands()
        self.assertGreater(len(hands), 1)
        self.assertEqual(properties._hand_names(None, None, hands[1][:3]), [hands[1]])
        for text in ("", hands[0], "/a/file.inkml"):
            self.assertEqual(properties._hand_names(None, None, text), hands)

    def test_unknown_preset_is_refused(self):
        with self.assertRaises(RuntimeError) as caught:
            bpy.ops.ductus.table_preset(operation=binding.operations()[0].id, preset="none")
        self.assertIn("none", str(caught.exception))

    def test_users_presets_hold_every_value(self):
        for operation in binding.operations():
            name = operators.settings_name(operation)
            group = getattr(bpy.context.scene.ductus, name)
            changed = next(param for param in operation.params if param.type == "real")
            setattr(group, properties.identifier(changed), changed.maximum)
            group.thinnest = 0.125
            self.assertEqual(getattr(bpy.ops.ductus, f"{name}_preset_add")(name="Mine"), {"FINISHED"})
            path = next(path for folder in bpy.utils.preset_paths(f"ductus/{name}")
                        for path in pathlib.Path(folder).glob("*.py"))
            text = path.read_text()
            for prop in properties.names(list(OWN) + list(operation.params)):
                self.assertIn(f"group.{prop} = ", text)
            setattr(group, properties.identifier(changed), changed.minimum)
            group.thinnest = 0.3
            exec(compile(text, str(path), "exec"), {"bpy": bpy})
            self.assertAlmostEqual(getattr(group, properties.identifier(changed)), changed.maximum, places=5)
            self.assertAlmostEqual(group.thinnest, 0.125, places=6)

    def test_each_operation_has_panels_in_the_sidebar(self):
        for operation in binding.operations():
            name = operators.settings_name(operation)
            main = getattr(bpy.types, f"DUCTUS_PT_{name}")
            self.assertEqual((main.bl_space_type, main.bl_region_type, main.bl_category), ("VIEW_3D", "UI", "Ductus"))
            below = [cls for cls in bpy.types.Panel.__subclasses__() if getattr(cls, "bl_parent_id", "") == main.__name__]
            labels = " ".join(cls.bl_label for cls in below)
            for group in operators.groups(operation.params):
                self.assertIn(group, labels)

    def test_no_operation_is_named_in_the_add_on(self):
        ids = [operation.id for operation in binding.operations()]
        for path in ADDON.rglob("*.py"):
            for id_ in ids:
                self.assertIsNone(re.search(rf"\b{id_.replace('-', '[-_]')}\b", path.read_text(), re.IGNORECASE),
                                  f"{path.name} names the operation {id_}")

    def test_points_are_read_and_written_in_bulk(self):
        for path in ADDON.rglob("*.py"):
            self.assertIsNone(re.search(r"for \w+ in \w*\.?points\b(?!\.)\s*:", path.read_text()), path.name)

    def test_the_hosts_data_is_touched_by_one_module_alone(self):
        for path in ADDON.rglob("*.py"):
            if path.parent.name != "grease_pencil":
                self.assertIsNone(re.search(r"foreach_[gs]et|\.strokes\.new|\.frames\.copy", path.read_text()), path.name)
            if path.parent.name == "geometry":
                self.assertNotIn("bpy", path.read_text())


class WithoutTheCore(Case):
    def tearDown(self):
        os.environ.pop("DUCTUS_LIBRARY", None)
        bpy.context.preferences.addons["ductus_addon"].preferences.library = ""
        self.assertEqual(ductus_addon.reload_operations(), "")

    def test_a_missing_library_is_a_sentence_and_a_right_path_mends_it(self):
        preferences = bpy.context.preferences.addons["ductus_addon"].preferences
        good = binding.library_path()
        preferences.library = "/nowhere/libductus.so"
        self.assertIn("/nowhere/libductus.so", binding.problem())
        self.assertFalse(hasattr(bpy.types, "DUCTUS_PT_restyle"))
        self.assertTrue(bpy.types.DUCTUS_PT_missing.poll(bpy.context))
        with self.assertRaises(RuntimeError) as caught:
            bpy.ops.ductus.look_again()
        self.assertIn("/nowhere/libductus.so", str(caught.exception))
        preferences.library = good
        self.assertEqual(binding.problem(), "")
        self.assertFalse(bpy.types.DUCTUS_PT_missing.poll(bpy.context))
        self.scene.wave()
        self.assertEqual(restyle(), {"FINISHED"})

    def test_a_file_that_is_no_library_is_a_sentence(self):
        preferences = bpy.context.preferences.addons["ductus_addon"].preferences
        preferences.library = str(ADDON / "__init__.py")
        self.assertIn("__init__.py", binding.problem())

    def test_the_add_on_registers_without_the_library(self):
        script = ("import os, addon_utils, bpy\n"
                  "addon_utils.enable('ductus_addon', default_set=True)\n"
                  "from ductus_addon import binding\n"
                  "assert 'nothing.so' in binding.problem(), binding.problem()\n"
                  "assert bpy.types.DUCTUS_PT_missing.poll(bpy.context)\n"
                  "addon_utils.disable('ductus_addon')\n"
                  "print('registered without')\n")
        environment = dict(os.environ, DUCTUS_LIBRARY="/nowhere/nothing.so")
        done = subprocess.run([bpy.app.binary_path, "--background", "--factory-startup", "--python-exit-code", "3",
                               "--python-expr", script], env=environment, capture_output=True, text=True,
                              stdin=subprocess.DEVNULL, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
        self.assertIn("registered without", done.stdout)


class OnAndOff(Case):
    def test_disabling_takes_everything_away_and_enabling_brings_it_back(self):
        addon_utils.disable("ductus_addon")
        self.assertFalse(hasattr(bpy.types.Scene, "ductus"))
        self.assertEqual([name for name in dir(bpy.types) if name.startswith("DUCTUS_")], [])
        addon_utils.enable("ductus_addon", default_set=True)
        scene = Scene()
        before = positions(scene.wave())
        self.assertEqual(restyle(), {"FINISHED"})
        self.assertMoved(scene.frame.strokes[0], before)

    def test_panels_draw(self):
        """Every draw function runs against a layout that takes anything: a wrong property name would raise."""
        class Layout:
            def __getattr__(self, name):
                return lambda *args, **kwargs: Layout() if not self._check(name, args) else None

            @staticmethod
            def _check(name, args):
                if name == "prop":
                    getattr(args[0], args[1])
        for operation in binding.operations():
            group = getattr(bpy.context.scene.ductus, operators.settings_name(operation))
            for advanced in (False, True):
                properties.draw(Layout(), group, list(OWN) + list(operation.params), advanced)
