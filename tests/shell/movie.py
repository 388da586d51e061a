"""What a small run leaves for ParaView, and its movie:  movie.py FOLDER  of the run of tests/support/press.edp.

Read with meshio and our own reader of XML; tests/viewers reads the same files with VTK.
"""
import base64
import csv
import io
import json
import sys
import unittest
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree

TOP = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(TOP / "cases"), str(TOP / "tests/support")]
import meshio
import numpy as np
from PIL import Image
from picture import faults
from plotting.inputs import InputError
from plotting.run import Run
from plotting.vtp import read_vtp

FOLDER = Path(sys.argv.pop(1))
FRAMES = 5  # -series 4, and the start


def table(name):
    with open(FOLDER / name, encoding="utf-8") as file:
        return list(csv.DictReader(file))


class Series(unittest.TestCase):
    def test_parts_of_every_frame(self):
        entries = ElementTree.parse(FOLDER / "fields.pvd").findall("Collection/DataSet")
        parts = [(e.get("part"), e.get("name"), e.get("file")) for e in entries]
        expected = [(str(k), name, f"{file}-{i}.{kind}") for i in range(FRAMES) for k, (name, file, kind) in enumerate(
            [("workpiece", "fields", "vtu"), ("tools", "tools", "vtp"), ("contact surface", "surface", "vtp")])]
        self.assertEqual(parts, expected)
        times = [float(e.get("timestep")) for e in entries]
        self.assertEqual((times[0], times[-1]), (0, 1))
        self.assertEqual(len(Run(str(FOLDER)).series), FRAMES - 1)  # the pictures leave the start out

    def test_fields(self):
        """Double precision; the tensor is that of the components, in ParaView's order."""
        mesh = meshio.read(FOLDER / "fields-4.vtu")
        data = mesh.point_data
        self.assertEqual({a.dtype for a in data.values()} | {mesh.points.dtype}, {np.dtype("f8")})
        self.assertEqual(data["stress"].shape, (len(mesh.points), 6))
        for k, name in enumerate(("xx", "yy", "zz", "xy")):
            np.testing.assert_array_equal(data["stress"][:, k], data["stress_" + name])
        self.assertFalse(data["stress"][:, 4:].any())
        xx, yy, zz, xy = data["stress"][:, :4].T
        mises = np.sqrt(0.5 * ((xx - yy)**2 + (yy - zz)**2 + (zz - xx)**2) + 3 * xy**2)
        self.assertGreater(np.corrcoef(mises, data["stress_eq"])[0, 1], 0.95)  # means of products differ
        names = (FOLDER / "fields-4.vtu").read_text().split('Name="stress"')[1].split(">")[0]
        self.assertEqual([names.count(f'ComponentName{k}="{n}"') for k, n in
                          enumerate(("XX", "YY", "ZZ", "XY", "YZ", "XZ"))], [1] * 6)
        triangles = mesh.points[mesh.cells_dict["triangle"]][..., :2]
        area = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]) / 2
        self.assertGreater(area.min(), 0)
        np.testing.assert_allclose(area.sum(), 0.02 * 0.01, rtol=1e-12)

    def test_start(self):
        data = meshio.read(FOLDER / "fields-0.vtu").point_data
        self.assertFalse(data["displacement"].any() or data["stress"].any())

    def test_surface(self):
        """The last frame is what surface.csv says; its edges go along the whole surface."""
        surface, rows = read_vtp(FOLDER / "surface-4.vtp"), table("surface.csv")
        place = (surface.points + surface.data["displacement"])[:, :2]
        names = ["free", "touched", "sliding", "sticking", "leaving", "receding"]
        self.assertEqual([names[k] for k in surface.data["state"]], [r["state"] for r in rows])
        np.testing.assert_allclose(place, [[float(r["x"]), float(r["y"])] for r in rows], rtol=1e-11)
        for name in ("gap", "pressure", "traction_tangential", "nodal_pressure", "nodal_traction"):
            np.testing.assert_allclose(surface.data[name], [float(r[name]) for r in rows], rtol=1e-10, err_msg=name)
        lengths = [np.ptp(surface.points[line, 0]) for line in surface.lines]
        np.testing.assert_allclose(sum(lengths), 0.02, rtol=1e-12)
        # the vector has the pressure along the roller's normal, down on the body, and the friction across it
        traction, touching = surface.data["traction"], surface.data["pressure"] > 0
        self.assertTrue(touching.any() and (traction[touching, 1] < 0).all())
        np.testing.assert_allclose(np.hypot(*traction[:, :2].T), np.hypot(surface.data["pressure"],
                                                                        surface.data["traction_tangential"]), rtol=1e-9)

    def test_tools(self):
        tools = read_vtp(FOLDER / "tools-4.vtp")
        self.assertEqual(len(tools.lines), 2)
        self.assertFalse(tools.data["displacement"].any())
        history = {k: float(v) for k, v in table("history.csv")[-1].items()}
        roller = tools.points[tools.lines[0], :2] - [history["roller.x"], history["roller.y"]]
        np.testing.assert_allclose(np.hypot(*roller.T), 15e-3, rtol=1e-11)
        # the chords near the block leave the circle by less than a pixel of a large picture
        chords = np.hypot(*np.diff(roller, axis=0).T)
        low = roller[:-1, 1] < -14e-3
        self.assertLess((chords[low]**2 / (8 * 15e-3)).max(), 2e-4 * 0.02)

    def test_supports(self):
        run = Run(str(FOLDER))
        places, fixed = run.supports
        self.assertEqual(len(places), 33)  # nodes of the bottom, 16 quadratic edges
        self.assertTrue((places[:, 1] == -0.01).all() and fixed.all())
        self.assertEqual(run.mirrors, [])

    def test_symmetry(self):
        for word, ring, signs in (("", False, []), ("x", False, [(-1, 1)]), ("y", False, [(1, -1)]),
                                  ("xy", False, [(-1, 1), (1, -1), (-1, -1)]), ("", True, [(-1, 1)]), ("y", None, [(1, -1)])):
            run = Run(str(FOLDER))
            run.__dict__.update(summary={"symmetry": word}, axisymmetric=ring)
            self.assertEqual(run.mirrors, signs)

    def test_broken(self):
        whole = (FOLDER / "surface-4.vtp").read_text()
        for name, text in (("cut", whole[:len(whole) // 2]), ("empty", ""), ("other", whole.replace("PolyData", "Grid"))):
            (FOLDER / f"{name}.vtp").write_text(text)
            with self.assertRaises(InputError):
                read_vtp(FOLDER / f"{name}.vtp")


class Page(HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.tags, self.inside, self.data = [], None, ""
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.tags.append((tag, dict(attributes)))
        self.inside = dict(attributes).get("id")

    def handle_endtag(self, tag):
        self.inside = None

    def handle_data(self, data):
        if self.inside == "frames":
            self.data += data


class Movie(unittest.TestCase):
    def test_page(self):
        page = Page((FOLDER / "movie.html").read_text())
        links = [a.get("src", a.get("href", "")) for _, a in page.tags]
        self.assertEqual([link for link in links if link and not link.startswith("data:image/png;base64,")], [])
        slider = next(a for tag, a in page.tags if tag == "input")
        self.assertEqual((slider["type"], slider["max"]), ("range", str(FRAMES - 1)))
        data = json.loads(page.data)
        shown = next(a["src"] for tag, a in page.tags if tag == "img")
        self.assertEqual((slider["value"], shown), ("0", data["images"][0]))   # it opens at its first frame
        self.assertEqual(len(data["images"]), FRAMES)
        self.assertEqual((data["t"][0], data["t"][-1]), (0, 1))
        frames = [base64.b64decode(image.split(",")[1]) for image in data["images"]]
        self.assertEqual(len(set(frames)), FRAMES)
        for k, frame in enumerate(frames):
            (FOLDER / "frame.png").write_bytes(frame)
            self.assertEqual(faults(FOLDER / "frame.png") if k else [], [])
            self.assertEqual(Image.open(io.BytesIO(frame)).size, Image.open(FOLDER / "movie.gif").size)

    def test_gif(self):
        with Image.open(FOLDER / "movie.gif") as movie:
            self.assertEqual(movie.n_frames, FRAMES)
        self.assertLess((FOLDER / "movie.gif").stat().st_size + (FOLDER / "movie.html").stat().st_size, 5e6)


if __name__ == "__main__":
    unittest.main(verbosity=2)
