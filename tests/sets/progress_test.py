"""Checks that the progress of a run is shown on a terminal only, and leaves nothing behind."""

import os
import pty
import re
import subprocess
import unittest

import program

ERASE = "\r\x1b[K"
LINE = re.compile(r"\[[# ]{20}\] (files|between) \d+/12, [\d.]+( [kMG])? faces"
                  r"(, [\d.]+( [kMG])?/s, \d+:\d\d:\d\d left)?$")


class Progress(program.SetTest):
    def setUp(self):
        super().setUp()
        self.pack(12, 1000)

    def terminal(self, *arguments):
        """What a run shows on a terminal that its standard error is."""
        ours, theirs = pty.openpty()
        process = self.start(*arguments, stdout=subprocess.DEVNULL, stderr=theirs)
        os.close(theirs)
        shown = b""
        try:
            while part := os.read(ours, 4096):
                shown += part
        except OSError:
            pass  # so ends a terminal that nobody holds open any more
        os.close(ours)
        self.assertEqual(process.wait(timeout=60), program.DONE, shown)
        return shown.decode()

    def check_shown(self, shown):
        self.assertTrue(shown.startswith(ERASE) and shown.endswith(ERASE), repr(shown))
        lines = [line for line in shown.split(ERASE) if line]
        self.assertGreater(len(lines), 0)
        for line in lines:
            self.assertRegex(line, LINE)
            self.assertLess(len(line), 80)
        return lines

    def test_of_the_files_and_of_what_is_between_them(self):
        lines = self.check_shown(self.terminal("--threads", "1", "packed"))
        self.assertIn("files 1/12, ", lines[0])

    def test_of_parts_and_of_merging(self):
        journals = [f"part{k}.ndjson" for k in (1, 2)]
        for k, journal in enumerate(journals, 1):
            shown = self.terminal("--shard", f"{k}/2", f"--ndjson={journal}", "-i", "packed")
            self.assertIn("files ", shown)
        self.check_shown(self.terminal("merge", *journals))

    def test_nothing_where_it_is_not_wanted(self):
        self.assertEqual(self.terminal("--no-progress", "packed"), "")
        self.assertEqual(self.terminal("--quiet", "packed"), "")

    def test_nothing_where_there_is_no_terminal(self):
        self.assertEqual(self.run_program("packed").err, b"")

    def test_nothing_of_a_single_file(self):
        self.assertEqual(self.terminal("packed/01.mesh"), "")


if __name__ == "__main__":
    unittest.main()
