# SPDX-License-Identifier: GPL-3.0-or-later
"""What happens to single lines: planes, pen, odd ones."""
import bpy
import numpy as np
from helpers import Case, helix, look_from, positions, read, restyle, turned, wave


class InAPlane(Case):
    def test_line_moves_within_its_plane_and_stays_near(self):
        stroke = self.scene.wave()
        before = positions(stroke)
        self.assertEqual(restyle(), {"FINISHED"})
        self.assertMoved(stroke, before)
        self.assertNear(positions(stroke)[:, 1], 0 * positions(stroke)[:, 1], 1e-5)
        self.assertNearLine(stroke, before, 0.07)

    def test_every_plane(self):
        line = wave() @ np.array([[1, 0, 0], [0, 1, 0], [0, 0.3, 1.0]])
        for plane in ("auto", "drawing", "view", "front", "side", "top", "fit", "surface"):
            with self.subTest(plane=plane):
                stroke = self.scene.stroke(line)
                self.assertEqual(restyle(plane=plane), {"FINISHED"})
                self.assertTrue(np.isfinite(positions(stroke)).all())
                self.assertNearLine(stroke, line, 0.12)
                self.scene.frame.strokes.remove(stroke)

    def test_planes_of_the_viewports_header(self):
        settings = bpy.context.scene.tool_settings.gpencil_sculpt
        look_from(turned(x=90))
        for axis, out_of_plane in (("AXIS_Y", 1), ("AXIS_X", 0), ("AXIS_Z", 2), ("CURSOR", 2), ("VIEW", 1)):
            with self.subTest(axis=axis):
                settings.lock_axis = axis
                line = np.roll(wave(), out_of_plane - 1, axis=1)
                stroke = self.scene.stroke(line)
                restyle(plane="drawing")
                self.assertMoved(stroke, line.astype(np.float32))
                self.assertNear(positions(stroke)[:, out_of_plane], np.zeros(len(stroke.points)), 1e-5)
                self.scene.frame.strokes.remove(stroke)

    def test_depth_is_kept(self):
        line = wave()
        line[:, 1] = 0.5 * line[:, 0] ** 2
        stroke = self.scene.stroke(line)
        restyle(plane="front")
        after = positions(stroke)
        self.assertNear(after[:, 1], 0.5 * after[:, 0] ** 2, 0.03)

    def test_lines_on_tables_and_walls_stay_there(self):
        for turn in ([0, 2, 1], [1, 0, 2]):
            stroke = self.scene.stroke(wave()[:, turn])
            flat = turn.index(1)
            restyle()
            self.assertNear(positions(stroke)[:, flat], np.zeros(len(stroke.points)), 1e-5)

    def test_equal_lines_in_different_planes_get_the_same_shape(self):
        front, top = self.scene.wave(), self.scene.stroke(wave()[:, [0, 2, 1]])
        restyle()
        self.assertNear(positions(front)[:, [0, 2, 1]], positions(top), 1e-4)


class OnASurface(Case):
    def test_line_around_a_cylinder_stays_on_it(self):
        stroke = self.scene.stroke(helix())
        restyle(plane="surface")
        radius = np.hypot(*positions(stroke)[:, :2].T)
        self.assertGreater(radius.min(), 0.93)
        self.assertLess(radius.max(), 1.07)
        self.assertNearLine(stroke, helix(), 0.06)

    def test_wavy_line_on_a_sphere_stays_on_it(self):
        t = np.linspace(0, 2.5, 120)
        height = 0.25 * np.sin(6 * t)
        line = np.stack((np.cos(t) * np.cos(height), np.sin(t) * np.cos(height), np.sin(height)), axis=1)
        stroke = self.scene.stroke(line)
        before = positions(stroke)
        restyle(plane="auto")
        self.assertMoved(stroke, before)
        radius = np.linalg.norm(positions(stroke), axis=1)
        self.assertLess(np.abs(radius - 1).max(), 0.02)


