"""Checks that output depends neither on the number of threads nor on the memory limit."""

import unittest

import program

WAYS = [("--threads", "1"), ("--threads", "2"), ("--memory-limit", "1K"),
        ("--threads", "1", "--memory-limit", "1K"), ("--memory-limit", "2G", "--threads", "7")]
QUESTIONS = [(), ("-p", "-i"), ("-a", "-s"), ("-g", "100,0,0", "-p", "-s", "--search-radius", "1"),
             ("-a", "-s", "--include-self", "2", "--search-cone", "70")]


class SameBytes(program.SetTest):
    def check(self, *arguments):
        want = self.run_program(*arguments).out
        self.assertGreater(len(want), 100)
        for way in WAYS:
            self.assert_same(self.run_program(*way, *arguments).out, want, f"{arguments} with {way}")

    def test_text(self):
        self.pack(9, 100)
        for questions in QUESTIONS:
            self.check(*questions, "packed")

    def test_json(self):
        self.pack(9, 100)
        for questions in QUESTIONS:
            self.check("--json", *questions, "packed")

    def test_ndjson(self):
        self.pack(9, 100)
        for questions in QUESTIONS:
            self.check("--ndjson", *questions, "packed")

    def test_summary_of_several_sets(self):
        for name in ("clash", "nest", "gap", "fold", "set"):
            self.copy(name)
        self.check("--summary", "clash", "nest", "gap", "fold", "set")

    def test_ndjson_of_files_that_are_no_set(self):
        self.pack(9, 100)
        self.check("--ndjson", "packed/1.mesh", "packed/9.mesh", "packed/5.mesh", "packed/5.mesh")

    def test_journal_is_what_goes_to_standard_output(self):
        self.pack(9, 100)
        self.run_program("--ndjson=journal.ndjson", "packed")
        self.assert_same(self.read("journal.ndjson"), self.run_program("--ndjson", "packed").out, "journal")

    def pictures(self, *arguments):
        """The pages, fields and curvatures of a set."""
        out = self.run_program(*arguments, "--json", "--curvature", "--html", "a.html", "--export", "f.vtp", "--field",
                               "separation", "-s", "packed").out
        names = ["a.html", *sorted(str(file.relative_to(self.folder)) for folder in ("a_pages", "f")
                                   for file in (self.folder / folder).iterdir())]
        return out, {name: self.read(name) for name in names}

    def test_pictures(self):
        self.pack(9, 100)
        want_out, want = self.pictures()
        self.assertEqual(len(want), 1 + 9 + 9)
        # Resumed: nothing is looked for again, and the files are read a second time.
        for way in [*WAYS, ("--ndjson=journal.ndjson",), ("--resume", "journal.ndjson")]:
            out, got = self.pictures(*way)
            self.assert_same(out, want_out, f"report with {way}")
            self.assertEqual(sorted(got), sorted(want))
            for name, content in got.items():
                self.assert_same(content, want[name], f"{name} with {way}")


if __name__ == "__main__":
    unittest.main()
