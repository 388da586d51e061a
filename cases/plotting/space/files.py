"""The files of a run in space as arrays: workpiece, contact surface and tools of a frame. VTK reads them (python3-vtk9)."""
import os
from collections import namedtuple
from functools import lru_cache

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLogger
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

from plotting.inputs import InputError, MissingInput
from plotting.space import grids, mirror
from plotting.vtp import read_cell_data

vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)  # what is wrong with a file, `read` says

# Faces of a tetrahedron: corners, then the nodes between them, in the order of VTK
FACES = np.array([[0, 1, 3, 4, 8, 7], [1, 2, 3, 5, 9, 8], [2, 0, 3, 6, 7, 9], [0, 2, 1, 6, 5, 4]])
PARTS = np.array([[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]])  # triangles of a quadratic face
IN_CONTACT = (1, 2, 3)                                          # states: touched, sliding, sticking

# points: present places n x 3; triangles; data: {name: n or n x components}; cells: {name: of the triangles}
Surface = namedtuple("Surface", "points triangles data cells")
# faces: outer ones, m x 3 or m x 6; lines: edges of the elements that were computed; vtk: the undeformed grid, in the file's unit
Body = namedtuple("Body", "points faces lines data vtk")
Frame = namedtuple("Frame", "t body surface tools")


def read(path, reader):
    """What VTK reads of a file that must be whole."""
    if not os.path.isfile(path):
        raise MissingInput(f"{path}: missing")
    complaints = []
    for part in (reader, reader.GetExecutive()):  # instead of a text of VTK
        part.AddObserver("ErrorEvent", lambda *_: complaints.append(path))
    reader.SetFileName(path)
    reader.Update()
    if complaints or reader.GetOutput().GetNumberOfPoints() == 0:
        raise InputError(f"{path}: not a whole file of VTK")
    return reader.GetOutput()


def arrays(attributes):
    return {attributes.GetArrayName(k): vtk_to_numpy(attributes.GetArray(k)) for k in range(attributes.GetNumberOfArrays())}


def outer_faces(cells):
    """Faces that belong to one tetrahedron only. cells: m x 4 or m x 10"""
    faces = cells[:, FACES[:, :3 if cells.shape[1] == 4 else 6]].reshape(-1, 3 if cells.shape[1] == 4 else 6)
    corners = np.sort(faces[:, :3], axis=1).astype(np.int64)
    numbers = np.ravel_multi_index(corners.T[:2], [corners.max() + 1] * 2)  # one for two: sorting rows is slow
    _, pairs = np.unique(numbers, return_inverse=True)
    _, first, count = np.unique(pairs * (corners.max() + 1) + corners[:, 2], return_index=True, return_counts=True)
    return faces[np.sort(first[count == 1])]


@lru_cache(maxsize=2)
def body_arrays(path):
    """(points, cells, data, vtk's grid) of a workpiece, in the file's unit; those of a picture are asked for more than once."""
    grid = read(path, vtkXMLUnstructuredGridReader())
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(grid.GetNumberOfCells(), -1)
    if cells.shape[1] not in (4, 10):
        raise InputError(f"{path}: elements of {cells.shape[1]} nodes, expected tetrahedra of 4 or 10")
    data, points = arrays(grid.GetPointData()), vtk_to_numpy(grid.GetPoints().GetData())
    if "displacement" not in data:
        raise MissingInput(f"{path}: no nodal data displacement")
    return points, cells, data, grid


@lru_cache(maxsize=4)
def surface_arrays(path):
    """(points where they are, triangles, data, data of the triangles), in the file's unit."""
    surface = read(path, vtkXMLPolyDataReader())
    data, cells = arrays(surface.GetPointData()), arrays(surface.GetCellData())
    points = vtk_to_numpy(surface.GetPoints().GetData()) + data["displacement"]
    return points, vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3), data, cells


def read_body(path, scale, symmetry=()):
    """scale: from the file's unit of length to that of the picture; symmetry: [(axis, side)] of the planes in which it is
    reflected (mirror.py)."""
    points, cells, data, grid = body_arrays(path)
    computed = len(points)
    for axis, _ in symmetry:
        points, cells, data = mirror.doubled(points, cells, data, axis)
    faces = outer_faces(cells)
    lines = edges_of(faces)
    return Body(scale * (points + data["displacement"]), faces, lines[(lines < computed).all(axis=1)], data,
                grids.tetrahedra(points, cells, data) if symmetry else grid)


def read_surface(path, scale, symmetry=()):
    """Triangles where they are: of the contact surface or, where the cells know their tool, the tools."""
    points, triangles, data, cells = surface_arrays(path)
    for axis, side in symmetry:
        if "tool" in cells:
            points, triangles, cells = mirror.doubled_tools(points, triangles, cells, axis, side)
        else:
            points, triangles, data = mirror.doubled(points, triangles, data, axis)
    return Surface(scale * points, triangles, data, cells)


def read_origins(path):
    """(number, origin of its frame in the file's unit) of every tool."""
    cells = read_cell_data(path)  # of every frame: a third of what VTK takes for the whole file
    numbers, first = np.unique(cells["tool"], return_index=True)
    return [(int(number), cells["origin"][k]) for number, k in zip(numbers, first)]


def read_frame(t, parts, scale, symmetry=()):
    """parts: {"workpiece": path, "tools": path, "contact surface": path}; a part that is not there is None."""
    some = {name: read_surface(parts[name], scale, symmetry) if name in parts else None for name in ("contact surface", "tools")}
    return Frame(t, read_body(parts["workpiece"], scale, symmetry), some["contact surface"], some["tools"])


def triangles_of(faces):
    return faces if faces.shape[1] == 3 else faces[:, PARTS].reshape(-1, 3)


def edges_of(faces):
    """Pairs of neighboring nodes on the edges of the elements."""
    ring = (0, 1, 2, 0) if faces.shape[1] == 3 else (0, 3, 1, 4, 2, 5, 0)
    return np.unique(np.sort(np.vstack([faces[:, [a, b]] for a, b in zip(ring, ring[1:])]), axis=1), axis=0)


def touching(surface):
    return np.isin(surface.data["state"], IN_CONTACT)


def near(tools, body, apart):
    """The tools whose box is not farther from that of the workpiece."""
    low, high, kept = body.points.min(axis=0), body.points.max(axis=0), []
    for number, points, _, _ in tool_parts(tools):
        if np.maximum(low - points.max(axis=0), points.min(axis=0) - high).max() <= apart:
            kept.append(number)
    mine = np.isin(tools.cells["tool"], kept)
    return tools._replace(triangles=tools.triangles[mine], cells={name: values[mine] for name, values in tools.cells.items()})


def tool_parts(tools):
    """(number, points, triangles, origin of its frame in the file's unit) of every tool."""
    parts = []
    for number in np.unique(tools.cells["tool"]) if tools else ():
        mine = tools.cells["tool"] == number
        nodes, triangles = np.unique(tools.triangles[mine], return_inverse=True)
        parts.append((int(number), tools.points[nodes], triangles.reshape(-1, 3), tools.cells["origin"][mine][0]))
    return parts
