"""Writes a table as a Parquet file: one row group, a page for each column, PLAIN, not compressed; empty cells are nulls.

Layout and numbers of fields: Apache Parquet's parquet.thrift; its structures are written by Apache Thrift (python3-thrift).
"""
import struct

from thrift.protocol.TCompactProtocol import TCompactProtocol
from thrift.Thrift import TType
from thrift.transport.TTransport import TMemoryBuffer

MAGIC = b"PAR1"
DOUBLE, BYTE_ARRAY = 5, 6               # Type
REQUIRED, OPTIONAL = 0, 1               # FieldRepetitionType
UTF8 = 0                                # ConvertedType
PLAIN, RLE = 0, 3                       # Encoding
UNCOMPRESSED, DATA_PAGE = 0, 0          # CompressionCodec, PageType


def i32(number):
    return TType.I32, number


def i64(number):
    return TType.I64, number


def text(words):
    return TType.STRING, words


def struct_of(**fields):
    """Fields f1, f2, ... by their numbers in parquet.thrift."""
    return TType.STRUCT, {int(name[1:]): value for name, value in fields.items()}


def list_of(values):
    return TType.LIST, values


def put(protocol, kind, value):
    """One value of thrift, whatever is in it."""
    if kind == TType.STRUCT:
        protocol.writeStructBegin("")
        for number in sorted(value):
            protocol.writeFieldBegin("", value[number][0], number)
            put(protocol, *value[number])
            protocol.writeFieldEnd()
        protocol.writeFieldStop()
        protocol.writeStructEnd()
    elif kind == TType.LIST:
        protocol.writeListBegin(value[0][0], len(value))
        for item in value:
            put(protocol, *item)
        protocol.writeListEnd()
    else:
        {TType.I32: protocol.writeI32, TType.I64: protocol.writeI64, TType.STRING: protocol.writeString}[kind](value)


def packed(value):
    buffer = TMemoryBuffer()
    put(TCompactProtocol(buffer), *value)
    return buffer.getvalue()


def number(cell):
    try:
        return float(cell)
    except (TypeError, ValueError):
        return None


class Column:
    """Cells of one name: numbers if all that are there can be read as such, otherwise texts. @param cells None or "" where empty"""

    def __init__(self, name, cells):
        present = [c is not None and c != "" for c in cells]
        filled = [c for c, there in zip(cells, present) if there]
        numeric = bool(filled) and all(number(c) is not None for c in filled)
        self.name, self.rows, self.type = name, len(cells), DOUBLE if numeric else BYTE_ARRAY
        bits = [sum(bit << k for k, bit in enumerate(present[i:i + 8])) for i in range(0, len(present), 8)]
        head, groups = b"", len(bits) << 1 | 1                  # a bit-packed run of groups of eight, its length as a varint
        while groups > 127:
            head, groups = head + bytes([groups & 127 | 128]), groups >> 7
        levels = head + bytes([groups]) + bytes(bits)
        values = [struct.pack("<d", number(c)) for c in filled] if numeric else \
                 [struct.pack("<i", len(b)) + b for b in (str(c).encode() for c in filled)]
        page = struct.pack("<i", len(levels)) + levels + b"".join(values)
        data = struct_of(f1=i32(self.rows), f2=i32(PLAIN), f3=i32(RLE), f4=i32(RLE))
        self.bytes = packed(struct_of(f1=i32(DATA_PAGE), f2=i32(len(page)), f3=i32(len(page)), f5=data)) + page

    def schema(self):
        kind = {} if self.type == DOUBLE else {"f6": i32(UTF8)}
        return struct_of(f1=i32(self.type), f3=i32(OPTIONAL), f4=text(self.name), **kind)

    def chunk(self, offset):
        size = i64(len(self.bytes))
        return struct_of(f2=i64(offset), f3=struct_of(
            f1=i32(self.type), f2=list_of([i32(PLAIN), i32(RLE)]), f3=list_of([text(self.name)]), f4=i32(UNCOMPRESSED),
            f5=i64(self.rows), f6=size, f7=size, f9=i64(offset)))


def write_parquet(path, columns, rows):
    """@param columns names; @param rows dictionaries, cells that lack are null. Nothing is written without columns or rows."""
    if not columns or not rows:
        return
    listed = [Column(name, [row.get(name) for row in rows]) for name in columns]
    offsets = [len(MAGIC) + sum(len(c.bytes) for c in listed[:k]) for k in range(len(listed))]
    root = struct_of(f3=i32(REQUIRED), f4=text("sweep"), f5=i32(len(listed)))
    group = struct_of(f1=list_of([c.chunk(o) for c, o in zip(listed, offsets)]), f2=i64(sum(len(c.bytes) for c in listed)), f3=i64(len(rows)))
    foot = packed(struct_of(f1=i32(1), f2=list_of([root] + [c.schema() for c in listed]), f3=i64(len(rows)), f4=list_of([group]), f6=text("Burnish")))
    with open(path, "wb") as file:
        file.write(MAGIC + b"".join(c.bytes for c in listed) + foot + struct.pack("<i", len(foot)) + MAGIC)
