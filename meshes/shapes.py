"""Shapes that the meshes are made of: a mesh is a list of points and a list of triangles, indices from 0."""

from decimal import Decimal, localcontext
from math import sqrt
from typing import NamedTuple

PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459230781640628621")


class Mesh(NamedTuple):
    points: list
    faces: list


def sin_cos(k, n):
    """Sine and cosine of k/n of a full turn, correctly rounded: math.sin differs from one machine to the next."""
    with localcontext() as context:
        context.prec = 60
        angle = 2 * PI * (k % n) / n
        sums = [Decimal(0), Decimal(0)]
        term, i = Decimal(1), 0
        while abs(term) > Decimal("1e-50") or i < 8:
            sums[i % 2] += term if i % 4 < 2 else -term
            i += 1
            term *= angle / i
        cosine, sine = (Decimal(0) if abs(s) < Decimal("1e-45") else s for s in sums)
        return float(sine), float(cosine)


def moved(mesh, by, scale=1.0):
    """Scaled about the origin, then moved."""
    return Mesh([tuple(scale * c + d for c, d in zip(p, by)) for p in mesh.points], mesh.faces)


def inverted(mesh):
    return Mesh(mesh.points, [(a, c, b) for a, b, c in mesh.faces])


def joined(*meshes):
    """Several meshes in one file, one after the other."""
    points, faces = [], []
    for mesh in meshes:
        first = len(points)
        points += mesh.points
        faces += [tuple(first + i for i in face) for face in mesh.faces]
    return Mesh(points, faces)


CUBE_QUADS = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]


def box(a, b, c):
    """Corner at the origin, edges along the axes; faces two by two: bottom, top, front, right, back, left."""
    points = [(0.0, 0.0, 0.0), (a, 0.0, 0.0), (a, b, 0.0), (0.0, b, 0.0),
              (0.0, 0.0, c), (a, 0.0, c), (a, b, c), (0.0, b, c)]
    faces = [(0, 2, 1), (0, 3, 2), (4, 5, 6), (4, 6, 7), (0, 1, 5), (0, 5, 4),
             (1, 2, 6), (1, 6, 5), (2, 3, 7), (2, 7, 6), (3, 0, 4), (3, 4, 7)]
    return Mesh(points, faces)


def cube():
    return box(1.0, 1.0, 1.0)


def tetrahedron():
    """The corner of a cube: the origin and the three unit points."""
    return Mesh([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)],
                [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])


def short_edged(h):
    """The tetrahedron with its top cut into an edge of length h along y. Five points, six faces."""
    return Mesh([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0.0, h, 1.0)],
                [(0, 2, 1), (0, 1, 3), (0, 3, 4), (0, 4, 2), (1, 4, 3), (1, 2, 4)])


def uv_sphere(n, m):
    """Radius 1, n meridians, m stacks; the poles first and last."""
    points = [(0.0, 0.0, -1.0)]
    for j in range(1, m):
        r, z = sin_cos(j, 2 * m)
        for i in range(n):
            s, c = sin_cos(i, n)
            points.append((r * c, r * s, -z))
    points.append((0.0, 0.0, 1.0))
    top = len(points) - 1

    def ring(j, i):
        return 1 + (j - 1) * n + i % n

    faces = [(0, ring(1, i + 1), ring(1, i)) for i in range(n)]
    for j in range(1, m - 1):
        for i in range(n):
            faces.append((ring(j, i), ring(j, i + 1), ring(j + 1, i + 1)))
            faces.append((ring(j, i), ring(j + 1, i + 1), ring(j + 1, i)))
    faces += [(ring(m - 1, i), ring(m - 1, i + 1), top) for i in range(n)]
    return Mesh(points, faces)


def torus(n, m, big, small):
    """n sections round the axis, m points round the tube."""
    points = []
    for i in range(n):
        s, c = sin_cos(i, n)
        for j in range(m):
            v, u = sin_cos(j, m)
            r = big + small * u
            points.append((r * c, r * s, small * v))

    def at(i, j):
        return i % n * m + j % m

    faces = []
    for i in range(n):
        for j in range(m):
            faces.append((at(i, j), at(i + 1, j), at(i + 1, j + 1)))
            faces.append((at(i, j), at(i + 1, j + 1), at(i, j + 1)))
    return Mesh(points, faces)


def frustums(n, profile):
    """Area and volume of the solid that n-sided frustums make; profile: (radius, height), outside on the right."""
    s, c = sin_cos(1, 2 * n)
    base = n * s * c  # area of the n-gon in the unit circle
    area = volume = 0.0
    for (r, z), (q, w) in zip(profile, profile[1:]):
        slant = sqrt((w - z) * (w - z) + (q - r) * (q - r) * c * c)
        area += n * s * (r + q) * slant
        volume += base * (w - z) * (r * r + r * q + q * q) / 3
    return area, volume


