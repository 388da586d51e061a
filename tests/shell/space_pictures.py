"""Unit tests of the pictures of a run in space:  space_pictures.py FOLDER  makes the files there."""
import base64
import contextlib
import io
import json
import re
import sys
import unittest
from pathlib import Path
from types import SimpleNamespace

TOP = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(TOP / "cases"), str(TOP / "tests/support")]
import numpy as np
from PIL import Image
from picture import faults
from plotting import case, drives
from plotting.border import new_figure
from plotting.inputs import InputError
from plotting.run import Run
from plotting.space import contact_view, edge_labels, files, maps, scene
from plotting.space.arrows import covered, draw_arrows, projected
from plotting.space.run import SpaceRun
from space_run import DEPTH, FRAMES, write_run

FOLDER = Path(sys.argv.pop(1))
for kind in ("P1", "P2"):
    write_run(FOLDER / kind, kind == "P2")


class Files(unittest.TestCase):
    def test_outer_faces_of_a_cube(self):
        """12 triangles with 18 edges, each in two halves on P2; their area in the deformed state."""
        for kind, nodes in (("P1", 3), ("P2", 6)):
            body = files.read_body(str(FOLDER / kind / "final.vtu"), 1.0)
            self.assertEqual(body.faces.shape, (12, nodes))
            self.assertEqual(len(files.edges_of(body.faces)), 18 * nodes // 3)
            a, b, c = (body.points[column] for column in files.triangles_of(body.faces).T)
            area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()
            self.assertAlmostEqual(area, 2 + 4 * (1 - DEPTH), delta=1e-12)

    def test_broken_file(self):
        path = FOLDER / "broken.vtu"
        path.write_text((FOLDER / "P1/final.vtu").read_text()[:900])
        with self.assertRaisesRegex(InputError, "broken.vtu: not a whole file"):
            files.read_body(str(path), 1.0)


class Symmetry(unittest.TestCase):
    """The cube y = 0 to 1 with its image: what is whole, what is cut open for a viewer at -y."""

    def setUp(self):
        self.run_ = SpaceRun(str(FOLDER / "P2"))
        self.run_.__dict__["said_symmetry"] = "y"

    def test_body(self):
        self.assertEqual(self.run_.symmetry, [(1, 1)])
        half, whole = self.run_.frame(-1, ()).body, self.run_.last.body
        np.testing.assert_allclose((whole.points.min(axis=0)[1], whole.points.max(axis=0)[1]), (-1, 1), atol=1e-12)
        self.assertEqual(len(whole.points), 2 * len(half.points) - 25 + 16)     # of 5 x 5 nodes on the plane 9 are of the faces
        area = lambda body: 0.5 * np.linalg.norm(np.cross(*(body.points[b] - body.points[a] for a, b in (
            files.triangles_of(body.faces).T[[0, 1]], files.triangles_of(body.faces).T[[0, 2]]))), axis=1).sum()
        self.assertAlmostEqual(area(whole), 2 * area(half) - 2 * (1 - DEPTH), delta=1e-12)
        self.assertLess(whole.lines.max(), len(half.points))
        image = whole.points[len(half.points):]
        values = whole.data["stress_eq"][len(half.points):]                     # = x
        np.testing.assert_allclose(values, image[:, 0] - whole.data["displacement"][len(half.points):, 0], atol=1e-12)
        places, cells, _ = maps.cut_body(self.run_, whole, "stress_eq", np.array([0.3, 0.5, 0.5]), [1, 0, 0])
        a, b, c = (places[column] for column in cells.T)
        self.assertAlmostEqual(0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum(), 2 * (1 - DEPTH), delta=1e-12)

    def test_tool_as_far_as_the_plane(self):
        (_, points, triangles, _), = files.tool_parts(self.run_.last.tools)
        corners = points[triangles]
        area = 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum()
        self.assertAlmostEqual(area, np.prod(np.ptp(points, axis=0)[:2]), delta=1e-9)   # nothing lies twice
        self.assertAlmostEqual(points[:, 1].min(), -points[:, 1].max(), delta=1e-12)

    def test_cut(self):
        self.assertEqual(self.run_.cut, 1)
        self.assertAlmostEqual(self.run_.view(-1).body.points[:, 1].min(), 0, delta=1e-12)
        self.run_.__dict__["along"] = np.array([-1.0, 0, 0])
        for name in ("front", "cut"):
            self.run_.__dict__.pop(name)
        self.assertIsNone(self.run_.cut)                                        # seen from behind nothing is open


def said(length, stress):
    """The run of a script with rcUnits."""
    run = SpaceRun(str(FOLDER / "P2"))
    run.__dict__["said"] = length, stress
    return run


class Views(unittest.TestCase):
    run_ = SpaceRun(str(FOLDER / "P2"))

    def test_known_as_one_in_space(self):
        self.assertTrue(Run(str(FOLDER / "P2")).in_space)
        self.assertFalse(Run(str(FOLDER)).in_space)

    def test_directions_and_track(self):
        np.testing.assert_array_equal(self.run_.up, [0, 0, 1])
        np.testing.assert_array_equal(self.run_.along, [1, 0, 0])
        track = self.run_.tracks[0]
        self.assertEqual(len(track), FRAMES)
        np.testing.assert_allclose(track[-1] - track[0], [0.3, 0, -DEPTH], atol=1e-12)

    def test_ways(self):
        """Drawn of a tool that goes over the workpiece, not of one that pushes it along its way, nor in a frame that it is beside."""
        run, pushed, frame = said("mm", "MPa"), said("mm", "MPa"), self.run_.last
        run.__dict__["tracks"] = pushed.__dict__["tracks"] = {0: np.array([[0.1 * k, 0, 1 - DEPTH] for k in range(FRAMES)])}
        self.assertEqual((run.riders, len(scene.ways_of(run, frame))), ({0}, 1))
        beside = frame._replace(body=frame.body._replace(points=frame.body.points + [5, 0, 0]))
        self.assertEqual(scene.ways_of(run, beside), [])
        pushed.__dict__["along"] = np.array([0, 0, 1.0])
        self.assertEqual((pushed.riders, scene.ways_of(pushed, frame)), (set(), []))

    def test_units_are_not_per_thickness(self):
        self.assertEqual(self.run_.columns["Q_z"].unit, "force")
        self.assertEqual(said("mm", "MPa").columns["Q_z"].unit, "N")

    def test_section(self):
        """Of the deformed cube at x = 0.3: 1 x 0.9, where stress_eq = x."""
        for kind in ("P1", "P2"):
            run = SpaceRun(str(FOLDER / kind))
            places, cells, values = maps.cut_body(run, run.last.body, "stress_eq", np.array([0.3, 0.5, 0.5]), [1, 0, 0])
            a, b, c = (places[column] for column in cells.T)
            self.assertAlmostEqual(0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum(), 1 - DEPTH, delta=1e-12)
            np.testing.assert_allclose(values, 0.3, atol=1e-12)
        edges = maps.cut_tools(self.run_.last, np.array([0.3, 0.5, 0.5]), [1, 0, 0])
        self.assertAlmostEqual(np.linalg.norm(edges[:, 1] - edges[:, 0], axis=1).sum(), 3, delta=1e-12)

    def test_bands_have_equal_widths(self):
        """A value in a band of the map has its color, one below the first level that of the workpiece."""
        scale = scene.scale_of(self.run_, [self.run_.last])
        levels, (colors, (low, high)) = scale.levels, scene.bands(scale)
        self.assertEqual(scale.quantity, scene.fields.STRAIN)
        self.assertEqual(len(colors), len(levels))
        self.assertAlmostEqual((high - low) / len(colors), levels[2] - levels[1], delta=1e-15)
        self.assertLess(0, low + (high - low) / len(colors))
        self.assertEqual(colors[0][:3], scene.BODY)


class Arrows(unittest.TestCase):
    """The plate is led along x, turned about y and pressed down."""

    def setUp(self):
        self.run_ = said("mm", "MPa")
        twists = {"x": (1, 0, 0, 0, 0, 0), "z": (0, 0, 1, 0, 0, 0), "turn": (0, 0, 0, 0, 1, 0)}
        self.run_.summary["drive"] = {name: {"kind": "force" if name == "z" else "motion", "force": -50.0 * (name == "z"), "twist": list(twist)}
                                      for name, twist in twists.items()}
        self.run_.history = {**self.run_.history, "turn": -self.run_.history["t"], "Q_turn": 0 * self.run_.history["t"]}

    def test_found(self):
        found = [(a.tool, a.what, a.shape.kind, list(a.shape.points), a.text) for a in drives.arrows(self.run_, 1.0)]
        self.assertEqual(found, [("plate", "motion", "straight", [1, 0, 0], "0.3 mm"), ("plate", "force", "straight", [0, 0, -1], "50 N"),
                                 ("plate", "motion", "turn", [0, -1, 0], "57.3°")])

    def test_projected(self):
        """To the right what goes along, upward what goes up; a turn about the eye's direction is counterclockwise."""
        eye, up = scene.eye_of(self.run_), self.run_.up
        along, upward = (projected(drives.Shape("straight", v), eye, up).points for v in (self.run_.along, up))
        self.assertGreater(along[0], abs(along[1]))
        self.assertAlmostEqual(upward[0], 0, delta=1e-12)
        self.assertGreater(upward[1], 0.5)
        for sense in (1, -1):
            x, y = projected(drives.Shape("turn", sense * eye / np.linalg.norm(eye)), eye, up).points.T
            self.assertGreater(sense * (x[:-1] * y[1:] - y[:-1] * x[1:]).sum(), 0)
        self.assertGreater(np.linalg.norm(projected(drives.Shape("straight", eye / np.linalg.norm(eye) + 1e-3 * up), eye, up).points), 0.3)

    def test_contact_is_not_covered(self):
        """Neither arrows nor their values lie on the contact surface or on one another, in the scene and in the gallery's picture."""
        frame = self.run_.view(-1)
        for words, number in (("motion", "force"), 3), ((), 0):
            image, placed = scene.picture(self.run_, frame, scene.box_of([frame]), scene.scale_of(self.run_, [frame]))
            figure = new_figure(5.0)
            axes = figure.add_axes((0, 0, 1, 1))
            scene.show(axes, image, scene.near(placed, frame.body))
            self.assertEqual([h.get_label() for h in draw_arrows(axes, self.run_, frame, placed, words)], ["motion", "force"])
            figure.draw_without_rendering()
            boxes = [text.get_window_extent() for text in axes.texts if text.get_text()]
            self.assertEqual(len(boxes), number)
            self.assertFalse(any(box.overlaps(other) for k, box in enumerate(boxes) for other in boxes[:k]))
            a, b = np.meshgrid(np.linspace(0, 1, 9), np.linspace(0, 1, 9))
            top = placed.pixels(np.column_stack([a.ravel(), b.ravel(), np.full(a.size, 1 - DEPTH)]))
            self.assertFalse(any(box.contains(*place) for box in boxes for place in axes.transData.transform(top)))
            way = np.vstack([line.get_xydata() for line in axes.lines])
            self.assertGreater(np.hypot(*(way[:, None] - top).T).min(), 10)


    def test_force_on_a_small_tool(self):
        """Where the workpiece goes on beyond all sides of the view, all that is not above the tool is covered, so that the force ends above it."""
        frame = self.run_.view(-1)
        right = np.cross(self.run_.up, scene.eye_of(self.run_))
        large = np.array([20 * (i * right + j * self.run_.up) for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))])
        frame = frame._replace(body=frame.body._replace(points=large, faces=np.array([[0, 1, 2], [0, 2, 3]])))
        stage = scene.Scene((690, 460))
        stage.look(scene.eye_of(self.run_), self.run_.up, (np.full(3, -4.0), np.full(3, 5.0)))
        axes = new_figure(5.0).add_axes((0, 0, 1, 1))
        axes.set(xlim=(0, 690), ylim=(0, 460))
        self.run_.summary["drive"] = {"z": self.run_.summary["drive"]["z"]}
        draw_arrows(axes, self.run_, frame, stage)
        tool, way = stage.pixels(frame.tools.points), axes.lines[0].get_xydata()
        cells = covered(axes, frame, stage, 690, self.run_.up)
        self.assertLess(cells[:, 1].min(), 20)
        self.assertLess(cells[:, 1].max(), tool[:, 1].max() + 0.02 * 690)
        self.assertGreater(way[0, 1], way[1, 1])
        self.assertGreater(way[1, 1], tool[:, 1].max() - 10)


