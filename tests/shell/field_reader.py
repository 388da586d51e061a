"""Unit tests of the reader of field files:  field_reader.py FOLDER  with good.vtu and element.vtu of test_field_reader.sh."""
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "cases"))
import numpy as np
from plotting.inputs import InputError, MissingInput
from plotting.vtu import read_vtu

FOLDER = Path(sys.argv.pop(1))
GOOD = (FOLDER / "good.vtu").read_bytes()


def written(name, content):
    path = FOLDER / name
    path.write_bytes(content)
    return path


def payload(name):
    """Where the numbers of an array begin and end in the good file."""
    begin = GOOD.index(b">", GOOD.index(f'Name="{name}"'.encode())) + 1
    return begin, GOOD.index(b"<", begin)


class Reader(unittest.TestCase):
    def refused(self, path, *words, kind=InputError, names=("displacement",)):
        """The error names the file and says the words."""
        with self.assertRaises(kind) as caught:
            read_vtu(path, names)
        for word in (str(path), *words):
            self.assertIn(word, str(caught.exception))

    def test_good_file(self):
        field = read_vtu(FOLDER / "good.vtu", ("displacement", "stress_eq"))
        x, y = field.points.T
        self.assertEqual(field.points.shape, (35, 2))
        self.assertEqual(field.triangles.shape, (48, 3))  # the 20 edges of the boundary are left out
        np.testing.assert_allclose((x.min(), x.max(), y.min(), y.max()), (0, 3, 0, 1))
        np.testing.assert_allclose(field.data["displacement"][:, :2], np.column_stack([2 * x, 3 * y]), atol=1e-6)
        np.testing.assert_allclose(field.data["stress_eq"], x + y, atol=1e-6)
        a, b, c = (field.points[field.triangles[:, k]] for k in range(3))
        area = 0.5 * np.abs(np.cross(b - a, c - a))
        np.testing.assert_allclose(area, 3 / 48)

    def test_missing_file(self):
        self.refused(FOLDER / "nothing.vtu", "missing", kind=MissingInput)
        self.refused(FOLDER, "missing", kind=MissingInput)

    def test_missing_array(self):
        self.refused(FOLDER / "good.vtu", "no nodal data plastic_strain_eq", kind=MissingInput,
                     names=("displacement", "plastic_strain_eq"))
        with self.assertRaises(MissingInput):
            read_vtu(FOLDER / "good.vtu").data["plastic_strain_eq"]

    def test_data_of_order_0(self):
        self.refused(FOLDER / "element.vtu", "no nodal data stress_eq", "order 1", kind=MissingInput,
                     names=("stress_eq",))

    def test_truncated(self):
        for part in range(10):
            with self.subTest(part=part):
                self.refused(written("truncated.vtu", GOOD[:len(GOOD) * part // 10]), "not a whole VTU file")
        self.refused(written("truncated.vtu", GOOD.rstrip()[:-3]), "not a whole VTU file")

    def test_array_cut_short(self):
        for name in ("displacement", "connectivity", "offsets", "types"):
            begin, end = payload(name)
            text = GOOD[begin:end].strip()
            keep = len(text) // 8 * 4  # base64 in groups of four
            with self.subTest(array=name):
                self.refused(written("short.vtu", GOOD[:begin] + text[:keep] + GOOD[end:]))

    def test_no_mesh(self):
        self.refused(written("text.vtu", b"t,x,y\n0,1,2\n"), "not a whole VTU file")
        self.refused(written("binary.vtu", bytes(range(256)) * 8), "not a whole VTU file")
        self.refused(written("empty.vtu", b""), "not a whole VTU file")
        self.refused(written("image.vtu", GOOD.replace(b"UnstructuredGrid", b"ImageData")), "not a whole VTU file")

    def test_no_triangles(self):
        head = b'<VTKFile type="UnstructuredGrid" version="0.1"><UnstructuredGrid>'
        lines = (b'<Piece NumberOfPoints="2" NumberOfCells="1"><Points><DataArray type="Float64" '
                 b'NumberOfComponents="3" format="ascii">0 0 0 1 0 0</DataArray></Points><Cells>'
                 b'<DataArray type="Int32" Name="connectivity" format="ascii">0 %d%s</DataArray>'
                 b'<DataArray type="Int32" Name="offsets" format="ascii">%d</DataArray>'
                 b'<DataArray type="UInt8" Name="types" format="ascii">%d</DataArray></Cells></Piece>')
        tail = b"</UnstructuredGrid></VTKFile>"
        self.refused(written("lines.vtu", head + lines % (1, b"", 2, 3) + tail), "no triangles", names=())
        self.refused(written("outside.vtu", head + lines % (1, b" 2", 3, 5) + tail), "outside 0..1", names=())


if __name__ == "__main__":
    unittest.main(verbosity=2)
