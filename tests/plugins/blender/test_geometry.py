# SPDX-License-Identifier: GPL-3.0-or-later
"""The geometry of the Blender add-on, without Blender."""
import unittest

import numpy as np
from geometry import pens, planes, tracks
from geometry.layout import lay_out
from geometry.lines import Course, Lines, correspondence
from geometry.views import axes_across, axes_from_view

random = np.random.default_rng(1)


def wave(count=60, x=0.0):
    t = np.linspace(0, 1, count)
    return np.stack((x + 100 * t, 0 * t, 20 * np.sin(8 * t)), axis=1)


def stacked(*lines):
    return [len(line) for line in lines], np.concatenate(lines)


class OfLines(unittest.TestCase):
    def test_empty_one_point_and_closed_lines_keep_apart(self):
        lines = Lines([0, 1, 3, 0, 4, 0], [False, False, True, True, False, False])
        self.assertEqual(lines.index.tolist(), [0, 1, 2, 3, 1, 4, 5, 6, 7])
        points = random.normal(size=(8, 2))
        steps = lines.steps(points)
        np.testing.assert_allclose(steps[3], points[1] - points[3])
        np.testing.assert_array_equal(steps[[0, 4, 8]], 0)
        np.testing.assert_allclose(lines.sums(np.ones(9)), [0, 1, 4, 0, 4, 0])

    def test_places_between_points(self):
        counts, points = stacked(np.array([[0, 0], [1, 0], [3, 0.0]]), np.array([[5, 5], [5, 9.0]]))
        course = Course(Lines(counts, [False, False]), points)
        found = course.find(np.array([0, 0, 0, 1, 1]), np.array([0, 0.5, 1, 0.25, 2]))
        np.testing.assert_allclose(course.read(points, found), [[0, 0], [1.5, 0], [3, 0], [5, 6], [5, 9]])

    def test_points_at_places_of_points_are_exact(self):
        counts, points = stacked(*[random.normal(size=(20, 2)) for _ in range(50)])
        course = Course(Lines(counts, [False] * 50), points)
        line = np.repeat(np.arange(50), 20)
        found = course.find_along(line, course.along)
        np.testing.assert_allclose(course.read(points, found), points, atol=1e-9)

    def test_correspondence_of_equal_lines_is_themselves(self):
        counts, points = stacked(wave()[:, [0, 2]], wave(40)[:, [0, 2]] + 500)
        lines = Lines(counts, [False, False])
        course = Course(lines, points)
        along = correspondence(course, points, lines, points)
        np.testing.assert_allclose(along, course.along, atol=0.3)

    def test_correspondence_never_runs_back_and_reaches_the_ends(self):
        old = wave()[:, [0, 2]]
        new = np.repeat(old, 3, axis=0) + random.normal(scale=2, size=(180, 2))
        course = Course(Lines([60], [False]), old)
        along = correspondence(course, old, Lines([180], [False]), new)
        self.assertTrue((np.diff(along) >= 0).all())
        self.assertAlmostEqual(along[0], 0)
        self.assertAlmostEqual(along[-1], course.length[0])

    def test_correspondence_finds_the_place_after_a_detour(self):
        """One half of the new line is much longer than that of the old; corners stay corners."""
        old = np.array([[0, 0], [50, 0], [100, 0.0]])
        t = np.linspace(0, 1, 200)
        new = np.concatenate((np.stack((50 * t, 1.2 * np.sin(60 * t)), 1), np.stack((50 + 50 * t, 0 * t), 1)))
        along = correspondence(Course(Lines([3], [False]), old), old, Lines([400], [False]), new)
        self.assertLess(np.abs(along - new[:, 0]).max(), 8)

    def test_lines_without_length(self):
        points = np.zeros((5, 2))
        lines = Lines([5], [False])
        along = correspondence(Course(lines, points), points, lines, points)
        np.testing.assert_array_equal(along, 0)


