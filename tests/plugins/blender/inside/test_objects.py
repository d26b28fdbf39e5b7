# SPDX-License-Identifier: GPL-3.0-or-later
"""Which lines are worked on, and objects and layers that are moved, turned, scaled and parented."""
import bpy
import mathutils
import numpy as np
from helpers import Case, Scene, positions, read, restyle, turned, wave

from ductus_addon import grease_pencil


def world_points(ob, layer, stroke):
    """Where a line's points are in the world, as the add-on sees it."""
    host = grease_pencil.generation()
    matrix = np.array(next(one for one in host.layers(ob) if one.name == layer).matrix)
    points = positions(stroke)
    return points @ matrix[:3, :3].T + matrix[:3, 3]


class Lines(Case):
    def moved(self, lines, **values):
        before = [positions(line) for line in lines]
        self.assertEqual(restyle(**values), {"FINISHED"})
        return [positions(line).shape != old.shape or not np.allclose(positions(line), old, atol=1e-6)
                for line, old in zip(lines, before)]

    def select(self, *strokes):
        for layer in self.scene.data.layers:
            for frame in layer.frames:
                for stroke in frame.strokes:
                    stroke.select = stroke in strokes

    def test_selected_lines_alone(self):
        lines = [self.scene.wave(z=z) for z in range(3)]
        self.select(lines[1])
        self.assertEqual(self.moved(lines, apply_to="selected"), [False, True, False])
        self.assertTrue(lines[1].select and all(point.select for point in lines[1].points))
        self.assertFalse(lines[0].select)

    def test_part_of_a_line_selected(self):
        line = self.scene.wave()
        bpy.ops.object.mode_set(mode="EDIT_GPENCIL")
        line.select = False
        for i in range(10, 20):
            line.points[i].select = True
        self.assertTrue(line.select)
        self.assertEqual(self.moved([line], apply_to="selected"), [True])
        flags = [point.select for point in line.points]
        self.assertTrue(line.select and any(flags) and not all(flags))
        bpy.ops.object.mode_set(mode="OBJECT")

    def test_selection_counts_by_itself_in_edit_mode_alone(self):
        lines = [self.scene.wave(z=z) for z in range(2)]
        self.select(lines[0])
        bpy.ops.object.mode_set(mode="EDIT_GPENCIL")
        self.select(lines[0])
        self.assertEqual(self.moved(lines), [True, False])
        bpy.ops.object.mode_set(mode="OBJECT")
        self.assertEqual(self.moved(lines, seed=3, variation=1), [True, True])

    def test_edit_mode_without_selection_means_all(self):
        lines = [self.scene.wave(z=z) for z in range(2)]
        bpy.ops.object.mode_set(mode="EDIT_GPENCIL")
        self.select()
        self.assertEqual(self.moved(lines), [True, True])
        bpy.ops.object.mode_set(mode="OBJECT")

    def test_layers(self):
        other = self.scene.data.layers.new("Other", set_active=False)
        lines = [self.scene.wave(), self.scene.wave(other.frames.new(1))]
        self.scene.data.layers.active = self.scene.data.layers["Layer"]
        self.assertEqual(self.moved(lines, apply_to="layer"), [True, False])
        self.scene.data.layers.active = other
        self.assertEqual(self.moved(lines, apply_to="layer"), [False, True])
        self.assertEqual(self.moved(lines, apply_to="object", variation=1), [True, True])

    def test_locked_and_hidden_layers_and_materials_are_left_alone(self):
        locked, hidden = (self.scene.data.layers.new(name, set_active=False) for name in ("Locked", "Hidden"))
        lines = [self.scene.wave(), self.scene.wave(locked.frames.new(1)), self.scene.wave(hidden.frames.new(1)),
                 self.scene.wave(), self.scene.wave()]
        locked.lock, hidden.hide = True, True
        for number, name in ((3, "lock"), (4, "hide")):
            material = self.scene.add_material(name)
            lines[number].material_index = number - 2
            setattr(material.grease_pencil, name, True)
        self.assertEqual(self.moved(lines), [True, False, False, False, False])
        self.scene.layer.lock_material = False
        self.assertEqual(self.moved(lines, variation=1), [True, False, False, True, False])

    def test_nothing_to_do_is_a_sentence(self):
        with self.assertRefused("'Lines'", "frame"):
            restyle()
        self.scene.wave()
        with self.assertRefused("selected"):
            self.select()
            restyle(apply_to="selected")
        self.scene.layer.lock = True
        with self.assertRefused("'Layer'", "locked"):
            restyle()
        self.scene.layer.lock, self.scene.layer.hide = False, True
        with self.assertRefused("'Layer'", "hidden"):
            restyle(apply_to="layer")
        self.scene.data.layers.remove(self.scene.layer)
        with self.assertRefused("'Lines'"):
            restyle(apply_to="layer")

    def test_wrong_objects_are_refused(self):
        self.scene.wave()
        mesh = bpy.data.objects.new("Mesh", bpy.data.meshes.new("Mesh"))
        bpy.context.collection.objects.link(mesh)
        bpy.context.view_layer.objects.active = mesh
        with self.assertRefused("Grease Pencil"):
            restyle()
        bpy.context.view_layer.objects.active = None
        with self.assertRefused("Grease Pencil"):
            restyle()
        bpy.ops.object.select_all(action="DESELECT")
        with self.assertRefused("selected"):
            restyle(apply_to="objects")

    def test_selected_objects_and_shared_data(self):
        second = Scene("Second", clear=False)
        twin = bpy.data.objects.new("Twin", second.data)
        bpy.context.collection.objects.link(twin)
        twin.select_set(True)
        alone = Scene("Alone", clear=False)
        lines = [self.scene.wave(), second.wave(), alone.wave()]
        alone.ob.select_set(False)
        self.assertEqual(self.moved(lines, apply_to="objects"), [True, True, False])
        self.assertEqual(self.moved(lines), [False, False, True])

    def test_curve_editing_is_refused(self):
        self.scene.wave()
        self.scene.data.use_curve_edit = True
        with self.assertRefused("curves"):
            restyle()
        self.scene.data.use_curve_edit = False
        self.assertEqual(restyle(), {"FINISHED"})

    def test_multiframe_editing(self):
        frames = [self.scene.frame, self.scene.layer.frames.new(5), self.scene.layer.frames.new(9)]
        lines = [self.scene.wave(frame) for frame in self.scene.layer.frames]
        bpy.ops.object.mode_set(mode="EDIT_GPENCIL")
        self.scene.data.use_multiedit = True
        for frame, chosen in zip(self.scene.layer.frames, (True, False, True)):
            frame.select = chosen
        self.select(*lines)
        self.assertEqual(len(frames), 3)
        self.assertEqual(self.moved(lines), [True, False, True])
        self.scene.data.use_multiedit = False
        bpy.ops.object.mode_set(mode="OBJECT")

    def test_every_mode_of_the_object(self):
        for mode in ("PAINT_GPENCIL", "EDIT_GPENCIL", "SCULPT_GPENCIL", "VERTEX_GPENCIL", "WEIGHT_GPENCIL", "OBJECT"):
            with self.subTest(mode=mode):
                line = self.scene.wave()
                bpy.ops.object.mode_set(mode=mode)
                self.assertTrue(self.moved([line], variation=1, seed=5)[0])
                bpy.ops.object.mode_set(mode="OBJECT")


