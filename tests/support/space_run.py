"""Files of a run in space as the core writes them, small: a cube of six tetrahedra is pressed by a plane that goes along x.

space_run.py FOLDER
"""
import itertools
import json
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_QUADRATIC_TETRA, VTK_TETRA, vtkCellArray, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter

FRAMES = 4
DEPTH = 0.1   # at the end
EDGES = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))  # of VTK_QUADRATIC_TETRA


def cube(quadratic):
    """(points, cells) of the unit cube."""
    points = [list(map(float, p)) for p in itertools.product((0, 1), repeat=3)]
    cells, middle = [], {}
    for order in itertools.permutations(range(3)):
        corner, cell = [0, 0, 0], [0]
        for axis in order:
            corner[axis] = 1
            cell.append(4 * corner[0] + 2 * corner[1] + corner[2])
        if np.linalg.det(np.diff(np.array(points)[cell], axis=0)) < 0:
            cell[1], cell[2] = cell[2], cell[1]
        for a, b in EDGES if quadratic else ():
            key = frozenset((cell[a], cell[b]))
            if key not in middle:
                middle[key] = len(points)
                points.append(list(0.5 * (np.array(points[cell[a]]) + points[cell[b]])))
            cell.append(middle[key])
        cells.append(cell)
    return np.array(points), np.array(cells)


def set_all(data, points, cells, attach, arrays, of_cells=()):
    places, array = vtkPoints(), vtkCellArray()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points, float), deep=True))
    data.SetPoints(places)
    offsets = np.arange(0, cells.size + 1, cells.shape[1], dtype=np.int64)
    array.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(cells.astype(np.int64).ravel(), deep=True))
    attach(array)
    for where, some in ((data.GetPointData(), arrays), (data.GetCellData(), dict(of_cells))):
        for name, values in some.items():
            made = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
            made.SetName(name)
            where.AddArray(made)


def write(data, writer, path):
    writer.SetInputData(data)
    writer.SetFileName(path)
    writer.SetDataModeToBinary()   # as the core writes
    writer.SetHeaderTypeToUInt64()
    writer.SetCompressorTypeToNone()
    writer.Write()


def write_body(path, t, quadratic):
    points, cells = cube(quadratic)
    grid, kind = vtkUnstructuredGrid(), VTK_QUADRATIC_TETRA if quadratic else VTK_TETRA
    x, _, z = points.T
    displacement = np.column_stack([0 * x, 0 * x, -DEPTH * t * z])
    set_all(grid, points, cells, lambda array: grid.SetCells(kind, array),
            {"displacement": displacement, "stress_eq": t * x, "plastic_strain_eq": 0.1 * t * z})
    write(grid, vtkXMLUnstructuredGridWriter(), path)


def write_frame(folder, k, t, quadratic):
    write_body(f"{folder}/fields-{k}.vtu", t, quadratic)
    corners, cells = np.array([[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1.0]]), np.array([[0, 1, 2], [0, 2, 3]])
    touches, none = float(t > 0), np.zeros((4, 3))
    surface, tools = vtkPolyData(), vtkPolyData()
    set_all(surface, corners, cells, surface.SetPolys,
            {"displacement": none + [0, 0, -DEPTH * t], "state": np.full(4, 3 * (t > 0)), "tool": np.zeros(4, int),
             "pressure": np.array([1, 2, 2, 1]) * touches, "traction_tangential": none + [0.2 * touches, 0, 0],
             "traction": none + [0.2 * touches, 0, -touches]})
    write(surface, vtkXMLPolyDataWriter(), f"{folder}/surface-{k}.vtp")
    place = np.array([0.3 * t, 0, 1 - DEPTH * t])
    set_all(tools, 3 * corners - [1, 1, 3] + place, cells, tools.SetPolys, {"displacement": none},
            {"tool": np.zeros(2, int), "origin": np.array([place, place])})
    write(tools, vtkXMLPolyDataWriter(), f"{folder}/tools-{k}.vtp")


def write_run(folder, quadratic=True):
    os.makedirs(folder, exist_ok=True)
    lines = []
    for k in range(FRAMES):
        t = k / (FRAMES - 1)
        write_frame(folder, k, t, quadratic)
        lines += [f'<DataSet timestep="{t}" part="{part}" name="{name}" file="{file}-{k}.{kind}"/>' for part, (name, file, kind) in
                  enumerate((("workpiece", "fields", "vtu"), ("tools", "tools", "vtp"), ("contact surface", "surface", "vtp")))]
    write_body(f"{folder}/final.vtu", 1, quadratic)
    with open(f"{folder}/fields.pvd", "w") as file:
        file.write('<VTKFile type="Collection"><Collection>' + "".join(lines) + "</Collection></VTKFile>")
    with open(f"{folder}/summary.json", "w") as file:
        json.dump({"status": "finished", "final": {"t": 1}, "balance": {"moment_point": [0, 0, 0], "contact": {"plate": [0] * 6}}}, file)
    with open(f"{folder}/history.csv", "w") as file:
        file.write("t,x,z,Q_x,Q_z,contact,sticking,sliding,plate_Fz\n0,0,1,0,0,0,0,0,0\n1,0.3,0.9,0.2,-1,4,4,0,-1\n")


if __name__ == "__main__":
    write_run(sys.argv[1])
