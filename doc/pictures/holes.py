#!/usr/bin/env python3
"""Draws holes before and after: as they are, with the patch of `--fill-shape linear`, and with that of `auto`.

usage: holes.py MESHFIXER OUT.png MESH...

A row a mesh, looked at from the side of its largest patch. The surface is grey, its inner side dark, the patch orange. Needs
nothing but Python.
"""
import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

SIZE = 280
BACKGROUND = (255, 255, 255)
OUTSIDE = (176, 184, 196)
INSIDE = (92, 70, 66)
PATCH = (240, 150, 60)


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def unit(a):
    length = math.sqrt(dot(a, a)) or 1.0
    return (a[0] / length, a[1] / length, a[2] / length)


def read_obj(path):
    """Returns the faces of a file, each as its three corners."""
    points, faces = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words[:1] == ['v']:
            points.append(tuple(float(word) for word in words[1:4]))
        elif words[:1] == ['f']:
            corners = [points[int(word.split('/')[0]) - 1] for word in words[1:]]
            faces += [(corners[0], corners[i], corners[i + 1]) for i in range(1, len(corners) - 1)]
    return faces


def repaired(meshfixer, mesh, options):
    with tempfile.TemporaryDirectory() as scratch:
        out = pathlib.Path(scratch, 'out.obj')
        subprocess.run([meshfixer, *options, mesh, '-o', out], stdout=subprocess.DEVNULL, check=False)
        return read_obj(out)


def normal(face):
    return cross(sub(face[1], face[0]), sub(face[2], face[0]))


def largest_part(faces):
    """Returns the faces of the part with the most area."""
    parent = {}

    def find(a):
        while parent.setdefault(a, a) != a:
            a = parent[a] = parent[parent[a]]
        return a

    for face in faces:
        for corner in face[1:]:
            parent[find(corner)] = find(face[0])
    areas = {}
    for face in faces:
        n = normal(face)
        areas[find(face[0])] = areas.get(find(face[0]), 0.0) + math.sqrt(dot(n, n))
    best = max(areas, key=areas.get)
    return [face for face in faces if find(face[0]) == best]


class View:
    """A parallel projection that shows a patch, seen a little from the side."""

    def __init__(self, patch):
        total = [0.0, 0.0, 0.0]
        for face in patch:
            total = [t + x for t, x in zip(total, normal(face))]
        straight = unit(total)
        side = unit(cross(straight, (0, 1, 0) if abs(straight[1]) < 0.9 else (1, 0, 0)))
        up = cross(side, straight)
        self.towards = unit(tuple(s + 0.55 * a + 0.45 * b for s, a, b in zip(straight, side, up)))
        self.right = unit(cross(up, self.towards))
        self.up = cross(self.towards, self.right)
        corners = [corner for face in patch for corner in face]
        low = [min(c[k] for c in corners) for k in range(3)]
        high = [max(c[k] for c in corners) for k in range(3)]
        self.centre = tuple((a + b) / 2 for a, b in zip(low, high))
        self.scale = 0.36 * SIZE / (math.dist(low, high) / 2 or 1.0)
        self.light = unit(tuple(t + 0.5 * u - 0.6 * r for t, u, r in zip(self.towards, self.up, self.right)))

    def place(self, point):
        p = sub(point, self.centre)
        return (SIZE / 2 + self.scale * dot(p, self.right), SIZE / 2 - self.scale * dot(p, self.up), dot(p, self.towards))


def draw(faces, patch, view):
    """Returns the rows of a picture."""
    pixels = [[BACKGROUND] * SIZE for _ in range(SIZE)]
    depth = [[-math.inf] * SIZE for _ in range(SIZE)]
    for face in faces:
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (view.place(corner) for corner in face)
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        if area == 0:
            continue
        n = unit(normal(face))
        is_front = dot(n, view.towards) > 0
        colour = PATCH if face in patch else OUTSIDE if is_front else INSIDE
        shade = 0.35 + 0.65 * abs(dot(n, view.light))
        colour = tuple(int(shade * channel) for channel in colour)
        for y in range(max(0, math.ceil(min(ay, by, cy))), min(SIZE - 1, math.floor(max(ay, by, cy))) + 1):
            for x in range(max(0, math.ceil(min(ax, bx, cx))), min(SIZE - 1, math.floor(max(ax, bx, cx))) + 1):
                v = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / area
                w = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area
                if v < 0 or w < 0 or v + w > 1:
                    continue
                z = az + v * (bz - az) + w * (cz - az)
                if z > depth[y][x]:
                    depth[y][x] = z
                    pixels[y][x] = colour
    return pixels


def png(rows):
    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))

    data = b''.join(b'\0' + bytes(channel for pixel in row for channel in pixel) for row in rows)
    head = struct.pack('>IIBBBBB', len(rows[0]), len(rows), 8, 2, 0, 0, 0)
    return b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', head) + chunk(b'IDAT', zlib.compress(data, 9)) + chunk(b'IEND', b'')


def main():
    meshfixer, out, *meshes = sys.argv[1:]
    rows = []
    for mesh in meshes:
        before = repaired(meshfixer, mesh, ['--no-fix', 'hole'])
        linear = repaired(meshfixer, mesh, ['--fill-shape', 'linear'])
        chosen = repaired(meshfixer, mesh, ['--fill-shape', 'auto'])
        old = set(before)
        view = View(largest_part([face for face in linear if face not in old]))
        pictures = [draw(faces, {face for face in faces if face not in old}, view) for faces in (before, linear, chosen)]
        rows += [sum(lines, []) for lines in zip(*pictures)]
    pathlib.Path(out).write_bytes(png(rows))


main()
