"""After every kind of repair, faces have the attributes of what they were made of, interpolated where a corner moved.

Each mesh gets attributes that are linear in space: texture coordinates and numbers of vertices that are its coordinates, and a label
a face. Then wherever a face was made of another, its texture coordinates and numbers must be those of its place, whatever was
split, flipped, welded or cut; and its middle must be on the face that its label names.
"""
import json
import math
import os
import pathlib
import subprocess
import tempfile
import unittest

from records import read_ply

PROGRAM = os.environ["MESHFIXER"]
MESHES = pathlib.Path(os.environ["MESHES"].split(":")[0])
REPAIRS = {
    "all of meshes/": ([], None),
    "flips and splits of thin faces": (["--fix", "flat-facet,degenerate-facet", "--degen-tolerance", "0.01"], None),
    "welds": (["--weld", "0.05", "--max-deviation", "0.1"], None),
    "foldovers": (["--fix", "foldover", "--max-foldover-angle", "30"], None),
    "cuts": ([], ["crossing_cubes", "touching_cubes", "tetrahedra_sharing_edge", "crossing_faces"]),
}


def read_native(path):
    points, faces = {}, []
    for words in map(str.split, path.read_text().splitlines()):
        if words[:1] == ["Vertex"]:
            points.setdefault(words[1], tuple(map(float, words[2:5])))
        elif words[:1] == ["Face"]:
            faces.append(words[2:5])
    numbers = {vertex: i for i, vertex in enumerate(points)}
    return list(points.values()), [[numbers[v] for v in face] for face in faces if all(v in numbers for v in face)]


def texture(point):
    x, y, z = point
    return x + 2 * z, y - z


def as_obj(points, faces):
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in points] + ["vt {!r} {!r}".format(*texture(p)) for p in points]
    return "\n".join(lines + ["f " + " ".join(f"{v + 1}/{v + 1}" for v in face) for face in faces]) + "\n"


def as_ply(points, faces):
    header = (f"ply\nformat ascii 1.0\nelement vertex {len(points)}\n" + "".join(f"property double {n}\n" for n in ("x", "y", "z")) +
              "".join(f"property double at_{n}\n" for n in ("x", "y", "z")) + f"element face {len(faces)}\n"
              "property list uchar int vertex_indices\nproperty int label\nend_header\n")
    vertices = "".join(" ".join(map(repr, p + p)) + "\n" for p in points)
    return header + vertices + "".join(f"3 {a} {b} {c} {i}\n" for i, (a, b, c) in enumerate(faces))


def as_off(points, faces):
    """Colours from 0 to 1; the numbers are bytes nowhere, as each has a point."""
    lines = ["COFF", f"{len(points)} {len(faces)} 0"]
    lines += [f"{x!r} {y!r} {z!r} {x!r} {y!r} {z!r} 1.0" for x, y, z in points]
    return "\n".join(lines + [f"3 {a} {b} {c} {i % 256} 0 0" for i, (a, b, c) in enumerate(faces)]) + "\n"


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def distance_to_segment(p, a, b):
    along = minus(b, a)
    length = dot(along, along)
    share = min(1.0, max(0.0, dot(minus(p, a), along) / length)) if length else 0.0
    return math.dist(p, [x + share * d for x, d in zip(a, along)])


def distance(p, triangle):
    """From a point to a triangle."""
    a, b, c = triangle
    u, v, w = minus(b, a), minus(c, a), minus(p, a)
    uu, uv, vv, wu, wv = dot(u, u), dot(u, v), dot(v, v), dot(w, u), dot(w, v)
    area = uu * vv - uv * uv
    if area > 1e-12 * uu * vv:
        s, t = (vv * wu - uv * wv) / area, (uu * wv - uv * wu) / area
        if min(s, t) >= 0 and s + t <= 1:
            return math.dist(p, [x + s * d + t * e for x, d, e in zip(a, u, v)])
    return min(distance_to_segment(p, *edge) for edge in ((a, b), (b, c), (c, a)))


