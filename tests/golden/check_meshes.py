#!/usr/bin/env python3
"""Compares what the program says of each mesh with the truth in expected.json; prints each field that differs.

usage: check_meshes.py MESHALYZER FOLDER

Integers, words and truth values must agree exactly, reals to 1e-12 of themselves. A field that expected.json does not
give is not looked at.
"""

import json
import pathlib
import subprocess
import sys

GOODNESS = "1e6,0,0"


class Checker:
    """Runs the program in a folder and counts the fields that agree."""

    def __init__(self, program, folder):
        self.program = pathlib.Path(program).resolve()
        self.folder = folder
        self.passed = 0
        self.failed = 0

    def run(self, *arguments):
        return subprocess.run([self.program, *arguments], cwd=self.folder, capture_output=True, text=True,
                              stdin=subprocess.DEVNULL, timeout=120, check=False)

    def report(self, *arguments):
        run = self.run("--json", *arguments)
        self.check(arguments[-1], "exit status", run.returncode, 0)
        try:
            return json.loads(run.stdout)
        except ValueError:
            print(f"{arguments[-1]}: no JSON; standard error: {run.stderr.strip()[-500:]}")
            return {}

    def check(self, name, field, got, want):
        """Descends into objects by the keys that are wanted, and into lists of equal length."""
        if isinstance(want, dict) and isinstance(got, dict):
            for key, value in want.items():
                self.check(name, f"{field}.{key}", got.get(key, "absent"), value)
        elif isinstance(want, list) and isinstance(got, list) and len(want) == len(got):
            for i, value in enumerate(want):
                self.check(name, f"{field}[{i}]", got[i], value)
        elif same(got, want):
            self.passed += 1
        else:
            self.failed += 1
            print(f"{name}: {field} is {got}, expected {want}")

    def check_mesh(self, name, truth):
        meshes = self.report("-p", name).get("meshes", [])
        self.check(name, "number of meshes", len(meshes), 1)
        good = truth["good"]
        for key, want in truth.items():
            if key != "good" and meshes:
                self.check(name, key, meshes[0].get(key, "absent"), want)
        verdict = self.run("-g", GOODNESS, name)
        self.check(name, "-g", (verdict.stdout, verdict.returncode), ("1\n", 0) if good else ("0\n", 1))

    def check_refused(self, name, line):
        run = self.run(name)
        place = f"{name}:{line}: " if line else f"{name}:"
        self.check(name, "exit status", run.returncode, 3)
        self.check(name, "standard output", run.stdout, "")
        if place not in run.stderr:
            self.check(name, "standard error", run.stderr, f"...{place}...")

    def check_set(self, name, truth):
        self.check(name, "set", self.report(name).get("set", "absent"), truth)


def same(got, want):
    if isinstance(got, bool) or isinstance(want, bool):
        return got is want
    if isinstance(got, (int, float)) and isinstance(want, (int, float)):
        # The floor is for figures that are 0 in truth, as the variance of equal values.
        return abs(got - want) <= max(1e-12 * max(abs(got), abs(want)), 1e-24)
    return got == want


def main(program, folder):
    checker = Checker(program, folder)
    expected = json.loads(pathlib.Path(folder, "expected.json").read_text())
    for name, truth in expected["meshes"].items():
        checker.check_mesh(name, truth)
    for name, line in expected["refused"].items():
        checker.check_refused(name, line)
    for name, truth in expected["sets"].items():
        checker.check_set(name, truth)
    print(f"{checker.passed} passed, {checker.failed} failed")
    return 1 if checker.failed else 0


if len(sys.argv) != 3:
    sys.exit(__doc__)
sys.exit(main(*sys.argv[1:]))
