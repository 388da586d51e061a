"""The pictures of a case. A plot.py needs three lines after its docstring:

    import os, sys
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
    from plotting.case import main; sys.exit(main(sys.argv[1:]))

main(arguments, length="m", mu=None, columns=None, pictures=(), without=())
    length    unit of the script's lengths: "m" (forces N/m, stresses Pa) or "mm" (N/mm, MPa)
    mu        name of the option that holds the friction coefficient, for the bounds in the pressure picture
    columns   {column: (label, unit, factor)} of the history, None to leave it out; see plotting/units.py
    pictures  functions of the run that return a figure, drawn after the default ones into function-name.png
    without   names of default pictures not wanted
Default pictures: stress, plastic_strain, sequence, history, pressure, expected (see DEFAULT below).
"""
import os
import signal
import sys
from xml.etree import ElementTree

from plotting import curves, fields, maps
from plotting.figure import apply_style, save
from plotting.inputs import InputError, option, read_summary, read_text, read_whole_table
from plotting.tools import read_tools
from plotting.units import SYSTEMS, describe
from plotting.vtu import read_vtu

FIELDS = ("displacement", "stress_eq", "plastic_strain_eq")


class CaseRun:
    """What a case wrote: summary, history, events, surface, field and mesh at the end [mm], tools [mm], series.

    history: {column: array}; columns: {column: Column}; series: [(t, path)] of the field files; t: where the run ended.
    """

    def __init__(self, folder, length="m", mu=None, columns=None):
        if not os.path.isdir(folder):
            raise InputError(f"{folder}: no such folder")
        path = {name: os.path.join(folder, name) for name in
                ("history.csv", "events.csv", "surface.csv", "summary.json", "final.vtu", "tools.csv", "fields.pvd")}
        self.folder, self.units = folder, SYSTEMS[length]
        self.summary = read_summary(path["summary.json"])
        self.history = read_whole_table(path["history.csv"])
        self.columns = describe(list(self.history), self.units, columns)
        self.events = read_whole_table(path["events.csv"], ("event", "tool"), rows=0)
        self.surface = read_whole_table(path["surface.csv"], ("state", "tool"), rows=2)
        self.t = self.history["t"][-1]
        self.field = self.read_field(path["final.vtu"])
        self.mesh = maps.deformed(self.field, self.units.mm)
        self.tools = read_tools(path["tools.csv"], self.units.mm) if os.path.isfile(path["tools.csv"]) else []
        self.series = read_series(path["fields.pvd"]) if os.path.isfile(path["fields.pvd"]) else []
        self.mu = option(self.summary, mu) if mu else None

    @staticmethod
    def read_field(path):
        return read_vtu(path, FIELDS)

    def result(self, name):
        """Value of a result of the summary."""
        try:
            return self.summary["results"][name]["value"]
        except KeyError:
            raise InputError(f"summary.json: no result {name!r}") from None


def read_series(path):
    """(t, path) of the files that a ParaView collection names and that are there."""
    try:
        entries = ElementTree.fromstring(read_text(path)).findall("Collection/DataSet")
        pairs = [(float(e.get("timestep")), os.path.join(os.path.dirname(path), e.get("file"))) for e in entries]
    except (ElementTree.ParseError, TypeError, ValueError) as error:
        raise InputError(f"{path}: {error}") from None
    return [(t, file) for t, file in pairs if os.path.isfile(file)]


def stress(run):
    return fields.field_figure(run, fields.STRESS, "MPa", run.units.MPa)


def plastic_strain(run):
    if not run.field.data["plastic_strain_eq"].max() > 0:
        return None
    return fields.field_figure(run, fields.STRAIN, "-", 1.0)


def sequence(run):
    plastic = run.field.data["plastic_strain_eq"].max() > 1e-3
    field, unit, factor = (fields.STRAIN, "-", 1.0) if plastic else (fields.STRESS, "MPa", run.units.MPa)
    return fields.sequence_figure(run, field, unit, factor) if len(run.series) >= 3 else None


def history(run):
    return curves.history_figure(run)


def pressure(run):
    return curves.pressure_figure(run, run.mu)


def expected(run):
    return curves.expected_figure(run)


DEFAULT = (stress, plastic_strain, sequence, history, pressure, expected)


def draw_all(run, pictures, folder):
    """Each picture into folder/function-name.png, whose path is printed; None: no picture. 1 if one could not be
    drawn."""
    apply_style()
    failed = 0
    for picture in pictures:
        name = picture.__name__.replace("_", "-")
        try:
            figure = picture(run)
            if figure is not None:
                print(save(figure, folder, name), flush=True)
        except Exception as error:  # the other pictures may still be drawn
            print(f"plot.py: {name}.png not made: {type(error).__name__}: {error}", file=sys.stderr)
            failed = 1
    return failed


def draw(arguments, read_run, pictures):
    """The body of a plot.py OUTDIR: reads the run and draws it; returns the exit code."""
    for name in (signal.SIGINT, signal.SIGPIPE):
        signal.signal(name, signal.SIG_DFL)  # stop quietly
    if len(arguments) != 1 or arguments[0].startswith("-"):
        print("usage: plot.py OUTDIR    (the folder of a run's results)", file=sys.stderr)
        return 2
    try:
        run = read_run(arguments[0])
    except InputError as error:
        print(f"plot.py: {error}", file=sys.stderr)
        return 1
    return draw_all(run, pictures, arguments[0])


def main(arguments, length="m", mu=None, columns=None, pictures=(), without=()):
    chosen = [p for p in DEFAULT if p.__name__ not in without] + list(pictures)
    return draw(arguments, lambda folder: CaseRun(folder, length, mu, columns), chosen)
