#!/usr/bin/env python3
"""Checks that texts for people name a file on one line, whatever characters its name has.

usage: names_test.py MESHALYZER MESHFIXER MESHES
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

# A good mesh, one with a border, one that cuts the first, one that cannot be read, and one with the ending of another format.
FILES = {"cube.mesh": "good\n1.mesh", "cube_with_hole.mesh": "bad\r2.mesh", "crossing_cubes.mesh": "two\t3.mesh",
         "README.md": "none\n4.mesh", "cube.obj": "called\x1b[2J5.off"}

# The options of each program, and the files of FILES, by number, that the text must name.
MESHALYZER = [(["."], {1, 2, 3, 4, 5}), (["-p", "-i", "."], {1, 2, 3, 4, 5}), (["--summary", "."], {1, 2, 3, 4, 5}),
              (["-g", "9,9,9", "."], {1, 2, 3, 4, 5}), (["-s", "--force", "."], {1, 2, 3, 4, 5}), (["check", "."], {2, 3, 4, 5}),
              (["check", "--diff", "good\n1.mesh", "bad\r2.mesh"], {2})]
MESHFIXER = [(["--find", "bad\r2.mesh"], {2}), (["bad\r2.mesh", "-o", "two\t3.mesh"], {2, 3}),
             (["--union", "good\n1.mesh", "two\t3.mesh", "-o", "bad\r2.mesh"], {1, 2, 3}),
             (["--in-place", "."], {1, 2, 3, 4, 5}), (["bad\r2.mesh", "-o", "bad\r2.mesh"], {2}),
             (["--intersection", "bad\r2.mesh", "good\n1.mesh", "-o", "new.mesh"], {2}),
             (["none\n4.mesh", "-o", "new.mesh"], {4})]


def faults_of(program, options, numbers, meshes):
    with tempfile.TemporaryDirectory() as folder:
        for source, name in FILES.items():
            shutil.copy(meshes / source, pathlib.Path(folder) / name)
        result = subprocess.run([program, *options], cwd=folder, capture_output=True, timeout=60, check=False)
    told = result.stdout + result.stderr
    for i, name in enumerate(FILES.values(), 1):
        if name.encode() in told:
            yield f"{options}: {name!r} is not on one line"
        shown = "".join(c if c.isprintable() else "?" for c in name).encode()
        if i in numbers and shown not in told:
            yield f"{options}: {shown} is not named"


def main(meshalyzer, meshfixer, meshes):
    faults = [fault for program, runs in ((meshalyzer, MESHALYZER), (meshfixer, MESHFIXER)) for options, numbers in runs
              for fault in faults_of(program, options, numbers, pathlib.Path(meshes))]
    print("\n".join(faults) or "every name is on one line")
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
