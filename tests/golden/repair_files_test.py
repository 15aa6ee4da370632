"""Checks that meshfixer changes only the repaired parts of whole files, in place and in folders too."""

import json
import os
import pathlib
import resource
import struct
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["MESHFIXER"]

CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
# A cube without its lid.
WALLS = [(0, 3, 2, 1), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]


def run(*arguments, cwd):
    return subprocess.run([PROGRAM, *map(str, arguments)], cwd=cwd, capture_output=True, check=False, timeout=60)


def obj():
    lines = ["# a box"] + [f"v {x}.0 {y}.0 {z}.0" for x, y, z in CORNERS]
    return "\n".join(lines + ["f " + " ".join(str(v + 1) for v in wall) for wall in WALLS]) + "\n"


def binary_ply(order):
    """With a colour a vertex, a label a face, and an element that no mesh has."""
    name = "little" if order == "<" else "big"
    header = (f"ply\nformat binary_{name}_endian 1.0\ncomment a box\nobj_info box\nelement vertex 8\nproperty float x\n"
              "property float y\nproperty float z\nproperty uchar red\nelement face 5\n"
              "property list uchar int vertex_indices\nproperty ushort label\nelement camera 1\nproperty double fov\n"
              "end_header\n").encode()
    vertices = [struct.pack(order + "3fB", *corner, 10 * i) for i, corner in enumerate(CORNERS)]
    faces = [struct.pack(order + "B4iH", 4, *wall, 300 + i) for i, wall in enumerate(WALLS)]
    return header, b"".join(vertices), b"".join(faces), struct.pack(order + "d", 60.0)


def binary_stl():
    facets = []
    for i, wall in enumerate(WALLS):
        for triangle in ((wall[0], wall[1], wall[2]), (wall[0], wall[2], wall[3])):
            points = [x for v in triangle for x in CORNERS[v]]
            facets.append(struct.pack("<12fH", 0, 0, 7, *points, 100 + i))
    return b"exported by hand".ljust(80, b"."), b"".join(facets)


class RepairFiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def fixed(self, name, content):
        self.write(name, content)
        result = run(name, "-o", "out-" + name, cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertNotIn(b"\nlost:", result.stdout)
        return (self.folder / ("out-" + name)).read_bytes()

    def test_an_obj_file_only_gains_lines(self):
        fixed = self.fixed("box.obj", obj()).decode()
        self.assertTrue(fixed.startswith(obj()))
        self.assertEqual(fixed.count("\n"), obj().count("\n") + 2)

    def test_a_binary_ply_file_only_gains_faces_and_their_count(self):
        for order in "<>":
            header, vertices, faces, camera = binary_ply(order)
            fixed = self.fixed("box.ply", header + vertices + faces + camera)
            kept = header.replace(b"face 5", b"face 7") + vertices + faces
            self.assertTrue(fixed.startswith(kept))
            self.assertTrue(fixed.endswith(camera))
            self.assertEqual(len(fixed), len(kept) + len(camera) + 2 * 15)

    def test_a_binary_stl_file_only_gains_facets_and_their_count(self):
        header, facets = binary_stl()
        fixed = self.fixed("box.stl", header + struct.pack("<I", 10) + facets)
        self.assertTrue(fixed.startswith(header + struct.pack("<I", 12) + facets))
        self.assertEqual(fixed[-2:], b"\0\0")

    def test_of_separate_parts_only_that_is_lost_which_none_has(self):
        second = "".join(f"v {x + 5} {y} {z} # right\n" for x, y, z in CORNERS)
        second += "".join("f " + " ".join(str(v + 9) for v in wall) + "\n" for wall in WALLS)
        self.write("two.obj", obj() + second + "l 1 2\nl 9 10\nl 1 9\n")
        result = run("--separate", "--keep-borders", "two.obj", "-o", "part.obj", cwd=self.folder)
        self.assertEqual((self.folder / "part_1.obj").read_text().count("\nl "), 1)
        self.assertEqual((self.folder / "part_2.obj").read_text().count("\nl "), 1)
        # Only the line between the parts is in none.
        self.assertIn(b"\nlost: 1 line or point\n", result.stdout)

    def test_the_table_of_many_files_says_what_all_have_lost(self):
        # A line to a vertex that goes.
        for name in ("a.obj", "b.obj"):
            self.write(name, obj() + "v 7 7 7\nl 1 9\n")
        result = run("a.obj", "b.obj", "-o", "out", cwd=self.folder)
        self.assertIn(b"\na.obj: 2 -> 0 defects, written: out/a.obj, lost: 1 line or point\n", b"\n" + result.stdout)
        self.assertTrue(result.stdout.endswith(b"\nlost: 2 lines and points\n"), result.stdout)

    def test_in_place_keeps_the_original_where_asked_for(self):
        self.write("box.obj", obj())
        result = run("--in-place", "--backup", "box.obj", cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn(b"box.obj: 1 -> 0 defects\n", result.stdout)
        self.assertEqual((self.folder / "box.obj.orig").read_text(), obj())
        self.assertTrue((self.folder / "box.obj").read_text().startswith(obj()))
        self.assertEqual(sorted(os.listdir(self.folder)), ["box.obj", "box.obj.orig"])

    def test_in_place_does_not_touch_what_is_whole(self):
        self.write("box.obj", obj())
        run("--in-place", "box.obj", cwd=self.folder)
        before = os.stat(self.folder / "box.obj")
        result = run("--in-place", "--backup", "box.obj", cwd=self.folder)
        self.assertIn(b"box.obj: 0 -> 0 defects, unchanged\n", result.stdout)
        after = os.stat(self.folder / "box.obj")
        self.assertEqual((before.st_ino, before.st_mtime_ns), (after.st_ino, after.st_mtime_ns))

    def test_a_full_disk_leaves_the_input_and_no_part_of_its_copy(self):
        self.write("box.obj", obj())
        limit = len(obj()) // 2  # of the size of files, in place of the disk
        # Without signals restored the limit is an error of the system call, and does not end the program.
        result = subprocess.run([PROGRAM, "--in-place", "--backup", "box.obj"], cwd=self.folder, capture_output=True,
                                check=False, timeout=60, restore_signals=False,
                                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
        self.assertEqual(result.returncode, 3)
        self.assertEqual(result.stderr, b"box.obj.orig: cannot be written: File too large\n")
        self.assertEqual(os.listdir(self.folder), ["box.obj"])
        self.assertEqual((self.folder / "box.obj").read_text(), obj())

    @unittest.skipIf("SANITIZED" in os.environ, "sanitizers end the program where there is no memory left")
    def test_a_file_too_large_for_the_memory_does_not_keep_others_from_being_repaired(self):
        self.write("box.obj", obj())
        n = 300_000  # facets, for each of which a repair needs some hundred bytes
        facets = b"".join(struct.pack("<12fH", *(0, 0, 0), *((i * k) % 1009 for k in range(1, 10)), 0) for i in range(n))
        self.write("large.stl", bytes(80) + struct.pack("<I", n) + facets)
        limit = 40 << 20
        result = subprocess.run([PROGRAM, "--threads", "1", ".", "-o", "fixed"], cwd=self.folder, capture_output=True,
                                check=False, timeout=60,
                                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_DATA, (limit, limit)))
        self.assertEqual(result.returncode, 3)
        self.assertIn(b"large.stl: not enough memory\n", result.stderr)
        self.assertIn(b"hole: 1 -> 0\n", result.stdout)
        self.assertEqual(os.listdir(self.folder / "fixed"), ["box.obj"])

    def test_a_pipe_is_written_and_not_read_back(self):
        self.write("box.obj", obj())
        os.mkfifo(self.folder / "pipe.obj")
        with subprocess.Popen(["cat", "pipe.obj"], cwd=self.folder, stdout=subprocess.PIPE) as reader:
            result = subprocess.run([PROGRAM, "box.obj", "-o", "pipe.obj"], cwd=self.folder, capture_output=True,
                                    check=False, timeout=10)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn(b"\nwritten: pipe.obj\n", result.stdout)
            self.assertEqual(reader.stdout.read().decode(), self.fixed("box.obj", obj()).decode())

    def test_a_device_is_written_and_not_read_back(self):
        self.write("box.obj", obj())
        os.symlink("/dev/null", self.folder / "null.obj")
        result = run("box.obj", "-o", "null.obj", cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn(b"\nhole: 1 -> 0\n", result.stdout)

    def test_an_older_original_is_not_written_over(self):
        self.write("box.obj", obj())
        self.write("box.obj.orig", "older")
        result = run("--in-place", "--backup", "box.obj", cwd=self.folder)
        self.assertEqual(result.returncode, 3)
        self.assertEqual((self.folder / "box.obj").read_text(), obj())
        self.assertEqual((self.folder / "box.obj.orig").read_text(), "older")

    def test_many_files_are_told_of_in_json_and_ndjson(self):
        for name in ("a.obj", "b.obj"):
            self.write(name, obj())
        self.write("c.obj", "no mesh")
        result = run("a.obj", "b.obj", "c.obj", "-o", "out", "--json=all.json", "--ndjson=all.ndjson", cwd=self.folder)
        self.assertEqual(result.returncode, 3)
        report = json.loads((self.folder / "all.json").read_text())
        lines = [json.loads(line) for line in (self.folder / "all.ndjson").read_text().splitlines()]
        self.assertEqual(report["reports"], lines)
        self.assertEqual([line.get("remaining") for line in lines], [0, 0, None])
        self.assertTrue(lines[2]["error"].startswith("c.obj:1: "))
        self.assertIn("files: 3\nchanged: 2\n", result.stdout.decode())


if __name__ == "__main__":
    unittest.main()
