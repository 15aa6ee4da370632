#!/usr/bin/env python3
"""Measures meshes with meshalyzer, and compares with the tables of 7_the_report.md.

usage: check_report.py MESHALYZER [LAB_FOLDER] [--update]

The tables of your own meshes are made of this repository's. Those of the laboratory report need its meshes, which are not
ours to give: LAB_FOLDER holds sphere1.0.obj, bunnySmall.obj, cube.obj, cow.obj, torus.obj and genuscube.obj. Every figure of
ours comes out of the program; only what the report did beyond that (means over faces, absolute values, single precision) is
done here.
"""

import json
import math
import pathlib
import re
import struct
import subprocess
import sys
import tempfile

PAGE = pathlib.Path(__file__).with_name("7_the_report.md")
MESHES = pathlib.Path(__file__).resolve().parents[2] / "meshes"
# Below this a curvature is rounding of zero: the largest ones are in the hundreds.
ROUNDING = 1e-9


def run(*command):
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=300, check=False)
    assert result.returncode == 0, f"{command}: {result.returncode} {result.stderr}"
    return result.stdout


class Program:
    """meshalyzer, and the folder of the meshes."""

    def __init__(self, path, folder):
        self.path, self.folder = path, pathlib.Path(folder)

    def report(self, mesh, area="mixed"):
        return json.loads(run(self.path, "--json", f"--curvature={area}", self.folder / mesh))["meshes"][0]

    def field(self, mesh, name, area):
        """The values of a field at the vertices, and the faces, as exported: [value], [(i, j, k)]."""
        with tempfile.TemporaryDirectory() as scratch:
            ply = pathlib.Path(scratch) / "field.ply"
            run(self.path, "--quiet", f"--curvature={area}", "--export", ply, "--field", name, self.folder / mesh)
            return read_ply(ply.read_bytes())


PLY_TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d"}


def read_ply(content):
    """`quality` of the vertices, and the triangles, of a binary little-endian PLY."""
    head, body = content.split(b"end_header\n", 1)
    assert b"format binary_little_endian" in head
    counts = {name: int(n) for name, n in re.findall(r"element (\w+) (\d+)", head.decode())}
    of_vertex = head.decode().split("element vertex")[1].split("element face")[0]
    properties = re.findall(r"property (\w+) (\w+)\n", of_vertex)
    record = struct.Struct("<" + "".join(PLY_TYPES[kind] for kind, _ in properties))
    quality = [name for _, name in properties].index("quality")
    n_bytes = record.size * counts["vertex"]
    values = [row[quality] for row in record.iter_unpack(body[:n_bytes])]
    count, index = re.search(r"property list (\w+) (\w+) ", head.decode()).groups()
    face = struct.Struct("<" + PLY_TYPES[count] + 3 * PLY_TYPES[index])
    faces = [row[1:] for row in face.iter_unpack(body[n_bytes:n_bytes + face.size * counts["face"]])]
    return values, faces


def range_of(values):
    known = [value for value in values if not math.isnan(value)]
    return min(known), max(known)


def range_over_faces(values, faces):
    """Of the means of the three corners; faces with a corner that has no value count for nothing."""
    return range_of(sum(values[i] for i in face) / 3.0 for face in faces)


def agrees(ours, printed):
    """Whether a number, rounded or cut off, is the one printed."""
    digits = len(printed.split(".")[1]) if "." in printed else 0
    return abs(ours - float(printed)) < 10.0 ** -digits


def number(value, digits=6):
    return "0" if abs(value) < ROUNDING else f"{value:.{digits}g}"


def interval(pair, digits=4):
    return f"[{number(pair[0], digits)}, {number(pair[1], digits)}]"


# Table 1


def inscribed_sphere(n, bands=None):
    """Area and volume of the polyhedron of n bands (or as many as said) of n segments in the unit sphere."""
    bands = bands or n
    radius = [math.sin(math.pi * k / bands) for k in range(bands + 1)]
    height = [math.cos(math.pi * k / bands) for k in range(bands + 1)]
    half = math.pi / n
    area = volume = 0.0
    for r, s, h in zip(radius, radius[1:], (a - b for a, b in zip(height, height[1:]))):
        area += n * math.sin(half) * (r + s) * math.hypot(h, math.cos(half) * (r - s))
        volume += n / 2.0 * math.sin(2.0 * half) * h * (r * r + r * s + s * s) / 3.0
    return area, volume


def single(value):
    return struct.unpack("f", struct.pack("f", value))[0]


def dot(a, b):
    products = [single(x * y) for x, y in zip(a, b)]
    return single(single(products[0] + products[1]) + products[2])


def cross(a, b):
    return [single(single(a[i - 2] * b[i - 1]) - single(a[i - 1] * b[i - 2])) for i in range(3)]


