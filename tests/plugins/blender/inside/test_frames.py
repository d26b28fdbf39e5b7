# SPDX-License-Identifier: GPL-3.0-or-later
"""Ranges of frames, boiling lines, lines that keep their choices from drawing to drawing, and cancelling."""
import bpy
import numpy as np
from helpers import Case, Scene, positions, read, restyle, snapshot, wave

from ductus_addon import binding, grease_pencil, operators


class Frames(Case):
    def animate(self, numbers=(1, 5, 9, 13), change=lambda line, k: line, scene=None):
        scene = scene or self.scene
        made = []
        for k, number in enumerate(numbers):
            frame = scene.frame if number == 1 else scene.layer.frames.new(number)
            for z in (0.0, 0.6):
                scene.stroke(change(wave(z=z, phase=3 * z), k), frame)
            made.append(number)
        return made

    def drawings(self, scene=None):
        layer = (scene or self.scene).data.layers[0]
        return {frame.frame_number: [positions(stroke) for stroke in frame.strokes] for frame in layer.frames}

    def changed(self, before):
        return [number for number, lines in self.drawings().items()
                if any(a.shape != b.shape or not np.allclose(a, b, atol=1e-6)
                       for a, b in zip(lines, before.get(number, lines)))]


class Ranges(Frames):
    def test_current_drawing_is_the_one_that_is_shown(self):
        self.animate()
        before = self.drawings()
        bpy.context.scene.frame_set(7)
        restyle()
        self.assertEqual(self.changed(before), [5])

    def test_range_scene_preview_and_all(self):
        scene = bpy.context.scene
        for values, wanted in (({"frames": "range", "frame_start": 5, "frame_end": 12}, [5, 9]),
                               ({"frames": "scene"}, [1, 5, 9]), ({"frames": "all"}, [1, 5, 9, 13])):
            with self.subTest(values=values):
                self.setUp()
                bpy.context.scene.frame_start, bpy.context.scene.frame_end = 1, 10
                self.animate()
                before = self.drawings()
                self.assertEqual(restyle(**values), {"FINISHED"})
                self.assertEqual(self.changed(before), wanted)
        self.setUp()
        scene = bpy.context.scene
        scene.use_preview_range, scene.frame_preview_start, scene.frame_preview_end = True, 4, 6
        self.animate()
        before = self.drawings()
        restyle(frames="scene")
        self.assertEqual(self.changed(before), [5])

    def test_bad_ranges_are_refused(self):
        self.animate()
        with self.assertRefused("range", "9", "12"):
            restyle(frames="range", frame_start=12, frame_end=9)
        with self.assertRefused("no lines in these frames"):
            restyle(frames="range", frame_start=100, frame_end=200)
        bpy.context.scene.frame_set(-5)
        with self.assertRefused("no lines in the drawing at this frame"):
            restyle()

    def test_frame_stays_where_it_is_and_keys_stay_sorted(self):
        self.animate()
        bpy.context.scene.frame_set(6)
        restyle(frames="range", frame_start=1, frame_end=20, seeds="boil", boil_frames=3, variation=1)
        numbers = [frame.frame_number for frame in self.scene.data.layers[0].frames]
        self.assertEqual(numbers, sorted(set(numbers)))
        self.assertEqual(bpy.context.scene.frame_current, 6)


