"""Folders of objects that belong together. Each object is good by itself."""

import shapes


def block(low, high):
    """A box between two corners."""
    return shapes.moved(shapes.box(*(h - c for c, h in zip(low, high))), low)


def corner(at, side):
    """A tetrahedron: the corner of a cube."""
    return shapes.moved(shapes.tetrahedron(), at, side)


def gap():
    return {"lower_plate.mesh": block((0.0, 0.0, 0.0), (8.0, 8.0, 1.0)),
            "upper_plate.mesh": block((0.0, 0.0, 4.0), (8.0, 8.0, 5.0)),
            "block.mesh": block((3.0, 3.0, 2.0), (5.0, 5.0, 3.0)),
            "post.mesh": block((11.0, 1.0, 0.0), (12.0, 3.0, 1.0)),
            "wedge.mesh": corner((-5.0, -5.0, -4.0), 8.0)}


def clash():
    spike = shapes.Mesh([(3.0, 2.0, 6.0), (2.0, 1.0, 8.0), (4.0, 1.0, 8.0), (3.0, 4.0, 8.0)],
                        [(0, 2, 1), (0, 3, 2), (0, 1, 3), (1, 2, 3)])
    return {"base.mesh": block((0.0, 0.0, 0.0), (6.0, 6.0, 6.0)),
            "crossing.mesh": block((5.0, 2.0, 2.0), (8.0, 4.0, 4.0)),
            "spike.mesh": spike,
            "shelf.mesh": block((-2.0, 3.0, 3.0), (0.0, 5.0, 5.0)),
            "plinth.mesh": block((0.0, 0.0, -2.0), (6.0, 6.0, 0.0)),
            "inside.mesh": block((1.0, 1.0, 3.0), (2.0, 2.0, 4.0)),
            "apart.mesh": block((11.0, 0.0, 0.0), (12.0, 1.0, 1.0))}


def nest():
    wall = shapes.inverted(block((23.0, 3.0, 3.0), (27.0, 7.0, 7.0)))
    return {"outer.mesh": block((0.0, 0.0, 0.0), (16.0, 16.0, 16.0)),
            "middle.mesh": block((4.0, 4.0, 4.0), (12.0, 12.0, 12.0)),
            "inner.mesh": block((7.0, 7.0, 7.0), (9.0, 9.0, 9.0)),
            "ledge.mesh": block((6.0, 6.0, 0.0), (8.0, 8.0, 1.0)),
            "half_in.mesh": shapes.joined(block((0.5, 7.0, 7.0), (1.5, 9.0, 9.0)),
                                          block((-3.0, 7.0, 7.0), (-2.0, 9.0, 9.0))),
            "hollow.mesh": shapes.joined(block((20.0, 0.0, 0.0), (30.0, 10.0, 10.0)), wall),
            "guest.mesh": block((24.0, 4.0, 4.0), (26.0, 6.0, 6.0))}


def fold():
    cells = {(x, y, 0) for x in range(3) for y in range(3)} - {(1, 1, 0), (2, 1, 0)}
    return {"clamp.mesh": shapes.voxels(cells), "neighbour.mesh": block((5.0, 0.0, 0.0), (6.0, 3.0, 1.0))}


def fold_widths():
    """[vertex id, width] of the clamp: the vertices of the slot's two walls that are not on its back."""
    points = fold()["clamp.mesh"].points
    return [[i, 1.0] for i, (x, y, _) in enumerate(points, 1) if x >= 2 and 1 <= y <= 2]


def all_sets():
    """(folder, meshes by file name, words)."""
    yield ("gap", gap(),
           "Two plates of thickness 1, 3 apart: 3 from each corner that faces the other plate, 4 = 3 + 1 from those behind,"
           " where no third object is nearer. A block between them, 1 from either, a post beside the lower one, 3 from"
           " its side, and a wedge whose slanted face is 2 sqrt 3 from a corner of the lower plate.")
    yield ("clash", clash(),
           "What can happen to a base of side 6: a bar crosses its right side and has four corners 1 deep within it, a"
           " spike touches its top with a point, a shelf sits on its left side (an overlap in one plane), a plinth has"
           " its bottom for top (two faces in the same three places), a unit cube lies inside it, and a cube is apart.")
    yield ("nest", nest(),
           "Boxes three deep, 4 and then 3 apart, and a ledge that stands on the floor of the outer one, contained as well."
           " An object of two parts, only one of them inside the outer box, is not contained; nor is the guest in the"
           " cavity of a hollow block, 1 from its wall on every side.")
    yield ("fold", fold(),
           "A clamp with a slot of width 1, and 2 off its mouth a neighbour. `folds` gives the width at the vertices of"
           " the slot's walls that are not on its back: the distance to the object itself, straight across the slot.")
