"""What is true of a mesh, as the JSON report says it: a nested dict, made from figures that the catalogue states."""

from math import sqrt

INTEGRITY = ("orphan_vertices", "missing_vertices", "degenerate_faces", "duplicate_vertex_indices",
             "duplicate_face_indices", "contiguous_vertices", "contiguous_faces")
ATTRIBUTES = ("closed", "manifold", "orientable", "consistent", "outward")
COUNTS = ("boundaries", "border_edges", "non_manifold_edges", "non_manifold_vertices", "pinched_vertices",
          "flipped_edges", "indistinguishable_vertices", "indistinguishable_edges", "zero_area_faces",
          "duplicate_faces", "intersecting_pairs", "unwelded_pairs", "intersecting_faces")
BESIDE = ("good", "offenders", "per_component", "format", "polygons", "merged_points")

# What is not known from a formula is left out of a truth: give a figure as UNKNOWN.
UNKNOWN = object()


def solid(vertices, faces, area, volume, **figures):
    """A good mesh: closed, outward, every edge with two faces. Figures given replace those of a good mesh."""
    truth = dict.fromkeys(INTEGRITY, 0) | {"contiguous_vertices": True, "contiguous_faces": True}
    truth |= dict.fromkeys(ATTRIBUTES, True) | dict.fromkeys(COUNTS, 0)
    truth |= {"vertices": vertices, "faces": faces, "edges": 3 * faces // 2, "components": 1, "edge_components": 1,
              "area": area, "volume": volume, "genus": 0, "good": True}
    return truth | figures


def bad(vertices, faces, **figures):
    """Neither good nor a solid: no volume and no outside, where the figures given do not say otherwise."""
    return solid(vertices, faces, **{"area": UNKNOWN, "volume": None, "outward": None, "good": False} | figures)


# Where a mesh is not manifold, orientation, volume and genus have no meaning.
NOT_MANIFOLD = {"manifold": False, "orientable": None, "consistent": None, "outward": None, "volume": None, "genus": None}
# An open mesh without any other fault.
OPEN = {"closed": False, "good": False}


def box(low, high):
    return {"min": list(map(float, low)), "max": list(map(float, high))}


def cube_figures(side=1.0):
    """12 edges and 6 diagonals; at the edges 270 degrees, at the diagonals 180; legs 1 1 give an aspect ratio of 2."""
    root = sqrt(2.0)
    return {
        "edge_length": {"count": 18, "min": side, "max": side * root, "median": side, "total": side * (12 + 6 * root)},
        "edge_angle": {"count": 18, "min": 180.0, "max": 270.0, "mean": 240.0, "median": 270.0,
                       "variance": (12 * 30.0 * 30.0 + 6 * 60.0 * 60.0) / 17},
        "face_area": {"count": 12, "min": side * side / 2, "max": side * side / 2, "mean": side * side / 2,
                      "variance": 0.0, "total": 6 * side * side},
        "aspect_ratio": {"count": 12, "infinite": 0, "min": 2.0, "max": 2.0, "mean": 2.0},
        "vertex_valence": {"count": 8, "min": 4.0, "max": 5.0, "mean": 4.5, "median": 4.5, "variance": 2 / 7},
    }


def nested(truth):
    """The figures under the keys of the report."""
    out = {"integrity": {}, "attributes": {}, "characteristics": {}}
    for key, value in truth.items():
        if value is UNKNOWN:
            continue
        if key in BESIDE:
            out[key] = value
        else:
            part = "integrity" if key in INTEGRITY else "attributes" if key in ATTRIBUTES else "characteristics"
            out[part][key] = value
    return out
