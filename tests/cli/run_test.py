#!/usr/bin/env python3
"""Checks how run.py reads the lines that a case holds, that it says which line is missing, and that it never rewrites them."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import run

REPORT = "HEAD\nfile: a\nholes: 1\nslits: 0\nfolds: 0\n\nTAIL\nall: 1\n"


def trouble(held, got=REPORT):
    return run.first_difference(held.split("\n"), got.split("\n"))


class Lines(unittest.TestCase):
    def test_the_text_itself_is_held(self):
        self.assertIsNone(trouble(REPORT))

    def test_a_line_of_dots_is_any_lines_of_a_paragraph(self):
        self.assertIsNone(trouble("HEAD\n...\n\nTAIL\nall: 1\n"))
        self.assertIsNone(trouble("HEAD\n...\nslits: 0\n...\n\n...\nTAIL\n...\nall: 1\n...\n"))

    def test_no_dots_reach_over_an_empty_line(self):
        self.assertIn("line 3", trouble("HEAD\n...\nTAIL\nall: 1\n"))

    def test_dots_with_an_end_are_lines_that_end_so(self):
        self.assertIsNone(trouble("HEAD\nfile: a\nholes: 1\n...: 0\n\nTAIL\nall: 1\n"))
        self.assertIn("line 4", trouble("HEAD\nfile: a\n...: 0\n\nTAIL\nall: 1\n"))

    def test_dots_within_a_line_are_any_characters(self):
        self.assertIsNone(trouble("HEAD\nfile: ...\nh...s: 1\n...: 0\n\nTAIL\nall: 1\n"))

    def test_lines_are_whole_and_follow_each_other(self):
        self.assertIn("line 2", trouble("HEAD\nfile\n...\n\nTAIL\nall: 1\n"))
        self.assertIn("line 4", trouble("HEAD\nfile: a\nholes: 1\nfolds: 0\n\nTAIL\nall: 1\n"))
        self.assertIn("line 4", trouble("HEAD\nfile: a\n...\nfile: a\n...\n\nTAIL\nall: 1\n"))

    def test_nothing_may_come_before_after_or_be_cut_off(self):
        self.assertIn("line 1", trouble("file: a\n...\n\nTAIL\nall: 1\n"))
        self.assertIn("goes on with line 7: TAIL", trouble("HEAD\n...\n"))
        self.assertIn("goes on with line 2", trouble("HEAD", "HEAD\n"))
        self.assertIn("line 2", trouble("HEAD\n", "HEAD"))


class Runs(unittest.TestCase):
    """A case whose program is `echo`."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.case = pathlib.Path(folder.name, "case")
        self.case.mkdir()
        self.write("args", "holes: 1\n")
        self.write("exit", "0\n")

    def write(self, name, content):
        (self.case / name).write_text(content)

    def run_case(self, **environment):
        command = [sys.executable, run.__file__, "/bin/echo", self.case, "/", self.case.parent / "scratch"]
        result = subprocess.run(command, env={**os.environ, "UPDATE": "", **environment}, capture_output=True, text=True,
                                check=False)
        return result.returncode, result.stderr

    def test_a_line_that_is_not_found_is_told_with_the_output(self):
        self.write("stdout_lines", "holes: 2\n")
        status, message = self.run_case()
        self.assertEqual(status, 1)
        self.assertIn("line 1 is not found after line 0 of the output: holes: 2", message)
        self.assertIn("--- got\nholes: 1", message)

    def test_a_text_beside_its_lines_is_an_error(self):
        self.write("stdout_lines", "holes: ...\n")
        self.assertEqual(self.run_case()[0], 0)
        self.write("stdout", "holes: 7\n")
        status, message = self.run_case()
        self.assertEqual(status, 1)
        self.assertIn("stdout and stdout_lines cannot both be held", message)

    def test_an_update_writes_whole_texts(self):
        self.assertEqual(self.run_case()[0], 1)
        self.assertEqual(self.run_case(UPDATE="1")[0], 0)
        self.assertEqual((self.case / "stdout").read_text(), "holes: 1\n")
        self.assertEqual(self.run_case()[0], 0)

    def test_an_update_leaves_lines_and_says_so(self):
        self.write("stdout_lines", "holes: 2\n")
        status, message = self.run_case(UPDATE="1")
        self.assertEqual(status, 1)
        self.assertIn("UPDATE=1 does not rewrite it", message)
        self.assertEqual((self.case / "stdout_lines").read_text(), "holes: 2\n")
        self.assertFalse((self.case / "stdout").exists())


if __name__ == "__main__":
    unittest.main()
