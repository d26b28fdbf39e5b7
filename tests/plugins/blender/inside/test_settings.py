# SPDX-License-Identifier: GPL-3.0-or-later
"""Every property of every operator has an effect, or at least does no harm: the tables say which values to try."""
import bpy
import numpy as np
from helpers import Case, Scene, helix, positions, restyle, snapshot

from ductus_addon import binding, operators, properties
from ductus_addon.own import OWN


def other_values(param):
    """Values other than the default."""
    name = properties.identifier(param)
    if param.type == "bool":
        return [{name: param.default != "true"}]
    if param.type == "choice":
        return [{name: choice.id} for choice in param.choices if choice.id != param.default]
    if param.type == "hand":
        return [{name: hand} for hand in binding.hands()[1:3]]
    if param.type == "seed":
        return [{name: 12345}, {name: 2**31 - 1}]
    low, high = param.minimum, param.maximum
    values = [low, high, 0.5 * (low + high)] if high - low <= 100 else [low, low + 10]
    if param.type == "int":
        values = [int(value) for value in values]
    if param.type == "auto":
        return [{name: value, properties.switch(param): False} for value in (0.5, 2.0)]
    return [{name: value} for value in values if str(value) != param.default]


class EveryProperty(Case):
    def drawn(self):
        scene = Scene()
        scene.wave(phase=1)
        scene.stroke([[0, 0, 1], [1, 0, 1], [1, 0, 2], [0, 0, 2]], closed=True)
        scene.stroke(helix(30))
        return scene

    def test_every_parameter_of_every_operation(self):
        """All values run; of each parameter at least one changes the result, where it is not one of a search that
        gives the same result by another way or has no say here. The first operation's: of the others, whose runs take
        longer, the defaults run."""
        idle = []
        for operation in binding.operations()[1:]:
            run = getattr(bpy.ops.ductus, operators.settings_name(operation))
            scene = self.drawn()
            self.assertEqual(run("EXEC_DEFAULT"), {"FINISHED"})
            for stroke in scene.frame.strokes:
                self.assertTrue(np.isfinite(positions(stroke)).all())
        for operation in binding.operations()[:1]:
            run = getattr(bpy.ops.ductus, operators.settings_name(operation))
            scene = self.drawn()
            run("EXEC_DEFAULT")
            reference = snapshot(scene.data)
            for param in operation.params:
                changed = False
                for values in other_values(param):
                    with self.subTest(values=values):
                        scene = self.drawn()
                        self.assertEqual(run("EXEC_DEFAULT", **values), {"FINISHED"})
                        for stroke in scene.frame.strokes:
                            self.assertTrue(np.isfinite(positions(stroke)).all())
                        changed = changed or snapshot(scene.data) != reference
                if not changed:
                    idle.append(param.id)
        # Seeds without variation, exact searches and costs that this small drawing never has to pay.
        self.assertLess(len(idle), len(binding.operations()[0].params) / 3, idle)

    def test_every_value_of_the_add_ons_own(self):
        for own in OWN:
            for values in other_values(own):
                if own.id == "apply-to":
                    continue  # see test_objects
                with self.subTest(values=values):
                    scene = self.drawn()
                    if own.id in ("seeds", "boil-frames", "frame-start", "frame-end"):
                        values = {"frames": "range", "frame_start": 1, "frame_end": 8, **values}
                        if values["frame_start"] > values["frame_end"]:
                            continue
                        if values["frame_end"] - values["frame_start"] > 1000:
                            continue
                    self.assertEqual(restyle(**values), {"FINISHED"})
                    for layer in scene.data.layers:
                        self.assertGreater(len(layer.frames), 0)

    def test_file_as_a_hand(self):
        hand = next(hand for hand in binding.ductus().hands() if hand.name == binding.hands()[1])
        named, by_path = self.drawn(), None
        restyle(hand=hand.name)
        named = snapshot(named.data)
        by_path = self.drawn()
        restyle(hand=hand.path)
        self.assertEqual(snapshot(by_path.data), named)

    def test_bad_hands_are_refused(self):
        self.scene.wave()
        with self.assertRefused("No hand is chosen"):
            restyle(hand="")
        with self.assertRefused("nobody"):
            restyle(hand="nobody")
        with self.assertRefused("/nowhere/hand.inkml"):
            restyle(hand="/nowhere/hand.inkml")

    def test_execute_leaves_the_panels_values_alone(self):
        """With a window, the panel's button takes them: see the test in a window."""
        line = self.scene.wave()
        before = positions(line)
        bpy.context.scene.ductus.restyle.amount = 0
        self.assertEqual(bpy.ops.ductus.restyle("EXEC_DEFAULT"), {"FINISHED"})
        self.assertMoved(line, before)

    def test_settings_are_saved_with_the_file(self):
        import os
        path = os.path.join(os.environ["TMPDIR"], "saved.blend")
        group = bpy.context.scene.ductus.restyle
        group.hand, group.variation, group.plane, group.scale_auto = "eve", 0.75, "top", False
        bpy.ops.wm.save_as_mainfile(filepath=path)
        bpy.ops.wm.read_homefile(use_empty=True)
        self.assertNotEqual(bpy.context.scene.ductus.restyle.hand, "eve")
        bpy.ops.wm.open_mainfile(filepath=path)
        group = bpy.context.scene.ductus.restyle
        self.assertEqual((group.hand, group.variation, group.plane, group.scale_auto), ("eve", 0.75, "top", False))