class Pen(Case):
    def test_pressure_becomes_thickness_around_the_lines_own(self):
        stroke = self.scene.wave(pressure=2.0)
        restyle(thinnest=0.5, thickest=1.5)
        thickness = read(stroke, "pressure")
        self.assertGreater(np.ptp(thickness), 0.1)
        self.assertGreaterEqual(thickness.min(), 1.0)
        self.assertLessEqual(thickness.max(), 3.0)

    def test_even_range_leaves_the_thickness(self):
        stroke = self.scene.wave(pressure=0.7)
        restyle(thinnest=1, thickest=1)
        self.assertNear(read(stroke, "pressure"), np.full(len(stroke.points), 0.7))

    def test_strength_follows_pressure_and_zero_leaves_it(self):
        first, second = self.scene.wave(strength=0.8), self.scene.wave(z=1, strength=0.8)
        restyle(strength=0)
        self.assertNear(read(first, "strength"), np.full(len(first.points), 0.8))
        restyle(strength=1, apply_to="object")
        self.assertLess(read(second, "strength").min(), 0.7)

    def test_nib_angle_becomes_rotation(self):
        stroke, other = self.scene.wave(), self.scene.wave(z=1, uv_rotation=0.25)
        restyle()
        rotation = read(stroke, "uv_rotation")
        self.assertGreater(np.abs(rotation).max(), 0.01)
        self.assertLessEqual(np.abs(rotation).max(), np.pi / 2 + 1e-5)
        self.scene.frame.strokes.remove(stroke)
        restyle(rotation=False, mode="trajectory")
        self.assertEqual(restyle(rotation=False), {"FINISHED"})
        self.assertTrue(np.isfinite(read(other, "uv_rotation")).all())

    def test_rotation_off_keeps_the_points_rotation(self):
        stroke = self.scene.wave(uv_rotation=0.25)
        restyle(rotation=False)
        self.assertNear(read(stroke, "uv_rotation"), np.full(len(stroke.points), 0.25))

    def test_rotation_is_measured_from_the_path_where_the_material_says_so(self):
        path = self.scene.add_material("Path").grease_pencil
        path.mode, path.alignment_mode = "BOX", "PATH"
        fixed = self.scene.add_material("Object").grease_pencil
        fixed.mode, fixed.alignment_mode = "BOX", "OBJECT"
        strokes = [self.scene.wave(), self.scene.wave()]
        for k, stroke in enumerate(strokes):
            stroke.material_index = k + 1
        restyle()
        along, absolute = (read(stroke, "uv_rotation") for stroke in strokes)
        steps = np.diff(positions(strokes[0]), axis=0)
        direction = np.arctan2(-steps[:, 2], steps[:, 0])
        apart = along[:-1] + direction - absolute[:-1]
        apart -= np.pi * np.round(apart / np.pi)
        self.assertLess(np.median(np.abs(apart)), 0.1)

    def test_broad_nib_makes_width_follow_direction(self):
        t = np.linspace(0, 1, 30)
        across = [self.scene.stroke(np.stack((t, 0 * t, 0 * t), 1)), self.scene.stroke(np.stack((0 * t, 0 * t, t), 1))]
        restyle(nib_aspect=6, mode="pose")
        wide = [read(stroke, "pressure").mean() for stroke in across]
        self.assertGreater(abs(wide[0] / wide[1] - 1), 0.3)

    def test_recorded_pressure_is_kept_where_the_line_stays(self):
        pressure = 0.2 + 0.6 * np.linspace(0, 1, 40) ** 2
        stroke = self.scene.wave(pressure=pressure, strength=0.9)
        restyle(mode="pose", channels="auto")
        self.assertNear(read(stroke, "pressure")[[0, -1]], pressure[[0, -1]], 1e-4)
        self.assertNear(read(stroke, "strength"), np.full(len(stroke.points), 0.9))

    def test_pose_keeps_the_line_in_place(self):
        stroke = self.scene.wave()
        line = positions(stroke)
        restyle(mode="pose")
        self.assertNearLine(stroke, line, 2e-3)
        self.assertGreater(np.ptp(read(stroke, "pressure")), 0.05)


