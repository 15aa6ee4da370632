"""meshfixer loses nothing without a line: on files made up to hold every kind of record, and on every mesh at hand."""
import difflib
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from made_up import made_up_files
from records import count_records, read_ply

PROGRAM = os.environ["MESHFIXER"]
FOLDERS = [pathlib.Path(folder) for folder in os.environ.get("MESHES", "").split(":") if folder]
ENDINGS = ("mesh", "obj", "off", "ply", "stl")
# Larger ones only take longer.
MAX_BYTES = int(os.environ.get("MAX_BYTES", "300000"))
# Kinds that are counted by names, or once a property: statements of them stay even where their elements go.
OF_ELEMENTS = {"vertex_colours", "face_colours", "attribute_words", "references", "normals"}


def fix(path, out, *options):
    """Returns the exit status and the report."""
    result = subprocess.run([PROGRAM, str(path), "-o", str(out), "--json", "--quiet", *options], capture_output=True, check=False,
                            timeout=120)
    return result.returncode, json.loads(result.stdout) if result.stdout else None


def meshes():
    for folder in FOLDERS:
        for path in sorted(folder.rglob("*")):
            if path.suffix[1:].lower() in ENDINGS and path.stat().st_size <= MAX_BYTES:
                yield path


def changed_lines(before, after):
    """The lines that went and those that came."""
    lines = difflib.ndiff(before.splitlines(keepends=True), after.splitlines(keepends=True))
    marked = [line for line in lines if line[0] in "+-"]
    return [line[2:] for line in marked if line[0] == "-"], [line[2:] for line in marked if line[0] == "+"]


class Lossless(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def fixed(self, name, content, *options):
        path = self.folder / name
        path.write_bytes(content)
        out = self.folder / ("out-" + name)
        status, report = fix(path, out, *options)
        self.assertEqual((status, report["lost"]), (0, {}), name)
        return out.read_bytes()

    def assert_nothing_lost(self, name, content, out_name, out, lost, changed=()):
        """Other formats count some kinds otherwise: texture coordinates by vertex, by face or apart; what every face has as one
        property; a header as a comment."""
        before, after = count_records(name, content), count_records(out_name, out)
        is_other = name.rsplit(".", 1)[-1] != out_name.rsplit(".", 1)[-1]
        for kind, n in before.items():
            if kind in changed:
                continue
            n_held = after[kind] + lost.get(kind, 0)
            if is_other and kind == "headers":
                n_held += after["comments"] - before["comments"]
            elif is_other and kind in ("attribute_words", "references"):
                n_held += n * (after["face_properties"] + after["vertex_properties"])
            is_recounted = is_other and kind == "texture_coordinates"
            self.assertGreaterEqual(n_held, min(n, 1) if is_recounted else n, f"{kind} of {name} in {out_name}; lost: {lost}")

    def test_without_a_defect_the_bytes_stay(self):
        for name, content in made_up_files(has_hole=False).items():
            self.assertEqual(self.fixed(name, content), content, name)

    def test_a_filled_hole_only_adds_lines(self):
        # The number of faces stands in a line of its own, and the last line of one file has no end.
        counts = {"ascii.ply": ("element face 23\n", "element face 25\n"), "colours.off": ("26 23 48\n", "26 25 48\n"),
                  "texture.off": ("26 23 0\n", "26 25 0\n"), "inria.mesh": ("Triangles 2\n", "Triangles 4\n")}
        for name, content in made_up_files(has_hole=True).items():
            if name in ("words.stl", "little.ply", "big.ply"):
                continue
            gone, come = changed_lines(content.decode(), self.fixed(name, content).decode())
            if name in counts:
                self.assertEqual(come.pop(0), counts[name][1], name)
            elif name == "colours.obj":
                counts[name] = [come.pop(0).rstrip("\r\n")]
            self.assertEqual(gone, list(counts.get(name, [])[:1]), name)

    def test_a_filled_hole_only_adds_records_to_binary_ply(self):
        for name in ("little.ply", "big.ply"):
            content = made_up_files(has_hole=True)[name]
            header, before = read_ply(content)
            fixed_header, after = read_ply(self.fixed(name, content))
            self.assertEqual(fixed_header, header.replace("face 23", "face 25"))
            for (element, _, old), (_, _, new) in zip(before, after):
                self.assertEqual(new[:len(old)], old, element)

    def test_other_formats_hold_it_or_it_is_counted(self):
        for has_hole in (False, True):
            for name, content in made_up_files(has_hole).items():
                path = self.folder / name
                path.write_bytes(content)
                for ending in ENDINGS:
                    out = self.folder / ("out." + ending)
                    _, report = fix(path, out)
                    self.assert_nothing_lost(name, content, out.name, out.read_bytes(), report["lost"])

    def test_nothing_is_written_where_losses_are_not_allowed(self):
        for name, content in made_up_files(has_hole=True).items():
            path = self.folder / name
            path.write_bytes(content)
            for ending in ENDINGS:
                out = self.folder / ("out." + ending)
                out.unlink(missing_ok=True)
                status, report = fix(path, out, "--strict-attributes")
                self.assertEqual(status, 1 if report["lost"] else 0)
                self.assertEqual(out.exists(), not report["lost"])

    def test_every_mesh_keeps_what_is_not_counted(self):
        for path in meshes():
            out = self.folder / ("out" + path.suffix)
            out.unlink(missing_ok=True)
            status, report = fix(path, out)
            if status == 3 or not out.exists():
                continue
            content, written = path.read_bytes(), out.read_bytes()
            if not report["log"]["steps"]:
                self.assertEqual(written, content, path)
            # The log says which faces went; a polygon of which none stays went with them.
            lost = dict(report["lost"])
            removed = sum(step["faces_removed"] for step in report["log"]["steps"])
            lost["polygons"] = lost.get("polygons", 0) + removed // 2
            with self.subTest(path=str(path)):
                self.assert_nothing_lost(path.name, content, out.name, written, lost, OF_ELEMENTS)


if __name__ == "__main__":
    unittest.main()
