"""What is written does not depend on the number of threads nor on the memory that may be used."""

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


if __name__ == "__main__":
    unittest.main()
