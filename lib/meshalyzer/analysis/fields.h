#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/analysis/field_info.h"

#include <tuple>

namespace meshalyzer {

// The descriptions of the fields of an analysis, in the order of JSON. Texts have the same order,
// except that the bounding box, area and volume come after all counts.

/// Returns which fields an analysis fills in.
[[nodiscard]] inline Known known_of(const Analysis& analysis) {
  return analysis.has_characteristics ? Known::Measured : Known::Always;
}

inline constexpr std::tuple kIntegrityFields{
    FieldRow{{.key = "orphan_vertices",
              .label = "orphan vertices",
              .definition = "vertices that no face uses"},
             &Integrity::orphan_vertices},
    FieldRow{{.key = "missing_vertices",
              .label = "missing vertices",
              .definition = "ids that faces name and no vertex record has"},
             &Integrity::missing_vertices},
    FieldRow{{.key = "degenerate_faces",
              .label = "degenerate faces",
              .definition = "faces that name the same vertex more than once"},
             &Integrity::degenerate_faces},
    FieldRow{{.key = "duplicate_vertex_indices",
              .label = "duplicate vertex indices",
              .definition = "vertex records with the id of an earlier one"},
             &Integrity::duplicate_vertex_indices},
    FieldRow{{.key = "duplicate_face_indices",
              .label = "duplicate face indices",
              .definition = "face records with the id of an earlier one"},
             &Integrity::duplicate_face_indices},
    FieldRow{{.key = "torn_lines",
              .label = "torn lines",
              .definition = "lines that begin with a number: what is left of a torn record"},
             &Integrity::torn_lines},
    FieldRow{{.key = "contiguous_vertices",
              .label = "contiguous vertex numbering",
              .definition = "the ids of the vertices are 1, 2, 3, ... in order"},
             &Integrity::contiguous_vertices},
    FieldRow{{.key = "contiguous_faces",
              .label = "contiguous face numbering",
              .definition = "the ids of the faces are 1, 2, 3, ... in order"},
             &Integrity::contiguous_faces},
};

inline constexpr std::tuple kAttributeFields{
    FieldRow{{.key = "closed",
              .label = "closed",
              .definition = "every edge has two or more faces: there is no border"},
             &Attributes::closed},
    FieldRow{{.key = "manifold",
              .label = "manifold",
              .definition = "no edge has more than two faces, and the faces round each vertex are "
                            "one fan"},
             &Attributes::manifold},
    FieldRow{{.key = "orientable",
              .label = "orientable",
              .definition = "the faces can be turned so that neighbours agree which side is "
                            "outside"},
             &Attributes::orientable},
    FieldRow{{.key = "consistent",
              .label = "consistent",
              .definition = "neighbouring faces, as they are, agree which side is outside"},
             &Attributes::consistent},
    FieldRow{{.key = "outward",
              .label = "outward",
              .definition = "the faces point away from the solid; those of the wall of a cavity "
                            "point into it"},
             &Attributes::outward},
};

/// The fields of Characteristics except the statistics, which kElementMeasures describes.
inline constexpr std::tuple kCharacteristicFields{
    FieldRow{{.key = "vertices",
              .label = "vertices",
              .definition = "vertex records of the file, orphans too"},
             &Characteristics::vertices},
    FieldRow{
        {.key = "faces", .label = "faces", .definition = "triangles of the file, broken ones too"},
        &Characteristics::faces},
    FieldRow{{.key = "edges",
              .label = "edges",
              .definition = "pairs of vertices that bound a face, each pair once"},
             &Characteristics::edges},
    FieldRow{{.key = "components",
              .label = "components",
              .definition = "parts whose faces hang together through common vertices"},
             &Characteristics::components},
    FieldRow{{.key = "edge_components",
              .label = "edge components",
              .definition = "parts whose faces hang together through common edges"},
             &Characteristics::edge_components},
    FieldRow{{.key = "boundaries",
              .label = "boundaries",
              .definition = "loops, or chains, of border edges"},
             &Characteristics::boundaries},
    FieldRow{
        {.key = "border_edges", .label = "border edges", .definition = "edges with one face alone"},
        &Characteristics::border_edges},
    FieldRow{{.key = "non_manifold_edges",
              .label = "non-manifold edges",
              .definition = "edges with more than two faces"},
             &Characteristics::non_manifold_edges},
    FieldRow{{.key = "non_manifold_vertices",
              .label = "non-manifold vertices",
              .definition = "vertices whose faces are not one fan, and the ends of non-manifold "
                            "edges"},
             &Characteristics::non_manifold_vertices},
    FieldRow{{.key = "pinched_vertices",
              .label = "pinched vertices",
              .definition = "non-manifold vertices that are on no non-manifold edge"},
             &Characteristics::pinched_vertices},
    FieldRow{{.key = "flipped_edges",
              .label = "flipped edges",
              .definition = "edges whose two faces run along them in the same direction"},
             &Characteristics::flipped_edges},
    FieldRow{{.key = "bounding_box",
              .label = "bounding box",
              .definition = "the smallest box, along the axes, that holds all faces"},
             &Characteristics::bounding_box},
    FieldRow{{.key = "volume",
              .label = "volume",
              .definition = "what the faces enclose; negative where they point inward"},
             &Characteristics::volume},
    FieldRow{{.key = "genus",
              .label = "genus",
              .definition = "how many handles the surface has: a ball has none, a ring one. From "
                            "vertices - edges + faces = 2 - 2 genus - boundaries"},
             &Characteristics::genus},
    FieldRow{{.key = "genus_of_components",
              .definition = "the genus of the components summed: the same as genus, but where "
                            "orphan vertices leave that undefined"},
             &Characteristics::genus_of_components},
    FieldRow{{.key = "indistinguishable_vertices",
              .label = "indistinguishable vertices",
              .definition = "vertices at the place of another one"},
             &Characteristics::indistinguishable_vertices,
             Known::Measured},
    FieldRow{{.key = "indistinguishable_edges",
              .label = "indistinguishable edges",
              .definition = "edges with both ends at the same place"},
             &Characteristics::indistinguishable_edges,
             Known::Measured},
    FieldRow{{.key = "zero_area_faces",
              .label = "zero-area faces",
              .definition = "faces whose corners are on a line"},
             &Characteristics::zero_area_faces,
             Known::Measured},
    FieldRow{{.key = "duplicate_faces",
              .label = "duplicate faces",
              .definition = "faces with the same three vertices as an earlier one"},
             &Characteristics::duplicate_faces,
             Known::Measured},
    FieldRow{{.key = "intersecting_pairs",
              .label = "intersecting pairs",
              .definition = "pairs of faces that share a point which is not on a common vertex or "
                            "edge; unwelded ones only meet along a seam whose vertices were never "
                            "joined"},
             &Characteristics::intersecting_pairs,
             Known::Measured},
    FieldRow{{.key = "unwelded_pairs",
              .definition = "those of the intersecting pairs that only meet along a seam whose "
                            "vertices were never joined"},
             &Characteristics::unwelded_pairs,
             Known::Measured},
    FieldRow{{.key = "intersecting_faces",
              .label = "intersecting faces",
              .definition = "faces that intersect at least one other"},
             &Characteristics::intersecting_faces,
             Known::Measured},
    FieldRow{{.key = "area", .label = "area", .definition = "sum of the areas of the faces"},
             &Characteristics::area,
             Known::Measured},
};

/// The fields of a component except the first face, which reports name by its id. Texts have a
/// table of components, see components_table().
inline constexpr std::tuple kComponentFields{
    FieldRow{{.key = "faces"}, &ComponentAnalysis::faces},
    FieldRow{{.key = "vertices"}, &ComponentAnalysis::vertices},
    FieldRow{{.key = "edges"}, &ComponentAnalysis::edges},
    FieldRow{{.key = "edge_components"}, &ComponentAnalysis::edge_components},
    FieldRow{{.key = "boundaries"}, &ComponentAnalysis::boundaries},
    FieldRow{{.key = "border_edges"}, &ComponentAnalysis::border_edges},
    FieldRow{{.key = "non_manifold_edges"}, &ComponentAnalysis::non_manifold_edges},
    FieldRow{{.key = "non_manifold_vertices"}, &ComponentAnalysis::non_manifold_vertices},
    FieldRow{{.key = "flipped_edges"}, &ComponentAnalysis::flipped_edges},
    FieldRow{{.key = "closed"}, &ComponentAnalysis::closed},
    FieldRow{{.key = "manifold"}, &ComponentAnalysis::manifold},
    FieldRow{{.key = "orientable"}, &ComponentAnalysis::orientable},
    FieldRow{{.key = "consistent"}, &ComponentAnalysis::consistent},
    FieldRow{{.key = "outward"}, &ComponentAnalysis::outward},
    FieldRow{{.key = "zero_area_faces"}, &ComponentAnalysis::zero_area_faces, Known::Measured},
    FieldRow{{.key = "intersecting_pairs",
              .definition = "those with at least one face in the component"},
             &ComponentAnalysis::intersecting_pairs,
             Known::Measured},
    FieldRow{{.key = "genus"}, &ComponentAnalysis::genus},
    FieldRow{{.key = "volume"}, &ComponentAnalysis::volume},
    FieldRow{{.key = "area"}, &ComponentAnalysis::area, Known::Measured},
    FieldRow{{.key = "bounding_box"}, &ComponentAnalysis::bounding_box},
    FieldRow{
        {.key = "inside", .definition = "index of the component that directly encloses this one"},
        &ComponentAnalysis::inside},
};

}  // namespace meshalyzer
