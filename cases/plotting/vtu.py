"""Reader of the .vtu files that FreeFEM's savevtk writes (iovtk): one piece, inline base64 or ascii, nodal data.

What it looks like: Float32 points with three components; triangles first, then the boundary edges as lines, which are
dropped here; one base64 stream per array, opened by the number of bytes as UInt32; data of order 1 under PointData.
"""
import base64
import binascii
from collections import namedtuple
from xml.etree import ElementTree

import numpy as np

from plotting.inputs import InputError, read_text

TRIANGLE = 5  # VTK cell type
TYPES = {"Float32": "f4", "Float64": "f8", "Int8": "i1", "Int16": "i2", "Int32": "i4", "Int64": "i8",
         "UInt8": "u1", "UInt16": "u2", "UInt32": "u4", "UInt64": "u8"}

# points: n x 2; triangles: m x 3, indices of points; data: {name: n or n x components}
Field = namedtuple("Field", "points triangles data")


def decode(array, order, header):
    """Flat numbers of one DataArray; order: < or >; header: type of the leading byte count."""
    kind = np.dtype(order + TYPES[array.get("type")])
    form, text = array.get("format"), array.text or ""
    if form == "ascii":
        return np.array(text.split(), dtype=float).astype(kind)
    if form != "binary":
        raise ValueError(f"format {form!r} is not read, only inline binary and ascii")
    raw = base64.b64decode("".join(text.split()), validate=True)
    width = np.dtype(header).itemsize
    if len(raw) < width:
        raise ValueError("no data")
    count = int(np.frombuffer(raw[:width], order + header)[0])
    if count != len(raw) - width or count % kind.itemsize:
        raise ValueError(f"{len(raw) - width} bytes, announced {count} of {array.get('type')}")
    return np.frombuffer(raw[width:], kind)


def read_array(path, array, rows, order, header):
    """One DataArray, checked: rows x components, flat if there is one component; rows = -1: any number."""
    name = array.get("Name", "points")
    try:
        components = int(array.get("NumberOfComponents", 1))
        values = decode(array, order, header)
        if rows >= 0 and len(values) != rows * components:
            raise ValueError(f"{len(values)} numbers, expected {rows} x {components}")
        values = values.reshape(-1, components)
    except KeyError:
        raise InputError(f"{path}: array {name}: unknown type {array.get('type')!r}") from None
    except (ValueError, binascii.Error) as error:
        raise InputError(f"{path}: array {name}: {error}") from None
    return values[:, 0] if components == 1 else values


def declared(path, piece, name):
    """A number that the head of the piece announces."""
    try:
        return int(piece.get(name, ""))
    except ValueError:
        raise InputError(f"{path}: {name} is {piece.get(name)!r}") from None


def find(path, element, what):
    found = element.find(what)
    if found is None:
        raise InputError(f"{path}: no {what} in {element.tag}")
    return found


def parse(path):
    """Root element of an uncompressed unstructured grid."""
    try:
        root = ElementTree.fromstring(read_text(path))
    except ElementTree.ParseError as error:
        raise InputError(f"{path}: not valid XML: {error}") from None
    if root.tag != "VTKFile" or root.get("type") != "UnstructuredGrid":
        raise InputError(f"{path}: not a VTK unstructured grid")
    if root.get("compressor"):
        raise InputError(f"{path}: compressed; write it uncompressed, as savevtk does")
    return root


def triangles(path, piece, read, points):
    """Connectivity of the cells of type triangle, m x 3."""
    cells, count = find(path, piece, "Cells"), declared(path, piece, "NumberOfCells")
    part = {name: read(find(path, cells, f"DataArray[@Name='{name}']"), rows) for name, rows in
            (("connectivity", -1), ("offsets", count), ("types", count))}
    last = part["offsets"][part["types"] == TRIANGLE].astype(int)
    nodes = part["connectivity"].astype(int)
    if not len(last):
        raise InputError(f"{path}: no triangles")
    if last.min() < 3 or last.max() > len(nodes):
        raise InputError(f"{path}: cell offsets outside the connectivity")
    corners = nodes[last[:, None] - [3, 2, 1]]
    if corners.min() < 0 or corners.max() >= points:
        raise InputError(f"{path}: a triangle names a point outside 0..{points - 1}")
    return corners


def read_vtu(path, names):
    """Triangles and nodal data of path; names: data that must be there."""
    root = parse(path)
    order = ">" if root.get("byte_order") == "BigEndian" else "<"
    header = TYPES.get(root.get("header_type", "UInt32"), "u4")
    pieces = root.findall("UnstructuredGrid/Piece")
    if len(pieces) != 1:
        raise InputError(f"{path}: {len(pieces)} pieces, expected 1")
    piece = pieces[0]

    def read(array, rows):
        return read_array(path, array, rows, order, header)

    points = read(find(path, piece, "Points/DataArray"), declared(path, piece, "NumberOfPoints"))
    if points.ndim != 2 or points.shape[1] < 2 or not np.isfinite(points).all():
        raise InputError(f"{path}: points are not finite vectors")
    data = {array.get("Name"): read(array, len(points)) for array in piece.findall("PointData/DataArray")}
    missing = [name for name in names if name not in data]
    if missing:
        raise InputError(f"{path}: no nodal data {', '.join(missing)} (savevtk needs order 1 for each)")
    corners = triangles(path, piece, read, len(points))
    return Field(points[:, :2].astype(float), corners, data)
