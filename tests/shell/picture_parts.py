"""Unit tests of what pictures are made of, without a run:  picture_parts.py FOLDER  for what they draw."""
import sys
import unittest
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "cases"))
import numpy as np
from matplotlib.tri import Triangulation
from plotting import contact, fields, quadratic
from plotting.figure import new_figure, save
from plotting.labels import place_labels
from plotting.tools import Outline, area_of, own_part, rim_of
from plotting.vtu import Field

FOLDER = Path(sys.argv.pop(1))


class ContactLine(unittest.TestCase):
    def parts(self, x, y, tools):
        surface = {"x": np.array(x, float), "y": np.array(y, float), "tool": np.array(tools),
                   "state": np.where(np.array(tools) == "", "free", "sliding")}
        return [(p.start, p.stop) for p in contact.contact_arcs(surface)]

    def test_one_piece(self):
        self.assertEqual(self.parts(range(6), [0] * 6, ["", "a", "a", "a", "", ""]), [(1, 4)])

    def test_not_across_the_body(self):
        """Upper and lower surface follow one another in the table; no line joins them."""
        self.assertEqual(self.parts([*range(5)] * 2, [0] * 5 + [9] * 5, ["a"] * 10), [(0, 5), (5, 10)])

    def test_not_between_tools(self):
        self.assertEqual(self.parts(range(6), [0] * 6, ["a", "a", "b", "b", "b", ""]), [(0, 2), (2, 5)])


class Labels(unittest.TestCase):
    def test_none_on_another(self):
        """Points and labels of three curves that nearly meet, in an axes without much room."""
        figure, axes = new_figure(3.2, 2.4)
        points = [(x, x + 0.03 * k, str(n), "red") for k in range(3) for n, x in ((8, 1.0), (16, 1.2), (32, 3.0))]
        for k in range(3):
            axes.plot(*zip(*[p[:2] for p in points[3 * k:3 * k + 3]]), marker="o", markersize=5)
        figure.draw_without_rendering()
        place_labels(axes, points)
        boxes = [text.get_window_extent() for text in axes.texts]
        self.assertEqual(len(boxes), 9)
        frame = axes.get_window_extent()
        for k, box in enumerate(boxes):
            self.assertFalse(any(box.overlaps(other) for other in boxes[:k]))
            self.assertTrue(frame.contains(box.x0, box.y0) and frame.contains(box.x1, box.y1))


class Mirrored(unittest.TestCase):
    def test_tools(self):
        """One that crosses the line of symmetry ends there; one out of view is no error."""
        mesh = Triangulation([0, 1, 1, 0], [0, 0, 1, 1], [[0, 1, 2], [0, 2, 3]])
        angle = np.linspace(0, 2 * np.pi, 100)
        circle = np.column_stack([np.cos(angle), np.sin(angle)])
        outlines = [Outline("near", 0.0, 2 * circle + [0.5, 3.1]), Outline("far", 0.0, circle + [40, 0])]
        figure, axes = new_figure(4, 4)
        fields.draw_map(axes, mesh, np.zeros(4), None, outlines, (-2, 2, -0.5, 3), "viridis", mirrors=[(-1, 1)])
        save(figure, FOLDER, "mirrored")
        part = own_part(axes, mesh, [(-1, 1)])
        self.assertTrue(part.contains_point((1.5, 2.9)) and not part.contains_point((-0.1, 1)))
        self.assertIsNone(own_part(axes, mesh, []))


class Areas(unittest.TestCase):
    """What is filled of a tool over the block -1 to 1, -1 to 0, whose outlines have it at their left: within a punch, beside a die."""

    MESH = Triangulation([-1, 1, 1, -1], [-1, -1, 0, 0], [[0, 1, 2], [0, 2, 3]])
    HALF = Triangulation([0, 1, 1, 0], [-1, -1, 0, 0], [[0, 1, 2], [0, 2, 3]])
    PUNCH = np.array([[0.5, 3], [0.5, 0], [-0.5, 0], [-0.5, 3]])

    def area(self, points, mesh, mirrors=()):
        x, y = area_of(np.array(points, float), mesh, 0.1, mirrors).T
        return 0.5 * abs((x * np.roll(y, -1) - np.roll(x, -1) * y).sum())

    def test_punch(self):
        self.assertAlmostEqual(self.area(self.PUNCH, self.MESH), 3, delta=1e-12)
        for points in (self.PUNCH, self.PUNCH[:3], [[0.5, 3], [0.5, 0], [0, 0]]):       # as far as the line of symmetry or beyond it
            self.assertAlmostEqual(self.area(points, self.HALF, [(-1, 1)]), 1.5, delta=1e-12)

    def test_die(self):
        """A plane and a groove over the block: bands."""
        self.assertAlmostEqual(self.area([[2, 0], [-2, 0]], self.MESH), 0.4, delta=1e-12)
        self.assertLess(self.area([[2, 0], [0.5, 0], [0.5, 1], [-0.5, 1], [-0.5, 0], [-2, 0]], self.MESH), 1)


