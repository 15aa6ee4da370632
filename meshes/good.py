"""The meshes with nothing wrong, each beside what is true of it and why."""

from math import sqrt

import formats
import shapes
from truth import box, cube_figures, solid

CUBE = solid(8, 12, 6, 1, bounding_box=box((0, 0, 0), (1, 1, 1)), **cube_figures())
TETRAHEDRON_AREA = (3 + sqrt(3.0)) / 2


def solids():
    """(name, bytes, truth, words) of single bodies."""
    cube, tetrahedron = shapes.cube(), shapes.tetrahedron()
    yield ("cube.mesh", formats.native(cube), CUBE | {"format": "mesh"},
           "Unit cube, 12 faces: area 6, volume 1, genus 0. 12 edges of 270 degrees and 6 diagonals of 180; every face"
           " is half a square, aspect ratio 2.")
    yield ("tetrahedron.mesh", formats.native(tetrahedron),
           solid(4, 4, TETRAHEDRON_AREA, 1 / 6, bounding_box=box((0, 0, 0), (1, 1, 1)),
                 edge_length={"count": 6, "min": 1.0, "max": sqrt(2.0), "total": 3 + 3 * sqrt(2.0)},
                 edge_angle={"count": 6, "min": 270.0}),
           "Corner of a cube: three right triangles of area 1/2 and one of (sqrt 3)/2, volume 1/6; three edges of 270"
           " degrees, three of 360 - arccos(1/sqrt 3).")
    n, m = 16, 8
    profile = [shapes.sin_cos(j, 2 * m) for j in range(m + 1)]
    area, volume = shapes.frustums(n, [(r, -z) for r, z in profile])
    yield ("uv_sphere.mesh", formats.native(shapes.uv_sphere(n, m)), solid(2 + n * (m - 1), 2 * n * (m - 1), area, volume),
           "16 meridians, 8 stacks in the unit sphere: 2 + 16 * 7 vertices, 2 * 16 * 7 faces; area and volume are those"
           " of eight 16-sided frustums.")
    area, volume = shapes.icosphere_measures()
    yield ("icosphere.mesh", formats.native(shapes.icosphere()), solid(42, 80, area, volume),
           "Icosahedron in the unit sphere with every face cut in four: 20 equilateral faces and 60 with two equal sides.")
    n, m, big, small = 12, 8, 2.0, 0.5
    profile = [shapes.sin_cos(j, m) for j in range(m + 1)]
    area, volume = shapes.frustums(n, [(big + small * u, small * v) for v, u in profile])
    torus = solid(n * m, 2 * n * m, area, volume, genus=1)
    yield ("torus.mesh", formats.native(shapes.torus(n, m, big, small)), torus,
           "Radii 2 and 1/2, 12 sections of 8 points: 96 vertices, 192 faces, genus 1; area and volume are those of"
           " 12-sided frustums, the inner ones taken away.")
    yield ("torus.obj", formats.obj(shapes.torus(n, m, big, small)), torus | {"format": "obj"}, "torus.mesh as OBJ.")
    for g in (2, 3):
        yield (f"genus_{g}.mesh", formats.native(shapes.block_with_holes(g)),
               solid(16 * g + 16, 36 * g + 28, 18 * g + 14, 5 * g + 3, genus=g),
               f"Block of {2 * g + 1} x 3 x 1 unit cubes with {g} square holes through it: genus {g}, volume"
               f" {5 * g + 3} cubes, area {18 * g + 14} unit squares.")
    yield ("far_away.mesh", formats.native(shapes.moved(cube, (1e6, 1e6, 1e6))),
           CUBE | {"bounding_box": box((1e6,) * 3, (1e6 + 1,) * 3)},
           "The unit cube a million units from the origin: still volume 1 to the last digit.")
    yield ("messy_but_good.mesh", formats.messy(cube), CUBE,
           "The unit cube with CRLF line ends, comments, tabs, blank lines, signs and exponents, and the faces before"
           " the vertices: nothing of that is a fault.")
    h = 2.0**-10
    slope = sqrt(2 + (1 - h) * (1 - h)) / 2
    yield ("short_edge.mesh", formats.native(shapes.short_edged(h)),
           solid(5, 6, (1 + h) / 2 + 1 + h * sqrt(2.0) / 2 + slope, (1 + h) / 6, edge_length={"count": 9, "min": h}),
           "tetrahedron.mesh with its top cut into an edge 4-5 of length 2^-10: good, but for who asks for longer edges.")
    yield ("sliver.mesh", formats.native(shapes.box(1.0, 1.0, h)),
           solid(8, 12, 2 + 4 * h, h, aspect_ratio={"count": 12, "infinite": 0, "min": 2.0, "max": (1 + h * h) / h}),
           "Plate 1 x 1 x 2^-10: the 8 side faces have legs 1 and h = 2^-10, aspect ratio (1 + h^2)/h = 1024.0009765625."
           " Good, but for who asks for a smaller aspect ratio.")


