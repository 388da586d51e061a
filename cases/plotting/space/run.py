"""A run in space: its frames, its units, the directions that its pictures look along."""
from functools import cached_property

import numpy as np

from plotting import units as u
from plotting.inputs import MissingInput
from plotting.run import Run
from plotting.space import files

AXES = "xyz"
ALONG_AXIS = 0.999  # part of a direction from which it is an axis


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
    def undeformed(self):
        return files.read_body(self.path("final.vtu"), 1.0)

    def size(self):
        return np.ptp(self.undeformed.points, axis=0).max() if self.has("final.vtu") else 1.0

    def largest_stress(self):
        return self.undeformed.data["stress_eq"].max() if self.has("final.vtu") else 1.0

    def frame(self, k):
        if not self.frames:
            raise MissingInput(f"{self.path('fields.pvd')}: no frames; -series gives some")
        t, parts = self.frames[k]
        return files.read_frame(t, parts, self.units.length)

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

    def tool_name(self, number):
        """From the summary, which has the tools in their order."""
        names = list((self.summary.get("balance") or {}).get("contact") or {})
        return names[number] if number < len(names) else f"tool {number}"

    @cached_property
    def up(self):
        """From the workpiece to the tools: against the sum of the tractions of the last frame with some; z without any."""
        for k in range(len(self.frames) - 1, -1, -1):
            surface = self.frame(k).surface
            if surface and files.touching(surface).any():
                traction = surface.data["traction"]
                pull, all_of_it = -traction.sum(axis=0), np.abs(traction).sum(axis=0)
                if np.abs(pull).max() < 0.01 * all_of_it.max():  # tools on two sides: upward along their normals
                    return np.eye(3)[np.argmax(all_of_it)]
                return unit(np.eye(3)[np.argmax(np.abs(pull))] * np.sign(pull[np.argmax(np.abs(pull))]))
        return np.array([0.0, 0.0, 1.0])

    @cached_property
    def along(self):
        """Across `up`, the axis along which the tools go most; of tools that go nowhere the longer one of the workpiece."""
        ways = [np.ptp(track, axis=0) for track in self.tracks.values()]
        size = np.ptp(self.last.body.points, axis=0)
        way = np.max(ways, axis=0) * (np.abs(self.up) < 0.5) if ways else np.zeros(3)
        chosen = way if way.max() > 1e-3 * size.max() else size * (np.abs(self.up) < 0.5)
        direction = np.eye(3)[np.argmax(chosen)]
        track = max(self.tracks.values(), key=lambda places: np.ptp(places @ direction), default=np.zeros((1, 3)))
        return -direction if (track[-1] - track[0]) @ direction < -1e-9 else direction


def unit(vector):
    return vector / np.linalg.norm(vector)
