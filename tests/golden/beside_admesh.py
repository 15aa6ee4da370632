#!/usr/bin/env python3
"""Repairs every bad mesh of the corpus with meshfixer and with ADMesh in one run, and writes the table of doc/repair.md.

usage: beside_admesh.py MESHALYZER MESHFIXER ROOT [--update]

ADMesh reads STL alone, so both get the same STL file of each mesh. Each result is judged by `meshalyzer -g`, and its
distance from the input is measured by `meshalyzer -s`, at its vertices and at those of the input. Times are those of
whole processes, one after the other.
"""

import json
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

from repair_table import meshes_in, reasons, run

BEGIN, END = "<!-- admesh -->\n", "\n<!-- end of admesh -->"
# The figures that ADMesh counts of its own work.
ADMESH_COUNTS = ["Edges fixed", "Facets removed", "Facets added", "Facets reversed", "Backwards edges"]


def timed(*command):
    begin = time.monotonic()
    try:
        return run(*command), time.monotonic() - begin
    except subprocess.TimeoutExpired:
        return None, time.monotonic() - begin


def largest_distances(meshalyzer, before, after):
    """How far a vertex of `after` is from `before`, and one of `before` from `after`, at most."""
    result = run(meshalyzer, "-s", "--force", "--json", str(before), str(after))
    assert result.returncode == 0, result.stderr
    found = json.loads(result.stdout)["set"]["separation"]
    return [max(abs(found[path.name]["min"]), abs(found[path.name]["max"])) for path in (after, before)]


def diagonal(meshalyzer, path):
    report = json.loads(run(meshalyzer, "--json", str(path)).stdout)["meshes"][0]
    box = report["characteristics"]["bounding_box"]
    return sum((high - low) ** 2 for low, high in zip(box["min"], box["max"])) ** 0.5


def done_by_meshfixer(result):
    steps = {}
    for step in json.loads(result.stdout)["log"]["steps"]:
        steps[step["pass"]] = steps.get(step["pass"], 0) + step["operations"]
    return ", ".join(f"{name} {n}" for name, n in steps.items()) or "nothing"


def done_by_admesh(result):
    counts = {}
    for name in ADMESH_COUNTS:
        found = re.search(rf"^{name}\s*:\s*(\d+)", result.stdout, re.MULTILINE)
        if found and int(found[1]):
            counts[name.lower()] = int(found[1])
    return ", ".join(f"{name} {n}" for name, n in counts.items()) or "nothing"


class Outcome:
    """What came of one mesh by one program."""

    def __init__(self, meshalyzer, before, after, attempt):
        result, self.seconds = attempt
        self.is_written = result is not None and after.exists() and after.stat().st_size > 84
        self.is_good = self.is_written and not reasons(meshalyzer, str(after))
        self.verdict = "good" if self.is_good else "not good" if self.is_written else "nothing written"
        self.distances = largest_distances(meshalyzer, before, after) if self.is_written else []

    def cells(self, length, done):
        far = " / ".join(f"{distance / length:.1g}" for distance in self.distances)
        return f"{self.verdict} | {far} | {self.seconds:.2f} s | {done} |"


def row(programs, folder, path, scratch):
    """The outcomes by both programs and the row; nothing where the mesh is good, or no STL can be made of it."""
    meshalyzer, meshfixer = programs
    before, ours, theirs = (scratch / name for name in ("in.stl", "ours.stl", "theirs.stl"))
    for file in (before, ours, theirs):
        file.unlink(missing_ok=True)
    run(meshfixer, "--renumber", str(path), "-o", str(before))
    if not before.exists() or not reasons(meshalyzer, str(before)):
        return None
    by_us = timed(meshfixer, "--json", "--threads", "1", str(before), "-o", str(ours))
    by_them = timed("admesh", f"--write-binary-stl={theirs}", str(before))
    length = diagonal(meshalyzer, before)
    outcomes = [Outcome(meshalyzer, before, ours, by_us), Outcome(meshalyzer, before, theirs, by_them)]
    done = [done_by_meshfixer(by_us[0]) if by_us[0] else "", done_by_admesh(by_them[0]) if by_them[0] else ""]
    cells = " ".join(outcome.cells(length, text) for outcome, text in zip(outcomes, done))
    return outcomes, f"| `{path.relative_to(folder)}` | {cells}"


def table(programs, folder):
    rows, outcomes = [], []
    with tempfile.TemporaryDirectory() as scratch:
        for path in meshes_in(folder):
            made = row(programs, folder, path, pathlib.Path(scratch))
            if made is None:
                continue
            outcomes.append(made[0])
            rows.append(made[1])
            print(made[1], file=sys.stderr)
    good = [sum(pair[k].is_good for pair in outcomes) for k in (0, 1)]
    median = [statistics.median(pair[k].seconds for pair in outcomes) for k in (0, 1)]
    head = [f"Of {len(rows)} meshes that are not good {good[0]} come out good by meshfixer, in {median[0]:.2f} s in the middle, and "
            f"{good[1]} by ADMesh, in {median[1]:.2f} s.", "",
            "| file | meshfixer | distance | time | what it did | ADMesh | distance | time | what it did |",
            "|---|---|---|---|---|---|---|---|---|"]
    return "\n".join(head + rows)


def main():
    programs, root = sys.argv[1:3], pathlib.Path(sys.argv[3])
    folder = root.parent / "shared" / "corpus"
    if not folder.is_dir() or shutil.which("admesh") is None:
        print(f"skipped: there is no {folder}" if not folder.is_dir() else "skipped: there is no admesh; it is in Debian's package admesh")
        return
    os.environ["LC_ALL"] = "C"
    made = table(programs, folder)
    if "--update" not in sys.argv:
        print(made)
        return
    page = root / "doc" / "repair.md"
    text = page.read_text()
    begin = text.index(BEGIN) + len(BEGIN)
    page.write_text(text[:begin] + made + text[text.index(END):])


if __name__ == "__main__":
    main()