class Boil(Frames):
    def test_held_drawing_boils(self):
        self.animate((1,))
        restyle(frames="range", frame_start=1, frame_end=12, seeds="boil", boil_frames=3, variation=1)
        frames = self.scene.data.layers[0].frames
        self.assertEqual([frame.frame_number for frame in frames], [1, 4, 7, 10])
        self.assertEqual([frame.keyframe_type for frame in frames], ["KEYFRAME"] + 3 * ["JITTER"])
        # By chance a step may choose as another did; not all of them.
        lines = self.drawings().values()
        self.assertGreaterEqual(len({one[0].tobytes() + one[1].tobytes() for one in lines}), 3)

    def test_drawing_held_from_before_the_range_stays_before_it(self):
        self.animate((1,))
        before = self.drawings()[1]
        restyle(frames="range", frame_start=5, frame_end=8, seeds="boil", boil_frames=2, variation=1)
        after = self.drawings()
        self.assertEqual(sorted(after), [1, 5, 7])
        self.assertNear(after[1][0], before[0], 0)

    def test_each_drawing_keeps_its_own_content(self):
        self.animate((1, 4), lambda line, k: line + [0, 0, 5 * k])
        restyle(frames="range", frame_start=1, frame_end=8, seeds="boil", boil_frames=2, variation=1)
        heights = {number: lines[0][:, 2].mean() for number, lines in self.drawings().items()}
        self.assertEqual(sorted(heights), [1, 3, 4, 5, 7])
        for number, height in heights.items():
            self.assertAlmostEqual(height, 0 if number < 4 else 5, delta=0.2)

    def test_boil_step_zero_is_still(self):
        self.animate((1,))
        restyle(frames="range", frame_start=1, frame_end=6, seeds="boil", boil_frames=3, variation=1)
        boiled = self.drawings()[1]
        self.setUp()
        self.animate((1,))
        restyle(frames="range", frame_start=1, frame_end=6, variation=1)
        self.assertNear(self.drawings()[1][0], boiled[0], 0)

    def test_boil_that_does_not_move_says_so(self):
        self.animate((1,))
        work = operators._Run(bpy.context, binding.operations()[0], self.group(variation=0))
        work.compute()
        self.assertTrue(work.job.alike)
        work = operators._Run(bpy.context, binding.operations()[0], self.group(variation=1))
        work.compute()
        self.assertFalse(work.job.alike)

    def group(self, **values):
        group = getattr(bpy.context.scene.ductus, operators.settings_name(binding.operations()[0]))
        for name, value in {"frames": "range", "frame_start": 1, "frame_end": 8, "seeds": "boil", **values}.items():
            setattr(group, name, value)
        return group


class Coherence(Frames):
    def offsets(self, line, stroke):
        """How far the result is from the line at even places, for comparisons."""
        def even(points):
            along = np.concatenate(([0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))))
            return np.stack([np.interp(np.linspace(0, along[-1], 200), along, points[:, k]) for k in range(3)], axis=1)
        return even(stroke) - even(line)

    def test_moved_line_keeps_its_result(self):
        self.animate(change=lambda line, k: line + [0.1 * k, 0, 0.05 * k])
        restyle(frames="all", variation=1)
        drawings = self.drawings()
        for k, number in enumerate((1, 5, 9, 13)):
            for a, b in zip(drawings[1], drawings[number]):
                self.assertNear(a + np.float32([0.1 * k, 0, 0.05 * k]), b, 1e-5)

    def test_line_that_bends_slowly_keeps_its_choices_and_follows(self):
        def bend(line, k):
            line = line.copy()
            line[:, 2] += 0.01 * k * np.sin(5 * line[:, 0])
            return line
        self.animate(change=bend)
        restyle(frames="all", variation=1, coherence=0.2)
        drawings, held = self.drawings(), []
        for k, number in enumerate((1, 5, 9, 13)):
            line = bend(wave(), k)
            held.append(self.offsets(line, drawings[number][0]))
        for other in held[1:]:
            self.assertLess(np.abs(other - held[0]).max(), 0.02)
        self.setUp()
        self.animate(change=bend)
        restyle(frames="all", variation=1, coherence=0)
        drawings = self.drawings()
        apart = max(np.abs(self.offsets(bend(wave(), k), drawings[n][0]) - held[0]).max()
                    for k, n in enumerate((1, 5, 9, 13)))
        self.assertGreater(apart, 1e-4)

    def test_line_that_changes_much_is_done_anew(self):
        self.animate((1, 5), lambda line, k: line if k == 0 else line * [1, 1, 4])
        restyle(frames="all")
        together = self.drawings()[5]
        self.assertLess(np.abs(np.ptp(together[0][:, 2]) - 4 * np.ptp(wave()[:, 2])), 0.3)

    def test_line_is_known_again_when_another_is_drawn_before_it(self):
        first, second = wave(), wave(z=2, phase=1)
        self.scene.stroke(first)
        later = self.scene.layer.frames.new(5)
        self.scene.stroke(second, later)
        self.scene.stroke(first + [0.02, 0, 0], later)
        restyle(frames="all", variation=1)
        drawings = self.drawings()
        self.assertNear(drawings[1][0] + np.float32([0.02, 0, 0]), drawings[5][1], 1e-5)

    def test_one_by_one_gives_the_same_choices_as_alone(self):
        """Names do not depend on what else is worked on: still drawings come out alike."""
        self.animate((1, 5))
        restyle(frames="all", variation=1, coherence=0)
        drawings = self.drawings()
        self.assertNear(drawings[1][0], drawings[5][0], 0)

    def test_followers_keep_the_pressure_they_were_drawn_with(self):
        for k, number in enumerate((1, 5)):
            frame = self.scene.frame if number == 1 else self.scene.layer.frames.new(number)
            self.scene.wave(frame, pressure=np.linspace(0.2, 0.6 + 0.3 * k, 40))
        restyle(frames="all", mode="pose", channels="missing")
        for k, frame in enumerate(self.scene.layer.frames):
            thickness = read(frame.strokes[0], "pressure")
            self.assertNear([thickness[0], thickness[-1]], [0.2, 0.6 + 0.3 * k], 1e-4)

    def test_boiled_steps_hold_what_they_chose(self):
        self.animate((1, 2, 3, 4), lambda line, k: line + [0.01 * k, 0, 0])
        restyle(frames="range", frame_start=1, frame_end=4, seeds="boil", boil_frames=2, variation=2)
        d = self.drawings()
        self.assertNear(d[1][0] + np.float32([0.01, 0, 0]), d[2][0], 1e-5)
        self.assertNear(d[3][0] + np.float32([0.01, 0, 0]), d[4][0], 1e-5)
        self.assertTrue(d[2][0].shape != d[3][0].shape or np.abs(d[2][0] - d[3][0]).max() > 0.015)


