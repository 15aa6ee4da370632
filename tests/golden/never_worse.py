#!/usr/bin/env python3
"""Repairs meshes and judges the files before and after: no count of defects may rise, no attribute may be lost.

usage: never_worse.py MESHALYZER MESHFIXER FOLDER... [--damaged N] [--seed S] [--timeout SECONDS] [--table]
  FOLDER           every mesh in it is repaired as a user does it first: meshfixer IN -o OUT
  --damaged N      also N meshes that are made of those in text by damaging records at random
  --timeout        fails where a repair takes longer (default 120)
  --table          prints the counts before and after of each mesh that is not good in the end

Edges, vertices, duplicate faces and zero areas are counted here, from the bytes of the files and in rational numbers,
without anything of the library. Only the intersecting pairs and whether the mesh points outward are asked of
meshalyzer, which tests of its own compare with brute force. Prints what got worse, and a last line of figures; exits 1
where something got worse. Excepted is what doc/repair.md excepts: each non-manifold edge that is parted may leave one
border edge and one pinched vertex, and sheets may end where they were cut, at borders or slits, if fewer faces
intersect than before.
"""
import argparse
import collections
import concurrent.futures
import fractions
import itertools
import json
import math
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import time

from compare_builds import ENDINGS, damaged_meshes

COUNTS = ['border edges', 'non-manifold edges', 'non-manifold vertices', 'pinched vertices', 'flipped edges', 'slit edges',
          'intersecting pairs', 'zero-area faces', 'duplicate faces']
LEFT_BY_PARTING = {'border edges', 'pinched vertices'}


def fan(corners):
    return [(corners[0], corners[i], corners[i + 1]) for i in range(1, len(corners) - 1)]


def read_mesh(text):
    """The native format: Vertex ID X Y Z and Face ID A B C; INRIA's is left to meshalyzer."""
    points, faces = {}, []
    for words in map(str.split, text.splitlines()):
        if words[:1] == ['Vertex'] and len(words) >= 5:
            points.setdefault(int(words[1]), tuple(map(float, words[2:5])))
        elif words[:1] == ['Face'] and len(words) >= 5:
            faces.append(tuple(map(int, words[2:5])))
    return points, faces


def read_obj(text):
    points, faces = {}, []
    for words in map(str.split, text.splitlines()):
        if words[:1] == ['v']:
            points[len(points)] = tuple(map(float, words[1:4]))
        elif words[:1] == ['f']:
            numbers = [int(w.split('/')[0]) for w in words[1:]]
            faces += fan([n - 1 if n > 0 else len(points) + n for n in numbers])
    return points, faces


def read_off(text):
    lines = [line.split('#')[0].split() for line in text.splitlines()]
    words = list(itertools.chain.from_iterable(lines))
    n_points, n_faces = int(words[1]), int(words[2])
    rows = [row for row in lines if row][1 if len(words) > 3 and lines[0] == ['OFF'] else 0:]
    if rows[0][0] == 'OFF':
        rows[0] = rows[0][1:]
    points = {i: tuple(map(float, row[:3])) for i, row in enumerate(rows[1:1 + n_points])}
    faces = []
    for row in rows[1 + n_points:1 + n_points + n_faces]:
        faces += fan([int(w) for w in row[1:1 + int(row[0])]])
    return points, faces


def read_stl(content):
    corners = []
    if len(content) >= 84 and len(content) == 84 + 50 * struct.unpack_from('<I', content, 80)[0]:
        for i in range(84, len(content), 50):
            values = struct.unpack_from('<12f', content, i)
            corners += [values[3:6], values[6:9], values[9:12]]
    else:
        for words in map(str.split, content.decode('latin-1').splitlines()):
            if words[:1] == ['vertex']:
                corners.append(tuple(map(float, words[1:4])))
    numbers = {}
    records = [numbers.setdefault(corner, len(numbers)) for corner in corners]
    return {n: corner for corner, n in numbers.items()}, [tuple(records[i:i + 3]) for i in range(0, len(records) - 2, 3)]


def read(path):
    """Points by number and faces, or nothing where this script does not know the format."""
    content = path.read_bytes()
    ending = path.suffix.lower()
    text = content.decode('latin-1')
    if ending == '.stl':
        return read_stl(content)
    if ending == '.mesh' and 'MeshVersionFormatted' not in text:
        return read_mesh(text)
    if ending == '.obj':
        return read_obj(text)
    if ending == '.off' and text.startswith('OFF'):
        return read_off(text)
    return None


def has_no_area(a, b, c):
    a, b, c = ([fractions.Fraction(x) for x in p] for p in (a, b, c))
    u, v = [p - q for p, q in zip(b, a)], [p - q for p, q in zip(c, a)]
    return all(u[i] * v[j] == u[j] * v[i] for i, j in ((0, 1), (1, 2), (2, 0)))


def may_have_no_area(a, b, c):
    """A filter in floats: false only where the area is surely not zero."""
    u, v = [p - q for p, q in zip(b, a)], [p - q for p, q in zip(c, a)]
    size = max(map(abs, u + v), default=0) * (1 + max(map(abs, [*a, *b, *c])))
    return all(abs(u[i] * v[j] - u[j] * v[i]) <= 1e-9 * size for i, j in ((0, 1), (1, 2), (2, 0)))


def fans_at(vertex, faces, sides):
    """How many fans the faces round a vertex are, joined through edges with two faces."""
    group = {f: f for f in faces}

    def find(f):
        while group[f] != f:
            f = group[f]
        return f
    for around in sides[vertex].values():
        if len(around) == 2:
            group[find(around[0])] = find(around[1])
    return len({find(f) for f in faces})


