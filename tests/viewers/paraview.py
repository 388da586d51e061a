"""The files of tests/support/press.edp as VTK, and so ParaView, takes them:  paraview.py FOLDER  with the runs of paraview.sh."""
import sys
import unittest
from pathlib import Path
from xml.etree import ElementTree

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "cases"))
import numpy as np
import vtk
from plotting.vtu import read_vtu
from vtk.util.numpy_support import vtk_to_numpy

FOLDER = Path(sys.argv.pop(1))
complaints = []


def read(path):
    reader = (vtk.vtkXMLUnstructuredGridReader if path.suffix == ".vtu" else vtk.vtkXMLPolyDataReader)()
    reader.AddObserver("ErrorEvent", lambda *_: complaints.append(str(path)))
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def points(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def array(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def warped(data):
    """As the filter Warp By Vector of ParaView leaves it."""
    warp = vtk.vtkWarpVector()
    warp.SetInputData(data)
    warp.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, "displacement")
    warp.Update()
    return warp.GetOutput()


class Files(unittest.TestCase):
    def test_every_file_of_the_series(self):
        for run in ("run", "damage"):
            for entry in ElementTree.parse(FOLDER / run / "fields.pvd").findall("Collection/DataSet"):
                data = read(FOLDER / run / entry.get("file"))
                self.assertGreater(data.GetNumberOfCells(), 0, entry.get("file"))
                self.assertEqual(data.GetPoints().GetDataType(), vtk.VTK_DOUBLE)
                for k in range(data.GetPointData().GetNumberOfArrays()):
                    self.assertTrue(np.isfinite(vtk_to_numpy(data.GetPointData().GetArray(k))).all())
        self.assertEqual(read(FOLDER / "run/supports.vtp").GetNumberOfVerts(), 33)
        self.assertEqual(complaints, [])

    def test_same_numbers_as_our_reader(self):
        path = FOLDER / "run/fields-4.vtu"
        data, ours = read(path), read_vtu(str(path))
        np.testing.assert_array_equal(points(data)[:, :2], ours.points)
        for name in ("displacement", "stress", "stress_eq", "plastic_strain_eq", "stress_error"):
            self.assertEqual(data.GetPointData().GetArray(name).GetDataType(), vtk.VTK_DOUBLE)
            np.testing.assert_array_equal(array(data, name), ours.data[name], name)
        size = vtk.vtkCellSizeFilter()
        size.SetInputData(data)
        size.Update()
        area = vtk_to_numpy(size.GetOutput().GetCellData().GetArray("Area"))
        np.testing.assert_allclose(area.sum(), 0.02 * 0.01, rtol=1e-12)

    def test_stress_is_a_tensor(self):
        data = read(FOLDER / "run/fields-4.vtu")
        self.assertEqual(data.GetPointData().GetTensors().GetName(), "stress")
        names = [data.GetPointData().GetTensors().GetComponentName(k) for k in range(6)]
        self.assertEqual(names, ["XX", "YY", "ZZ", "XY", "YZ", "XZ"])
        glyph, sphere = vtk.vtkTensorGlyph(), vtk.vtkSphereSource()
        glyph.SetInputData(data)
        glyph.SetSourceConnection(sphere.GetOutputPort())
        glyph.Update()
        self.assertGreater(glyph.GetOutput().GetNumberOfPoints(), data.GetNumberOfPoints())

    def test_warped_together(self):
        """Workpiece and surface meet where they are deformed; the tools stay, and none is inside the workpiece."""
        body, surface, tools = (warped(read(FOLDER / f"run/{name}")) for name in ("fields-4.vtu", "surface-4.vtp", "tools-4.vtp"))
        place = {tuple(p) for p in points(body)}
        self.assertTrue(all(tuple(p) in place for p in points(surface)))
        np.testing.assert_array_equal(points(tools), points(read(FOLDER / "run/tools-4.vtp")))
        touching = np.isin(array(surface, "state"), (1, 2, 3))
        self.assertGreaterEqual(touching.sum(), 3)
        roller = points(tools)[vtk_to_numpy(tools.GetLines().GetConnectivityArray())[:tools.GetCell(0).GetNumberOfPoints()]]
        for p in points(surface)[touching]:
            a, b = roller[:-1], roller[1:]
            part = np.clip(((p - a) * (b - a)).sum(1) / ((b - a)**2).sum(1), 0, 1)[:, None]
            self.assertLess(np.hypot(*(p - a - part * (b - a))[:, :2].T).min(), 1e-5)  # m

    def test_tools_move(self):
        """The roller goes 2 mm in a unit of time, from t = 0.5 on: the centers of the circles that fit its outlines."""
        entries = ElementTree.parse(FOLDER / "run/fields.pvd").findall("Collection/DataSet[@part='1']")
        times, centers = [float(entries[k].get("timestep")) for k in (2, 4)], []
        for k in (2, 4):
            tools = read(FOLDER / f"run/tools-{k}.vtp")
            x, y = points(tools)[:tools.GetCell(0).GetNumberOfPoints(), :2].T
            terms = np.column_stack([2 * x, 2 * y, np.ones_like(x)])
            centers.append(np.linalg.lstsq(terms, x**2 + y**2, rcond=None)[0][:2])
        np.testing.assert_allclose(centers[1][0] - centers[0][0], 2e-3 * (times[1] - times[0]), rtol=1e-4)

    def test_integrity_where_damage_is_defined(self):
        self.assertLessEqual(array(read(FOLDER / "damage/final.vtu"), "integrity").max(), 1)
        self.assertFalse(read(FOLDER / "run/final.vtu").GetPointData().HasArray("integrity"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
