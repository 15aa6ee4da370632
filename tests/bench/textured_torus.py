#!/usr/bin/env python3
"""Writes the torus of a million triangles with ten holes that doc/benchmarks.md repairs with a texture and without.

usage: textured_torus.py FILE.obj [--bare]
  --bare  without texture coordinates and materials
"""
import math
import sys

SECTIONS, POINTS = 1000, 500
FACES_A_MATERIAL = 10_000
FACES_A_HOLE = 100_000


def position(i, j):
    around, along = 2 * math.pi * i / SECTIONS, 2 * math.pi * j / POINTS
    distance = 10 + 4 * math.cos(along)
    return distance * math.cos(around), distance * math.sin(around), 4 * math.sin(along)


def faces():
    """The corners of each, as pairs of a section and a point of it, which go one beyond the last at the seams."""
    for i in range(SECTIONS):
        for j in range(POINTS):
            a, b, c, d = (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)
            yield a, b, c
            yield a, c, d


def vertex(corner):
    return corner[0] % SECTIONS * POINTS + corner[1] % POINTS + 1


def texture_point(corner):
    return corner[0] * (POINTS + 1) + corner[1] + 1


def main():
    has_texture = "--bare" not in sys.argv[2:]
    with open(sys.argv[1], "w", encoding="ascii") as file:
        for i in range(SECTIONS):
            file.writelines("v {:.6f} {:.6f} {:.6f}\n".format(*position(i, j)) for j in range(POINTS))
        for i in range(SECTIONS + 1 if has_texture else 0):
            file.writelines(f"vt {i / SECTIONS:.6f} {j / POINTS:.6f}\n" for j in range(POINTS + 1))
        for number, corners in enumerate(faces()):
            if number % FACES_A_HOLE == 37:
                continue
            if has_texture and number % FACES_A_MATERIAL == 0:
                file.write(f"usemtl m{number // FACES_A_MATERIAL}\n")
            names = (f"{vertex(c)}/{texture_point(c)}" if has_texture else str(vertex(c)) for c in corners)
            file.write("f " + " ".join(names) + "\n")


if __name__ == "__main__":
    main()
