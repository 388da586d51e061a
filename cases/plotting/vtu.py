"""Reader of the .vtu files that FreeFEM's savevtk writes: meshio's, with errors that name the file.

savevtk writes the boundary edges as lines behind the triangles; they are dropped. Data of order 1 is nodal.
"""
import os
from collections import namedtuple

from plotting.inputs import InputError, MissingInput

# points: n x 2; triangles: m x 3, indices of points; data: {name: n or n x components}
Field = namedtuple("Field", "points triangles data")


class NodalData(dict):
    """Nodal arrays by name; one that is not there is a missing input."""

    def __init__(self, path, arrays):
        super().__init__(arrays)
        self.path = path

    def __missing__(self, name):
        raise MissingInput(f"{self.path}: no nodal data {name} (savevtk needs order 1 for each)")


def read_mesh(path):
    """meshio's mesh; whatever meshio raises is a fault of the file."""
    if not os.path.isfile(path):
        raise MissingInput(f"{path}: missing")
    try:
        from meshio import vtu  # takes long to load: runs in space do without
        return vtu.read(path)
    except ImportError as error:
        raise InputError(f"{error}; the Debian package python3-meshio is needed") from None
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    except Exception as error:
        reason = str(error) or type(error).__name__
        raise InputError(f"{path}: not a whole VTU file: {reason}") from None


def read_vtu(path, names=()):
    """Triangles and nodal data of path; names: data that must be there."""
    mesh = read_mesh(path)
    data = NodalData(path, {name: a[:, 0] if a.ndim == 2 and a.shape[1] == 1 else a
                            for name, a in mesh.point_data.items()})
    for name in names:
        data[name]
    corners = mesh.get_cells_type("triangle")
    if not len(corners):
        raise InputError(f"{path}: no triangles")
    if corners.min() < 0 or corners.max() >= len(mesh.points):
        raise InputError(f"{path}: a triangle names a point outside 0..{len(mesh.points) - 1}")
    return Field(mesh.points[:, :2].astype(float), corners, data)
