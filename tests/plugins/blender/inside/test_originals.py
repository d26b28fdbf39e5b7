# SPDX-License-Identifier: GPL-3.0-or-later
"""Results on a new layer: the original is hidden, running again starts from it, and it can be brought back."""
import bpy
import numpy as np
from helpers import Case, positions, restyle, snapshot, wave

NEW = {"result": "new-layer"}


class NewLayer(Case):
    def setUp(self):
        super().setUp()
        self.lines = [self.scene.wave(z=z) for z in range(3)]
        self.layers = self.scene.data.layers
        self.before = [positions(line) for line in self.lines]

    def result(self):
        return self.layers["Layer Ductus"]

    def lines_of(self, layer, number=1):
        frame = next(frame for frame in layer.frames if frame.frame_number == number)
        return [positions(stroke) for stroke in frame.strokes]

    def test_original_is_hidden_and_untouched(self):
        self.scene.layer.opacity, self.scene.layer.blend_mode = 0.5, "MULTIPLY"
        restyle(**NEW)
        self.assertEqual([layer.info for layer in self.layers], ["Layer", "Layer Ductus"])
        self.assertTrue(self.layers["Layer"].hide)
        self.assertFalse(self.result().hide)
        self.assertEqual(self.layers.active, self.result())
        for line, before in zip(self.lines_of(self.layers["Layer"]), self.before):
            self.assertNear(line, before, 0)
        for stroke, before in zip(self.result().frames[0].strokes, self.before):
            self.assertMoved(stroke, before)
        self.assertEqual((self.result().opacity, self.result().blend_mode), (0.5, "MULTIPLY"))

    def test_restore(self):
        before = snapshot(self.scene.data)
        restyle(**NEW)
        self.assertEqual(bpy.ops.ductus.restore_original(), {"FINISHED"})
        self.assertEqual(snapshot(self.scene.data), before)
        with self.assertRefused("no original"):
            bpy.ops.ductus.restore_original()

    def test_running_again_starts_from_the_original(self):
        restyle(**NEW)
        once = self.lines_of(self.result())
        for values in (NEW, {}, {"apply_to": "layer"}):
            restyle(hand="eve")
            restyle(**values)
            self.assertEqual(len(self.layers), 2)
            for a, b in zip(self.lines_of(self.result()), once):
                self.assertNear(a, b, 0)

    def test_amount_zero_brings_the_original_lines_back(self):
        restyle(**NEW)
        restyle(amount=0)
        for a, b in zip(self.lines_of(self.result()), self.before):
            self.assertNear(a, b, 0)

    def test_what_the_user_draws_and_deletes_on_the_result_stays_so(self):
        restyle(**NEW)
        strokes = self.result().frames[0].strokes
        strokes.remove(strokes[0])
        self.scene.stroke(wave(z=7), self.result().frames[0])
        restyle(**NEW)
        after = self.lines_of(self.result())
        self.assertEqual(len(after), 3)
        for line, height in zip(after, (1, 2, 7)):
            self.assertAlmostEqual(line[:, 2].mean(), height, delta=0.2)
        # The user's line was worked on from itself: it has moved, and is not the original's.
        self.assertFalse(after[2].shape == wave(z=7).shape and np.allclose(after[2], wave(z=7), atol=1e-6))

    def test_one_selected_line_of_the_result(self):
        restyle(**NEW)
        once = self.lines_of(self.result())
        for k, stroke in enumerate(self.result().frames[0].strokes):
            stroke.select = k == 1
        restyle(apply_to="selected", hand="eve")
        after = self.lines_of(self.result())
        self.assertNear(after[0], once[0], 0)
        self.assertNear(after[2], once[2], 0)
        self.assertFalse(after[1].shape == once[1].shape and np.allclose(after[1], once[1], atol=1e-6))

    def test_frames_and_boil(self):
        frame = self.scene.layer.frames.new(8)
        self.scene.wave(frame, z=9)
        restyle(frames="range", frame_start=1, frame_end=12, seeds="boil", boil_frames=3, variation=1, **NEW)
        self.assertEqual([f.frame_number for f in self.layers["Layer"].frames], [1, 8])
        self.assertEqual([f.frame_number for f in self.result().frames], [1, 4, 7, 8, 10])
        restyle(frames="range", frame_start=1, frame_end=12, seeds="boil", boil_frames=4, variation=1, **NEW)
        self.assertEqual([f.frame_number for f in self.result().frames], [1, 5, 8, 9])
        restyle(frames="range", frame_start=1, frame_end=12, **NEW)
        self.assertEqual([f.frame_number for f in self.result().frames], [1, 8])
        self.assertAlmostEqual(self.lines_of(self.result(), 8)[0][:, 2].mean(), 9, delta=0.2)

    def test_users_key_on_the_result_stays(self):
        restyle(**NEW)
        frame = self.result().frames.new(5)
        self.scene.wave(frame, z=4)
        restyle(frames="range", frame_start=1, frame_end=10, **NEW)
        self.assertEqual([f.frame_number for f in self.result().frames], [1, 5])

    def test_names_that_are_taken_and_renamed_layers(self):
        self.layers.new("Layer Ductus", set_active=False)
        self.layers.active = self.layers["Layer"]
        restyle(apply_to="layer", **NEW)
        self.assertIn("Layer Ductus 2", self.layers)
        self.layers["Layer Ductus 2"].info = "Mine"
        self.layers.active = self.layers["Layer"]
        self.assertEqual(bpy.ops.ductus.restore_original(), {"FINISHED"})
        self.assertFalse(self.layers["Layer"].hide)
        self.assertIn("Mine", self.layers)

    def test_deleted_original(self):
        restyle(**NEW)
        self.layers.remove(self.layers["Layer"])
        self.assertEqual(restyle(), {"FINISHED"})
        with self.assertRefused("no original"):
            bpy.ops.ductus.restore_original()

    def test_record_is_saved_with_the_file(self):
        import os
        path = os.path.join(os.environ["TMPDIR"], "original.blend")
        restyle(**NEW)
        once = self.lines_of(self.result())
        bpy.ops.wm.save_as_mainfile(filepath=path)
        bpy.ops.wm.open_mainfile(filepath=path)
        self.layers = bpy.data.grease_pencils["Lines"].layers
        restyle(**NEW)
        for a, b in zip(self.lines_of(self.result()), once):
            self.assertNear(a, b, 0)

    def test_restore_wants_a_grease_pencil(self):
        bpy.context.view_layer.objects.active = None
        with self.assertRaises(RuntimeError):
            bpy.ops.ductus.restore_original()
