"""What is true of a set of meshes, by brute force over the rationals: every pair of faces, every vertex and face.

Nothing is rounded before the end. The triangles' common part is constructed, not decided by signs of determinants, so
that a program which does the latter is judged by something other than itself.
"""

from decimal import Decimal, localcontext
from fractions import Fraction
from itertools import combinations, permutations

DIRECTIONS = ((1009, 13, 7), (17, 2003, 11), (-19, 29, 3001), (-4001, -31, 23))


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def towards(a, b, t):
    return tuple(x + t * (y - x) for x, y in zip(a, b))


def normal(t):
    return cross(sub(t[1], t[0]), sub(t[2], t[0]))


def triangles(mesh):
    """The corners of each face as exact numbers."""
    points = exact(mesh)
    return [tuple(points[v] for v in face) for face in mesh.faces]


def exact(mesh):
    return [tuple(int(c) if c.is_integer() else Fraction(c) for c in p) for p in mesh.points]


def root(square):
    """The square root of a rational number, rounded once."""
    with localcontext() as context:
        context.prec = 60
        return (Decimal(square.numerator) / Decimal(square.denominator)).sqrt()


# Contacts.

def walls(t):
    """The half-spaces that cut the triangle out of its plane: (point, inward normal)."""
    n = normal(t)
    return [(t[i], cross(n, sub(t[(i + 1) % 3], t[i]))) for i in range(3)]


def clipped(polygon, wall):
    """The part of a convex polygon, segment or point within a half-space; corners may come twice."""
    origin, inward = wall
    heights = [dot(inward, sub(p, origin)) for p in polygon]
    kept = []
    for i, (p, h) in enumerate(zip(polygon, heights)):
        q, k = polygon[i - 1], heights[i - 1]
        if h * k < 0:
            kept.append(towards(q, p, Fraction(k, k - h)))
        if h >= 0:
            kept.append(p)
    return kept


def common_part(p, q):
    """Corners of what two triangles share: nothing, a point, a segment or a polygon. None of the two has zero area."""
    n = normal(q)
    part = clipped(clipped(list(p), (q[0], n)), (q[0], tuple(-x for x in n)))
    for wall in walls(q):
        part = clipped(part, wall)
    return part


def is_within(point, t):
    """Whether the foot of a point in the triangle's plane lies inside, not on the border."""
    return all(dot(inward, sub(point, origin)) > 0 for origin, inward in walls(t))


def contact(p, q):
    """How two faces of different files share points; None where they do not."""
    if set(p) == set(q):
        return "duplicate"
    part = list(dict.fromkeys(common_part(p, q)))
    if not part:
        return None
    if any(any(normal((part[0], a, b))) for a, b in combinations(part[1:], 2)):
        return "coplanar-overlap"
    # The mean lies inside the common part, so inside both triangles if any point does.
    mean = tuple(Fraction(sum(c), len(part)) for c in zip(*part))
    is_coplanar = all(dot(normal(q), sub(corner, q[0])) == 0 for corner in p)
    return "crossing" if not is_coplanar and is_within(mean, p) and is_within(mean, q) else "touching"


# Distances.

def from_segment(point, a, b):
    along = sub(b, a)
    t = min(max(Fraction(dot(sub(point, a), along), dot(along, along)), 0), 1)
    off = sub(point, towards(a, b, t))
    return dot(off, off)


def from_triangle(point, t):
    """The square of the distance between a point and a triangle."""
    if is_within(point, t):
        n = normal(t)
        return Fraction(dot(n, sub(point, t[0])) ** 2, dot(n, n))
    return min(from_segment(point, t[i], t[(i + 1) % 3]) for i in range(3))


def hits(point, direction, t):
    """Whether a ray meets a triangle; None where it passes through its border, or lies in its plane."""
    slope = dot(normal(t), direction)
    height = dot(normal(t), sub(t[0], point))
    if slope == 0:
        return None if height == 0 else False
    if height * slope < 0:
        return False
    foot = tuple(x + Fraction(height, slope) * d for x, d in zip(point, direction))
    sides = [dot(inward, sub(foot, origin)) for origin, inward in walls(t)]
    if all(s >= 0 for s in sides):
        return None if 0 in sides else True
    return False


def is_inside(point, faces):
    """Whether a point that is on no face is in the solid: the first ray that meets no border decides."""
    for direction in DIRECTIONS:
        answers = [hits(point, direction, t) for t in faces]
        if None not in answers:
            return sum(answers) % 2 == 1
    raise ValueError("every ray meets an edge")


# Sets.

def intersecting_pairs(faces):
    """[file, face id, file, face id, kind] in order of the files' names."""
    return [[a, i, b, j, kind] for a, b in combinations(sorted(faces), 2)
            for i, p in enumerate(faces[a], 1) for j, q in enumerate(faces[b], 1) if (kind := contact(p, q))]


def signed_distances(name, points, faces):
    """[vertex id, distance to the nearest face of the others], negative inside any of them."""
    rows = []
    for i, point in enumerate(points, 1):
        squares = {other: min(from_triangle(point, t) for t in faces[other]) for other in faces if other != name}
        least = min(squares.values())
        around = {other for other, square in squares.items() if square > 0 and is_inside(point, faces[other])}
        nearest = {other for other, square in squares.items() if square == least}
        # So the sign is the same whether all others or only the nearest are asked.
        if least > 0 and (bool(around) != bool(around & nearest) or around & nearest not in (set(), nearest)):
            raise ValueError(f"{name}: the sign at vertex {i} is a matter of definition")
        rows.append([i, float(root(least)) * (-1 if around and least > 0 else 1)])
    return rows


def contained(points, faces, pairs):
    """[inner, outer]: no faces cross, and all vertices of the one that are not on the other are in its solid."""
    crossing = {(a, b) for a, _, b, _, kind in pairs if kind == "crossing"}
    rows = []
    for a, b in permutations(sorted(faces), 2):
        off = [p for p in points[a] if all(from_triangle(p, t) > 0 for t in faces[b])]
        if (min(a, b), max(a, b)) not in crossing and off and all(is_inside(p, faces[b]) for p in off):
            rows.append([a, b])
    return rows


def truth(meshes):
    """Of a dict from file name to mesh, each a good solid."""
    points = {name: exact(mesh) for name, mesh in meshes.items()}
    faces = {name: triangles(mesh) for name, mesh in meshes.items()}
    every = [t for name in faces for t in faces[name]]
    pairs = intersecting_pairs(faces)
    return {"meshes": len(meshes), "faces": len(every), "vertices": sum(map(len, points.values())),
            "area": float(sum(root(dot(normal(t), normal(t))) for t in every) / 2),
            "volume": float(Fraction(sum(dot(t[0], cross(t[1], t[2])) for t in every), 6)),
            "intersecting_pairs": pairs, "contained": contained(points, faces, pairs),
            "separation": {name: signed_distances(name, points[name], faces) for name in sorted(meshes)}}
