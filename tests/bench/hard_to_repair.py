#!/usr/bin/env python3
"""Writes a mesh on which repairs have taken long, for doc/benchmarks.md.

usage: hard_to_repair.py unwelded|cubes|crossed|shifted|star FILE.obj
  unwelded  a torus of 160,000 faces, each with vertices of its own
  cubes     a block of 20 x 20 x 20 cubes of 12 faces that touch their neighbours, each with vertices of its own
  crossed   a rough torus of 10,000 faces, and one face that cuts through it from side to side
  shifted   a sheet of 8,000 faces, whose vertices are in no order, and the second half of which names vertices three
            records too late
  star      200 faces round one place, each of which crosses all others
"""
import itertools
import math
import sys


def grid_faces(nx, ny):
    """Two triangles for each square of a grid with nx + 1 vertices a row."""
    for y, x in itertools.product(range(ny), range(nx)):
        a = y * (nx + 1) + x
        yield a, a + 1, a + nx + 2
        yield a, a + nx + 2, a + nx + 1


def torus_point(u, v):
    return ((2 + 0.5 * math.cos(v)) * math.cos(u), (2 + 0.5 * math.cos(v)) * math.sin(u), 0.5 * math.sin(v))


def unwelded():
    nu, nv = 400, 200
    points, faces = [], []
    for i, j in itertools.product(range(nu), range(nv)):
        a, b, c, d = ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))
        for corners in ((a, b, c), (a, c, d)):
            faces.append(tuple(range(len(points), len(points) + 3)))
            points += [torus_point(2 * math.pi * (p % nu) / nu, 2 * math.pi * (q % nv) / nv) for p, q in corners]
    return points, faces


def cubes():
    n = 20
    corners = list(itertools.product((0, 1), repeat=3))
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    points, faces = [], []
    for place in itertools.product(range(n), repeat=3):
        first = len(points)
        points += [tuple(p + c for p, c in zip(place, corner)) for corner in corners]
        for a, b, c, d in sides:
            faces += [(first + a, first + b, first + c), (first + a, first + c, first + d)]
    return points, faces


def wavy_sheet(nx, ny):
    return [(x, y, 3 * math.sin(0.2 * x) * math.cos(0.15 * y) + 0.01 * math.sin(12.9898 * x + 78.233 * y))
            for y, x in itertools.product(range(ny + 1), range(nx + 1))]


def crossed():
    points, faces = [], []
    nu, nv = 100, 50
    for i, j in itertools.product(range(nu), range(nv)):
        u, v = 2 * math.pi * i / nu, 2 * math.pi * j / nv
        wave = 1 + 0.01 * math.sin(12.9898 * i + 78.233 * j)
        points.append(tuple(wave * x for x in torus_point(u, v)))
        a, b, c, d = (p % nu * nv + q % nv for p, q in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
        faces += [(a, b, c), (a, c, d)]
    faces.append((len(points), len(points) + 1, len(points) + 2))
    return points + [(-3, -1.1, 0.1), (3, -0.9, 0.2), (0.3, 2.9, 0.15)], faces


def shifted():
    nx, ny = 80, 50
    surface = [(x, y, 3 * math.sin(0.2 * x) * math.cos(0.15 * y)) for y, x in itertools.product(range(ny + 1), range(nx + 1))]
    # A scan has its vertices in no order that the eye would see.
    order = sorted(range(len(surface)), key=lambda i: math.sin(12.9898 * i) * 43758.5453 % 1)
    place = {vertex: i for i, vertex in enumerate(order)}
    faces = [tuple(place[v] for v in face) for face in grid_faces(nx, ny)]
    begin = len(faces) // 2
    return ([surface[v] for v in order],
            faces[:begin] + [tuple((v + 3) % len(surface) for v in face) for face in faces[begin:]])


def star():
    points, faces = [], []
    for i in range(200):
        z = 1 - (2 * i + 1) / 200
        normal = (math.sqrt(1 - z * z) * math.cos(2.4 * i), math.sqrt(1 - z * z) * math.sin(2.4 * i), z)
        u = (-math.sin(2.4 * i), math.cos(2.4 * i), 0)
        v = (normal[1] * u[2] - normal[2] * u[1], normal[2] * u[0] - normal[0] * u[2], normal[0] * u[1] - normal[1] * u[0])
        faces.append(tuple(range(len(points), len(points) + 3)))
        for k in range(3):
            c, s = math.cos(i + 2 * math.pi * k / 3), math.sin(i + 2 * math.pi * k / 3)
            points.append(tuple(0.001 * n + c * p + s * q for n, p, q in zip(normal, u, v)))
    return points, faces


MESHES = {'unwelded': unwelded, 'cubes': cubes, 'crossed': crossed, 'shifted': shifted, 'star': star}


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in MESHES:
        sys.exit(__doc__)
    points, faces = MESHES[sys.argv[1]]()
    with open(sys.argv[2], 'w', encoding='ascii') as file:
        file.writelines(f'v {x!r} {y!r} {z!r}\n' for x, y, z in points)
        file.writelines(f'f {a + 1} {b + 1} {c + 1}\n' for a, b, c in faces)


main()
