"""Input of CalculiX for a plane scene: one layer of wedges, out of plane nothing moves, and a rigid tool.

Nodes: front 1..n, back n+1..2n, the middles of edges across the layer, then those of the tool, reference nodes. Displacements of
the nodes behind follow those in front by equations. Forces in the deck are those of the scene times the thickness.
"""
import math

TOOL_BAND = 0.02  # thickness of the rigid band over the radius


class Deck:
    def __init__(self, path, mesh, thickness):
        self.file, self.mesh, self.thickness = open(path, "w"), mesh, thickness
        n, middles = len(mesh.xy), mesh.corners if len(mesh.elements[0]) == 6 else 0
        self.body, self.count = n, 2 * n + middles
        self.write("*NODE, NSET=NALL")
        for layer, number, z in ((0, n, 0), (n, n, thickness), (2 * n, middles, thickness / 2)):
            for k in range(number):
                self.node(layer + k, *mesh.xy[k], z)
        self.write(f"*ELEMENT, TYPE={'C3D15' if middles else 'C3D6'}, ELSET=BODY")
        for k, e in enumerate(mesh.elements):
            corners, sides = list(e[:3]), list(e[3:])
            layered = corners + [n + c for c in corners] + sides + [n + s for s in sides] + [2 * n + c for c in corners if middles]
            self.row(k + 1, *(c + 1 for c in layered))

    def write(self, *lines):
        print(*lines, sep="\n", file=self.file)

    def row(self, *numbers):
        """At most 16 numbers in a line."""
        words = [str(v) for v in numbers]
        for k in range(0, len(words), 16):
            self.write(", ".join(words[k:k + 16]) + ("," if k + 16 < len(words) else ""))

    def node(self, number, x, y, z):
        self.write(f"{number + 1}, {x:.12e}, {y:.12e}, {z:.6e}")

    def set(self, name, nodes):
        self.write(f"*NSET, NSET={name}")
        for k in range(0, len(nodes), 12):
            self.write(", ".join(str(n + 1) for n in nodes[k:k + 12]) + ",")

    def behind(self, nodes):
        """With these nodes all those across the layer."""
        n = self.body
        return sorted([*nodes, *(n + k for k in nodes), *(2 * n + k for k in nodes if 2 * n + k < self.count)])

    def tie(self, free):
        """Nodes behind move as those in front; free: nodes in front that are held otherwise."""
        self.set("PLANE", [k for k in range(self.count) if k % self.body not in free])
        self.write("*BOUNDARY", "PLANE, 3, 3", "*EQUATION")
        for k in range(self.body, self.count):
            if k % self.body not in free:
                for direction in (1, 2):
                    self.write("2", f"{k + 1}, {direction}, 1., {k % self.body + 1}, {direction}, -1.")

    def surface(self, label, near):
        """Faces SURFACE of the edges of a label whose middle is near."""
        self.write("*SURFACE, NAME=SURFACE, TYPE=ELEMENT")
        for (e, k), nodes in zip(self.mesh.edges[label], self.mesh.edge_nodes(label)):
            if near(*(self.mesh.xy[nodes[0]] + self.mesh.xy[nodes[1]]) / 2):
                self.write(f"{e + 1}, S{k + 3}")

    def tool(self, center, radius, first, last, size):
        """Rigid band of a circle from the angle first to last, its faces TOOL; reference nodes self.place and self.turn."""
        number = max(8, math.ceil((last - first) * radius / size))
        base, per = self.count, 2 * (number + 1)
        self.write("*NODE")
        for z in (0, self.thickness):
            for r in (radius, radius * (1 - TOOL_BAND)):
                for k in range(number + 1):
                    angle = first + (last - first) * k / number
                    self.node(self.count, center[0] + r * math.cos(angle), center[1] + r * math.sin(angle), z)
                    self.count += 1
        self.write("*ELEMENT, TYPE=C3D8, ELSET=BAND")
        start = len(self.mesh.elements)
        for k in range(number):
            outer, inner = base + k, base + number + 1 + k
            face = [inner, outer, outer + 1, inner + 1]
            self.row(start + k + 1, *(c + 1 for c in face), *(c + per + 1 for c in face))
        self.set("ROLLER", range(base, self.count))
        self.write("*SURFACE, NAME=TOOL, TYPE=ELEMENT", *(f"{start + k + 1}, S4" for k in range(number)))
        self.place, self.turn = self.rigid("ROLLER", center)

    def rigid(self, nodes, center):
        """Nodes that move as a rigid body: numbers of the node that moves about with it and of the one whose places are angles."""
        self.write("*NODE")
        self.node(self.count, *center, 0)
        self.node(self.count + 1, *center, 0)
        self.count += 2
        self.write(f"*RIGID BODY, NSET={nodes}, REF NODE={self.count - 1}, ROT NODE={self.count}")
        return self.count - 1, self.count

    def material(self, name, elements, E, nu, plastic=()):
        self.write(f"*MATERIAL, NAME={name}", "*ELASTIC", f"{E:.10g}, {nu:.10g}")
        if plastic:
            self.write("*PLASTIC", *(f"{stress:.10g}, {strain:g}" for stress, strain in plastic))
        self.write(f"*SOLID SECTION, ELSET={elements}, MATERIAL={name}")

    def contact(self, slope, friction):
        """Linear penalty on faces, friction with the same slope."""
        self.write("*SURFACE INTERACTION, NAME=CONTACT", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{slope:g}")
        if friction > 0:
            self.write("*FRICTION", f"{friction:g}, {slope:g}")
        self.write("*CONTACT PAIR, INTERACTION=CONTACT, TYPE=SURFACE TO SURFACE", "SURFACE, TOOL")

    def step(self, length, first, largest, lines, large):
        """One step of the program; first and largest increment."""
        self.write(f"*STEP{', NLGEOM' if large else ''}, INC=20000", "*STATIC", f"{first:g}, {length:g}, 1e-7, {largest:g}", *lines, "*END STEP")

    def close(self):
        self.file.close()