class Attributes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def repaired(self, ending, content, options):
        """The file after repair, and what may have moved how far; nothing where none was written."""
        path, out = self.folder / ("in." + ending), self.folder / ("out." + ending)
        path.write_text(content)
        out.unlink(missing_ok=True)
        result = subprocess.run([PROGRAM, str(path), "-o", str(out), "--json", "--quiet", *options], capture_output=True, check=False,
                                timeout=120)
        if not out.exists():
            self.assertIn(result.returncode, (1, 3), result.stderr)
            return None, 0.0
        # A vertex that is moved keeps what it had.
        return out, 2.5 * json.loads(result.stdout)["max_deviation"] + 1e-6

    def cases(self):
        """Meshes of the native format, and what is done with them."""
        for title, (options, names) in REPAIRS.items():
            for path in sorted(MESHES.glob("*.mesh")):
                if (names is None or path.stem in names) and "MeshVersion" not in path.read_text():
                    points, faces = read_native(path)
                    if faces:
                        yield f"{title}: {path.name}", options, points, faces

    def test_texture_coordinates_are_those_of_the_place(self):
        n_checked = 0
        for title, options, points, faces in self.cases():
            out, tolerance = self.repaired("obj", as_obj(points, faces), options)
            lines = [line.split() for line in out.read_text().splitlines()] if out else []
            places = [tuple(map(float, words[1:])) for words in lines if words[0] == "v"]
            named = [tuple(map(float, words[1:])) for words in lines if words[0] == "vt"]
            for words in lines:
                for corner in words[1:] if words[0] == "f" and "/" in words[1] else []:
                    v, vt = (int(n) - 1 for n in corner.split("/"))
                    for a, b in zip(named[vt], texture(places[v])):
                        self.assertAlmostEqual(a, b, delta=3 * tolerance, msg=title)
                    n_checked += 1
        self.assertGreater(n_checked, 1000)

    def test_numbers_of_vertices_are_those_of_the_place_and_labels_those_of_the_face(self):
        n_added = 0
        for title, options, points, faces in self.cases():
            out, tolerance = self.repaired("ply", as_ply(points, faces), options)
            if out is None:
                continue
            _, ((_, _, vertices), (_, _, written)) = read_ply(out.read_bytes())
            patch = self.is_patched(title)
            for record in vertices:
                place, numbers = [n for (n,) in record[:3]], [n for (n,) in record[3:]]
                if not patch:
                    self.assertLessEqual(math.dist(place, numbers), 3 * tolerance, title)
            for corners, (label,) in written:
                places = [[n for (n,) in vertices[int(v)][:3]] for v in corners]
                middle = tuple(sum(c) / 3 for c in zip(*places))
                if not patch:
                    self.assertLessEqual(distance(middle, [points[v] for v in faces[int(label)]]), 3 * tolerance, title)
                    n_added += 1
        self.assertGreater(n_added, 1000)

    @staticmethod
    def is_patched(title):
        """Patches have the numbers of a face beside them, which says nothing of their place."""
        return title.startswith("all of")

    def test_colours_of_off_files_are_those_of_the_place(self):
        for title, options, points, faces in self.cases():
            largest = max(map(max, points))
            if self.is_patched(title) or min(map(min, points)) < 0:
                continue
            scaled = [tuple(float(x) / largest for x in p) for p in points]
            out, tolerance = self.repaired("off", as_off(scaled, faces), options)
            records = [line.split() for line in out.read_text().splitlines()[1:] if line] if out else [["0"]]
            for record in records[1:1 + int(records[0][0])]:
                numbers = list(map(float, record))
                self.assertLessEqual(math.dist(numbers[:3], numbers[3:6]), 3 * tolerance, title)


if __name__ == "__main__":
    unittest.main()