def assemblies():
    """Several components."""
    cube = shapes.cube()

    def part(outward, inside, volume, **more):
        return {"outward": outward, "inside": inside, "volume": float(volume), "genus": 0} | more

    yield ("two_cubes.mesh", formats.native(shapes.joined(cube, shapes.moved(cube, (3.0, 0.0, 0.0)))),
           solid(16, 24, 12, 2, components=2, edge_components=2,
                 per_component=[part(True, None, 1), part(True, None, 1, first_face=13)]),
           "Two unit cubes, 2 apart: two components, area 12, volume 2.")
    outer = shapes.moved(cube, (0.0, 0.0, 0.0), 3.0)
    hollow = shapes.inverted(shapes.moved(cube, (1.0, 1.0, 1.0)))
    yield ("cavity.mesh", formats.native(shapes.joined(outer, hollow)),
           solid(16, 24, 60, 26, components=2, edge_components=2, per_component=[part(True, None, 27), part(True, 0, -1)]),
           "A cube of side 3 (faces 1-12) with a unit cavity, whose wall (faces 13-24) points into the cavity, as it"
           " should: outward, volume 27 - 1, area 54 + 6.")
    outer = shapes.moved(cube, (0.0, 0.0, 0.0), 5.0)
    hollow = shapes.inverted(shapes.moved(cube, (1.0, 1.0, 1.0), 3.0))
    island = shapes.moved(cube, (2.0, 2.0, 2.0))
    yield ("island_in_cavity.mesh", formats.native(shapes.joined(outer, hollow, island)),
           solid(24, 36, 210, 99, components=3, edge_components=3,
                 per_component=[part(True, None, 125), part(True, 0, -27), part(True, 1, 1)]),
           "Side 5, a cavity of side 3, and a unit cube floating in it: outward, volume 125 - 27 + 1, area 150 + 54 + 6.")


def cubes():
    """The unit cube in every format."""
    cube = shapes.cube()
    truths = CUBE | {"edge_length": CUBE["edge_length"]}
    as_is = "The unit cube; figures as for cube.mesh."
    yield "cube_inria.mesh", formats.inria(cube), truths | {"format": "inria"}, as_is
    yield "cube.obj", formats.obj(cube), truths | {"format": "obj"}, as_is
    yield "cube.off", formats.off(cube), truths | {"format": "off"}, as_is
    stl = truths | {"format": "stl", "merged_points": 28}
    yield ("cube_ascii.stl", formats.stl_ascii(cube), stl,
           "The unit cube; 36 corners at 8 places, so 28 points are merged.")
    yield ("cube_binary.stl", formats.stl_binary(cube), stl,
           "The same in binary; its header begins with `solid`, which must not make it text.")
    for name, encoding in (("ascii", "ascii"), ("little", "binary_little_endian"), ("big", "binary_big_endian")):
        yield f"cube_{name}.ply", formats.ply(cube, encoding), truths | {"format": "ply"}, as_is
    names = ("bottom", "top", "front", "right", "back", "left")
    normals = [(0.0, 0.0, -1.0), (0.0, 0.0, 1.0), (0.0, -1.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (-1.0, 0.0, 0.0)]
    yield ("polygons.obj", formats.obj_quads(cube.points, shapes.CUBE_QUADS, normals, names),
           truths | {"format": "obj", "polygons": 6},
           "The unit cube as six quads with normals, in six groups: each quad counts as two faces.")


def all_good():
    yield from solids()
    yield from assemblies()
    yield from cubes()
