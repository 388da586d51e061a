"""Arrays as data of VTK (python3-vtk9), and what it does with them."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_QUADRATIC_TETRA, VTK_TETRA, vtkCellArray, vtkPlane, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkClipPolyData, vtkCutter, vtkTriangleFilter


def places_of(points):
    places = vtkPoints()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points, float), deep=True))
    return places


def array_of(cells):
    """vtkCellArray of cells of equal size."""
    array = vtkCellArray()
    array.SetData(numpy_to_vtkIdTypeArray(np.arange(0, cells.size + 1, cells.shape[1], dtype=np.int64), deep=True),
                  numpy_to_vtkIdTypeArray(np.ascontiguousarray(cells, np.int64).ravel(), deep=True))
    return array


def poly(points, cells, kind="polys"):
    """vtkPolyData of polygons or lines of equal size."""
    data = vtkPolyData()
    data.SetPoints(places_of(points))
    (data.SetPolys if kind == "polys" else data.SetLines)(array_of(cells))
    return data


def tetrahedra(points, cells, data):
    """vtkUnstructuredGrid with data at its nodes: {name: n or n x components}."""
    grid = vtkUnstructuredGrid()
    grid.SetPoints(places_of(points))
    grid.SetCells(VTK_TETRA if cells.shape[1] == 4 else VTK_QUADRATIC_TETRA, array_of(cells))
    for name, values in data.items():
        given = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        given.SetName(name)
        grid.GetPointData().AddArray(given)
    return grid


def clipped(data, normal):
    """What of vtkPolyData lies on the side of the plane through 0 to which the normal points; all of it without a normal."""
    if normal is None:
        return data
    plane, clip = vtkPlane(), vtkClipPolyData()
    plane.SetNormal(*normal)
    clip.SetClipFunction(plane)
    clip.SetInputData(data)
    clip.Update()
    return clip.GetOutput()


def cut(data, point, normal):
    """Where a plane cuts it."""
    cutter, plane = vtkCutter(), vtkPlane()
    plane.SetOrigin(*point)
    plane.SetNormal(*normal)
    cutter.SetCutFunction(plane)
    cutter.SetInputData(data)
    cutter.GenerateTrianglesOn()
    cutter.Update()
    return cutter.GetOutput()


def clipped_triangles(points, triangles, normal):
    """(points, triangles) of the same."""
    split = vtkTriangleFilter()
    split.SetInputData(clipped(poly(points, triangles), normal))
    split.Update()
    part = split.GetOutput()
    if not part.GetNumberOfPolys():
        return np.empty((0, 3)), np.empty((0, 3), int)
    return vtk_to_numpy(part.GetPoints().GetData()), vtk_to_numpy(part.GetPolys().GetConnectivityArray()).reshape(-1, 3)
