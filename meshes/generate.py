#!/usr/bin/env python3
"""Writes the meshes, what is true of them (expected.json, expected_sets.json) and README.md.

The same bytes on every machine.

usage: generate.py [FOLDER]     default: the folder this file is in
"""

import json
import pathlib
import re
import sys

sys.dont_write_bytecode = True

import formats  # noqa: E402  (must come after the line above, as what follows)
import shapes  # noqa: E402
from bad import all_bad  # noqa: E402
from broken import all_broken  # noqa: E402
from good import TETRAHEDRON_AREA, all_good  # noqa: E402
from sets import all_sets, fold_widths  # noqa: E402
from truth import nested  # noqa: E402
from truth_of_sets import truth  # noqa: E402

INTRODUCTION = """# Meshes with one thing right or wrong

Made by `generate.py` (Python 3, nothing else needed), which also writes this page and `expected.json`: what the JSON
report must say of each file. Every figure there is stated or comes from a formula; none is measured on the mesh.
A test compares the files with what the generator writes, byte for byte, another one the report with the figures.

Good means: `meshalyzer -g 1e6,0,0 FILE` says so. Ids are the files' own.

"""


BETWEEN = """All objects are good, each by itself. `expected_sets.json` has the truth of each folder, by brute force over the
rationals (`truth_of_sets.py`), rounded once at the end:

| key | meaning |
|---|---|
| `intersecting_pairs` | `[file, face id, file, face id, kind]`: the faces share a point. `duplicate` when their corners are the same three places |
| `contained` | `[inner, outer]`: no faces cross, and the vertices of the inner one that are not on the outer one are in its solid |
| `separation` | by file `[vertex id, distance]`: to the nearest point of all other files, negative inside the solid of one. No sign here depends on whether all others or only the nearest are asked |
| `area`, `volume`, `meshes`, `faces`, `vertices` | of the whole set |
"""


def set_of_three():
    """Three good objects that keep 2 from each other."""
    cube, tetrahedron = shapes.cube(), shapes.tetrahedron()
    yield "set/left_cube.mesh", formats.native(cube)
    yield "set/right_cube.mesh", formats.native(shapes.moved(cube, (3.0, 0.0, 0.0)))
    yield "set/tetrahedron.mesh", formats.native(shapes.moved(tetrahedron, (0.0, 3.0, 0.0)))


SET_TRUTH = {"meshes": 3, "faces": 28, "vertices": 20, "edges": 42, "components": 3, "boundaries": 0,
             "area": 12 + TETRAHEDRON_AREA, "volume": 2 + 1 / 6}


def truth_of_sets(sets):
    """By folder; one row a line, so that a change can be read."""
    truths = {folder: truth(meshes) for folder, meshes, _ in sets}
    truths["fold"]["folds"] = {"clamp.mesh": fold_widths()}
    text = json.dumps(truths, indent=1, sort_keys=True) + "\n"
    return re.sub(r"\[[^][]+]", lambda row: json.dumps(json.loads(row[0])), text)


def table(title, heads, rows):
    lines = [f"## {title}", "", "| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    return "\n".join([*lines, *("| " + " | ".join(row) + " |" for row in rows), "", ""])


def readme(good, bad, broken, sets):
    text = INTRODUCTION
    text += table("Good", ("file", "what it is, and the true figures"), [(f"`{n}`", words) for n, _, _, words in good])
    text += table("Bad", ("file", "what is wrong, and the true figures"), [(f"`{n}`", words) for n, _, _, words in bad])
    text += table("Broken: refused, exit status 3", ("file", "line", "why"),
                  [(f"`broken/{n}`", str(line or "-"), words) for n, _, line, words in broken])
    text += ("## A set\n\n`set/` holds two unit cubes and the tetrahedron, 2 apart, all good: 28 faces, volume 2 + 1/6,\n"
             "area 12 + (3 + sqrt 3)/2; nothing intersects.\n\n")
    text += table("Sets with something between their objects", ("folder", "what it is"),
                  [(f"`{n}/`", words) for n, _, words in sets])
    return text + BETWEEN


def main(folder):
    good, bad, broken, sets = list(all_good()), list(all_bad()), list(all_broken()), list(all_sets())
    files = {name: data for name, data, _, _ in good + bad} | dict(set_of_three())
    files |= {f"broken/{name}": data for name, data, _, _ in broken}
    files |= {f"{name}/{file}": formats.native(mesh) for name, meshes, _ in sets for file, mesh in meshes.items()}
    expected = {"meshes": {name: nested(truth) for name, _, truth, _ in good + bad},
                "refused": {f"broken/{name}": line for name, _, line, _ in broken},
                "sets": {"set": SET_TRUTH}}
    files["expected.json"] = (json.dumps(expected, indent=1, sort_keys=True) + "\n").encode()
    files["expected_sets.json"] = truth_of_sets(sets).encode()
    files["README.md"] = readme(good, bad, broken, sets).encode()
    for name, data in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)


if len(sys.argv) > 2 or sys.argv[1:2] in (["-h"], ["--help"]):
    sys.exit(__doc__)
main(pathlib.Path(sys.argv[1]) if len(sys.argv) == 2 else pathlib.Path(__file__).resolve().parent)
