"""--separation-ply draws what the JSON report says of each vertex."""

import math
import re
import struct
import unittest

import program

HEADER = re.compile(rb"""ply
format binary_little_endian 1\.0
(?:comment [^\n]*\n)*element vertex (\d+)
property double x
property double y
property double z
property double quality
property uchar red
property uchar green
property uchar blue
element face (\d+)
property list uchar int vertex_indices
end_header
""")
VERTEX = struct.Struct("<4d3B")
FACE = struct.Struct("<B3i")


class Picture:
    def __init__(self, content):
        header = HEADER.match(content)
        assert header, content[:400]
        n_vertices, n_faces = int(header[1]), int(header[2])
        begin, middle = header.end(), header.end() + n_vertices * VERTEX.size
        records = [VERTEX.unpack_from(content, begin + i * VERTEX.size) for i in range(n_vertices)]
        self.points = [record[:3] for record in records]
        self.qualities = [record[3] for record in records]
        self.colours = [record[4:] for record in records]
        self.faces = [FACE.unpack_from(content, middle + i * FACE.size) for i in range(n_faces)]
        assert len(content) == middle + n_faces * FACE.size


def is_grey(colour):
    return max(colour) - min(colour) <= 1


class Pictures(program.SetTest):
    def draw(self, *arguments, name):
        """The set's report and its pictures, by the name of the mesh."""
        report = self.report("-p", "-s", "--separation-ply", "new/pictures", *arguments, name)
        files = sorted((self.folder / "new/pictures").iterdir())
        self.assertEqual([file.stem + ".mesh" for file in files], sorted(report["set"]["closest"]))
        return report, {file.stem + ".mesh": Picture(file.read_bytes()) for file in files}

    def records_of(self, name):
        """Points and triangles of a mesh file whose ids are 1, 2, ..."""
        points, faces = [], []
        for line in self.read(name).decode().splitlines():
            words = line.split()
            if words and words[0] == "Vertex":
                points.append(tuple(float(word) for word in words[2:]))
            elif words:
                faces.append(tuple(int(word) - 1 for word in words[2:]))
        return points, faces

    def check(self, *arguments, name):
        report, pictures = self.draw(*arguments, name=name)
        for mesh, rows in report["set"]["closest"].items():
            points, faces = self.records_of(f"{name}/{mesh}")
            picture = pictures[mesh]
            self.assertEqual(picture.points, points, mesh)
            self.assertEqual(picture.faces, [(3, *face) for face in faces], mesh)
            for vertex, distance, *_ in rows:
                quality = picture.qualities[vertex - 1]
                if distance is None:
                    self.assertTrue(math.isnan(quality), f"{mesh}: vertex {vertex}")
                    self.assertTrue(is_grey(picture.colours[vertex - 1]), f"{mesh}: vertex {vertex}")
                else:
                    self.assertEqual(quality, distance, f"{mesh}: vertex {vertex}")
        return report["set"]["closest"], pictures

    def test_quality_is_the_distance(self):
        self.copy("gap")
        self.check(name="gap")

    def test_many_vertices(self):
        self.pack(8, 200)
        self.check("--search-radius", "1", name="packed")

    def test_vertex_that_no_face_uses_has_no_distance(self):
        self.copy("fold")
        self.write("fold/sheet.mesh", "Vertex 1 9 0 0\nVertex 2 5 5 5\nVertex 3 9 1 0\nVertex 4 9 0 1\nFace 1 1 3 4\n")
        closest, pictures = self.check("--force", name="fold")
        self.assertEqual([row[:2] for row in closest["sheet.mesh"]], [[1, 3.0], [3, 3.0], [4, 3.0]])
        self.assertTrue(math.isnan(pictures["sheet.mesh"].qualities[1]))

    def test_closest_rows_name_where_the_point_is(self):
        self.pack(8, 200)
        closest, _ = self.check(name="packed")
        for mesh, rows in closest.items():
            points, _ = self.records_of(f"packed/{mesh}")
            for vertex, distance, other, face, point in rows:
                self.assertNotEqual(other, mesh)
                self.assertAlmostEqual(math.dist(points[vertex - 1], point), abs(distance), places=12)
                self.check_on_face(point, f"packed/{other}", face)

    def check_on_face(self, point, name, face):
        """That a point is where its place within the triangle says, which is within it."""
        points, faces = self.cached_records(name)
        a, b, c = (points[v] for v in faces[face - 1])
        u, v, w = ([q - p for p, q in zip(a, x)] for x in (b, c, point))
        uu, uv, vv, wu, wv = (sum(p * q for p, q in zip(*pair)) for pair in ((u, u), (u, v), (v, v), (w, u), (w, v)))
        s = (wu * vv - wv * uv) / (uu * vv - uv * uv)
        t = (wv * uu - wu * uv) / (uu * vv - uv * uv)
        on_plane = [p + s * q + t * r for p, q, r in zip(a, u, v)]
        self.assertLess(math.dist(on_plane, point), 1e-12)
        self.assertTrue(s > -1e-12 and t > -1e-12 and s + t < 1.0 + 1e-12, f"{point} is not on face {face} of {name}")

    def cached_records(self, name):
        cache = self.__dict__.setdefault("records", {})
        if name not in cache:
            cache[name] = self.records_of(name)
        return cache[name]

    def test_inside_and_outside_have_different_colours(self):
        self.copy("nest")
        closest, pictures = self.check(name="nest")
        rows = {row[0]: row[1] for row in closest["half_in.mesh"]}
        inside = {pictures["half_in.mesh"].colours[v - 1] for v, d in rows.items() if d < 0}
        outside = {pictures["half_in.mesh"].colours[v - 1] for v, d in rows.items() if d > 0}
        self.assertFalse(inside & outside)
        self.assertTrue(inside and outside)

    def test_equal_distances_have_equal_colours(self):
        self.copy("gap")
        closest, pictures = self.check(name="gap")
        colours = {}
        for vertex, distance, *_ in closest["upper_plate.mesh"]:
            colours.setdefault(distance, set()).add(pictures["upper_plate.mesh"].colours[vertex - 1])
        self.assertEqual(sorted(colours), [3.0, 4.0])
        self.assertTrue(all(len(of_one) == 1 for of_one in colours.values()))
        self.assertNotEqual(colours[3.0], colours[4.0])

    def test_same_names_in_two_folders_are_two_pictures(self):
        self.copy("set")
        (self.folder / "set").rename(self.folder / "left")
        self.copy("set")
        self.run_program("-a", "-s", "--separation-ply=pictures", "left", "set")
        self.assertEqual(len(list((self.folder / "pictures").iterdir())), 6)

    def test_bad_set_has_no_pictures(self):
        self.copy("gap")
        self.write("gap/sheet.mesh", program.SHEET)
        said = self.run_program("-a", "-s", "--separation-ply=pictures", "gap", status=program.TROUBLE)
        self.assertIn("--separation-ply has written nothing: every mesh must be good", said.errors)
        self.assertFalse((self.folder / "pictures").exists())

    def test_part_that_finds_a_bad_mesh_has_no_pictures(self):
        self.copy("gap")
        self.write("gap/sheet.mesh", program.SHEET)
        said = self.run_program("-a", "-s", "--separation-ply=pictures", "--shard=2/2", "--ndjson=part2.ndjson",
                                "gap", status=program.TROUBLE)
        self.assertIn("--separation-ply has written nothing: every mesh must be good", said.errors)
        self.assertFalse((self.folder / "pictures").exists())

    def test_folder_that_cannot_be_made(self):
        self.copy("set")
        self.write("pictures", "in the way")
        said = self.run_program("-a", "-s", "--separation-ply=pictures", "set", status=program.TROUBLE)
        self.assertIn("pictures", said.errors)
        self.assertEqual(self.read("pictures"), b"in the way")


if __name__ == "__main__":
    unittest.main()