def in_single_precision(path):
    """Equations (2) and (4), every step rounded to 24 bits, in the order of the file."""
    points, area, flow = [], 0.0, 0.0
    for words in (line.split() for line in path.read_text().splitlines()):
        if words[:1] == ["v"]:
            points.append([single(float(word)) for word in words[1:4]])
        elif words[:1] == ["f"]:
            a, b, c = (points[int(word.split("/")[0]) - 1] for word in words[1:])
            sides = [[single(q - p) for p, q in zip(a, end)] for end in (b, c)]
            normal = cross(*sides)
            length = single(math.sqrt(dot(normal, normal)))
            centroid = [single(single(single(x + y) + z) / 3.0) for x, y, z in zip(a, b, c)]
            unit = [single(x / length) for x in normal]
            area = single(area + length / 2.0)
            flow = single(flow + single(dot(centroid, unit) * single(length / 2.0)))
    return area, single(flow / 3.0)


def table_1(program):
    measured = program.report("sphere1.0.obj")["characteristics"]
    printed = {"area": "12.511", "volume": "4.15192"}
    sphere = {"area": 4.0 * math.pi, "volume": 4.0 / 3.0 * math.pi}
    rows = ["| | report | ours | closed form of the polyhedron | equations (2), (4) in single precision | sphere |",
            "|---|---:|---:|---:|---:|---:|"]
    for key, polyhedron, rounded in zip(printed, inscribed_sphere(32), in_single_precision(program.folder / "sphere1.0.obj")):
        assert agrees(rounded, printed[key]), key
        rows.append(f"| {key} | {printed[key]} | {number(measured[key], 8)} | {number(polyhedron, 8)} | {number(rounded, 8)} "
                    f"| {number(sphere[key], 8)} |")
    return rows


# Table 2: mesh, file, field, the area that the report took, over what, what it printed

TABLE_2 = [
    ("sphere", "sphere1.0.obj", "gaussian", "one-ring", "faces", ("0.28", "0.41")),
    ("bunny", "bunnySmall.obj", "gaussian", "one-ring", "vertices", ("-42.5", "187.88")),
    ("cube", "cube.obj", "gaussian", "one-ring", "faces", ("0.16", "0.19")),
    ("sphere", "sphere1.0.obj", "mean", "voronoi", "faces", ("0.99", "1.00")),
    ("bunny", "bunnySmall.obj", "mean", "voronoi", "faces", ("2.4e-7", "23.55")),
    ("cube", "cube.obj", "mean", "voronoi", "faces", ("0.58", "0.58")),
]
NAMES = {"gaussian": "$K$", "mean": "$H$"}


def reported_range(program, mesh, field, area, place):
    values, faces = program.field(mesh, field, area)
    if field == "mean":
        values = [abs(value) for value in values]
    return range_of(values) if place == "vertices" else range_over_faces(values, faces)


def way_of(field, area, place):
    return f"{area}, " + ("length, " if field == "mean" else "") + ("means over faces" if place == "faces" else "vertices")


def as_the_report_did(program, row):
    _, mesh, field, area, place, printed = row
    got = reported_range(program, mesh, field, area, place)
    for ours, theirs in zip(got, printed):
        # 2.4e-7 is what single precision makes of zero.
        assert agrees(ours, "0.00" if theirs == "2.4e-7" else theirs), f"{mesh} {field}: {got}, the report has {printed}"
    return got


def at_vertices(program, mesh, field, area):
    statistic = program.report(mesh, area)["characteristics"][{"gaussian": "gaussian_curvature", "mean": "mean_curvature"}[field]]
    return statistic["min"], statistic["max"]


def table_2(program):
    rows = ["| | | report | ours, the report's way | which is | that area, signed, vertices | `mixed`, signed, vertices |",
            "|---|---|---|---|---|---|---|"]
    for row in TABLE_2:
        name, mesh, field, area, place, printed = row
        rows.append(f"| {name} | {NAMES[field]} | [{', '.join(printed)}] | {interval(as_the_report_did(program, row), 5)} "
                    f"| {way_of(field, area, place)} | {interval(at_vertices(program, mesh, field, area))} | {interval(at_vertices(program, mesh, field, 'mixed'))} |")
    return rows


# Figure 6

FIGURE_6 = [("cow", "cow.obj", "0"), ("torus", "torus.obj", "1"), ("cube with tunnels", "genuscube.obj", "5")]