class ContactViews(unittest.TestCase):
    """A tool that presses along a normal at four places of the plane x y."""

    def seen(self, normals, symmetry=(), points=((0, 1, 0), (2, 1, 0), (0, 3, 0), (2, 3, 0))):
        run = SimpleNamespace(up=np.array([0, 0, 1.0]), along=np.array([1.0, 0, 0]), symmetry=symmetry)
        normals = np.resize(np.array(normals, float), (4, 3))
        data = {"state": np.full(4, 2), "tool": np.zeros(4), "pressure": np.array([1, 1, 1, 3.0]), "traction_tangential": np.tile([0.1, 0, 0], (4, 1))}
        data["traction"] = data["traction_tangential"] - data["pressure"][:, None] * normals
        surface = files.Surface(np.array(points, float), np.array([[0, 1, 2], [1, 3, 2]]), data, {})
        mine = contact_view.nodes_of(run, surface, 0)
        return contact_view.view_of(run, surface, mine), mine, surface

    def test_along_an_axis(self):
        for normal, axes, labels, words in (((0, 0, -1), [[1, 0, 0], [0, 1, 0]], ["x", "y"], "along z"), ((0.02, 1, 0), [[1, 0, 0], [0, 0, 1]], ["x", "z"], "along y"),
                                            ((1, 0, 0), [[0, 1, 0], [0, 0, 1]], ["y", "z"], "along x")):
            view, _, surface = self.seen([np.array(normal) / np.linalg.norm(normal)])
            np.testing.assert_array_equal(view.axes, axes)
            self.assertEqual((view.labels, view.words), (labels, words))
            np.testing.assert_array_equal(contact_view.places_in(view, surface.points), surface.points @ np.array(axes).T)

    def test_between_axes(self):
        """Upright stays upright; lengths across it are from the middle, (4/3, 7/3) weighted by the pressure."""
        view, _, surface = self.seen([(0.6, -0.8, 0)])
        np.testing.assert_allclose(view.axes, [[0.8, 0.6, 0], [0, 0, 1]], atol=1e-12)
        self.assertEqual((view.labels, view.words), (["from the middle of the contact toward +x and +y", "z"], "along its normal (0.6, -0.8, 0)"))
        np.testing.assert_allclose(contact_view.places_in(view, surface.points)[3], [0.8 * 2 / 3 + 0.6 * 2 / 3, 0], atol=1e-12)

    def test_around(self):
        """Without a side of its own it is seen from above."""
        self.assertEqual(self.seen([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1 / 3, 0)])[0].words, "along z")

    def test_symmetry(self):
        """Of a contact beside the plane of symmetry what was computed, one that meets the plane as a whole."""
        self.assertEqual(list(self.seen([(0, 0, 1)], [(0, 1)], ((1, 0, 0), (2, 0, 0), (-1, 0, 0), (-2, 0, 0)))[1]), [True, True, False, False])
        self.assertTrue(self.seen([(0, 0, 1)], [(0, 1)])[1].all())


