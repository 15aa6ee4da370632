"""The meshes with one thing wrong each, beside what is true of them and why."""

from math import sqrt

import formats
import shapes
from good import CUBE, TETRAHEDRON_AREA
from shapes import Mesh
from truth import NOT_MANIFOLD, OPEN, UNKNOWN, bad, box, cube_figures, solid


def orientation():
    cube = shapes.cube()
    yield ("cube_inward.mesh", formats.native(shapes.inverted(cube)),
           CUBE | {"volume": -1.0, "outward": False, "good": False,
                   "edge_angle": {"count": 18, "min": 90.0, "max": 180.0}},
           "The unit cube with every face turned: volume -1, not outward, 90 degrees at its edges.")
    flipped = list(cube.faces)
    flipped[2] = (4, 6, 5)
    yield ("cube_flipped_face.mesh", formats.native(Mesh(cube.points, flipped)),
           CUBE | {"consistent": False, "outward": None, "volume": None, "good": False, "genus": UNKNOWN,
                   "edge_angle": {"count": 15, "min": 180.0, "max": 270.0}, "flipped_edges": 3,
                   "offenders": {"flipped_edges": [[5, 6, [3, 6]], [5, 7, [3, 4]], [6, 7, [3, 8]]]}},
           "The unit cube with face 3 turned: its three edges 5-6, 5-7, 6-7 are flipped; orientable, not consistent,"
           " so without volume and outside.")
    outer = shapes.moved(cube, (0.0, 0.0, 0.0), 3.0)
    inner = shapes.moved(cube, (1.0, 1.0, 1.0))
    yield ("cavity_inside_out.mesh", formats.native(shapes.joined(outer, inner)),
           solid(16, 24, 60, 28, components=2, edge_components=2, outward=False, good=False,
                 per_component=[{"outward": True, "inside": None}, {"outward": False, "inside": 0}]),
           "cavity.mesh with the wall of the cavity (faces 13-24) pointing into the material: not outward, and the"
           " volume sums to 27 + 1.")
    second = shapes.inverted(shapes.moved(cube, (3.0, 0.0, 0.0), 2.0))
    yield ("one_of_two_inward.mesh", formats.native(shapes.joined(cube, second)),
           solid(16, 24, 30, -7, components=2, edge_components=2, outward=False, good=False,
                 per_component=[{"outward": True, "inside": None}, {"outward": False, "inside": None}]),
           "A unit cube and, turned inwards, one of side 2 (faces 13-24): not outward, volume 1 - 8.")
    n = 16
    yield ("moebius_strip.mesh", formats.native(shapes.moebius_strip(n)),
           bad(2 * n, 2 * n, closed=False, orientable=False, consistent=False, genus=None, edges=4 * n, boundaries=1,
               border_edges=2 * n, flipped_edges=1, offenders={"flipped_edges": [[1, 2, [1, 32]]]}),
           "A strip of 16 quads with half a twist: one boundary of 32 edges, Euler characteristic 32 - 64 + 32 = 0, not"
           " orientable; as numbered, only edge 1-2 is flipped.")
    yield ("projective_plane.mesh", formats.native(shapes.projective_plane()),
           bad(6, 10, orientable=False, consistent=False, genus=None, flipped_edges=UNKNOWN,
               intersecting_pairs=UNKNOWN, intersecting_faces=UNKNOWN),
           "Ten faces on six vertices, Euler characteristic 6 - 15 + 10 = 1: closed and manifold, not orientable, and"
           " in space it must intersect itself.")


