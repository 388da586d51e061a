"""Reader of the .vtp files that a frame of a run has (C.savesurface, C.savetools): points and data at them."""
import base64
import mmap
from collections import namedtuple
from xml.etree import ElementTree

import numpy as np

from plotting.inputs import InputError, read_text

TYPES = {"Float64": "f8", "Int64": "i8", "UInt8": "u1"}

BROKEN = (ElementTree.ParseError, AttributeError, KeyError, TypeError, ValueError)

# points: n x 3; lines: list of arrays of point numbers; data: {name: n or n x components}; cells: {name: numbers of the lines}
Lines = namedtuple("Lines", "points lines data cells")


def numbers_of(element, order):
    """Numbers of a DataArray: eight bytes with their size go before them."""
    kind = np.dtype(order + TYPES[element.get("type")])
    blocks = base64.b64decode(element.text)
    values = np.frombuffer(blocks[8:8 + int(np.frombuffer(blocks[:8], order + "u8")[0])], kind)
    components = int(element.get("NumberOfComponents", 1))
    return values.reshape(-1, components) if components > 1 else values


def arrays_in(text):
    """{part of the file: {name: numbers}}"""
    root = ElementTree.fromstring(text)
    order = "<" if root.get("byte_order") == "LittleEndian" else ">"
    return {part.tag: {a.get("Name"): numbers_of(a, order) for a in part.findall("DataArray")} for part in root.find("PolyData/Piece")}


def read_cell_data(path):
    """{name: numbers of the cells}, the rest of the file left alone."""
    try:
        with open(path, "rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as text:
            first, last = text.find(b"<CellData"), text.find(b"</CellData>")
            if last < 0:
                raise ValueError("no end of its CellData")
            part = text[:text.find(b"<Piece")] + b"<Piece>" + text[first:last] + b"</CellData></Piece></PolyData></VTKFile>"
        return arrays_in(part)["CellData"]
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    except BROKEN as error:
        raise InputError(f"{path}: not a whole VTP file: {error}") from None


def read_vtp(path):
    try:
        arrays = arrays_in(read_text(path))
        cells = arrays["Lines" if "Lines" in arrays else "Verts"]
        ends = cells["offsets"]
        lines = np.split(cells["connectivity"], ends[:-1]) if len(ends) else []
        return Lines(arrays["Points"]["Points"], lines, arrays.get("PointData", {}), arrays.get("CellData", {}))
    except BROKEN as error:
        raise InputError(f"{path}: not a whole VTP file: {error}") from None