class EdgeLabels(unittest.TestCase):
    def test_seen_and_apart(self):
        """In a view that is too narrow for them there is room for all words; none lies on those of another edge."""
        run = said("mm", "MPa")
        frame, wide = run.view(-1), 3.4
        stage = scene.staged(run, frame, scene.box_of([frame]), scene.scale_of(run, [frame]), scene.SIZE)
        window = edge_labels.with_room(run, [frame], [stage], ((500, 600), (400, 500)), wide, 8)
        labels = edge_labels.edge_labels(run, frame, stage, (window[0][1] - window[0][0]) / (72 * wide), 8)
        self.assertEqual([label.text for label in labels], ["x: 0 to 1 [mm]", "y: 0 to 1 [mm]", "z: 0 to 0.9 [mm]"])
        for k, label in enumerate(labels):
            for axis in (0, 1):
                self.assertTrue(window[axis][0] - 9 < label.covers[:, axis].min() and label.covers[:, axis].max() < window[axis][1] + 9)
            for other in labels[:k]:
                self.assertGreater(np.hypot(*(label.covers[:, None] - other.covers).T).min(), 4)


class Origins(unittest.TestCase):
    def test_as_of_the_whole_file(self):
        """What is read of every frame's tools alone is what VTK reads; half a file is refused."""
        path = FOLDER / "P1/tools-1.vtp"
        whole = files.arrays(files.read(str(path), files.vtkXMLPolyDataReader()).GetCellData())
        for number, origin in files.read_origins(str(path)):
            np.testing.assert_array_equal(origin, whole["origin"][whole["tool"] == number][0])
        broken, text = FOLDER / "broken.vtp", path.read_text()
        for length in (0, text.index("</CellData>")):
            broken.write_text(text[:length])
            with self.assertRaisesRegex(InputError, "broken.vtp: not a whole VTP file"):
                files.read_origins(str(broken))


