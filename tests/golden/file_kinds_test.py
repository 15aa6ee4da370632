#!/usr/bin/env python3
"""Asks the same questions about meshes whose files are packed, marked, wrongly named or of a rarer kind, and compares the answers.

usage: file_kinds_test.py MESHALYZER MESHFIXER FOLDER
"""

import gzip
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

MARK = b"\xef\xbb\xbf"
ENDINGS = [".mesh", ".obj", ".off", ".stl", ".ply"]


def run(program, *arguments, stdin=b""):
    return subprocess.run([program, *map(str, arguments)], capture_output=True, input=stdin, timeout=120, check=False)


def is_text(content):
    return b"\0" not in content


class FileKinds(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.paths = [path for path in sorted(MESHES.iterdir()) if path.suffix in ENDINGS]

    def reports(self, paths):
        """What is said of each file that can be read, but for what it is called, by its number."""
        report = json.loads(run(MESHALYZER, "--json", *paths).stdout)
        numbers = {str(path): number for number, path in enumerate(paths)}
        said = {}
        for mesh in report["meshes"]:
            number = numbers[mesh.pop("path")]
            mesh.pop("named_format", None)
            said[number] = mesh
        return said

    def assert_same_reports(self, write):
        """@param write  Writes a variant of a file, and returns its path; nothing where it has none."""
        pairs = [(path, write(path)) for path in self.paths]
        pairs = [(path, variant) for path, variant in pairs if variant]
        self.assertGreater(len(pairs), 20)
        self.assertEqual(self.reports([path for path, _ in pairs]), self.reports([variant for _, variant in pairs]))

    def written(self, name, content):
        path = self.folder / name
        path.write_bytes(content)
        return path

    def test_gzipped_files_are_the_same_meshes(self):
        self.assert_same_reports(lambda path: self.written(path.name + ".gz", gzip.compress(path.read_bytes())))

    def test_marked_texts_are_the_same_meshes(self):
        self.assert_same_reports(
            lambda path: self.written(path.name, MARK + path.read_bytes()) if is_text(path.read_bytes()) else None)

    def test_wrongly_named_files_are_the_same_meshes(self):
        def write(path):
            other = ENDINGS[(ENDINGS.index(path.suffix) + 1) % len(ENDINGS)]
            return self.written(path.name + other, path.read_bytes())

        self.assert_same_reports(write)

    def test_a_wrong_name_is_told_of_everywhere(self):
        path = self.written("cube.stl", (MESHES / "cube.off").read_bytes())
        self.assertIn("format: off (by its content; its name says stl)", run(MESHALYZER, path).stdout.decode())
        self.assertEqual(json.loads(run(MESHALYZER, "--json", path).stdout)["meshes"][0]["named_format"], "stl")
        self.assertIn("note: read as off by its content", run(MESHALYZER, "check", path).stdout.decode())
        for name in ("json", "ndjson", "sarif", "junit", "github"):
            self.assertIn("stl", run(MESHALYZER, "check", "--format", name, path).stdout.decode().replace("cube.stl", ""))
        self.assertIn("its name says stl", run(MESHFIXER, "--find", path).stdout.decode())

    def test_damaged_gzip_is_refused(self):
        packed = gzip.compress((MESHES / "cube.off").read_bytes())
        bomb = gzip.compress(bytes(20_000_000))
        for name, content in {"cut.off.gz": packed[:-9], "changed.off.gz": packed[:60] + b"x" + packed[61:],
                              "more.off.gz": packed + b"more", "bomb.off.gz": bomb}.items():
            path = self.written(name, content)
            for arguments in ([MESHALYZER, path], [MESHALYZER, "check", path], [MESHFIXER, "--find", path]):
                result = run(*arguments)
                self.assertEqual(result.returncode, 3, arguments)
                self.assertIn(f"{path}:byte ".encode(), result.stderr + result.stdout)
        allowed = run(MESHALYZER, "--max-unpack-ratio", "2000", self.folder / "bomb.off.gz")
        self.assertNotIn(b"times their size", allowed.stderr)

    def fixed(self, path, name, *options):
        result = run(MESHFIXER, path, "-o", self.folder / name, *options)
        self.assertIn(result.returncode, (0, 1), result.stderr)
        return (self.folder / name).read_bytes(), result.stdout.decode()

    def test_what_is_not_broken_stays_packed_or_plain_as_it_was(self):
        plain = (MESHES / "cube.off").read_bytes()
        packed = self.written("cube.off.gz", gzip.compress(plain, 1, mtime=7))
        self.assertEqual(self.fixed(packed, "same.off.gz")[0], packed.read_bytes())
        self.assertEqual(self.fixed(packed, "plain.off")[0], plain)
        self.assertEqual(gzip.decompress(self.fixed(MESHES / "cube.off", "packed.off.gz")[0]), plain)
        result = run(MESHFIXER, "-", "-o", "-", stdin=packed.read_bytes())
        self.assertEqual(result.stdout, packed.read_bytes())

    def test_what_is_mended_is_the_same_packed_and_marked(self):
        for name in ("missing_vertex.mesh", "cube_with_hole.mesh", "pinched_vertex.mesh"):
            content = (MESHES / name).read_bytes()
            mended = self.fixed(MESHES / name, "mended.mesh")[0]
            packed = self.written("packed.mesh.gz", gzip.compress(content))
            self.assertEqual(gzip.decompress(self.fixed(packed, "mended.mesh.gz")[0]), mended)
            marked = self.written("marked.mesh", MARK + content)
            self.assertEqual(self.fixed(marked, "mended_too.mesh")[0], MARK + mended)
            run(MESHFIXER, "--in-place", packed)
            self.assertEqual(gzip.decompress(packed.read_bytes()), mended)

    def test_in_place_a_wrongly_named_file_stays_of_its_format(self):
        path = self.written("hole.stl", (MESHES / "cube_with_hole.mesh").read_bytes())
        self.assertEqual(run(MESHFIXER, "--in-place", path).returncode, 0)
        self.assertEqual(path.read_bytes(), self.fixed(MESHES / "cube_with_hole.mesh", "hole.mesh")[0])

    def test_separate_parts_of_a_packed_file_are_packed(self):
        packed = self.written("two.mesh.gz", gzip.compress((MESHES / "two_cubes.mesh").read_bytes()))
        run(MESHFIXER, "--separate", packed, "-o", self.folder / "part.mesh.gz")
        for number in (1, 2):
            self.assertTrue(gzip.decompress((self.folder / f"part_{number}.mesh.gz").read_bytes()))

    def binary_off(self, name):
        """The OFF text of a mesh, in binary."""
        words = (MESHES / name).read_text().split("\n", 1)[1].split()
        n_vertices, n_faces = int(words[0]), int(words[1])
        numbers = words[3:]
        content = b"OFF BINARY\n" + struct.pack(">3i", n_vertices, n_faces, 0)
        content += struct.pack(f">{3 * n_vertices}f", *map(float, numbers[:3 * n_vertices]))
        rest = numbers[3 * n_vertices:]
        for face in range(n_faces):
            content += struct.pack(">5i", *map(int, rest[4 * face:4 * face + 4]), 0)
        return content

    def test_binary_off_is_the_same_mesh_and_is_mended_as_text(self):
        path = self.written("binary.off", self.binary_off("cube.off"))
        self.assertEqual(self.reports([path]), self.reports([MESHES / "cube.off"]))
        self.assertEqual(self.fixed(path, "same.off")[0], path.read_bytes())
        content = path.read_bytes()
        # Without its last face of 20 bytes it has a hole.
        open_cube = content[:15] + struct.pack(">i", 11) + content[19:-20]
        path = self.written("open.off", open_cube)
        mended, report = self.fixed(path, "mended.off")
        self.assertTrue(mended.startswith(b"OFF\n"))
        self.assertIn("written as text: binary OFF is only read", report)

    def test_strips_are_mended_as_faces(self):
        header = ("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                  "element tristrips 1\nproperty list int int vertex_indices\nend_header\n")
        corners = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
        # The strip 0 1 2 3 0 1 is the tetrahedron 0 1 2, 2 1 3, 2 3 0, 0 3 1, turned inside out.
        path = self.written("whole.ply", (header + corners + "6 0 1 2 3 0 1\n").encode())
        figures = self.reports([path])[0]
        self.assertEqual(figures["characteristics"]["faces"], 4)
        self.assertTrue(figures["attributes"]["closed"] and figures["attributes"]["consistent"])
        path = self.written("open.ply", (header + corners + "5 0 1 2 3 0\n").encode())
        mended, report = self.fixed(path, "mended.ply")
        self.assertIn(b"element face 4", mended)
        self.assertIn("written as faces: strips of triangles are only read", report)


if __name__ == "__main__":
    MESHALYZER, MESHFIXER, MESHES = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    unittest.main(argv=sys.argv[:1])
