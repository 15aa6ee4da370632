"""The reports of meshfixer are as doc/repair.schema.json says; skipped where Python has no validator."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

try:
    import jsonschema
except ImportError:
    jsonschema = None

PROGRAM = os.environ["MESHFIXER"]
MESHES = pathlib.Path(os.environ["MESHES"])
ENDINGS = {".mesh", ".obj", ".off", ".stl", ".ply"}


def report(*arguments):
    result = subprocess.run([PROGRAM, "--json", *arguments], capture_output=True, check=False, timeout=60)
    assert result.returncode in (0, 1), (arguments, result.stderr)
    told = json.loads(result.stdout)
    assert (told["remaining"] == 0) == (result.returncode == 0), arguments
    return told


def unknown_keys(schema, told, where):
    """The keys of a report that the schema does not describe."""
    schema, known = whole(where, schema)
    if isinstance(told, dict) and known:
        for key, value in told.items():
            if key in known:
                yield from unknown_keys(known[key], value, where)
            else:
                yield key
    elif isinstance(told, list) and "items" in schema:
        for value in told:
            yield from unknown_keys(schema["items"], value, where)


def whole(root, schema):
    """A schema with all the properties of those that it refers to."""
    known = {}
    while True:
        known = {**schema.get("properties", {}), **known}
        if "$ref" not in schema:
            return schema, known
        schema = root["$defs"][schema["$ref"].removeprefix("#/$defs/")]


@unittest.skipIf(jsonschema is None, "Python has no jsonschema")
class RepairSchema(unittest.TestCase):
    def setUp(self):
        self.schema = json.loads(pathlib.Path(os.environ["SCHEMA"]).read_text())
        self.validator = jsonschema.Draft202012Validator(self.schema)

    def check(self, *arguments):
        told = report(*map(str, arguments))
        errors = [f"{'/'.join(map(str, error.absolute_path))}: {error.message[:300]}"
                  for error in self.validator.iter_errors(told)]
        self.assertEqual(errors, [], arguments)
        self.assertEqual(sorted(set(unknown_keys(self.schema, told, self.schema))), [], arguments)
        return told

    def meshes(self):
        return sorted(path for path in MESHES.iterdir() if path.suffix in ENDINGS)

    def test_schema_is_one(self):
        jsonschema.Draft202012Validator.check_schema(self.schema)

    def test_what_is_found(self):
        for path in self.meshes():
            told = self.check("--find", path)
            self.assertNotIn("meshes", told)

    def test_what_is_repaired(self):
        for path in self.meshes():
            told = self.check("--dry-run", path)
            self.assertFalse(any(mesh["written"] for mesh in told["meshes"]))

    def test_what_is_written(self):
        with tempfile.TemporaryDirectory() as folder:
            for path in self.meshes():
                told = self.check(path, "-o", pathlib.Path(folder) / path.name)
                self.assertTrue(all(mesh["written"] for mesh in told["meshes"]))

    def test_separate_components(self):
        told = self.check("--separate", "--dry-run", MESHES / "two_cubes.mesh")
        self.assertEqual(len(told["meshes"]), 2)

    def test_cut_list(self):
        told = self.check("--find", "--max-defects", "3", MESHES / "unwelded_cube.mesh")
        self.assertEqual(told["input"]["listed"], 3)
        self.assertGreater(told["input"]["total"], 3)

    def test_wrong_reports_are_refused(self):
        good = self.check("--dry-run", MESHES / "pinched_vertex.mesh")
        for path, value in ((("remaining",), -1), (("input", "counts", "hole"), None), (("fixes",), ["holes"]),
                            (("meshes", 0, "tracking"), [[1]]), (("log", "steps", 0, "pass"), None)):
            bad = json.loads(json.dumps(good))
            place = bad
            for key in path[:-1]:
                place = place[key]
            place[path[-1]] = value
            self.assertFalse(self.validator.is_valid(bad), path)


if __name__ == "__main__":
    unittest.main()
