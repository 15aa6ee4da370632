#!/usr/bin/env python3
"""Repairs every mesh there is, has the result judged by meshalyzer, and compares with the tables of doc/repair.md.

usage: repair_table.py MESHALYZER MESHFIXER ROOT meshes|corpus [--update]

A row is judged by `meshalyzer -g` on the file that was written, not by what the fixer says of its own work.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

# Only what is wrong, not what is thin: any aspect ratio, edge angle and edge length will do.
GOODNESS = "1e300,-1,-1"
ENDINGS = {".mesh", ".obj", ".off", ".stl", ".ply"}


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=600, check=False)


def reasons(meshalyzer, path):
    """What `meshalyzer -g` has against a file, in few words; empty when it is good."""
    result = run(meshalyzer, "-p", "-g", GOODNESS, path)
    assert result.returncode in (0, 1), result.stderr
    return [line.split(": ", 1)[1] for line in result.stdout.splitlines() if line.startswith("reason: ")]


def counts(counted):
    return ", ".join(f"{code} {n}" for code, n in counted.items() if n) or "nothing"


def why_left(report):
    """The codes that remain, and the reasons that the log gives, each once."""
    left = counts({code: n for mesh in report["meshes"] for code, n in mesh["counts"].items()})
    whys = sorted({f"{row['code']}: {row['reason']}" for row in report["log"]["refused"]})
    return left + ("" if not whys or left == "nothing" else "; " + "; ".join(whys[:3]))


def row(programs, folder, path):
    meshalyzer, meshfixer = programs
    with tempfile.TemporaryDirectory() as scratch:
        out = str(pathlib.Path(scratch) / ("out" + path.suffix))
        result = run(meshfixer, "--json", "--fix", "all", "--no-fix", "disjoint", str(path), "-o", out)
        assert result.returncode in (0, 1), f"{path}: {result.returncode} {result.stderr}"
        report = json.loads(result.stdout)
        verdict = reasons(meshalyzer, out)
        if report["remaining"] == 0 and not verdict:
            assert result.returncode == 0, path
        before = report["input"]["counts"]
        deviation = report["deviation"]
        return (f"| `{path.relative_to(folder)}` | {counts(before)} | {why_left(report)} | "
                f"{'good' if not verdict else '; '.join(verdict)} | {deviation:.2g} |")


def meshes_in(folder):
    return sorted(p for p in folder.rglob("*") if p.suffix.lower() in ENDINGS and not {"broken", "unreadable"} & set(p.parts))


def table(programs, folder):
    with ThreadPoolExecutor(2) as pool:
        rows = list(pool.map(lambda path: row(programs, folder, path), meshes_in(folder)))
    head = ["| file | before | after | `meshalyzer -g` of what was written | deviation |", "|---|---|---|---|---|"]
    return "\n".join(head + rows)


def main():
    programs, root, name = sys.argv[1:3], pathlib.Path(sys.argv[3]), sys.argv[4]
    folder = root / "meshes" if name == "meshes" else root.parent / "shared" / "corpus"
    if not folder.is_dir():
        print(f"skipped: there is no {folder}")
        return
    page = root / "doc" / "repair.md"
    text = page.read_text()
    begin, end = f"<!-- {name} -->\n", f"\n<!-- end of {name} -->"
    stands = text[text.index(begin) + len(begin):text.index(end)]
    made = table(programs, folder)
    if "--update" in sys.argv:
        page.write_text(text.replace(begin + stands + end, begin + made + end))
    elif made != stands:
        for line in sorted(set(made.splitlines()) ^ set(stands.splitlines())):
            print(line)
        sys.exit("doc/repair.md is not what the programs do; after a look, run this with --update")


if __name__ == "__main__":
    main()