def borders():
    cube = shapes.cube()
    angles = {"edge_angle": {"count": 13, "min": 180.0, "max": 270.0}, "edge_length": {"count": 17, "min": 1.0}}
    yield ("cube_with_hole.mesh", formats.native(Mesh(cube.points, cube.faces[:10])),
           bad(8, 10, **OPEN, edges=17, area=5.0, boundaries=1, border_edges=4, bounding_box=box((0,) * 3, (1,) * 3),
               **angles, offenders={"border_edges": [[1, 4, [2]], [1, 5, [6]], [4, 8, [9]], [5, 8, [4]]]}),
           "The unit cube without its left side: one boundary of the edges 1-4, 1-5, 4-8, 5-8; area 5, no volume, genus"
           " 0 as 8 - 17 + 10 = 2 - 0 - 1.")
    yield ("tube.mesh", formats.native(Mesh(cube.points, cube.faces[4:])),
           bad(8, 8, **OPEN, edges=16, area=4.0, boundaries=2, border_edges=8),
           "The unit cube without bottom and top: two boundaries of four edges, area 4, genus 0 as 8 - 16 + 8 = 2 - 0 - 2.")
    yield ("one_face.mesh", formats.native(Mesh([(0.0, 0.0, 0.0), (3.0, 0.0, 0.0), (0.0, 4.0, 0.0)], [(0, 1, 2)])),
           bad(3, 1, **OPEN, edges=3, area=6.0, boundaries=1, border_edges=3,
               edge_length={"count": 3, "min": 3.0, "max": 5.0, "mean": 4.0, "median": 4.0, "variance": 1.0, "total": 12.0},
               aspect_ratio={"count": 1, "min": 25 / 12, "max": 25 / 12, "variance": 0.0}, edge_angle={"count": 0}),
           "A right triangle of sides 3, 4, 5: area 6, shortest altitude 12/5, aspect ratio 25/12; one boundary.")
    apart = Mesh([cube.points[v] for face in cube.faces for v in face], [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(12)])
    yield ("unwelded_cube.mesh", formats.native(apart),
           bad(36, 12, **OPEN, edges=36, components=12, edge_components=12, area=6.0, boundaries=12, border_edges=36,
               indistinguishable_vertices=36, intersecting_pairs=46, unwelded_pairs=46, intersecting_faces=12,
               edge_angle={"count": 0}),
           "The unit cube, every face with three vertices of its own: 12 components. Of the 66 pairs of faces 46 share a"
           " corner of the cube: four corners have 5 faces and four have 4, 4 * 10 + 4 * 6 pairs, less the 18 that share"
           " two corners. All are unwelded; no vertex is alone at its place.")
    yield ("point_cloud.ply", formats.ply(Mesh(cube.points, [])),
           dict.fromkeys(("closed", "manifold", "orientable", "consistent", "outward", "volume", "genus")) |
           {"format": "ply", "vertices": 8, "faces": 0, "edges": 0, "components": 0, "boundaries": 0, "orphan_vertices": 8,
            "area": 0.0, "bounding_box": None, "good": False},
           "Eight points and no face: all are orphans, and no attribute is defined.")


def tetrahedron_and(more_points, more_faces):
    base = shapes.tetrahedron()
    return Mesh(base.points + more_points, base.faces + more_faces)


