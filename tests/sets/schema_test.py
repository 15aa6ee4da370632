"""The reports of sets are as doc/report.schema.json says; skipped where Python has no validator."""

import json
import os
import pathlib
import unittest

import program

try:
    import jsonschema
except ImportError:
    jsonschema = None

QUESTIONS = [(), ("-p",), ("-a",), ("-a", "-i"), ("-a", "-s"), ("--curvature=one-ring",), ("-g", "100,0,0"), ("-g=100,0,0", "-p", "-i", "-s"),
             ("-s", "-a", "--search-radius", "1", "--search-cone", "45", "--include-self", "1")]


@unittest.skipIf(jsonschema is None, "Python has no jsonschema")
class Schema(program.SetTest):
    def setUp(self):
        super().setUp()
        self.schema = json.loads(pathlib.Path(os.environ["SCHEMA"]).read_text())
        self.validator = jsonschema.Draft202012Validator(self.schema)

    def check(self, *arguments, status=program.DONE):
        report = self.report(*arguments, status=status)
        errors = [f"{'/'.join(map(str, error.absolute_path))}: {error.message[:300]}"
                  for error in self.validator.iter_errors(report)]
        self.assertEqual(errors, [], arguments)
        return report

    def test_good_sets(self):
        for name in ("nest", "clash"):
            self.copy(name)
            for questions in QUESTIONS:
                meet = "-i" in questions and "-a" not in questions
                self.check(*questions, name, status=program.NOT_GOOD if meet else program.DONE)

    def test_set_with_a_bad_mesh(self):
        self.copy("gap")
        self.write("gap/sheet.mesh", program.SHEET)
        self.assertIsNone(self.check("gap")["set"]["separation"])
        self.assertTrue(self.check("--force", "gap")["set"]["separation_forced"])

    def test_set_with_an_unreadable_file(self):
        self.copy("gap")
        self.write("gap/broken.mesh", program.NO_MESH)
        self.assertEqual(self.check("gap", status=program.TROUBLE)["set"]["unreadable"], 1)

    def test_set_of_unreadable_files(self):
        (self.folder / "bad").mkdir()
        self.write("bad/broken.mesh", program.NO_MESH)
        self.check("bad", status=program.TROUBLE)

    def test_schema_knows_every_member_of_a_set(self):
        self.copy("nest")
        known = self.schema["$defs"]["set"]["properties"]
        self.assertEqual([name for name in self.report("nest")["set"] if name not in known], [])


if __name__ == "__main__":
    unittest.main()