class Attributes(Case):
    def test_colours_and_material_go_along(self):
        colors = np.zeros((40, 4))
        colors[:, 0], colors[:, 3] = np.linspace(0, 1, 40), 1
        self.scene.add_material("Second")
        stroke = self.scene.wave(vertex_color=colors)
        stroke.material_index = 1
        restyle()
        after = read(stroke, "vertex_color", 4)
        self.assertEqual(stroke.material_index, 1)
        self.assertNear(after[[0, -1]], colors[[0, -1]], 1e-5)
        self.assertTrue((np.diff(after[:, 0]) >= -1e-6).all())
        self.assertNear(after[:, 0], positions(stroke)[:, 0], 0.08)

    def test_weights_go_along(self):
        self.scene.ob.vertex_groups.new(name="Bone")
        stroke, other = self.scene.wave(), self.scene.wave(z=1)
        for i in range(40):
            stroke.points.weight_set(vertex_group_index=0, point_index=i, weight=i / 39)
        restyle()
        weights = [stroke.points.weight_get(vertex_group_index=0, point_index=i) for i in range(len(stroke.points))]
        self.assertAlmostEqual(weights[0], 0, 5)
        self.assertAlmostEqual(weights[-1], 1, 5)
        self.assertNear(weights, positions(stroke)[:, 0], 0.08)
        self.assertEqual(other.points.weight_get(vertex_group_index=0, point_index=0), -1)


class Rendered(Case):
    def frame(self):
        """The darkness of a rendered frame, row by row."""
        import os
        path = os.path.join(os.environ["TMPDIR"], "frame.png")
        bpy.context.scene.render.filepath = path
        bpy.ops.render.render(write_still=True)
        image = bpy.data.images.load(path)
        pixels = 1 - np.array(image.pixels[:]).reshape(90, 160, 4)[:, :, 0]
        bpy.data.images.remove(image)
        return pixels

    def test_rendered_frame_shows_the_new_line(self):
        scene = bpy.context.scene
        camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
        scene.collection.objects.link(camera)
        camera.location, camera.rotation_euler = (0.5, -5, 0), turned(x=90)
        camera.data.type, camera.data.ortho_scale = "ORTHO", 1.3
        scene.camera, scene.world = camera, bpy.data.worlds.new("White")
        scene.world.color = (1, 1, 1)
        scene.display.shading.background_type = "WORLD"
        scene.render.engine = "BLENDER_WORKBENCH"
        scene.render.resolution_x, scene.render.resolution_y = 160, 90
        self.scene.layer.use_lights = False
        self.scene.wave(width=40)
        before = self.frame()
        restyle(thickest=3, thinnest=0)
        after = self.frame()
        for picture in (before, after):
            self.assertGreater((picture > 0.5).sum(), 200)
        self.assertGreater(np.abs(after - before).mean(), 0.005)
        # The width of an even line hardly varies along it, that of a drawn one does.
        widths = [(picture[:, 20:140] > 0.5).sum(axis=0) for picture in (before, after)]
        self.assertGreater(len(set(widths[1].tolist())), 3)


