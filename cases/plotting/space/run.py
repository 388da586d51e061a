"""A run in space: its frames, its units, the directions that its pictures look along."""
from functools import cached_property

import numpy as np

from plotting import units as u
from plotting.inputs import MissingInput
from plotting.run import Run
from plotting.space import files

AXES = "xyz"
FAR = 0.1      # distance of a tool over the size of the workpiece


class SpaceRun(Run):
    """The same as Run in the plane; Run.frames are paths, `frame(k)` is one that is read."""

    @cached_property
    def units(self):
        return u.named(*self.said, whole=True) if self.said else u.neutral(self.size(), self.largest_stress(), True)

    @cached_property
    def columns(self):
        if self.said:
            return u.describe(list(self.history), self.units, self.given)
        return u.describe(list(self.history), u.neutral(1.0, 1.0, True), self.given, u.LENGTHS + ("z",))

    @cached_property
    def symmetry(self):
        """[(axis, side)] of the planes of symmetry that the script names, rcSymmetry; side: where what was computed lies, 1 or -1."""
        axes = [axis for axis in range(3) if AXES[axis] in self.said_symmetry]
        middle = self.undeformed.points.mean(axis=0) if axes else None
        return [(axis, 1 if middle[axis] > 0 else -1) for axis in axes]

    @cached_property
    def undeformed(self):
        return files.read_body(self.path("final.vtu"), 1.0)

    def size(self):
        return np.ptp(self.undeformed.points, axis=0).max() if self.has("final.vtu") else 1.0

    def largest_stress(self):
        return self.undeformed.data["stress_eq"].max() if self.has("final.vtu") else 1.0

    def frame(self, k, symmetry=None):
        """The whole workpiece, or reflected only in the planes `symmetry`."""
        if not self.frames:
            raise MissingInput(f"{self.path('fields.pvd')}: no frames; -series gives some")
        t, parts = self.frames[k]
        return files.read_frame(t, parts, self.units.length, self.symmetry if symmetry is None else symmetry)

    def view(self, k):
        """A frame as it is seen: open along the plane of symmetry that faces the viewer."""
        return self.frame(k, [plane for plane in self.symmetry if plane[0] != self.cut])

    def close_view(self, k):
        """The same without tools that are far from the workpiece."""
        frame = self.view(k)
        return frame._replace(tools=frame.tools and files.near(frame.tools, frame.body, FAR * np.ptp(frame.body.points, axis=0).max()))

    @cached_property
    def last(self):
        return self.frame(-1)

    @cached_property
    def first(self):
        return self.frame(0)

    @cached_property
    def tracks(self):
        """{tool: places of its frame's origin in all frames}"""
        tracks = {}
        for _, parts in self.frames:
            for number, origin in files.read_origins(parts["tools"]) if "tools" in parts else ():
                tracks.setdefault(number, []).append(self.units.length * origin)
        return {number: np.array(places) for number, places in tracks.items()}

    @cached_property
    def riders(self):
        """Numbers of the tools whose pull on the workpiece, where they touch last, is across their way; others push its end."""
        pulls = {}
        for surface in (files.read_surface(parts["contact surface"], 1.0) for _, parts in self.frames if "contact surface" in parts):
            for number in self.tracks:
                mine = files.touching(surface) & (surface.data["tool"] == number)
                if mine.any():
                    pulls[number] = np.abs(surface.data["traction"][mine].sum(axis=0))
        return {number for number, pull in pulls.items() if pull @ np.abs(self.up) > pull @ np.abs(self.along)}

    @property
    def tool_names(self):
        """From the summary, which has the tools in their order."""
        return list((self.summary.get("balance") or {}).get("contact") or {})

    def tool_name(self, number):
        return self.tool_names[number] if number < len(self.tool_names) else f"tool {number}"

    @cached_property
    def up(self):
        """From the workpiece to the tools: against the sum of the tractions of the last frame with some; z without any."""
        for k in range(len(self.frames) - 1, -1, -1):
            surface = self.frame(k, ()).surface  # of what was computed: reflected, its tractions cancel
            if surface and files.touching(surface).any():
                traction = surface.data["traction"]
                pull, all_of_it = -traction.sum(axis=0), np.abs(traction).sum(axis=0)
                if np.abs(pull).max() < 0.01 * all_of_it.max():  # tools on two sides: upward along their normals
                    return np.eye(3)[np.argmax(all_of_it)]
                return unit(np.eye(3)[np.argmax(np.abs(pull))] * np.sign(pull[np.argmax(np.abs(pull))]))
        return np.array([0.0, 0.0, 1.0])

    @cached_property
    def front(self):
        """Horizontally to the viewer: the tools go to the right."""
        return np.cross(self.along, self.up)

    @cached_property
    def cut(self):
        """The axis across the plane of symmetry behind which what was computed lies for the viewer; None without one."""
        return next((axis for axis, side in self.symmetry if side * self.front[axis] < -0.5), None)

    @cached_property
    def along(self):
        """Across `up`, the axis along which the tools go most; of tools that go nowhere the longer one of the workpiece, turned so that a
        plane of symmetry faces the viewer."""
        ways = [np.ptp(track, axis=0) for track in self.tracks.values()]
        size = np.ptp(self.last.body.points, axis=0)
        way = np.max(ways, axis=0) * (np.abs(self.up) < 0.5) if ways else np.zeros(3)
        chosen = way if way.max() > 1e-3 * size.max() else size * (np.abs(self.up) < 0.5)
        direction = np.eye(3)[np.argmax(chosen)]
        track = max(self.tracks.values(), key=lambda places: np.ptp(places @ direction), default=np.zeros((1, 3)))
        if chosen is not way:
            return -direction if any(side * np.cross(direction, self.up)[axis] > 0.5 for axis, side in self.symmetry) else direction
        return -direction if (track[-1] - track[0]) @ direction < -1e-9 else direction


def unit(vector):
    return vector / np.linalg.norm(vector)
