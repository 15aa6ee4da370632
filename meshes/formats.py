"""Writers: each returns the bytes of a file. Reals are written so that they read back to the last bit."""

import struct


def real(x):
    return repr(x).removesuffix(".0")


def native(mesh, vertex_ids=None, face_ids=None):
    """The `Vertex i x y z` format. Faces name vertices by id: by the first record that has it, as a reader would."""
    vertex_ids = vertex_ids or list(range(1, len(mesh.points) + 1))
    face_ids = face_ids or list(range(1, len(mesh.faces) + 1))
    lines = [f"Vertex {i} {' '.join(map(real, p))}" for i, p in zip(vertex_ids, mesh.points)]
    lines += [f"Face {i} {' '.join(str(vertex_ids[v]) for v in f)}" for i, f in zip(face_ids, mesh.faces)]
    return text(lines)


def text(lines, end="\n"):
    return "".join(line + end for line in lines).encode()


def messy(mesh):
    """Native, but with Windows line ends, comments, blank lines, tabs, and the faces before the vertices."""
    lines = ["# faces first, then their vertices", ""]
    lines += [f"Face\t{i} {a + 1}  {b + 1}\t{c + 1} " for i, (a, b, c) in enumerate(mesh.faces, 1)]
    lines += ["", "# vertices"]
    lines += [f"  Vertex {i}   {' '.join(f'{c:+.3e}' for c in p)}" for i, p in enumerate(mesh.points, 1)]
    return text(lines, "\r\n")


def inria(mesh):
    lines = ["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(mesh.points))]
    lines += [" ".join(map(real, p)) + " 0" for p in mesh.points]
    lines += ["Triangles", str(len(mesh.faces))]
    lines += [" ".join(str(v + 1) for v in f) + " 0" for f in mesh.faces]
    return text([*lines, "End"])


def obj(mesh):
    return text([f"v {' '.join(map(real, p))}" for p in mesh.points] +
                [f"f {' '.join(str(v + 1) for v in f)}" for f in mesh.faces])


def obj_quads(points, quads, normals, names):
    """Quads with one normal each, in groups of one."""
    lines = [f"v {' '.join(map(real, p))}" for p in points]
    lines += [f"vn {' '.join(map(real, n))}" for n in normals]
    for i, (name, quad) in enumerate(zip(names, quads), 1):
        lines += [f"g {name}", "f " + " ".join(f"{v + 1}//{i}" for v in quad)]
    return text(lines)


def off(mesh):
    return text(["OFF", f"{len(mesh.points)} {len(mesh.faces)} 0"] +
                [" ".join(map(real, p)) for p in mesh.points] +
                [f"3 {' '.join(map(str, f))}" for f in mesh.faces])


def stl_ascii(mesh):
    lines = ["solid shape"]
    for face in mesh.faces:
        lines += ["  facet normal 0 0 0", "    outer loop"]
        lines += [f"      vertex {' '.join(map(real, mesh.points[v]))}" for v in face]
        lines += ["    endloop", "  endfacet"]
    return text([*lines, "endsolid shape"])


def stl_binary(mesh, count=None):
    """The header begins with `solid`, as that of many programs does; readers must not take it for text."""
    data = b"solid but binary all the same".ljust(80) + struct.pack("<I", len(mesh.faces) if count is None else count)
    for face in mesh.faces:
        data += struct.pack("<3f", 0, 0, 0)
        data += b"".join(struct.pack("<3f", *mesh.points[v]) for v in face) + b"\0\0"
    return data


def ply(mesh, encoding="ascii", counts=None):
    n_points, n_faces = counts or (len(mesh.points), len(mesh.faces))
    data = text(["ply", f"format {encoding} 1.0", f"element vertex {n_points}",
                 "property double x", "property double y", "property double z",
                 f"element face {n_faces}", "property list uchar int vertex_indices", "end_header"])
    if encoding == "ascii":
        return data + text([" ".join(map(real, p)) for p in mesh.points] +
                           [f"3 {' '.join(map(str, f))}" for f in mesh.faces])
    order = "<" if encoding == "binary_little_endian" else ">"
    data += b"".join(struct.pack(order + "3d", *p) for p in mesh.points)
    return data + b"".join(struct.pack(order + "B3i", 3, *f) for f in mesh.faces)
