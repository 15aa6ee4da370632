"""Files made up to hold every kind of record of each format: a box of 24 quads, whole or without one of them.

made_up_files(has_hole) gives the content of each, by name. Also by hand: made_up.py FOLDER writes them.
"""
import itertools
import pathlib
import struct
import sys

POINTS = [p for p in itertools.product((0, 1, 2), repeat=3) if p != (1, 1, 1)]
NUMBERS = {p: i for i, p in enumerate(POINTS)}
# The quad that the files with a hole do not have is the second of the last side.
MISSING = 21


def quads():
    """Four quads on each side of the box, outward."""
    for axis, level in itertools.product(range(3), (0, 2)):
        for i, j in itertools.product((0, 1), repeat=2):
            corners = []
            for a, b in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                point = [0, 0, 0]
                point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = level, a, b
                corners.append(NUMBERS[tuple(point)])
            yield corners if level == 2 else corners[::-1]


def faces(has_hole):
    return [(number, quad) for number, quad in enumerate(quads()) if not (has_hole and number == MISSING)]


def triangles(has_hole):
    return [(number, t) for number, (a, b, c, d) in faces(has_hole) for t in ((a, b, c), (a, c, d))]


def obj(has_hole):
    lines = ["# a box, made up", "mtllib box.mtl", "vp 0.5 0.5", "o box"]
    lines += [f"v {x}.000 {y} {z}e0" for x, y, z in POINTS]
    lines += ["# texture"] + [f"vt {i % 5 / 4} {i // 5 / 4:.6f}" for i in range(25)]
    lines += ["vn -1 0 0", "vn 1 0 0", "vn 0 -1 0", "vn 0 1 0", "vn 0 0 -1", "vn 0 0 1", ""]
    for number, quad in faces(has_hole):
        side, part = divmod(number, 4)
        if part == 0:
            lines += [f"g side_{side} box", "usemtl " + ("wood", "iron", "glass")[side // 2], f"s {side + 1}"]
        corners = [f"{v + 1}/{(number + k) % 25 + 1}/{side + 1}" for k, v in enumerate(quad)]
        if number == 2:
            lines += ["f " + " ".join(corners[:2]) + " \\", "  " + " ".join(corners[2:])]
        else:
            lines.append("f " + " ".join(corners) + ("  # the first" if number == 0 else ""))
    return "\n".join(lines + ["l 1/1 2/2 3/3", "p 4", "# end"]) + "\n"


def coloured_obj(has_hole):
    """Windows line ends, colours, references that count back, statements between the vertices, no last line end."""
    lines = [f"v {x} {y} {z} {x / 2} {y / 2} 0.25" for x, y, z in POINTS]
    lines += ["\tusemtl   red  "] + ["f " + " ".join(str(v - len(POINTS)) for v in quad) for _, quad in faces(has_hole)]
    return "\r\n".join(lines)


PLY_HEADER = """ply
format {} 1.0
comment a box, made up
obj_info by hand
comment TextureFile box.png
element material 2
property uchar shine
property list uchar float tint
element vertex 26
property float x
property float y
property double z
property uchar red
property uchar green
property uchar blue
property uchar alpha
property float quality
property int label
element face {}
property uchar red
property uchar green
property uchar blue
property list uchar int vertex_indices
property short flags
property list uchar float texcoord
element edge 2
property int vertex1
property int vertex2
property float sharpness
end_header
"""


def ply_records(has_hole):
    """Each record as a list of (type, number); a list is its size and its items."""
    for shine in (3, 200):
        yield [("B", shine), ("B", 2), ("f", 0.5), ("f", 0.25)]
    for i, (x, y, z) in enumerate(POINTS):
        yield [("f", x), ("f", y), ("d", z), ("B", 100 * x), ("B", 100 * y), ("B", 100 * z), ("B", 255), ("f", i / 8), ("i", 70000 + i)]
    for number, quad in faces(has_hole):
        texture = [("f", (number + k) / 64) for k in range(8)]
        yield [("B", number), ("B", 2 * number), ("B", 9), ("B", 4), *(("i", v) for v in quad), ("h", -number), ("B", 8), *texture]
    yield [("i", 0), ("i", 1), ("f", 0.5)]
    yield [("i", 1), ("i", 2), ("f", 1.5)]


def ascii_ply(has_hole):
    header = PLY_HEADER.format("ascii", len(faces(has_hole)))
    return header + "".join(" ".join(str(n) for _, n in record) + "\n" for record in ply_records(has_hole))


def binary_ply(order, has_hole):
    name = "binary_little_endian" if order == "<" else "binary_big_endian"
    header = PLY_HEADER.format(name, len(faces(has_hole))).encode()
    return header + b"".join(struct.pack(order + t, n) for record in ply_records(has_hole) for t, n in record)


def coloured_off(has_hole):
    lines = ["COFF  # a box, made up", f"26 {len(faces(has_hole))} 48", ""]
    lines += [f"{x}.0 {y} {z} {100 * x} {100 * y} {100 * z} 255" for x, y, z in POINTS]
    for number, quad in faces(has_hole):
        colour = ("", " 7", "  10 20 30", " 0.5 0.25 0 1.0")[number % 4]
        lines.append("4 " + " ".join(map(str, quad)) + colour + (" # the first" if number == 0 else ""))
    return "\n".join(lines + ["# end"]) + "\n"


def textured_off(has_hole):
    lines = ["STNOFF", f"26 {len(faces(has_hole))} 0"]
    lines += [f"{x} {y} {z} {x - 1} {y - 1} {z - 1} {x / 2} {y / 2}" for x, y, z in POINTS]
    return "\n".join(lines + ["4 " + " ".join(map(str, quad)) for _, quad in faces(has_hole)]) + "\n"


def ascii_stl(has_hole):
    lines = ["solid lower half"]
    for number, triangle in triangles(has_hole):
        lines += ["\tfacet normal 0 0 7", "\t\touter loop"]
        lines += [f"\t\t\tvertex {x}.0 {y} {z}" for x, y, z in (POINTS[v] for v in triangle)]
        lines += ["\t\tendloop", "\tendfacet"]
        if (number, triangle) == triangles(has_hole)[19]:
            lines += ["endsolid lower half", "", "solid"]
    return "\n".join(lines + ["endsolid"]) + "\n"


def binary_stl(has_hole):
    content = b"exported by hand".ljust(80, b".") + struct.pack("<I", len(triangles(has_hole)))
    for number, triangle in triangles(has_hole):
        corners = [x for v in triangle for x in POINTS[v]]
        content += struct.pack("<12fH", 0, 0, 7, *corners, 1000 + number)
    return content


def native(has_hole):
    lines = ["# a box, made up"] + [f"Vertex {10 + 2 * i} {x}.0 {y} {z}  # at {i}" for i, (x, y, z) in enumerate(POINTS)]
    for i, (_, t) in enumerate(triangles(has_hole)):
        lines.append(f"Face\t{i + 1} " + " ".join(str(10 + 2 * v) for v in t))
    return "\n".join(lines + ["", "# end"]) + "\n"


def inria(has_hole):
    lines = ["MeshVersionFormatted 2", "", "# a box, made up", "Dimension 3", "Vertices", "26"]
    lines += [f"{x}.0 {y} {z} {i % 3}" for i, (x, y, z) in enumerate(POINTS)]
    lines += ["Quadrilaterals", str(len(faces(has_hole)) - 1)]
    lines += [" ".join(str(v + 1) for v in quad) + f" {number}" for number, quad in faces(has_hole)[1:]]
    a, b, c, d = (v + 1 for v in faces(has_hole)[0][1])
    lines += ["Triangles 2", f"{a} {b} {c} 5  # the first", f"{a} {c} {d} 6"]
    lines += ["Edges", "2", "1 2 4", "2 3 5", "Corners 1", "1", "Ridges 1", "2", "RequiredTriangles 1 2"]
    return "\n".join(lines + ["End", "what follows is not read"]) + "\n"


MAKERS = {
    "materials.obj": obj,
    "colours.obj": coloured_obj,
    "ascii.ply": ascii_ply,
    "little.ply": lambda has_hole: binary_ply("<", has_hole),
    "big.ply": lambda has_hole: binary_ply(">", has_hole),
    "colours.off": coloured_off,
    "texture.off": textured_off,
    "solids.stl": ascii_stl,
    "words.stl": binary_stl,
    "native.mesh": native,
    "inria.mesh": inria,
}


def made_up_files(has_hole):
    contents = {name: make(has_hole) for name, make in MAKERS.items()}
    return {name: content if isinstance(content, bytes) else content.encode() for name, content in contents.items()}


def main():
    folder = pathlib.Path(sys.argv[1])
    for kind in ("whole", "hole"):
        (folder / kind).mkdir(parents=True, exist_ok=True)
        for name, content in made_up_files(kind == "hole").items():
            (folder / kind / name).write_bytes(content)


if __name__ == "__main__":
    main()