def count_elements(points, faces):
    faces = [f for f in faces if len(set(f)) == 3 and all(v in points for v in f)]
    edges, at_vertex = collections.defaultdict(list), collections.defaultdict(list)
    for i, f in enumerate(faces):
        for k in range(3):
            edges[frozenset((f[k], f[(k + 1) % 3]))].append((i, f[k]))
            at_vertex[f[k]].append(i)
    sides = collections.defaultdict(lambda: collections.defaultdict(list))
    for edge, around in edges.items():
        for v in edge:
            sides[v][edge] = [f for f, _ in around]
    crowded = [edge for edge, around in edges.items() if len(around) > 2]
    ends = set(itertools.chain.from_iterable(crowded))
    pinched = sum(1 for v, around in at_vertex.items() if v not in ends and fans_at(v, around, sides) > 1)
    borders = [edge for edge, around in edges.items() if len(around) == 1]
    places = collections.Counter(frozenset(points[v] for v in edge) for edge in borders)
    return {
        'border edges': len(borders),
        'non-manifold edges': len(crowded),
        'non-manifold vertices': len(ends) + pinched,
        'pinched vertices': pinched,
        'flipped edges': sum(1 for around in edges.values() if len(around) == 2 and around[0][1] == around[1][1]),
        'slit edges': sum(n for n in places.values() if n > 1),
        'zero-area faces': sum(1 for f in faces if may_have_no_area(*(points[v] for v in f)) and
                               has_no_area(*(points[v] for v in f))),
        'duplicate faces': len(faces) - len({frozenset(f) for f in faces}),
    }


def judge(meshalyzer, path):
    """Counts and attributes of a file; nothing where it cannot be read."""
    run = subprocess.run([meshalyzer, '--json', path], capture_output=True, text=True, timeout=600)
    if run.returncode != 0:
        return None
    mesh = json.loads(run.stdout)['meshes'][0]
    counts = {name: mesh['characteristics'].get(name.replace(' ', '_').replace('-', '_'), 0) for name in COUNTS}
    read_here = read(path)
    if read_here is not None:
        counts |= count_elements(*read_here)
    return counts, mesh['attributes']


def what_is_worse(before, after):
    counts, attributes = before
    counts_after, attributes_after = after
    parted = max(0, counts['non-manifold edges'] - counts_after['non-manifold edges'])
    allowed = dict.fromkeys(LEFT_BY_PARTING, parted)
    if counts['border edges'] and counts_after['intersecting pairs'] < counts['intersecting pairs']:
        allowed['border edges'] = allowed['slit edges'] = math.inf
    worse = [f'{name} {counts[name]} -> {counts_after[name]}' for name in COUNTS
             if counts_after[name] - counts[name] > allowed.get(name, 0)]
    return worse + [f'no longer {name}' for name in attributes if attributes[name] and not attributes_after[name]]


def repair_and_judge(programs, path, timeout):
    """What got worse, the counts before and after, and the seconds that the repair took."""
    meshalyzer, meshfixer = programs
    try:
        before = judge(meshalyzer, path)
    except (ValueError, IndexError, KeyError):
        before = None
    if before is None:
        return [], None, None, 0
    with tempfile.TemporaryDirectory() as scratch:
        out = pathlib.Path(scratch) / ('out' + path.suffix)
        begin = time.monotonic()
        try:
            run = subprocess.run([meshfixer, path, '-o', out], capture_output=True, text=True, timeout=timeout)
        except subprocess.TimeoutExpired:
            return ['it takes too long'], before, None, timeout
        seconds = time.monotonic() - begin
        if run.returncode not in (0, 1, 3):
            return [f'exit status {run.returncode}: {run.stderr.strip()}'], before, None, seconds
        if not out.exists():
            return [], before, None, seconds
        after = judge(meshalyzer, out)
        return what_is_worse(before, after), before, after, seconds


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('programs', nargs=2)
    parser.add_argument('folders', nargs='+', type=pathlib.Path)
    parser.add_argument('--damaged', type=int, default=0)
    parser.add_argument('--seed', type=int, default=1)
    parser.add_argument('--timeout', type=float, default=120)
    parser.add_argument('--table', action='store_true')
    arguments = parser.parse_intermixed_args()
    files = sorted(p for f in arguments.folders for p in f.rglob('*') if p.suffix.lower() in ENDINGS and p.is_file())
    scratch = pathlib.Path(tempfile.mkdtemp())
    n_worse = n_judged = 0
    try:
        if arguments.damaged:
            files = damaged_meshes(arguments.damaged, files, scratch, arguments.seed)
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            work = pool.map(lambda p: (p, *repair_and_judge(arguments.programs, p, arguments.timeout)), files)
            for path, worse, before, after, seconds in work:
                n_judged += before is not None
                if worse:
                    n_worse += 1
                    print(f'{path}: {"; ".join(worse)}', flush=True)
                    if path.parent == scratch:
                        shutil.copy(path, tempfile.gettempdir())
                elif arguments.table and after and any(after[0].values()):
                    print(path, f'{seconds:.1f} s', ', '.join(f'{n} {before[0][n]} -> {after[0][n]}' for n in COUNTS
                                                              if before[0][n] or after[0][n]), flush=True)
    finally:
        shutil.rmtree(scratch)
    print(f'{n_judged} meshes, {n_worse} worse')
    return 1 if n_worse else 0


if __name__ == '__main__':
    sys.exit(main())