def not_manifold():
    shared = tetrahedron_and([(-1.0, 0.0, 0.0), (0.0, -1.0, 0.0)], [(0, 5, 4), (0, 4, 3), (4, 5, 3), (5, 0, 3)])
    yield ("tetrahedra_sharing_edge.mesh", formats.native(shared),
           bad(6, 8, **NOT_MANIFOLD, edges=11, area=2 * TETRAHEDRON_AREA, non_manifold_edges=1, non_manifold_vertices=2,
               offenders={"non_manifold_edges": [[1, 4, [2, 4, 6, 8]]], "non_manifold_vertices": [1, 4]}),
           "Two tetrahedra with the edge 1-4 in common: it has the four faces 2, 4, 6, 8. Closed, not manifold.")
    shared = tetrahedron_and([(-1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, -1.0)],
                             [(0, 4, 5), (0, 6, 4), (4, 6, 5), (5, 6, 0)])
    yield ("tetrahedra_sharing_vertex.mesh", formats.native(shared),
           bad(7, 8, **NOT_MANIFOLD, edges=12, edge_components=2, area=2 * TETRAHEDRON_AREA, non_manifold_vertices=1,
               pinched_vertices=1, offenders={"non_manifold_vertices": [1], "pinched_vertices": [1]}),
           "Two tetrahedra with vertex 1 in common, which is pinched: one component, two by edges. Closed, not manifold.")
    shared = tetrahedron_and([(1.0, 1.0, 1.0)], [(1, 3, 2), (1, 2, 4), (2, 3, 4), (3, 1, 4)])
    yield ("tetrahedra_sharing_face.mesh", formats.native(shared),
           bad(5, 8, **NOT_MANIFOLD, edges=9, area=TETRAHEDRON_AREA + 2 * sqrt(3.0), non_manifold_edges=3,
               non_manifold_vertices=3, duplicate_faces=1, intersecting_pairs=1, intersecting_faces=2,
               offenders={"non_manifold_edges": [[2, 3, [1, 3, 5, 6]], [2, 4, [2, 3, 5, 8]], [3, 4, [3, 4, 5, 7]]],
                          "duplicate_faces": [5], "intersecting_pairs": [[3, 5, "duplicate"]]}),
           "Two tetrahedra with the wall 2-3-4 between them given twice, as faces 3 and 5: its three edges have four"
           " faces each, and the two faces are duplicates.")
    points = [(0.0, 0.0, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (-1.0, 0.0, 0.0)]
    yield ("fan_of_three.mesh", formats.native(Mesh(points, [(0, 1, 2), (0, 1, 3), (0, 1, 4)])),
           bad(5, 3, **NOT_MANIFOLD, closed=False, edges=7, area=1.5, boundaries=3, border_edges=6, non_manifold_edges=1,
               non_manifold_vertices=2, edge_angle={"count": 0},
               offenders={"non_manifold_edges": [[1, 2, [1, 2, 3]]], "non_manifold_vertices": [1, 2],
                          "pinched_vertices": []}),
           "Three faces on the edge 1-2. Each leaves a chain of two border edges from 1 to 2: three boundaries.")
    points = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (-1.0, 0.0, 0.0), (0.0, -1.0, 0.0)]
    yield ("bow_tie.mesh", formats.native(Mesh(points, [(0, 1, 2), (0, 3, 4)])),
           bad(5, 2, **NOT_MANIFOLD, closed=False, edges=6, edge_components=2, area=1.0, boundaries=2, border_edges=6,
               non_manifold_vertices=1, pinched_vertices=1, offenders={"pinched_vertices": [1]}),
           "Two faces with only vertex 1 in common: pinched, two boundaries of three edges.")
    cells = {(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)} - {(0, 0, 0), (1, 1, 1)}
    mesh = shapes.voxels(cells)
    middle = mesh.points.index((1.0, 1.0, 1.0)) + 1
    yield ("pinched_vertex.mesh", formats.native(mesh),
           bad(25, 48, **NOT_MANIFOLD, area=24.0, non_manifold_vertices=1, pinched_vertices=1,
               offenders={"non_manifold_vertices": [middle], "pinched_vertices": [middle]}),
           f"A 2 x 2 x 2 block without two opposite unit cubes, which met at its middle, vertex {middle}: two fans there,"
           " though all faces hang together by edges. 27 - 2 vertices, area 24 as each corner cut keeps it.")