def half(twice):
    """A half of a whole number, exactly, in few signs."""
    return str(twice // 2) if twice % 2 == 0 else f"{twice}/2"


def genus_in_words(mesh):
    genus = mesh["characteristics"]["genus"]
    if genus is not None:
        return str(genus)
    parts = [component["genus"] for component in mesh["per_component"]]
    why = []
    if mesh["attributes"]["manifold"] is False:
        why.append("not manifold")
    if mesh["integrity"]["orphan_vertices"] > 0:
        why.append("orphans")
    known = f"; without the orphans {sum(parts)}" if parts and None not in parts else ""
    return f"undefined ({', '.join(why)}{known})"


def figure_6(program):
    rows = ["| | report | $V$ | of these orphans | pinched | $E$ | $F$ | (8), all $V$ | (8), no orphans | ours |",
            "|---|---:|---:|---:|---:|---:|---:|---:|---:|---|"]
    for name, path, printed in FIGURE_6:
        mesh = program.report(path)
        n, orphans = mesh["characteristics"], mesh["integrity"]["orphan_vertices"]
        twice = n["edges"] + 2 - n["vertices"] - n["faces"]
        # As integers divide in C++: towards zero.
        assert str(int((twice + orphans) / 2)) == printed, path
        rows.append(f"| {name} | {printed} | {n['vertices']} | {orphans} | {n['pinched_vertices']} | {n['edges']} | {n['faces']} "
                    f"| {half(twice)} | {half(twice + orphans)} | {genus_in_words(mesh)} |")
    return rows


def cow(program):
    mesh = program.report("cow.obj")
    n, orphans, pinched = mesh["characteristics"], mesh["integrity"]["orphan_vertices"], mesh["characteristics"]["pinched_vertices"]
    # The pinched vertex has two fans: so says the page of the mesh.
    counted = {"all vertices of the file": n["vertices"], "those that faces use": n["vertices"] - orphans,
               "those, and the pinched one as the two that it stands for": n["vertices"] - orphans + pinched}
    rows = ["| the cow's $V$ | | (8) |", "|---|---:|---:|"]
    for words, vertices in counted.items():
        rows.append(f"| {words} | {vertices} | {half(n['edges'] + 2 - vertices - n['faces'])} |")
    return rows


# The same of meshes that everybody has


def your_table_1(program):
    measured = program.report("uv_sphere.mesh")["characteristics"]
    sphere = {"area": 4.0 * math.pi, "volume": 4.0 / 3.0 * math.pi}
    rows = ["| | ours | closed form of the polyhedron | sphere |", "|---|---:|---:|---:|"]
    for key, polyhedron in zip(sphere, inscribed_sphere(16, 8)):
        assert abs(measured[key] - polyhedron) < 1e-12 * polyhedron, key
        rows.append(f"| {key} | {number(measured[key], 8)} | {number(polyhedron, 8)} | {number(sphere[key], 8)} |")
    return rows


YOUR_TABLE_2 = [("sphere", "uv_sphere.mesh", "gaussian", "one-ring", "faces"), ("cube", "cube.mesh", "gaussian", "one-ring", "faces"),
                ("torus", "torus.mesh", "gaussian", "one-ring", "faces"), ("sphere", "uv_sphere.mesh", "mean", "voronoi", "faces"),
                ("cube", "cube.mesh", "mean", "voronoi", "faces"), ("torus", "torus.mesh", "mean", "voronoi", "faces")]


def your_table_2(program):
    rows = ["| | | the report's way | which is | that area, signed, vertices | `mixed`, signed, vertices |", "|---|---|---|---|---|---|"]
    for name, mesh, field, area, place in YOUR_TABLE_2:
        rows.append(f"| {name} | {NAMES[field]} | {interval(reported_range(program, mesh, field, area, place), 5)} "
                    f"| {way_of(field, area, place)} | {interval(at_vertices(program, mesh, field, area))} "
                    f"| {interval(at_vertices(program, mesh, field, 'mixed'))} |")
    return rows


def your_figure_6(program):
    rows = ["| `meshes/` | $V$ | of these orphans | pinched | $E$ | $F$ | (8), all $V$ | (8), no orphans | ours |",
            "|---|---:|---:|---:|---:|---:|---:|---:|---|"]
    for path in ("pinched_vertex.mesh", "torus.mesh", "genus_3.mesh", "orphan_vertex.mesh"):
        mesh = program.report(path)
        n, orphans = mesh["characteristics"], mesh["integrity"]["orphan_vertices"]
        twice = n["edges"] + 2 - n["vertices"] - n["faces"]
        rows.append(f"| `{path}` | {n['vertices']} | {orphans} | {n['pinched_vertices']} | {n['edges']} | {n['faces']} "
                    f"| {half(twice)} | {half(twice + orphans)} | {genus_in_words(mesh)} |")
    return rows


YOUR_TABLES = {"your table 1": your_table_1, "your table 2": your_table_2, "your figure 6": your_figure_6}
TABLES = {"table 1": table_1, "table 2": table_2, "figure 6": figure_6, "cow": cow}


def replaced(text, name, rows):
    """The page with these rows between the marks of a table."""
    begin, end = f"<!-- {name} -->\n", f"\n<!-- end of {name} -->"
    head, rest = text.split(begin)
    return head + begin + "\n".join(rows) + end + rest.split(end)[1]


def remade(text, tables, program):
    for name, table in tables.items():
        text = replaced(text, name, table(program))
    return text


def main():
    program, *folders = [argument for argument in sys.argv[1:] if argument != "--update"]
    stands = PAGE.read_text()
    made = remade(stands, YOUR_TABLES, Program(program, MESHES))
    if folders and pathlib.Path(folders[0]).is_dir():
        made = remade(made, TABLES, Program(program, folders[0]))
    else:
        print("without the meshes of the report: only the tables of your own are looked at")
    if "--update" in sys.argv:
        PAGE.write_text(made)
    elif made != stands:
        for line in sorted(set(made.splitlines()) ^ set(stands.splitlines())):
            print(line)
        sys.exit(f"{PAGE.name} is not what the program says; after a look, run this with --update")


if __name__ == "__main__":
    main()
