"""Counts what mesh files say beside vertices and triangles, from their bytes alone, in the words of meshfixer's JSON."""
import collections
import re
import struct

# The names of colours and texture coordinates in PLY files.
COLOURS = {"red", "green", "blue", "alpha", "diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha", "r", "g", "b", "a"}
TEXTURE = {"texcoord", "texcoords", "s", "t", "u", "v", "texture_u", "texture_v"}
OWN = {"x", "y", "z", "nx", "ny", "nz", "vertex_indices", "vertex_index"}
SIZES = {"char": "b", "int8": "b", "uchar": "B", "uint8": "B", "short": "h", "int16": "h", "ushort": "H", "uint16": "H",
         "int": "i", "int32": "i", "uint": "I", "uint32": "I", "float": "f", "float32": "f", "double": "d", "float64": "d"}
TRIANGLE_SECTIONS = {"MeshVersionFormatted", "Dimension", "Vertices", "Triangles", "Quadrilaterals", "End"}


def has_comment(line):
    """Inside a word, # does not begin a comment."""
    return any(word.startswith("#") for word in line.split())


def count_obj(content):
    text = re.sub(r"\\\r?\n", " ", content.decode(errors="replace"))
    counts = collections.Counter()
    names = collections.defaultdict(set)
    for line in text.splitlines():
        counts["comments"] += has_comment(line)
        words = line.split("#")[0].split()
        if not words:
            continue
        keyword, name = words[0], " ".join(words[1:])
        counts["vertex_colours"] += keyword == "v" and len(words) >= 7
        counts["texture_coordinates"] += keyword == "vt"
        counts["normals"] += keyword == "vn"
        counts["polygons"] += keyword in ("f", "fo") and len(words) > 4
        counts["lines_and_points"] += keyword in ("l", "p")
        if keyword in ("usemtl", "g", "o", "s"):
            names[{"usemtl": "materials", "s": "smoothing_groups"}.get(keyword, "groups")].add(name)
        elif keyword not in ("v", "vt", "vn", "f", "fo", "l", "p"):
            counts["other_statements"] += 1
    return counts + collections.Counter({kind: len(of_kind) for kind, of_kind in names.items()})


def ply_elements(header):
    """The elements: name, count, and properties as (name, type of size or None, type)."""
    elements = []
    for words in map(str.split, header.splitlines()):
        if words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
        elif words[:2] == ["property", "list"]:
            elements[-1][2].append((words[4], SIZES[words[2]], SIZES[words[3]]))
        elif words[:1] == ["property"]:
            elements[-1][2].append((words[2], None, SIZES[words[1]]))
    return elements


def ply_numbers(header, body):
    """Gives the numbers of the body, one after the other, to those who say their type."""
    if "format ascii" in header:
        words = iter(body.decode().split())
        return lambda letter: float(next(words))
    order = "<" if "little" in header else ">"
    at = 0

    def binary(letter):
        nonlocal at
        (number,) = struct.unpack_from(order + letter, body, at)
        at += struct.calcsize(letter)
        return number

    return binary


def read_ply(content):
    """The header, and the records of each element: lists of the numbers of each property."""
    match = re.search(rb"end_header *\r?\n", content)
    header = content[:match.end()].decode(errors="replace")
    number = ply_numbers(header, content[match.end():])
    elements = []
    for name, n, properties in ply_elements(header):
        records = [[[number(letter) for _ in range(1 if size is None else int(number(size)))] for _, size, letter in properties]
                   for _ in range(n)]
        elements.append((name, properties, records))
    return header, elements


def count_ply(content):
    header, elements = read_ply(content)
    counts = collections.Counter()
    counts["comments"] = sum(line.split()[:1] in (["comment"], ["obj_info"]) for line in header.splitlines())
    for element, properties, records in elements:
        names = {name for name, _, _ in properties}
        if element not in ("vertex", "face"):
            counts["other_records"] += len(records)
            continue
        counts["vertex_colours" if element == "vertex" else "face_colours"] += len(records) if names & COLOURS else 0
        counts["texture_coordinates"] += len(records) if names & TEXTURE else 0
        counts[element + "_properties"] += len(names - COLOURS - TEXTURE - OWN)
        counts["normals"] += len(records) if element == "vertex" and {"nx", "ny", "nz"} <= names else 0
        for i, (name, _, _) in enumerate(properties):
            if element == "face" and name in OWN:
                counts["polygons"] += sum(len(record[i]) > 3 for record in records)
    return counts


def count_off(content):
    lines = content.decode(errors="replace").splitlines()
    counts = collections.Counter(comments=sum(map(has_comment, lines)))
    records = [words for words in (line.split("#")[0].split() for line in lines) if words]
    keyword = records.pop(0)[0] if records[0][0].endswith("OFF") else ""
    n_vertices = int(records.pop(0)[0])
    n_own = 3 + 3 * ("N" in keyword) + 2 * keyword.startswith("ST")
    counts["normals"] = n_vertices if "N" in keyword else 0
    counts["texture_coordinates"] = n_vertices if keyword.startswith("ST") else 0
    counts["vertex_colours"] = sum(len(record) > n_own for record in records[:n_vertices])
    for record in records[n_vertices:]:
        counts["face_colours"] += len(record) > 1 + int(record[0])
        counts["polygons"] += int(record[0]) > 3
    return counts


def count_stl(content):
    if len(content) >= 84 and len(content) == 84 + 50 * struct.unpack_from("<I", content, 80)[0]:
        words = [struct.unpack_from("<H", content, at)[0] for at in range(84 + 48, len(content), 50)]
        return collections.Counter(headers=bool(content[:80].strip(b" \0")), attribute_words=sum(word != 0 for word in words))
    lines = content.decode(errors="replace").splitlines()
    return collections.Counter(comments=sum(map(has_comment, lines)),
                               groups=sum(len(line.split()) > 1 for line in lines if line.lower().split()[:1] == ["solid"]))


def count_inria(content):
    text = content.decode(errors="replace")
    text = text[:re.search(r"^\s*End\s*$|\Z", text, re.MULTILINE).start()]
    counts = collections.Counter(comments=sum(map(has_comment, text.splitlines())))
    words = iter(re.sub("#.*", "", text).split())
    sizes = {"Vertices": 4, "Triangles": 4, "Quadrilaterals": 5, "Edges": 3, "Corners": 1, "Ridges": 1, "RequiredTriangles": 1}
    for section in words:
        n = int(next(words))
        records = [[next(words) for _ in range(sizes[section])] for _ in range(n if section in sizes else 0)]
        counts["polygons"] += n if section == "Quadrilaterals" else 0
        counts["other_records"] += n if section not in TRIANGLE_SECTIONS else 0
        if section in TRIANGLE_SECTIONS:
            counts["references"] += sum(record[-1] != "0" for record in records)
    return counts


def count_records(name, content):
    ending = name.rsplit(".", 1)[-1].lower()
    if ending == "mesh" and content.split()[:1] != [b"MeshVersionFormatted"]:
        return collections.Counter(comments=sum(map(has_comment, content.decode(errors="replace").splitlines())))
    return {"obj": count_obj, "ply": count_ply, "off": count_off, "stl": count_stl, "mesh": count_inria}[ending](content)