def intersections():
    cube = shapes.cube()
    points = [(0.0, 0.0, 0.0), (4.0, 0.0, 0.0), (0.0, 4.0, 0.0), (1.0, 1.0, -1.0), (1.0, 1.0, 1.0), (5.0, 5.0, 1.0)]
    yield ("crossing_faces.mesh", formats.native(Mesh(points, [(0, 1, 2), (3, 4, 5)])),
           bad(6, 2, **OPEN, edges=6, components=2, edge_components=2, area=8 + 4 * sqrt(2.0), boundaries=2, border_edges=6,
               intersecting_pairs=1, intersecting_faces=2, offenders={"intersecting_pairs": [[1, 2, "crossing"]]}),
           "Two faces that cross along the segment from (1, 1, 0) to (2, 2, 0).")
    yield ("crossing_cubes.mesh", formats.native(shapes.joined(cube, shapes.moved(cube, (0.5, 0.25, 0.125)))),
           bad(16, 24, components=2, edge_components=2, area=12.0, volume=2.0, outward=UNKNOWN, intersecting_pairs=14,
               intersecting_faces=12),
           "Two unit cubes, the second moved by (1/2, 1/4, 1/8). Their surfaces cross along six segments, which the"
           " diagonals of the sides cut into 3 + 2 + 3 + 2 + 3 + 1 pieces, one pair of faces each; three sides"
           " of either take part, 12 faces.")
    small = shapes.moved(cube, (1.0, 0.25, 0.25), 0.5)
    yield ("touching_cubes.mesh", formats.native(shapes.joined(cube, small)),
           bad(16, 24, components=2, edge_components=2, area=7.5, volume=1.125, outward=UNKNOWN, intersecting_pairs=19,
               intersecting_faces=12),
           "A cube of side 1/2 sits on the right side of the unit cube (faces 7, 8). Its left side (faces 23, 24)"
           " overlaps both in one plane: 4 pairs. The 8 faces round it touch them along an edge or in a corner, two of"
           " its corners being on the diagonal: 7 * 2 + 1 pairs.")
    points = [(0.0, 0.0, 0.0), (2.0, 0.0, 0.0), (0.0, 2.0, 0.0), (0.5, 0.5, 0.0)]
    yield ("fold_over.mesh", formats.native(Mesh(points, [(0, 1, 2), (1, 0, 3)])),
           bad(4, 2, **OPEN, edges=5, area=2.5, boundaries=1, border_edges=4, intersecting_pairs=1, intersecting_faces=2,
               edge_angle={"count": 1, "min": 0.0, "max": 0.0},
               offenders={"intersecting_pairs": [[1, 2, "fold-over"]]}),
           "Two faces folded back on each other about the edge 1-2: an angle of exactly 0.")
    points = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)]
    yield ("pillow.mesh", formats.native(Mesh(points, [(0, 1, 2), (0, 2, 1)])),
           bad(3, 2, area=1.0, volume=0.0, duplicate_faces=1, intersecting_pairs=1, intersecting_faces=2,
               edge_angle={"count": 3, "min": 0.0, "max": 0.0},
               offenders={"duplicate_faces": [2], "intersecting_pairs": [[1, 2, "duplicate"]]}),
           "Two faces back to back on the same three vertices: closed, manifold, consistent, genus 0 as 3 - 3 + 2 = 2;"
           " volume 0, so it has no outside.")


def faces():
    cube = shapes.cube()
    yield ("duplicate_face.mesh", formats.native(Mesh(cube.points, [*cube.faces, cube.faces[0]])),
           bad(8, 13, **NOT_MANIFOLD, edges=18, area=6.5, non_manifold_edges=3, non_manifold_vertices=3, duplicate_faces=1,
               intersecting_pairs=1, intersecting_faces=2,
               offenders={"duplicate_faces": [13], "intersecting_pairs": [[1, 13, "duplicate"]],
                          "non_manifold_vertices": [1, 2, 3]}),
           "The unit cube with face 1 once more as face 13: the edges of the two have three faces.")
    split = list(cube.faces)
    split[2] = (4, 5, 8)
    needle = Mesh([*cube.points, (0.5, 0.5, 1.0)], [*split, (8, 5, 6), (4, 8, 6)])
    yield ("zero_area_face.mesh", formats.native(needle),
           solid(9, 14, 6, 1, good=False, zero_area_faces=1, intersecting_pairs=2, intersecting_faces=3,
                 aspect_ratio={"count": 13, "infinite": 1}, edge_angle={"count": 18, "min": 180.0, "max": 270.0},
                 offenders={"zero_area_faces": [14],
                            "intersecting_pairs": [[3, 4, "touching"], [4, 13, "touching"]]}),
           "The unit cube with the middle of the diagonal 5-7 as vertex 9 on one side only; the gap is closed by face 14"
           " (5, 9, 7), which has no area. Face 4 so touches faces 3 and 13 along an edge it does not share.")
    yield ("degenerate_face.mesh", formats.native(Mesh(cube.points, [*cube.faces, (0, 1, 1)])),
           CUBE | {"faces": 13, "degenerate_faces": 1, "good": False, "offenders": {"degenerate_faces": [13]}},
           "The unit cube and a face 13 that names vertex 2 twice: it is left out, all else is as for the cube.")