class OddOnes(Case):
    def test_empty_and_one_point_lines(self):
        empty, dot = self.scene.stroke([]), self.scene.stroke([[1, 2, 3]])
        wave_ = self.scene.wave()
        before = positions(wave_)
        self.assertEqual(restyle(), {"FINISHED"})
        self.assertEqual(len(empty.points), 0)
        self.assertNear(positions(dot), [[1, 2, 3]], 1e-6)
        self.assertMoved(wave_, before)

    def test_only_empty_and_one_point_lines(self):
        self.scene.stroke([])
        self.scene.stroke([[1, 2, 3]])
        self.assertEqual(restyle(), {"FINISHED"})
        self.assertEqual(restyle(plane="surface"), {"FINISHED"})

    def test_points_in_one_place_two_points_and_straight_lines(self):
        for line in ([[1, 1, 1]] * 5, [[0, 0, 0], [1, 0, 0]], [[0, 0, 0], [0, 1, 0]],
                     np.linspace([0, 0, 0], [1, 2, 3], 30)):
            stroke = self.scene.stroke(line)
            for plane in ("auto", "front", "side", "surface"):
                self.assertEqual(restyle(plane=plane), {"FINISHED"})
                self.assertTrue(np.isfinite(positions(stroke)).all())
            self.scene.frame.strokes.remove(stroke)

    def test_a_line_seen_end_on_keeps_its_depth(self):
        stroke = self.scene.stroke(np.linspace([0, 0, 0], [0, 1, 0], 20))
        restyle(plane="front")
        self.assertNear(positions(stroke)[[0, -1], 1], [0, 1], 1e-3)

    def test_closed_lines_stay_closed(self):
        a = np.linspace(0, 2 * np.pi, 50)[:-1]
        circle = np.stack((np.cos(a), 0 * a, np.sin(a)), 1)
        stroke = self.scene.stroke(circle, closed=True)
        before = positions(stroke)
        restyle()
        after = positions(stroke)
        self.assertTrue(stroke.use_cyclic)
        self.assertMoved(stroke, before)
        steps = np.linalg.norm(np.diff(after, axis=0, append=after[:1]), axis=1)
        self.assertLess(steps[-1], 5 * np.median(steps))
        self.assertNear(after[:, 1], 0 * after[:, 1], 1e-5)

    def test_bent_closed_line_stays_closed(self):
        a = np.linspace(0, 2 * np.pi, 80)[:-1]
        stroke = self.scene.stroke(np.stack((np.cos(a), 0.3 * np.cos(2 * a), np.sin(a)), 1), closed=True)
        restyle()
        after = positions(stroke)
        steps = np.linalg.norm(np.diff(after, axis=0, append=after[:1]), axis=1)
        self.assertLess(steps[-1], 5 * np.median(steps))
        self.assertGreater(np.ptp(after[:, 1]), 0.5)

    def test_long_lines(self):
        t = np.linspace(0, 1, 3000)
        stroke = self.scene.stroke(np.stack((8 * t, 0 * t, np.sin(40 * t)), 1))
        self.assertEqual(restyle(), {"FINISHED"})
        self.assertGreaterEqual(len(stroke.points), 3000)

    def test_not_finite_points_are_refused(self):
        stroke = self.scene.wave()
        stroke.points[3].co = (float("nan"), 0, 0)
        with self.assertRaises(RuntimeError) as caught:
            restyle()
        self.assertIn("Layer", str(caught.exception))
        self.assertEqual(len(stroke.points), 40)

    def test_amount_zero_changes_nothing(self):
        from helpers import snapshot
        self.scene.wave(pressure=np.linspace(0.1, 1.7, 40), uv_rotation=0.3)
        self.scene.stroke(helix())
        before = snapshot(self.scene.data)
        self.assertEqual(restyle(amount=0), {"FINISHED"})
        self.assertEqual(snapshot(self.scene.data), before)

    def test_same_input_same_bytes(self):
        from helpers import snapshot
        results = []
        for _ in range(2):
            self.setUp()
            for k in range(5):
                self.scene.wave(z=k, phase=k)
            self.scene.stroke(helix())
            restyle(variation=1, seed=4)
            results.append(snapshot(self.scene.data))
        self.assertEqual(results[0], results[1])

    def test_work_done_in_pieces_gives_the_same_bytes(self):
        from ductus_addon import job
        from helpers import snapshot
        whole, results = job.CHUNK, []
        try:
            for job.CHUNK in (whole, 300):
                self.setUp()
                for k in range(6):
                    self.scene.wave(z=k, phase=k)
                self.scene.stroke(helix())
                restyle()
                results.append(snapshot(self.scene.data))
        finally:
            job.CHUNK = whole
        self.assertEqual(results[0], results[1])
