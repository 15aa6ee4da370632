#!/usr/bin/env python3
"""Runs a program as the folder of a case says, and compares what it does with what stands there, byte for byte.

usage: run.py PROGRAM CASE MESHES SCRATCH

The files of a case:

  args       one argument a line; @SCRATCH@ is an empty folder, made anew
  stdin      optional: standard input
  stdout_to  optional: the file that standard output goes to instead of being compared
  files/     optional: where the program runs; otherwise in MESHES
  exit, stdout, stderr   what is expected; a stream without a file is empty
  written/   optional: the files that must then be in @SCRATCH@, and no others

In all that is compared, @SCRATCH@ stands for the folder, and @TIME@ and @STATE@ for what a journal says of the times of
files; in written/ only *.json and *.ndjson have such places.

A case holds what it is about, and few cases hold whole reports: README.md lists them. In place of a text there may be
the lines of it that the case is about, in a file whose name ends with _lines, as stdout_lines or
written/report.json_lines. Its lines are those of the text, one after another, but for what is left out:

  a line that begins with ...   any number of lines, also none, that end as it does; none of them is empty
  ... within a line             any characters, also none

UPDATE=1 in the environment rewrites exit, stdout, stderr and written/; review them with git diff. It leaves *_lines
alone, which somebody chose: where they do not hold any more, the case fails.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

UPDATE = os.environ.get("UPDATE", "") not in ("", "0")
LEFT_OUT = "..."
LINES = "_lines"


class Case:
    """Compares what is got with what a folder holds, and tells what differs."""

    def __init__(self, folder):
        self.folder = folder
        self.failed = False

    def fail(self, message):
        print(f"{self.folder}: {message}", file=sys.stderr)
        self.failed = True

    def check(self, name, got):
        """Compares bytes with the file of that name, or rewrites it; what is empty needs no file."""
        lines = self.folder / (name + LINES)
        if lines.exists():
            if (self.folder / name).exists():
                self.fail(f"{name} and {name + LINES} cannot both be held")
            self.check_lines(name + LINES, read(lines), got)
        elif UPDATE:
            rewrite(self.folder / name, got)
        elif got != (expected := read(self.folder / name)):
            self.fail(f"{name} differs\n--- expected\n{text(expected)}\n--- got\n{text(got)}")

    def check_lines(self, name, held, got):
        trouble = first_difference(text(held).split("\n"), text(got).split("\n"))
        if trouble:
            advice = "\nUPDATE=1 does not rewrite it" if UPDATE else ""
            self.fail(f"{name} does not hold: {trouble}{advice}\n--- expected\n{text(held)}\n--- got\n{text(got)}")

    def check_written(self, scratch):
        """Compares the files in `scratch` with those in written/."""
        expected = [name.removesuffix(LINES) for name in files_in(self.folder / "written")]
        for name in sorted({*files_in(scratch), *expected}):
            got = scratch / name
            if got.exists() != (name in expected) and not UPDATE:
                self.fail(f"written/{name} is not there, or should not be")
            elif name.endswith("json"):
                self.check(f"written/{name}", mask(read(got), scratch))
            else:
                self.check(f"written/{name}", read(got))


def first_difference(held, lines):
    """What is the first of the held lines that is not found in its place; nothing where all are."""
    places = {0}
    for number, line in enumerate(held, 1):
        reached = places_after(line, lines, places)
        if not reached:
            return f"line {number} is not found after line {max(places)} of the output: {line}"
        places = reached
    return None if len(lines) in places else f"the output goes on with line {max(places) + 1}: {lines[max(places)]}"


def places_after(held, lines, places):
    """Where one can be in `lines` once a held line was found at any of `places`."""
    fits = re.compile(".*".join(re.escape(part) for part in held.split(LEFT_OUT))).fullmatch
    if not held.startswith(LEFT_OUT):
        return {place + 1 for place in places if place < len(lines) and fits(lines[place])}
    reached = set()
    for place in places:
        while place not in reached:
            reached.add(place)
            if place < len(lines) and lines[place] and fits(lines[place]):
                place += 1
    return reached


def mask(got, scratch):
    """Replaces what differs from one place or day to another."""
    got = got.replace(os.fsencode(scratch), b"@SCRATCH@")
    got = re.sub(rb'"modified": -?[0-9]+', b'"modified": @TIME@', got)
    return re.sub(rb'"set": "[0-9a-f]+"', b'"set": "@STATE@"', got)


def text(content):
    return content.decode(errors="backslashreplace")


def read(file):
    return file.read_bytes() if file.exists() else b""


def rewrite(file, content):
    if content:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(content)
    else:
        file.unlink(missing_ok=True)


def files_in(folder):
    return [str(file.relative_to(folder)) for file in folder.rglob("*") if file.is_file()]


def run(program, folder, meshes, scratch):
    """Runs the program as the files in `folder` say."""
    arguments = [line.replace("@SCRATCH@", str(scratch)) for line in text(read(folder / "args")).splitlines()]
    stdin = folder / "stdin" if (folder / "stdin").exists() else os.devnull
    stdout_to = text(read(folder / "stdout_to")).strip() or None
    with open(stdin, "rb") as source, open(stdout_to or os.devnull, "wb") as target:
        return subprocess.run([program, *arguments], cwd=folder / "files" if (folder / "files").exists() else meshes,
                              stdin=source, stdout=target if stdout_to else subprocess.PIPE, stderr=subprocess.PIPE,
                              check=False)


def main(program, folder, meshes, scratch):
    scratch = pathlib.Path(scratch)
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    case = Case(pathlib.Path(folder))
    result = run(program, case.folder, meshes, scratch)
    case.check("stdout", mask(result.stdout or b"", scratch))
    case.check("stderr", mask(result.stderr, scratch))
    case.check("exit", f"{result.returncode}\n".encode())
    case.check_written(scratch)
    return case.failed


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