def records():
    cube = shapes.cube()
    ids = list(range(1, 9))
    yield ("orphan_vertex.mesh", formats.native(Mesh([*cube.points, (5.0, 5.0, 5.0)], cube.faces)),
           CUBE | {"vertices": 9, "orphan_vertices": 1, "genus": None, "genus_of_components": 0, "good": False,
                   "offenders": {"orphan_vertices": [9]}},
           "The unit cube and a vertex 9 that no face uses: not in the bounding box; no genus, as always with orphans.")
    lines = formats.native(cube).decode().splitlines()
    yield ("missing_vertex.mesh", formats.text([line for line in lines if not line.startswith("Vertex 8 ")]),
           bad(7, 12, **OPEN, edges=14, area=4.0, boundaries=1, border_edges=4, missing_vertices=1,
               offenders={"missing_vertices": [8], "faces_with_missing_vertices": [4, 9, 10, 12],
                          "border_edges": [[3, 4, [2]], [3, 7, [7]], [4, 5, [11]], [5, 7, [3]]]}),
           "The unit cube without the record of vertex 8: faces 4, 9, 10, 12 name it and are left out, which leaves a"
           " boundary of four edges and an area of 4.")
    yield ("not_contiguous.mesh", formats.native(cube, [*ids[:7], 10], [*range(1, 12), 20]),
           CUBE | {"contiguous_vertices": False, "contiguous_faces": False, "good": False},
           "The unit cube with vertex 8 called 10 and face 12 called 20.")
    yield ("duplicate_vertex_id.mesh", formats.native(Mesh([*cube.points, (7.0, 7.0, 7.0)], cube.faces), [*ids, 3]),
           CUBE | {"vertices": 9, "duplicate_vertex_indices": 1, "contiguous_vertices": False, "good": False},
           "The unit cube with a second record of vertex 3 far away: the first counts.")
    yield ("duplicate_face_id.mesh", formats.native(cube, None, [*range(1, 12), 11]),
           CUBE | {"duplicate_face_indices": 1, "contiguous_faces": False, "good": False},
           "The unit cube with its last face called 11 like the one before it: both are faces all the same.")
    h = 5e-11
    slope = sqrt(2 + (1 - h) * (1 - h)) / 2
    yield ("indistinguishable_vertices.mesh", formats.native(shapes.short_edged(h)),
           solid(5, 6, (1 + h) / 2 + 1 + h * sqrt(2.0) / 2 + slope, (1 + h) / 6, good=False, indistinguishable_vertices=2,
                 indistinguishable_edges=1, edge_length={"count": 9, "min": h},
                 offenders={"indistinguishable_vertices": [4, 5], "indistinguishable_edges": [[4, 5, [3, 5]]]}),
           "short_edge.mesh with the edge 4-5 of length 5e-11, within the 1e-10 that make two vertices one to the eye;"
           " its faces are too thin to be good, but have an area.")


def all_bad():
    for group in (orientation, borders, not_manifold, intersections, faces, records):
        yield from group()