class Window(unittest.TestCase):
    def window(self, low, high):
        points = np.array([[*low, 0.0], [*high, 0.0]])
        stage = SimpleNamespace(points=[points], size=(200, 100), pixels=lambda places: places[:, :2])
        return scene.near(stage, SimpleNamespace(points=points))

    def test_about_the_workpiece(self):
        (left, right), (bottom, top) = self.window((80, 40), (120, 60))
        self.assertEqual((left, right, bottom), (80 - 6.4, 120 + 6.4, 40 - 6.4))
        self.assertAlmostEqual(top, 60 + 2 * 6.4)

    def test_a_workpiece_larger_than_the_view_ends_there(self):
        self.assertEqual(self.window((-4e4, -3e4), (5e4, 2e4)), ((0, 200), (0, 100)))


class Pictures(unittest.TestCase):
    def drawn(self, *words):
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            code = case.draw([str(FOLDER / "P2"), *words], Run, case.DEFAULT, patient=True)
        return code, out.getvalue().split(), err.getvalue()

    def test_default_pictures(self):
        code, paths, said = self.drawn()
        self.assertEqual((code, [Path(p).stem for p in paths], said), (0, ["final", "scene", "sequence", "pressure", "section", "history"], ""))
        for path in paths:
            self.assertEqual(faults(Path(path)), [])

    def test_one_by_name(self):
        for name in ("final", "gallery", "work", "scene"):
            code, paths, said = self.drawn(name)
            self.assertEqual((code, [Path(p).stem for p in paths], said), (0, [name], ""))
            self.assertEqual(faults(Path(paths[0])), [])
            with Image.open(paths[0]) as drawn:
                self.assertEqual((drawn.width, drawn.mode), (690 if name == "gallery" else 1200, "P"))
        code, paths, said = self.drawn("finale")
        self.assertEqual((code, paths), (2, []))
        self.assertRegex(said, r"usage: .*\[movie\|gallery\|work\|final\|")

    def test_page(self):
        code, paths, said = self.drawn("movie")
        self.assertEqual((code, said), (0, ""))
        page = Path(paths[0]).read_text()
        self.assertNotRegex(page, "(src|href)=|https?://|@import")
        data = json.loads(re.search('<script id="data"[^>]*>(.*?)</script>', page, re.S).group(1))
        self.assertEqual(len(data["frames"]), FRAMES)
        numbers = lambda text, kind: np.frombuffer(base64.b64decode(text), kind)
        self.assertEqual(len(numbers(data["cells"], "<u4")), 3 * 4 * 12)
        z = [numbers(data["frames"][k]["points"], "<f4").reshape(-1, 3)[:, 2] for k in (0, -1)]
        self.assertAlmostEqual(np.ptp(z[1]) / np.ptp(z[0]), 1 - DEPTH, delta=1e-6)


if __name__ == "__main__":
    unittest.main(verbosity=2, warnings="ignore")
