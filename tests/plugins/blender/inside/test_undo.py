# SPDX-License-Identifier: GPL-3.0-or-later
"""Undo and redo, one step a run; and running again from the undone state, as Adjust Last Operation does."""
import bpy
from helpers import Case, restyle, snapshot


class Undo(Case):
    def push(self):
        bpy.ops.ed.undo_push(message="drawn")

    def run_with_undo(self, **values):
        return bpy.ops.ductus.restyle("EXEC_DEFAULT", True, hand="anna", **values)

    def now(self):
        return snapshot(bpy.data.grease_pencils["Lines"])

    def test_undo_and_redo(self):
        for values in ({}, {"result": "new-layer"},
                       {"frames": "range", "frame_start": 1, "frame_end": 9, "seeds": "boil", "variation": 1.0}):
            with self.subTest(values=values):
                self.setUp()
                self.scene.wave()
                self.push()
                before = self.now()
                self.assertEqual(self.run_with_undo(**values), {"FINISHED"})
                after = self.now()
                self.assertNotEqual(after, before)
                bpy.ops.ed.undo()
                self.assertEqual(self.now(), before)
                bpy.ops.ed.redo()
                self.assertEqual(self.now(), after)

    def test_restore_is_undone(self):
        self.scene.wave()
        self.push()
        self.run_with_undo(result="new-layer")
        styled = self.now()
        bpy.ops.ductus.restore_original("EXEC_DEFAULT", True)
        self.assertNotEqual(self.now(), styled)
        bpy.ops.ed.undo()
        self.assertEqual(self.now(), styled)

    def test_again_with_other_values_from_the_undone_state(self):
        self.scene.wave()
        self.push()
        self.run_with_undo(amount=0.5)
        bpy.ops.ed.undo()
        self.run_with_undo(amount=1.0)
        again = self.now()
        self.setUp()
        self.scene.wave()
        restyle(amount=1.0)
        self.assertEqual(self.now(), again)

    def test_refused_run_leaves_no_step(self):
        self.scene.wave()
        self.push()
        before = self.now()
        self.run_with_undo()
        with self.assertRaises(RuntimeError):
            self.run_with_undo(seed=1, apply_to="selected")
        bpy.ops.ed.undo()
        self.assertEqual(self.now(), before)