class OfPlanes(unittest.TestCase):
    def test_best_fit_of_flat_lines_in_any_position(self):
        for _ in range(30):
            turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
            line = wave() @ turn.T
            lines = Lines([60], [False])
            right, down, flatness = planes.best_fit(lines, line)
            self.assertLess(flatness[0], 1e-6)
            away = np.cross(right[0], down[0])
            self.assertAlmostEqual(abs(away @ turn[:, 1]), 1, 6)
            self.assertGreaterEqual(away @ planes.BEHIND, 0)
            self.assertAlmostEqual(right[0] @ down[0], 0, 9)

    def test_usual_planes_are_seen_as_blender_shows_them(self):
        for turn, (right, down) in (([0, 1, 2], planes.FIXED["front"]), ([1, 0, 2], planes.FIXED["side"]),
                                    ([0, 2, 1], planes.FIXED["top"])):
            found = planes.best_fit(Lines([60], [False]), wave()[:, turn])
            np.testing.assert_allclose(found[0][0], right, atol=1e-6)
            np.testing.assert_allclose(found[1][0], down, atol=1e-6)

    def test_straight_lines_and_dots_face_the_viewer(self):
        counts, points = stacked(np.linspace([0, 0, 0], [9, 0, 0], 10), np.array([[1.0, 2, 3]]), np.zeros((4, 3)))
        right, down, flatness = planes.best_fit(Lines(counts, [False] * 3), points)
        away = np.cross(right, down)
        self.assertTrue((away @ planes.BEHIND > 0.9).all())
        self.assertLess(flatness.max(), 1e-6)

    def test_stretch_undoes_turns_and_keeps_sizes(self):
        turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
        found, size = planes.stretch(turn @ np.diag([2, 3, 4.0]))
        np.testing.assert_allclose(found @ size, turn @ np.diag([2, 3, 4.0]), atol=1e-9)
        np.testing.assert_allclose(size, np.diag([2, 3, 4.0]), atol=1e-9)
        np.testing.assert_allclose(planes.stretch(np.diag([1, 1, 0.0]))[1], np.eye(3))
        np.testing.assert_allclose(planes.stretch(np.full((3, 3), 0.0))[1], np.eye(3))

    def test_views(self):
        front = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])
        right, down = axes_from_view(front, np.eye(3))
        np.testing.assert_allclose((right, down), planes.FIXED["front"], atol=1e-12)
        right, down = axes_across([0, 0, 1], np.eye(3))
        np.testing.assert_allclose((right, down), planes.FIXED["top"], atol=1e-12)


class OfLayouts(unittest.TestCase):
    def round_trip(self, counts, closed, points, method, axes=None):
        layout = lay_out(counts, closed, points, method, axes)
        line = np.repeat(np.arange(len(counts)), counts)
        at = layout.course.find(line, layout.course.shares())
        back = layout.put_back(at, layout.plane - layout.course.read(layout.plane, at))
        np.testing.assert_allclose(back, points, atol=1e-6)
        return layout

    def test_lines_come_back_where_they_were(self):
        t = np.linspace(0, 6, 90)
        helix = np.stack((50 * np.cos(t), 50 * np.sin(t), 20 * t), axis=1)
        circle = np.stack((50 * np.cos(t), 9 * np.sin(3 * t), 50 * np.sin(t)), axis=1)[:-1]
        counts, points = stacked(wave(), np.zeros((0, 3)), helix, np.ones((1, 3)), circle, np.ones((6, 3)))
        closed = [False, False, False, False, True, False]
        axes = np.repeat(np.array(planes.FIXED["front"])[None], 6, axis=0)
        for method in ("auto", "surface", "fit", "plane"):
            self.round_trip(counts, closed, points, method, axes)
            self.round_trip([], [], np.zeros((0, 3)), method, axes[:0])

    def test_unrolled_lengths_are_the_lines_own(self):
        t = np.linspace(0, 4, 200)
        line = np.stack((80 * np.cos(t), 80 * np.sin(t), 25 * np.sin(3 * t)), axis=1)
        layout = self.round_trip([200], [False], line, "surface")
        np.testing.assert_allclose(np.linalg.norm(np.diff(layout.plane, axis=0), axis=1),
                                   np.linalg.norm(np.diff(line, axis=0), axis=1), rtol=1e-9)
        np.testing.assert_allclose((layout.along * layout.across).sum(axis=1), 0, atol=1e-9)

    def test_unrolling_a_flat_line_is_its_plane(self):
        turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
        line = wave() @ turn.T
        from geometry.ribbons import unroll
        lines = Lines([60], [False])
        right, down, _ = planes.best_fit(lines, line)
        plane, along, across = unroll(lines, line, right, down)
        np.testing.assert_allclose(plane, np.stack((line @ right[0], line @ down[0]), 1), atol=1e-6)
        np.testing.assert_allclose(along, np.repeat(right, 60, axis=0), atol=1e-6)
        np.testing.assert_allclose(across, np.repeat(down, 60, axis=0), atol=1e-6)

    def test_line_on_a_sphere_is_moved_along_the_sphere(self):
        """The frame that goes with a line on a sphere has the sphere's normal: small steps aside stay on it."""
        t = np.linspace(0, 2.5, 300)
        height = 0.3 * np.sin(5 * t)
        line = 100 * np.stack((np.cos(t) * np.cos(height), np.sin(t) * np.cos(height), np.sin(height)), axis=1)
        layout = lay_out([300], [False], line, "auto")
        normal = np.cross(layout.along, layout.across)
        outward = line / 100
        cosine = np.abs((normal * outward).sum(axis=1))
        self.assertGreater(np.median(cosine), 0.995)
        moved = layout.points + 3 * layout.along + 3 * layout.across
        self.assertLess(np.abs(np.linalg.norm(moved, axis=1) - 100).max(), 0.6)

    def test_many_lines_give_what_each_gives_alone(self):
        lines = [random.normal(size=(n, 3)).cumsum(axis=0) for n in (5, 50, 2, 17, 120)]
        counts, points = stacked(*lines)
        together = lay_out(counts, [False] * 5, points, "auto")
        start = 0
        for line in lines:
            alone = lay_out([len(line)], [False], line, "auto")
            np.testing.assert_allclose(together.plane[start:start + len(line)], alone.plane, atol=1e-6)
            start += len(line)