class Cancelling(Frames):
    def test_cancelled_run_changes_nothing(self):
        self.animate()
        before = snapshot(self.scene.data)
        group = getattr(bpy.context.scene.ductus, operators.settings_name(binding.operations()[0]))
        group.frames = "all"
        for stop_at in (0.0, 0.3, 0.9):
            run = operators._Run(bpy.context, binding.operations()[0], group)
            heard = []

            def tell(fraction):
                heard.append(fraction)
                run.stop = fraction >= stop_at
            with self.assertRaises(binding.ductus().Cancelled):
                run.compute(tell)
            self.assertTrue(heard)
            self.assertEqual(snapshot(self.scene.data), before)

    def test_failure_while_writing_changes_nothing(self):
        host = grease_pencil.generation()
        real, calls = host._set_points, []

        def broken(*arguments):
            calls.append(1)
            if len(calls) == 3:
                raise RuntimeError("on purpose")
            real(*arguments)
        for values in ({}, {"result": "new-layer"}, {"seeds": "boil", "frames": "range", "frame_end": 20}):
            with self.subTest(values=values):
                self.scene = Scene()
                self.animate()
                calls.clear()
                host._set_points = broken
                try:
                    with self.assertRefused("changed nothing", "on purpose"):
                        restyle(**{"frames": "all", **values})
                finally:
                    host._set_points = real

    def test_failure_in_a_second_object_changes_neither(self):
        host = grease_pencil.generation()
        real = host._set_points

        def broken(ob, *arguments):
            if ob.name == "Second":
                raise RuntimeError("on purpose")
            real(ob, *arguments)
        self.animate()
        second = Scene("Second", clear=False)
        second.wave()
        bpy.ops.object.select_all(action="SELECT")
        host._set_points = broken
        try:
            for result in ("in-place", "new-layer"):
                with self.assertRefused("on purpose"):
                    restyle(apply_to="objects", result=result)
        finally:
            host._set_points = real
        self.assertEqual(restyle(apply_to="objects"), {"FINISHED"})
