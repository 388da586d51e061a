"""Unit tests of the pictures of a run:  pictures.py FOLDER  with the runs of test_pictures.sh in it. Their parts: picture_parts.py."""
import contextlib
import io
import shutil
import sys
import unittest
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(TOP / "cases"), str(TOP / "tests/support")]
import numpy as np
from matplotlib.tri import Triangulation
from picture import faults
from PIL import Image
from plotting import arrows, case, contact, curves, drives, fields, units
from plotting.figure import new_figure, save
from plotting.inputs import InputError
from plotting.run import Run
from plotting.start import spread, start_figure
from plotting.tools import Outline, at_time, own_side

FOLDER = Path(sys.argv.pop(1))
FINISHED = FOLDER / "finished"


class Refused(unittest.TestCase):
    """What tests/support/picture.py says of files that are no pictures."""

    def refused(self, path, word):
        self.assertIn(word, "; ".join(faults(path)))

    def test_missing(self):
        self.refused(FOLDER / "nothing.png", "missing")

    def test_blank(self):
        for color in ("white", "black", "red"):
            Image.new("RGB", (900, 600), color).save(FOLDER / "blank.png")
            self.refused(FOLDER / "blank.png", "1 colors")

    def test_axes_without_curves(self):
        figure, axes = new_figure()
        axes.set_title("Nothing in it")
        self.refused(save(figure, FOLDER, "empty"), "blank: 0 %")
        figure, axes = new_figure()
        axes.plot([0, 1], [0, 1])
        self.assertEqual(faults(save(figure, FOLDER, "curve")), [])

    def test_small(self):
        with Image.open(FINISHED / "stress.png") as picture:
            picture.resize((120, 80)).save(FOLDER / "small.png")
        self.refused(FOLDER / "small.png", "120 x 80 pixels")

    def test_broken(self):
        whole = (FINISHED / "stress.png").read_bytes()
        for name, content in (("cut", whole[:len(whole) // 2]), ("text", b"t,x,y\n" * 5000), ("none", b"")):
            (FOLDER / f"{name}.png").write_bytes(content)
            self.refused(FOLDER / f"{name}.png", "cannot be decoded")


class Scene(unittest.TestCase):
    def test_something_is_drawn(self):
        for path in sorted([*FINISHED.glob("*.png"), *(FOLDER / "stopped").glob("*.png")]):
            with self.subTest(path=path):
                self.assertEqual(faults(path), [])

    def test_units_are_neutral(self):
        run = Run(str(FINISHED))
        self.assertEqual(run.units.length_unit, r"$10^{-3}$ length")
        self.assertEqual(run.units.stress_unit, r"$10^{6}$ stress")
        axes = fields.field_figure(run, fields.STRESS).axes
        self.assertEqual([axes[0].get_xlabel(), axes[0].get_ylabel(), axes[1].get_ylabel()],
                         [r"x [$10^{-3}$ length]", r"y [$10^{-3}$ length]", r"von Mises stress [$10^{6}$ stress]"])
        titles = [a.get_title(loc="left") for a in curves.history_figure(run).axes]
        self.assertIn(r"drive force [$10^{3}$ force/length]", titles)
        self.assertEqual(units.neutral(40.0, 300.0).length_unit, "length")
        self.assertEqual(units.neutral(40.0, 300.0, axisymmetric=True).force_unit, "force")

    def test_units_that_are_said(self):
        """A force of 1 stress times length, and times length again, in N; moments alike."""
        for length, stress, meter, pascal in (("m", "Pa", 1, 1), ("mm", "MPa", 1e-3, 1e6), ("cm", "kPa", 1e-2, 1e3), ("um", "GPa", 1e-6, 1e9)):
            plane, ring = units.named(length, stress), units.named(length, stress, whole=True)
            newton = {"N": 1, "kN": 1e3, "N/mm": 1e3, "kN/m": 1e3}
            self.assertAlmostEqual(plane.force * newton[plane.force_unit] / (pascal * meter), 1)
            self.assertAlmostEqual(ring.force * newton[ring.force_unit] / (pascal * meter**2), 1)
            arm = {r"N$\cdot$m": 1, r"N$\cdot$mm": 1e-3, r"N$\cdot$m/m": 1, r"N$\cdot$mm/mm": 1}
            self.assertAlmostEqual(plane.moment * arm[plane.moment_unit] / (pascal * meter**2), 1)
            self.assertAlmostEqual(ring.moment * arm[ring.moment_unit] / (pascal * meter**3), 1)
            self.assertAlmostEqual(plane.stress * 1e6 / pascal, 1)
            self.assertAlmostEqual(plane.length * {"mm": 1e-3}.get(plane.length_unit, 1e-6) / meter, 1)
        with self.assertRaisesRegex(InputError, "'inch', 'MPa': expected one of m, cm, mm, um"):
            units.named("inch", "MPa")

    def test_styles_of_curves(self):
        (x, dash_x), (y, dash_y), (other, dash_other), (nodes, _) = curves.styles(["die: x", "die: y", "punch: x", "sliding"])
        self.assertEqual((x, dash_x), (y, "-"))
        self.assertEqual(dash_other, dash_x)
        self.assertNotEqual(dash_y, dash_x)
        self.assertEqual(len({x, other, nodes}), 3)
        self.assertEqual(len(set(curves.styles(["x", "y", "angle"]))), 3)
        of_states = [(contact.STATES[k][1], "-") for k in (3, 2)]   # as in maps and movies
        self.assertEqual(curves.styles(["sticking", "sliding"]), of_states)
        self.assertEqual(curves.styles(["die: in contact", "punch: in contact", "sticking", "sliding"])[2:], of_states)
        self.assertEqual(len(set(curves.styles(["die: in contact", "punch: in contact", "sticking", "sliding"]))), 4)

    def test_what_is_zero_is_not_drawn(self):
        run = Run(str(FINISHED))
        run.history = {**run.history, "Q_x": 1e-8 * np.abs(run.history["Q_y"]).max() * np.sin(run.history["t"])}
        names = [name for _, names, _ in curves.default_panels(run) for name in names]
        self.assertIn("Q_y", names)
        self.assertNotIn("Q_x", names)

    def test_drive_of_no_force(self):
        """What is left of the equilibrium of a coordinate under no force is not drawn; a force that is prescribed is, and that of a motion."""
        run = Run(str(FINISHED))
        noise = 1e-5 * np.abs(run.history["Q_y"]).max() * run.size() * np.sin(run.history["t"])
        run.history = {**run.history, "turn": run.history["t"], "Q_turn": noise, "lean": run.history["t"], "Q_lean": noise}
        kinds = {"y": ("force", [0, 1, 0]), "turn": ("force", [0, 0, 1]), "lean": ("motion", [0, 0, 1])}
        run.summary["drive"] = {name: {"kind": kind, "force": 0.0, "twist": twist} for name, (kind, twist) in kinds.items()}
        names = [name for _, names, _ in curves.default_panels(run) for name in names]
        self.assertEqual([name for name in ("Q_y", "Q_turn", "Q_lean", "turn", "lean") if name not in names], ["Q_turn"])

    def test_moments_have_a_panel_of_their_own(self):
        names = ["t", "z", "spinx", "ball.spinz", "Q_z", "Q_spinx", "Q_ball.spinz"]
        found = units.describe(names, units.named("mm", "MPa", whole=True))
        self.assertEqual([found[n].kind for n in names],
                         [units.TIME, units.LENGTH, units.ANGLE, units.ANGLE, units.FORCE, units.MOMENT, units.MOMENT])
        self.assertEqual((found["Q_z"].unit, found["Q_spinx"].unit, found["spinx"].unit), ("N", r"N$\cdot$mm", "deg"))

    def test_units_of_columns(self):
        """Of the script's columns: what their names end with; none is made up."""
        found = units.describe(["t", "depth_mm", "way_um", "pull_N", "energy", "e_over_a"], units.named("mm", "MPa"))
        self.assertEqual([found[name].axis() for name in list(found)[1:]], ["depth [mm]", r"way [$\mu$m]", "pull [N]", "energy", "e_over_a"])

    def test_groups(self):
        """Columns of the script with one unit and about one size share a panel."""
        run = Run(str(FINISHED), None, {"a": ("a", "mm", 1), "b": ("b", "mm", 1), "c": ("c", "mm", 1), "d": ("d", "-", 1), "e": ("e", "-", 1)})
        t = run.history["t"]
        run.history = {**run.history, "a": t, "b": 5 * t, "c": 1e3 * t, "d": t, "e": t}
        own = [names for _, names, _ in curves.default_panels(run) if set(names) & set("abcde")]
        self.assertEqual(own, [["a", "b"], ["c"], ["d"], ["e"]])
        self.assertIsNotNone(curves.history_figure(run))

    def test_stress_error(self):
        """No larger than the stress."""
        run = Run(str(FINISHED))
        run.field.data["stress_error"] = 3 * run.field.data["stress_eq"]
        largest = run.units.stress * run.field.data["stress_eq"].max()
        title = fields.field_figure(run, fields.ERROR).axes[0].get_title()
        self.assertIn(f"largest at a node {units.amount(largest, run.units.stress_unit)}", title)

    def test_drive_forces_of_a_ring(self):
        for ring in (False, True):
            run = Run(str(FINISHED))
            run.axisymmetric = ring
            run.summary["drive"] = {}
            names = [name for _, names, _ in curves.default_panels(run) for name in names if name.startswith("Q_")]
            self.assertEqual(names, ["Q_y"] if ring else ["Q_x", "Q_y", "Q_angle"])

    def draw(self, folder):
        """The exit code of the pictures of any scene, their names, and what is said."""
        said = io.StringIO()
        with contextlib.redirect_stderr(said), contextlib.redirect_stdout(io.StringIO()):
            pictures = (case.history, case.pressure, case.expected)
            code = case.draw_all(Run(str(folder)), pictures, str(folder), patient=True)
        return code, sorted(p.stem for p in folder.glob("*.png")), said.getvalue()

    def test_files_that_are_missing(self):
        folder = FOLDER / "part"
        folder.mkdir()
        shutil.copy(FINISHED / "surface.csv", folder)
        self.assertEqual(self.draw(folder), (0, ["pressure"], ""))

    def test_file_that_is_broken(self):
        folder = FOLDER / "broken"
        folder.mkdir()
        (folder / "history.csv").write_text("t,x\n0,many\n")
        (folder / "history.png").write_bytes(b"of an earlier run")
        code, drawn, said = self.draw(folder)
        self.assertEqual((code, drawn), (1, []))
        self.assertIn("history.csv: line 2, column x: not a number: 'many'", said)


class Arrows(unittest.TestCase):
    """What the program prescribes: the roller of the finished run is pressed down by 400 kN/m, x is held, it may turn."""

    def run_with(self, **drives):
        """The finished run with other drives: kind, twist, places of the coordinate in the history."""
        run = Run(str(FINISHED))
        run.summary["drive"] = {name: {"kind": kind, "force": 0.0, "twist": twist} for name, (kind, twist, _) in drives.items()}
        run.history = {**run.history, **{name: values(run.history["t"]) for name, (_, _, values) in drives.items()}}
        return run

    def found(self, size=40.0, **given):
        return [(a.shape.kind, list(np.atleast_1d(a.shape.points)), a.both, a.what) for a in drives.arrows(self.run_with(**given), size)]

    def test_of_a_run(self):
        run = Run(str(FINISHED))
        self.assertEqual({name: drive["kind"] for name, drive in run.summary["drive"].items()},
                         {"x": "motion", "y": "force", "angle": "force"})
        (force,) = drives.arrows(run, 40.0)
        self.assertEqual((force.tool, force.shape.kind, force.both), ("roller", "straight", False))
        np.testing.assert_allclose(force.shape.points, [0, -1])
        self.assertEqual(force.text, units.amount(4e5 * run.units.force, run.units.force_unit))

    def test_motions(self):
        along, up, turn = [1.0, 0, 0], [0, 1.0, 0], [0, 0, 1.0]
        self.assertEqual(self.found(x=("motion", along, lambda t: -0.01 * t)), [("straight", [-1, 0], False, "motion")])
        self.assertEqual(self.found(x=("motion", along, lambda t: 0.01 * np.sin(2 * np.pi * t)))[0][2], True)
        self.assertEqual(self.found(x=("follows", along, lambda t: 0.01 * t), y=("motion", up, lambda t: 1e-3 * t)),
                         [("straight", [1, 0], False, "motion")])                    # the second is small beside it
        self.assertEqual(self.found(x=("motion", along, lambda t: 1e-4 * t)), [("straight", [1, 0], False, "motion")])     # nothing else goes
        self.assertEqual(self.found(x=("motion", along, lambda t: 1e-4 * t), angle=("motion", turn, lambda t: -t)), [("turn", [-1], False, "motion")])
        self.assertEqual(self.found(x=("motion", along, lambda t: 1e-5 * t)), [])   # small beside the view
        self.assertEqual(self.found(x=("force", along, lambda t: 0.01 * t)), [])    # without a force, free
        self.assertEqual(self.found(angle=("motion", turn, lambda t: -t)), [("turn", [-1], False, "motion")])
        self.assertEqual(self.found(angle=("force", turn, lambda t: -t)), [("turn", [-1], False, "free turn")])     # it idles
        self.assertEqual(self.found(angle=("force", turn, lambda t: 0.1 * t)), [])
        self.assertEqual(drives.arrows(self.run_with(), 40.0), [])                  # of older files

    def test_around(self):
        """A way around something is one of its own, drawn where it is if all of it is in the view."""
        angle, run = np.linspace(0, 0.5 * np.pi, 9), self.run_with(x=("motion", [1.0, 0, 0], lambda t: 0.01 * t))
        run.tools = [Outline("roller", t, run.tools[0].points + 10 * np.array([np.sin(a), np.cos(a)])) for t, a in zip(np.linspace(0, 1, 9), angle)]
        (arrow,) = drives.arrows(run, 40.0)
        self.assertEqual((arrow.shape.kind, len(arrow.shape.points)), (drives.AROUND, 9))
        low, high = arrow.shape.points.min(), arrow.shape.points.max()
        self.assertEqual([arrows.fitting(arrow.shape, (low - 1, end, low - 1, end)).kind for end in (high + 1, high - 1)], [drives.AROUND, drives.WAY])

    def test_beyond_symmetry(self):
        """A tool that is drawn back through the line of symmetry is not seen, one that reaches over it is."""
        box = np.array([[0.0, 0], [2, 0], [2, 1], [0, 1], [0, 0]])
        given = [Outline(str(x), 0.0, box + [x, 1.0]) for x in (-2.0, -1.0, 3.0)]
        mesh = Triangulation([0.0, 1, 0], [0.0, 0, 1])
        self.assertEqual([o.name for o in own_side(given, mesh, [(-1, 1)])], ["-1.0", "3.0"])
        self.assertEqual(own_side(given, mesh, ()), given)

    def test_supports_apart(self):
        places = spread(np.column_stack([np.zeros(101), np.linspace(1, 0, 101)]), 0.25)
        np.testing.assert_allclose(places[:, 1], [0, 0.25, 0.5, 0.75, 1])

    def test_how_far(self):
        """A motion and its way back say the length, a turn the angle; of the only coordinate of a tool it is what the outlines of the tool went."""
        along, turn = [1.0, 0, 0], [0, 0, 1.0]
        length = lambda number: units.amount(number, Run(str(FINISHED)).units.length_unit)
        text = lambda **given: [a.text for a in drives.arrows(self.run_with(**given), 40.0)]
        self.assertEqual(text(x=("motion", along, lambda t: 0.01 * t), angle=("motion", turn, lambda t: -t)), [length(10), "57.3°"])
        self.assertEqual(text(x=("motion", along, lambda t: 0.01 * np.sin(2 * np.pi * t)), angle=("motion", turn, lambda t: 0.1 * t))[0][-10:], ", and back")
        run = self.run_with(x=("motion", along, lambda t: 0.01 * t))
        run.tools = [Outline("roller", t, o.points + [3.0 * t**2, 4.0 * t**2]) for o in run.tools[:1] for t in (0.0, 0.5, 1.0)]
        self.assertEqual([a.text for a in drives.arrows(run, 40.0)], [length(5)])

    def test_nothing_is_covered(self):
        """Neither the value nor the arrow lies on a node, an outline or the other arrow."""
        run = Run(str(FINISHED))
        run.summary["drive"]["angle"]["force"] = 900.0
        figure = start_figure(run)
        figure.draw_without_rendering()
        axes = figure.axes[0]
        nodes = axes.transData.transform(run.units.length * run.field.points)
        rim = axes.transData.transform(np.vstack([o.points for o in at_time(run.tools, 0)]))
        boxes = [text.get_window_extent() for text in axes.texts if text.get_text()]
        self.assertEqual(len(boxes), 2)
        self.assertFalse(boxes[0].overlaps(boxes[1]))
        for box in boxes:
            self.assertFalse(any(box.contains(*place) for place in (*nodes, *rim)))
            self.assertTrue(axes.get_window_extent().containsx(box.x0) and axes.get_window_extent().containsx(box.x1))


if __name__ == "__main__":
    unittest.main(verbosity=2)
