"""What a run wrote, read when a picture asks for it: a file that is missing or broken spoils no picture that does
without it."""
import os
from functools import cached_property
from xml.etree import ElementTree

import numpy as np

from plotting import contact, maps
from plotting.inputs import (InputError, MissingInput, header_of, option, read_summary, read_text, read_whole_table)
from plotting.tools import read_tools
from plotting.units import LENGTHS, describe, named, neutral
from plotting.vtp import read_vtp
from plotting.vtu import read_vtu


class Run:
    """Results in a folder. Lengths of mesh and tools are in units.length_unit, those of the tables as in the files.

    mu       name of the option with the coefficient of friction, None: unknown
    given    columns of the history that the case describes itself, see units.describe
    """

    FILES = ("summary.json", "history.csv", "events.csv", "surface.csv", "final.vtu")  # of every case

    def __init__(self, folder, mu=None, given=None):
        if not os.path.isdir(folder):
            raise InputError(f"{folder}: no such folder")
        self.folder, self.given = folder, given
        self.mu = option(self.summary, mu) if mu else None

    def path(self, name):
        return os.path.join(self.folder, name)

    def has(self, name):
        return os.path.isfile(self.path(name))

    @cached_property
    def summary(self):
        return read_summary(self.path("summary.json"))

    @cached_property
    def history(self):
        """{column: array}"""
        return read_whole_table(self.path("history.csv"))

    @cached_property
    def columns(self):
        """{column: Column} of the history."""
        names = list(self.history)
        if self.said:
            return describe(names, self.units, self.given)
        return describe(names, neutral(1.0, 1.0, self.axisymmetric), self.given, LENGTHS)

    @cached_property
    def events(self):
        return read_whole_table(self.path("events.csv"), ("event", "tool"), rows=0)

    @cached_property
    def surface(self):
        """Contact surface; a file with polar angles in place of the tools gets the name of the only tool."""
        path = self.path("surface.csv")
        words = [name for name in ("state", "tool") if name in header_of(path)]
        table = read_whole_table(path, words, rows=2)
        if "tool" not in table:
            names = {outline.name for outline in self.tools}
            touching = contact.touching(table)
            table["tool"] = np.where(touching, names.pop() if len(names) == 1 else "the tools", "")
        return table

    @cached_property
    def field(self):
        """Nodal fields at the end."""
        return self.read_field(self.path("final.vtu"))

    def read_field(self, path):
        return read_vtu(path, ("displacement",))

    @cached_property
    def mesh(self):
        return maps.deformed(self.field, self.units.length)

    @cached_property
    def supports(self):
        """(places n x 2, whether x and y are fixed n x 2) of the nodes that are held, in the files' unit; none if no file says it."""
        path = self.path("supports.vtp")
        if not os.path.isfile(path):
            return np.empty((0, 2)), np.empty((0, 2), bool)
        points = read_vtp(path)
        return points.points[:, :2], points.data["fixed"] > 0

    @cached_property
    def said_symmetry(self):
        """The script's rcSymmetry: names of the axes across its lines or planes of symmetry."""
        try:
            return str(self.summary.get("symmetry", ""))
        except InputError:
            return ""

    @cached_property
    def mirrors(self):
        """Signs of x and y for the parts that symmetry leaves out: (-1, 1) where the left half is; the axis of a ring is such a line, too."""
        half = [self.axisymmetric or "x" in self.said_symmetry, "y" in self.said_symmetry]
        signs = [(-1, 1)] * half[0] + [(1, -1)] * half[1]
        return signs + [(-1, -1)] * (len(signs) == 2)

    @cached_property
    def tools(self):
        path = self.path("tools.csv")
        return read_tools(path, self.units.length) if os.path.isfile(path) else []

    @property
    def tool_names(self):
        return list(dict.fromkeys(outline.name for outline in self.tools))

    @cached_property
    def frames(self):
        """[(t, {"workpiece": path, "tools": path, "contact surface": path})] of the series, that of the start first."""
        path = self.path("fields.pvd")
        return read_frames(path) if os.path.isfile(path) else []

    @cached_property
    def series(self):
        """(t, path) of the field files on the way."""
        return [(t, parts["workpiece"]) for t, parts in self.frames if t > 0]

    @cached_property
    def t(self):
        """Where the run ended, None if no file says it."""
        if self.has("history.csv"):
            return self.history["t"][-1]
        try:
            return float(self.summary["final"]["t"])
        except (InputError, KeyError, TypeError, ValueError):
            return None

    @cached_property
    def axisymmetric(self):
        """None if no file says it."""
        try:
            return bool(self.summary["mesh"]["axisymmetric"])
        except (InputError, KeyError, TypeError):
            return None

    @cached_property
    def in_space(self):
        """Whether the point of the summary's moments has three numbers."""
        try:
            return len(self.summary["balance"]["moment_point"]) == 3
        except (InputError, KeyError, TypeError):
            return False

    @cached_property
    def said(self):
        """Units of lengths and stresses that the script has said, rcUnits; None: unknown."""
        try:
            return self.summary["units"]["length"], self.summary["units"]["stress"]
        except (InputError, KeyError, TypeError):
            return None

    @cached_property
    def units(self):
        if self.said:
            return named(*self.said, whole=self.axisymmetric)
        return neutral(self.size(), self.largest_stress(), self.axisymmetric)

    def size(self):
        """Larger side of the workpiece in the file's unit, 1 if there is none."""
        if self.has("final.vtu"):
            return np.ptp(self.field.points, axis=0).max()
        if self.has("surface.csv"):
            table = read_whole_table(self.path("surface.csv"), ("state", "tool"), rows=2)
            return max(np.ptp(table["X"]), np.ptp(table["Y"]))
        return 1.0

    def largest_stress(self):
        """Of the whole run, in the file's unit; 1 if there is none."""
        if self.has("history.csv") and "stress_eq_max" in self.history:
            return np.nanmax(self.history["stress_eq_max"], initial=0.0)
        return np.nanmax(self.field.data["stress_eq"], initial=0.0) if self.has("final.vtu") else 1.0

    def result(self, name):
        """Value of a result of the summary."""
        try:
            return self.summary["results"][name]["value"]
        except KeyError:
            raise MissingInput(f"{self.path('summary.json')}: no result {name!r}") from None


def read_frames(path):
    """(t, {name of the part: path}) of the files that a ParaView collection names and that are there."""
    frames = {}
    try:
        for entry in ElementTree.fromstring(read_text(path)).findall("Collection/DataSet"):
            file = os.path.join(os.path.dirname(path), entry.get("file"))
            if os.path.isfile(file):
                frames.setdefault(float(entry.get("timestep")), {})[entry.get("name", "workpiece")] = file
    except (ElementTree.ParseError, TypeError, ValueError) as error:
        raise InputError(f"{path}: {error}") from None
    return [(t, parts) for t, parts in sorted(frames.items()) if "workpiece" in parts]