class Transforms(Case):
    def result(self, change, **values):
        """The lines' points in the world after a run with an object that `change` has changed."""
        scene = Scene()
        scene.wave()
        scene.wave(z=0.5, phase=2)
        change(scene)
        bpy.context.view_layer.update()
        self.assertEqual(restyle(**values), {"FINISHED"})
        return [world_points(scene.ob, "Layer", stroke) for stroke in scene.frame.strokes], scene

    def test_moved_turned_and_evenly_scaled_objects_get_the_same_lines(self):
        def change(scene):
            scene.ob.location, scene.ob.rotation_euler = (3, -2, 5), turned(20, 40, 60)
            scene.ob.scale = (4, 4, 4)
        plain, _ = self.result(lambda scene: None)
        changed, scene = self.result(change)
        back = scene.ob.matrix_world.inverted()
        for a, b in zip(plain, changed):
            b = np.array([back @ mathutils.Vector(point) for point in b])
            self.assertNear(a, b, 2e-4)

    def test_uneven_scale_is_seen_as_it_looks(self):
        """A line on a squeezed object becomes what the same line, drawn squeezed, becomes."""
        def squeeze(scene):
            scene.ob.scale = (1, 1, 0.4)
        def drawn(scene):
            for stroke in scene.frame.strokes:
                points = positions(stroke)
                points[:, 2] *= 0.4
                stroke.points.foreach_set("co", points.ravel())
        # The pixel follows the object's mean scale, which with scale "auto" makes no difference.
        a, b = self.result(squeeze)[0], self.result(drawn)[0]
        for one, other in zip(a, b):
            self.assertNear(one, other, 2e-3)

    def test_flattened_mirrored_and_shrunken_objects(self):
        for scale in ((1, 1, 0), (0, 0, 0), (-1, 1, 1), (1e-4, 1e-4, 1e-4), (1e5, 1e5, 1e5)):
            with self.subTest(scale=scale):
                points, scene = self.result(lambda scene, scale=scale: setattr(scene.ob, "scale", scale))
                for stroke in scene.frame.strokes:
                    self.assertTrue(np.isfinite(positions(stroke)).all())
                    self.assertNear(positions(stroke)[:, 1], np.zeros(len(stroke.points)), 1e-5)
                    self.assertNearLine(stroke, wave(z=positions(stroke)[:, 2].min() > 0.2 and 0.5 or 0,
                                                     phase=positions(stroke)[:, 2].min() > 0.2 and 2 or 0), 0.1)

    def test_layer_matrices_are_blenders_own(self):
        """Blender's own Snap Cursor to Selected says where a layer's points are in the world."""
        scene = self.scene
        arm = bpy.data.armatures.new("Arm")
        rig = bpy.data.objects.new("Rig", arm)
        bpy.context.collection.objects.link(rig)
        bpy.context.view_layer.objects.active = rig
        bpy.ops.object.mode_set(mode="EDIT")
        bone = arm.edit_bones.new("Bone")
        bone.head, bone.tail = (0.5, 0, 0), (0.5, 0.3, 1)
        bpy.ops.object.mode_set(mode="OBJECT")
        rig.location, rig.rotation_euler = (1, 2, 3), turned(10, 20, 30)
        rig.pose.bones["Bone"].rotation_mode = "XYZ"
        rig.pose.bones["Bone"].rotation_euler = turned(15, 0, 40)
        bpy.context.view_layer.objects.active = scene.ob
        scene.ob.location, scene.ob.rotation_euler, scene.ob.scale = (1, -1, 0.5), turned(30, 0, 45), (2, 1, 1.5)
        scene.layer.location, scene.layer.rotation, scene.layer.scale = (0.1, 0.2, 0.3), turned(5, 6, 7), (1.2, 0.9, 1.1)
        stroke = scene.stroke([[0.3, 0.4, 0.5]])
        for parent, kind, name in ((None, None, ""), (rig, "OBJECT", ""), (rig, "BONE", "Bone")):
            with self.subTest(parent=kind):
                if parent is not None:
                    scene.layer.parent, scene.layer.parent_type = parent, kind
                    if name:
                        scene.layer.parent_bone = name
                bpy.context.view_layer.update()
                bpy.ops.object.mode_set(mode="EDIT_GPENCIL")
                stroke.select = True
                area = next(area for area in bpy.context.window.screen.areas if area.type == "VIEW_3D")
                with bpy.context.temp_override(area=area, region=area.regions[-1]):
                    bpy.ops.gpencil.snap_cursor_to_selected()
                bpy.ops.object.mode_set(mode="OBJECT")
                self.assertNear(world_points(scene.ob, "Layer", stroke)[0], bpy.context.scene.cursor.location, 1e-4)

    def test_parented_layers_are_worked_on_as_they_look(self):
        def drawn(scene):
            for stroke in scene.frame.strokes:
                points = positions(stroke)
                points[:, 2] *= 0.4
                stroke.points.foreach_set("co", points.ravel())
        def parent(scene):
            empty = bpy.data.objects.new("Empty", None)
            bpy.context.collection.objects.link(empty)
            scene.layer.parent = empty
            bpy.context.view_layer.update()
            empty.scale = (1, 1, 0.4)
        for one, other in zip(self.result(parent)[0], self.result(drawn)[0]):
            self.assertNear(one, other, 2e-3)

    def test_line_width_is_the_cores_width_whatever_the_pixel_factor(self):
        for factor in (0.5, 1, 4):
            scene = Scene()
            line = scene.wave(width=30)
            scene.data.pixel_factor = factor
            restyle(scale_auto=True)
            self.assertGreater(np.ptp(read(line, "pressure")), 0.05)