def icosphere():
    """The icosahedron in the unit sphere, each face cut in four: 42 points, 80 faces."""
    golden = (1 + sqrt(5.0)) / 2
    raw = []
    for a in (-1.0, 1.0):
        for b in (-golden, golden):
            raw += [(0.0, a, b), (a, b, 0.0), (b, 0.0, a)]

    def unit(p):
        length = sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2])
        return tuple(x / length for x in p)

    def near(i, j):
        return abs(sum((x - y) * (x - y) for x, y in zip(raw[i], raw[j])) - 4) < 0.1

    def outward(i, j, k):
        (a, b, c), (d, e, f), (g, h, m) = raw[i], raw[j], raw[k]
        return a * (e * m - f * h) - b * (d * m - f * g) + c * (d * h - e * g) > 0

    points = [unit(p) for p in raw]
    middles = {}

    def middle(i, j):
        key = (min(i, j), max(i, j))
        if key not in middles:
            middles[key] = len(points)
            points.append(unit(tuple(x + y for x, y in zip(raw[i], raw[j]))))
        return middles[key]

    faces = []
    for i in range(12):
        for j in range(i + 1, 12):
            for k in range(j + 1, 12):
                if near(i, j) and near(j, k) and near(i, k):
                    a, b, c = (i, j, k) if outward(i, j, k) else (i, k, j)
                    d, e, f = middle(a, b), middle(b, c), middle(c, a)
                    faces += [(a, d, f), (b, e, d), (c, f, e), (d, e, f)]
    return Mesh(points, faces)


def icosphere_measures():
    """Area and volume: 20 equilateral faces amid 60 with two equal sides, each with the centre a pyramid."""
    golden = (1 + sqrt(5.0)) / 2
    base = 1 / golden  # between two middles: the edge of the icosidodecahedron in the unit sphere
    half = sqrt((1 + 1 / sqrt(5.0)) / 2)  # cosine of half the angle that an edge subtends; its own cosine is 1/sqrt 5
    leg_squared = 2 - 2 * half  # from a corner to a middle
    area = volume = 0.0
    for count, squared in ((20, base * base), (60, leg_squared)):
        face = base / 2 * sqrt(squared - base * base / 4)
        radius = squared * base / (4 * face)  # of the circle through the corners
        area += count * face
        volume += count * face * sqrt(1 - radius * radius) / 3
    return area, volume


def voxels(cells):
    """The surface of a union of unit cubes, outward; a point of the grid is one vertex however often it is met."""
    sides = [((-1, 0, 0), 5), ((1, 0, 0), 3), ((0, -1, 0), 2), ((0, 1, 0), 4), ((0, 0, -1), 0), ((0, 0, 1), 1)]
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    index, faces = {}, []
    for cell in sorted(cells):
        for step, side in sides:
            if tuple(c + d for c, d in zip(cell, step)) in cells:
                continue
            ids = []
            for corner in CUBE_QUADS[side]:
                point = tuple(float(c + d) for c, d in zip(cell, corners[corner]))
                ids.append(index.setdefault(point, len(index)))
            faces += [(ids[0], ids[1], ids[2]), (ids[0], ids[2], ids[3])]
    return Mesh(list(index), faces)


def block_with_holes(g):
    """A block of (2g + 1) x 3 x 1 with g square holes through it: genus g."""
    holes = {(2 * i + 1, 1, 0) for i in range(g)}
    return voxels({(x, y, 0) for x in range(2 * g + 1) for y in range(3)} - holes)


def moebius_strip(n):
    """n rungs of length 1 round a circle of radius 2, half a twist. Oriented alike but across the first rung."""
    points = []
    for i in range(n):
        s, c = sin_cos(i, n)
        v, u = sin_cos(i, 2 * n)
        points += [((2 + h * u) * c, (2 + h * u) * s, h * v) for h in (0.5, -0.5)]
    faces = []
    for i in range(n):
        a, b, c, d = 2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 3
        if i == n - 1:
            c, d = 1, 0
        faces += [(a, b, d), (a, d, c)]
    return Mesh(points, faces)


def projective_plane():
    """Six points (of the moment curve, in general position), ten faces: half an icosahedron, glued to itself."""
    points = [(float(t), float(t * t), float(t * t * t)) for t in range(6)]
    ring = [(1 + i, 1 + (i + 1) % 5, 1 + (i + 3) % 5) for i in range(5)]
    return Mesh(points, [(0, a, b) for a, b, _ in ring] + ring)
