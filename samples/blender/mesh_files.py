# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads OFF, OBJ, PLY and STL, and writes PLY, strictly: a damaged file is an error that says where.

Blender's own importers leave out what they cannot read and go on; a batch that nobody watches had
better be told.
"""

from pathlib import Path

import numpy as np


class MeshFileError(Exception):
    """What is wrong with the file, one sentence."""


def _lines(data):
    text = data.decode("utf-8-sig", errors="replace")
    return text.replace("\r\n", "\n").replace("\r", "\n").split("\n")


def _numbers(words, kind, where):
    try:
        return [kind(word) for word in words]
    except ValueError:
        bad = next(word for word in words if not _is(kind, word))
        comma = ", it has a decimal comma" if _is(float, bad.replace(",", ".", 1)) else ""
        raise MeshFileError(f"{where}: {bad[:20]!r} is not a number{comma}") from None


def _is(kind, word):
    try:
        kind(word)
    except ValueError:
        return False
    return True


def _check_faces(faces, count, first=0, lines=None):
    for number, face in enumerate(faces):
        for index in face:
            if not 0 <= index < count:
                where = f"line {lines[number]}: " if lines else ""
                raise MeshFileError(f"{where}face {number} has vertex {index + first}, but the file "
                                    f"has {count} vertices")


# ---- Readers: bytes, list of remarks to add to -> (points n x 3, list of faces) -------------------------------------------------


def _read_off(data, notes):
    lines = _lines(data)
    rows = ((number, line.split("#")[0].split()) for number, line in enumerate(lines, 1))
    rows = ((number, words) for number, words in rows if words)
    number, words = next(rows, (1, [""]))
    if words[0] != "OFF":
        raise MeshFileError("not an OFF file: it does not begin with OFF")
    words = words[1:]
    if not words:
        number, words = next(rows, (number, []))
    counts = _numbers(words[:3], int, f"line {number}")
    if len(counts) < 2 or min(counts) < 0:
        raise MeshFileError(f"line {number}: the numbers of vertices and faces are missing or wrong")
    if 2 * (counts[0] + counts[1]) > len(data):
        raise MeshFileError(f"line {number}: the file is too short for {counts[0]} vertices and "
                            f"{counts[1]} faces")
    points, faces, at = [], [], []
    for index in range(counts[0]):
        number, words = next(rows, (None, []))
        if len(words) < 3:
            raise MeshFileError(f"line {len(lines)}: the file ends before vertex {index} of {counts[0]}"
                                if number is None else f"line {number}: a vertex needs three numbers")
        points.append(_numbers(words[:3], float, f"line {number}"))
    for index in range(counts[1]):
        number, words = next(rows, (None, []))
        if number is None:
            raise MeshFileError(f"line {len(lines)}: the file ends before face {index} of {counts[1]}")
        size = _numbers(words[:1], int, f"line {number}")[0]
        if size < 0 or len(words) < size + 1:
            raise MeshFileError(f"line {number}: the face is shorter than it says")
        if size < 3:
            raise MeshFileError(f"line {number}: a face needs three corners")
        faces.append(_numbers(words[1:size + 1], int, f"line {number}"))
        at.append(number)
    number, _ = next(rows, (None, []))
    if number is not None:
        notes.append(f"line {number}: what comes after the last face is left out")
    _check_faces(faces, len(points), lines=at)
    return points, faces


def _read_obj(data, _notes):
    points, faces, at, seen = [], [], [], False
    for number, line in enumerate(_lines(data.replace(b"\\\n", b" ")), 1):
        word, *rest = line.split("#")[0].split() or [""]
        seen = seen or word in ("v", "f", "o", "g", "vn", "vt", "mtllib", "usemtl", "s", "l", "p")
        if word == "v":
            if len(rest) < 3:
                raise MeshFileError(f"line {number}: a vertex needs three numbers")
            points.append(_numbers(rest[:3], float, f"line {number}"))
        elif word == "f":
            corners = _numbers([corner.split("/")[0] for corner in rest], int, f"line {number}")
            if len(corners) < 3:
                raise MeshFileError(f"line {number}: a face needs three corners")
            if 0 in corners:
                raise MeshFileError(f"line {number}: vertices are counted from 1, not 0")
            faces.append([c - 1 if c > 0 else len(points) + c for c in corners])
            at.append(number)
    if not seen:
        raise MeshFileError("not a Wavefront OBJ file")
    _check_faces(faces, len(points), first=1, lines=at)
    return points, faces


def _read_stl(data, _notes):
    count = int.from_bytes(data[80:84], "little") if len(data) >= 84 else -1
    if count >= 0 and len(data) == 84 + 50 * count:
        rows = np.frombuffer(data, offset=84, count=count, dtype=[
            ("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])
        corners = rows["corners"].reshape(-1, 3)
    elif data[:5].lower() == b"solid" and b"facet" in data[:1000]:
        corners = []
        for number, line in enumerate(_lines(data), 1):
            words = line.split()
            if words[:1] == ["vertex"]:
                if len(words) != 4:
                    raise MeshFileError(f"line {number}: a vertex needs three numbers")
                corners.append(_numbers(words[1:], float, f"line {number}"))
        if len(corners) % 3 or b"endsolid" not in data[-300:]:
            raise MeshFileError("the file ends within a face")
        corners = np.array(corners).reshape(-1, 3)
    else:
        raise MeshFileError(f"the file has {len(data)} bytes, but {count} triangles need "
                            f"{84 + 50 * count}" if count >= 0 else "not an STL file")
    # STL repeats a vertex for each of its triangles. NaN is unlike itself, and is kept as it is.
    points, index = np.unique(corners, axis=0, return_inverse=True)
    return points, index.reshape(-1, 3)


_PLY_TYPES = {"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4",
              "float": "f4", "double": "f8", "int8": "i1", "uint8": "u1", "int16": "i2",
              "uint16": "u2", "int32": "i4", "uint32": "u4", "float32": "f4", "float64": "f8"}

#: Names that the list of a face's vertices goes by.
_PLY_CORNERS = ("vertex_indices", "vertex_index")

#: Bytes within which a header that has no end is looked through for the line where it stops.
_LONGEST_HEADER = 100_000


def _ply_header(data):
    """(format, elements, where the data begin); an element is (name, count, properties)."""
    end = data.find(b"end_header")
    if data[:3] != b"ply":
        raise MeshFileError("not a PLY file: it does not begin with ply")
    newline = data.find(b"\n", end)
    if end < 0 or newline < 0:
        raise MeshFileError(f"line {len(_lines(data[:_LONGEST_HEADER]))}: the header has no end")
    order, elements = None, []
    for number, line in enumerate(_lines(data[:end]), 1):
        words = line.split()
        try:
            if words[:1] == ["format"]:
                order = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}[words[1]]
            elif words[:1] == ["element"]:
                _add(elements, (words[1], _count(words[2]), []), number)
            elif words[:1] == ["property"]:
                _add(elements[-1][2], _property(*words[1:]), number)
        except (KeyError, IndexError, ValueError, TypeError):
            raise MeshFileError(f"line {number} of the header is not understood") from None
    if order is None:
        raise MeshFileError("the header does not say the format")
    return order, elements, newline + 1


def _count(word):
    count = int(word)
    if count < 0:
        raise ValueError
    return count


def _property(kind, *rest):
    """(name, types) of the words after "property": two types if it is a list, which has its length first."""
    if kind != "list":
        (name,) = rest
        return name, [_PLY_TYPES[kind]]
    length, kind, name = rest
    types = [_PLY_TYPES[length], _PLY_TYPES[kind]]
    # A length, or an index of a vertex, that is no whole number means nothing.
    if types[0][0] == "f" or (name in _PLY_CORNERS and types[1][0] == "f"):
        raise ValueError
    return name, types


def _add(named, new, number):
    if any(new[0] == old[0] for old in named):
        raise MeshFileError(f"line {number} of the header: {new[0][:20]!r} is there twice")
    named.append(new)


class _Binary:
    def __init__(self, data, place, order):
        self.data, self.place, self.order = data, place, order

    def take(self, kind, count, what):
        kind = np.dtype(kind).newbyteorder(self.order)
        if count < 0 or self.place + count * kind.itemsize > len(self.data):
            raise MeshFileError(f"byte {self.place}: the file of {len(self.data)} bytes ends within "
                                f"{what}")
        values = np.frombuffer(self.data, kind, count, self.place)
        self.place += count * kind.itemsize
        return values


class _Ascii:
    def __init__(self, data, place, _order):
        self.words, self.place = data[place:].split(), 0

    def take(self, kind, count, what):
        kind = np.dtype(kind)
        width = len(kind.names) if kind.names else 1
        words = self.words[self.place:self.place + count * width] if count >= 0 else []
        if count < 0 or len(words) < count * width:
            raise MeshFileError(f"number {len(self.words)} of the data: the file ends within {what}")
        self.place += count * width
        try:
            values = np.array(words, dtype=np.float64)
        except ValueError:
            raise MeshFileError(f"something that is not a number stands within {what}") from None
        if not kind.names:
            return self._fit(values, kind, what)
        rows = np.empty(count, dtype=kind)
        for column, name in enumerate(kind.names):
            rows[name] = self._fit(values[column::width], kind[name], what)
        return rows

    @staticmethod
    def _fit(values, kind, what):
        """As numbers of their type. What does not fit a whole number would become any other."""
        if kind.kind in "iu":
            low, high = np.iinfo(kind).min, np.iinfo(kind).max
            if not ((values >= low) & (values <= high) & (values == np.floor(values))).all():
                raise MeshFileError(f"a number within {what} is not of its type, a whole number from "
                                    f"{low} to {high}")
        with np.errstate(over="ignore"):  # beyond a float's range is infinite, which is told later
            return values.astype(kind)


def _read_ply(data, _notes):
    order, elements, begin = _ply_header(data)
    reader = (_Binary if order else _Ascii)(data, begin, order)
    points, faces = np.zeros((0, 3)), []
    for element, count, properties in elements:
        if element == "vertex" and not set("xyz") <= {name for name, types in properties if len(types) == 1}:
            raise MeshFileError("the vertices have no x, y and z")
        if not properties:
            continue
        if all(len(types) == 1 for _, types in properties):
            rows = reader.take([(name, types[0]) for name, types in properties], count, element)
            if element == "vertex":
                points = np.stack([rows[axis].astype(np.float64) for axis in "xyz"], axis=1)
            continue
        places = []
        for number in range(count):
            what, row = f"{element} {number}", {}
            for name, types in properties:
                size = int(reader.take(types[0], 1, what)[0]) if len(types) == 2 else 1
                row[name] = reader.take(types[-1], size, what)
            if element == "vertex":
                places.append([float(row[axis][0]) for axis in "xyz"])
            elif element == "face":
                corners = next((row[name].tolist() for name in _PLY_CORNERS if name in row), None)
                if corners is not None and len(corners) < 3:
                    raise MeshFileError(f"{what}: a face needs three corners")
                if corners is not None:
                    faces.append(corners)
        if element == "vertex":
            points = np.array(places, dtype=np.float64).reshape(-1, 3)
    _check_faces(faces, len(points))
    return points, faces


_READERS = {".off": _read_off, ".obj": _read_obj, ".ply": _read_ply, ".stl": _read_stl}
_PACKED = (".gz", ".bz2", ".xz", ".zst", ".zip")


def is_mesh_file(path):
    """Whether its name is that of a mesh file, or of a compressed one, which read() refuses."""
    suffixes = [suffix.lower() for suffix in Path(path).suffixes[-2:]]
    if suffixes and suffixes[-1] in _PACKED:
        suffixes.pop()
    return bool(suffixes) and suffixes[-1] in _READERS


def read(path, notes=None):
    """(points, faces) of a mesh file; faces is a sequence of index sequences, empty for bare points.

    To the list `notes` is added what there is to say about a file that is read all the same.
    """
    suffix = Path(path).suffix.lower()
    if suffix in _PACKED:
        raise MeshFileError("the file is compressed: unpack it first")
    data = Path(path).read_bytes()
    if not data:
        raise MeshFileError("the file is empty")
    return _READERS[suffix](data, [] if notes is None else notes)


def write_ply(path, points, triangles, **columns):
    """A binary PLY file; `columns` are further numbers of the vertices, float32 or uint8."""
    fields = [(axis, np.asarray(points, dtype="<f4")[:, i]) for i, axis in enumerate("xyz")]
    fields += list(columns.items())
    rows = np.empty(len(points), dtype=[(name, values.dtype) for name, values in fields])
    for name, values in fields:
        rows[name] = values
    faces = np.empty(len(triangles), dtype=[("size", "u1"), ("corners", "<i4", 3)])
    faces["size"] = 3
    faces["corners"] = triangles
    names = {"f4": "float", "u1": "uchar"}
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(rows)}"]
    header += [f"property {names[values.dtype.str[1:]]} {name}" for name, values in fields]
    header += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]
    with open(path, "wb") as file:
        file.write(("\n".join(header) + "\n").encode("ascii"))
        file.write(rows.tobytes())
        file.write(faces.tobytes())