class Hidden(unittest.TestCase):
    def test_behind_a_smaller_tool(self):
        """Of a holder drawn as a large circle the part within the punch is not seen, of the punch all is, and all of a tool apart from others."""
        angle = np.linspace(0, 2 * np.pi, 1000)
        holder = Outline("holder", 0.0, np.column_stack([10 * np.cos(angle), 10 + 10 * np.sin(angle)]))
        punch = Outline("punch", 0.0, np.array([[-1, 4], [1, 4], [1, -2], [-1, -2], [-1, 4.0]]))
        areas = {o.name: o.points for o in (holder, punch)}
        rim = rim_of(holder, areas, 20)
        seen = rim[np.isfinite(rim).all(axis=1)]
        self.assertGreater(np.abs(seen[seen[:, 1] < 5, 0]).min(), 1)
        self.assertAlmostEqual(np.isnan(rim[:, 0]).mean(), 2 * np.arcsin(0.1) / (2 * np.pi), delta=2e-3)
        self.assertIs(rim_of(punch, areas, 20), punch.points)
        self.assertIs(rim_of(holder, {"holder": holder.points, "punch": punch.points - [0, 40]}, 20), holder.points)


class Quadratic(unittest.TestCase):
    """Two quadratic triangles of the unit square, divided as the file has them."""

    POINTS = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0.5, 0], [1, 0.5], [0.5, 0.5], [0.5, 1], [0, 0.5]], float)
    ELEMENTS = np.array([[0, 1, 2, 4, 5, 6], [0, 2, 3, 6, 7, 8]])

    def field(self):
        parts = [[[c[0], c[3], c[5]], [c[3], c[1], c[4]], [c[5], c[4], c[2]], [c[4], c[5], c[3]]] for c in self.ELEMENTS.tolist()]
        return Field(self.POINTS, np.array(parts).reshape(-1, 3), {"displacement": np.zeros((9, 3))})

    def test_elements(self):
        np.testing.assert_array_equal(quadratic.elements_of(self.field().triangles), self.ELEMENTS)
        np.testing.assert_array_equal(quadratic.elements_of(self.field().triangles[:7]), self.field().triangles[:7])

    def test_field(self):
        """A quadratic function comes out as it is at every point, edges and area as well; common points are one."""
        value = lambda x, y: 1 + x * (2 - y) + 0.3 * y**2
        field = self.field()
        found = quadratic.smooth(field, value(*field.points.T), 2.0)
        x, y = found.mesh.x / 2, found.mesh.y / 2
        np.testing.assert_allclose(found.values, value(x, y), atol=1e-12)
        self.assertEqual(len(set(zip(x.round(9), y.round(9)))), len(x))
        a, b, c = (np.column_stack([x, y])[k] for k in found.mesh.triangles.T)
        area = 0.5 * ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
        self.assertTrue((area > 0).all())
        self.assertAlmostEqual(area.sum(), 1)
        self.assertEqual(len(found.edges), 5)

    def test_curved_edge(self):
        """The middle of an edge moves: its line goes through the three nodes."""
        field = self.field()
        field.data["displacement"][4] = [0, -0.1, 0]
        edges = quadratic.smooth(field, np.zeros(9), 1.0).edges
        low = edges[[np.abs(edge[[0, -1], 1]).max() == 0 for edge in edges]][0]
        np.testing.assert_allclose(low[:, 1], -0.4 * low[:, 0] * (1 - low[:, 0]), atol=1e-12)


if __name__ == "__main__":
    unittest.main(verbosity=2)
