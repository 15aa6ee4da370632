"""Shared by the tests of sets: a folder of their own, sets in it, and runs of the program there.

The environment names the program (MESHALYZER), the meshes (MESHES) and the maker of larger sets (WRITE_PACKED_SET).
"""

import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

PROGRAM = pathlib.Path(os.environ["MESHALYZER"]).resolve()
MESHES = pathlib.Path(os.environ["MESHES"]).resolve()
WRITE_PACKED_SET = pathlib.Path(os.environ["WRITE_PACKED_SET"]).resolve()

DONE, NOT_GOOD, USAGE, TROUBLE, INTERRUPTED = 0, 1, 2, 3, 130

SHEET = "Vertex 1 30 0 0\nVertex 2 30 1 0\nVertex 3 30 0 1\nFace 1 1 2 3\n"
"""A mesh that is not good: it is not closed. No mesh of the sets is near it."""

NO_MESH = "Vertex 1 0 0 0\nFace 1 1\n"
"""Content that cannot be read."""


class SetTest(unittest.TestCase):
    """A test that works in an empty folder, which goes away with it."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="meshalyzer-sets-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def copy(self, name):
        """A copy of a folder of meshes/, under the same name."""
        shutil.copytree(MESHES / name, self.folder / name)
        return name

    def pack(self, n_objects, faces_per_object, name="packed"):
        (self.folder / name).mkdir()
        subprocess.run([WRITE_PACKED_SET, name, str(n_objects), str(faces_per_object)], cwd=self.folder, check=True)
        return name

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def read(self, name):
        return (self.folder / name).read_bytes()

    def lines(self, name):
        """A journal, each line understood."""
        text = self.read(name).decode()
        self.assertTrue(text == "" or text.endswith("\n"), f"{name} ends within a line")
        return [json.loads(line) for line in text.splitlines()]

    def start(self, *arguments, **options):
        return subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stdin=subprocess.DEVNULL, **options)

    def run_program(self, *arguments, status=DONE):
        """What a run writes to standard output and standard error; its status must be the one given."""
        process = self.start(*arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, status, f"{' '.join(arguments)}: {err.decode()}")
        return Said(out, err)

    def report(self, *arguments, status=DONE):
        return json.loads(self.run_program("--json", *arguments, status=status).out)

    def assert_same(self, got, want, what):
        """Two reports, byte for byte; where they differ, the first line that does is shown."""
        if got == want:
            return
        got_lines, want_lines = got.splitlines(), want.splitlines()
        for number, (a, b) in enumerate(zip(got_lines, want_lines), 1):
            if a != b:
                self.fail(f"{what}: line {number} is {a[:300]!r}, not {b[:300]!r}")
        self.fail(f"{what}: {len(got_lines)} lines, not {len(want_lines)}")


class Said:
    """What a run has written."""

    def __init__(self, out, err):
        self.out = out
        self.err = err

    @property
    def errors(self):
        return self.err.decode()


if __name__ == "__main__":
    raise SystemExit("run the *_test.py beside this file")