class OfPens(unittest.TestCase):
    def test_thickness_to_pressure_and_back(self):
        for thickness in (random.uniform(0, 3, 40), np.full(40, 0.7), np.zeros(40), np.r_[0, np.ones(39)]):
            thickness = thickness.astype(np.float32)
            lines = Lines([40], [False])
            found = pens.Thickness(lines, thickness, 0.3, 1.7)
            if found.recorded[0]:
                line = np.zeros(40, dtype=int)
                pressure = found.to_pressure(thickness, line)
                self.assertTrue(((pressure >= 0) & (pressure <= 1)).all())
                np.testing.assert_allclose(found.from_pressure(pressure, line), thickness, atol=1e-6)
            else:
                self.assertEqual(np.ptp(thickness), 0)

    def test_nib_and_breadth(self):
        angle, ratio = pens.nib(np.array([0.5, np.nan, np.nan]), np.array([0, np.nan, 0.8]), np.array([0, np.nan, 0]), 3)
        np.testing.assert_allclose(angle[[0, 2]], [0.5, 0])
        self.assertAlmostEqual(ratio[0], 3)
        self.assertAlmostEqual(ratio[1], 1)
        self.assertGreater(ratio[2], 3)
        self.assertAlmostEqual(pens.breadth(0.0, 4.0, 0.0), 0.5)
        self.assertAlmostEqual(pens.breadth(0.0, 4.0, np.pi / 2), 2)

    def test_directions_of_open_and_closed_lines(self):
        square = np.array([[0, 0], [1, 0], [1, 1], [0, 1.0]])
        found = pens.directions(Lines([4, 4], [False, True]), np.concatenate((square, square)))
        np.testing.assert_allclose(np.degrees(found), [0, 45, 135, 180, -45, 45, 135, -135], atol=1e-9)


class OfTracks(unittest.TestCase):
    def follow(self, drawings, tolerance=0.1, steps=None):
        track, first, found = tracks.Tracks(tolerance), 0, []
        for k, lines in enumerate(drawings):
            counts, points = stacked(*lines)
            layout = lay_out(counts, [False] * len(lines), points, "fit")
            found.append(track.follow(tracks.shapes(layout), np.zeros(len(lines), dtype=int), np.arange(len(lines)), first,
                                      steps[k] if steps else 0))
            first += len(lines)
        return found

    def test_lines_keep_their_names_when_order_changes(self):
        a, b, c = wave(), wave(x=300), wave(x=600)
        (names, _, _), (later, keys, _) = self.follow([[a, b], [c, b + 1, a + 1]])
        self.assertEqual(names.tolist(), [0, 1])
        self.assertEqual(later[1:].tolist(), [1, 0])
        self.assertNotIn(later[0], names)
        self.assertEqual(keys.tolist(), [2, 1, 0])

    def test_turned_line_follows_and_bent_one_does_not(self):
        turn = np.radians(10)
        turned = wave() @ np.array([[np.cos(turn), 0, np.sin(turn)], [0, 1, 0], [-np.sin(turn), 0, np.cos(turn)]])
        _, (_, keys, turns) = self.follow([[wave()], [turned]])
        self.assertEqual(keys.tolist(), [0])
        self.assertAlmostEqual(abs(np.degrees(np.angle(turns[0]))), 10, 1)
        _, (names, keys, _) = self.follow([[wave()], [wave() * [1, 1, 2]]])
        self.assertEqual((names.tolist(), keys.tolist()), ([0], [1]))

    def test_change_is_measured_from_the_key_and_not_from_the_drawing_before(self):
        drawings = [[wave() * [1, 1, 1 + 0.1 * k]] for k in range(12)]
        keys = [int(found[1][0]) for found in self.follow(drawings)]
        self.assertEqual(keys[1], 0)
        self.assertGreater(len(set(keys)), 1)
        for k, key in enumerate(keys):
            self.assertLessEqual(key, k)
            self.assertEqual(keys[key], key)

    def test_another_step_keeps_nothing(self):
        _, (names, keys, _) = self.follow([[wave()], [wave()]], steps=[0, 1])
        self.assertEqual((names.tolist(), keys.tolist()), ([0], [1]))

    def test_empty_drawings_and_empty_lines(self):
        found = self.follow([[wave(), np.zeros((0, 3))], [np.zeros((0, 3)), wave()]])
        self.assertEqual(len(set(found[1][0].tolist())), 2)


if __name__ == "__main__":
    unittest.main()
