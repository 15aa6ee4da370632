#include "meshalyzer/report/html/definitions.h"

#include "meshalyzer/set/set_analysis.h"

#include <algorithm>
#include <array>

namespace meshalyzer {
namespace {

struct Definition {
  std::string_view term;
  std::string_view meaning;
};

constexpr std::array kDefinitions{
    // The file.
    Definition{"file", "the file as it was named"},
    Definition{"format", "what the file was read as"},
    Definition{"merged points",
               "corners of an STL file that were joined: STL names no vertices, so points equal in "
               "every bit are one"},
    Definition{"polygons", "faces of more than three corners; each counts as its triangles"},
    Definition{"orphan vertices", "vertices that no face uses"},
    Definition{"missing vertices", "ids that faces name and no vertex record has"},
    Definition{"degenerate faces", "faces that name the same vertex more than once"},
    Definition{"duplicate vertex indices", "vertex records with the id of an earlier one"},
    Definition{"duplicate face indices", "face records with the id of an earlier one"},
    Definition{"torn lines", "lines that begin with a number: what is left of a torn record"},
    Definition{"contiguous vertex numbering", "the ids of the vertices are 1, 2, 3, ... in order"},
    Definition{"contiguous face numbering", "the ids of the faces are 1, 2, 3, ... in order"},
    // Attributes.
    Definition{"closed", "every edge has two or more faces: there is no border"},
    Definition{"manifold",
               "no edge has more than two faces, and the faces round each vertex are one fan"},
    Definition{"orientable",
               "the faces can be turned so that neighbours agree which side is outside"},
    Definition{"consistent", "neighbouring faces, as they are, agree which side is outside"},
    Definition{"outward",
               "the faces point away from the solid; those of the wall of a cavity point into it"},
    // Counts.
    Definition{"vertices", "vertex records of the file, orphans too"},
    Definition{"faces", "triangles of the file, broken ones too"},
    Definition{"edges", "pairs of vertices that bound a face, each pair once"},
    Definition{"components", "parts whose faces hang together through common vertices"},
    Definition{"edge components", "parts whose faces hang together through common edges"},
    Definition{"boundaries", "loops, or chains, of border edges"},
    Definition{"border edges", "edges with one face alone"},
    Definition{"non-manifold edges", "edges with more than two faces"},
    Definition{"non-manifold vertices",
               "vertices whose faces are not one fan, and the ends of non-manifold edges"},
    Definition{"pinched vertices", "non-manifold vertices that are on no non-manifold edge"},
    Definition{"flipped edges", "edges whose two faces run along them in the same direction"},
    Definition{"indistinguishable vertices", "vertices at the place of another one"},
    Definition{"indistinguishable edges", "edges with both ends at the same place"},
    Definition{"zero-area faces", "faces whose corners are on a line"},
    Definition{"duplicate faces", "faces with the same three vertices as an earlier one"},
    Definition{
        "intersecting pairs",
        "pairs of faces that share a point which is not on a common vertex or edge; unwelded "
        "ones only meet along a seam whose vertices were never joined"},
    Definition{"intersecting faces", "faces that intersect at least one other"},
    // Extent.
    Definition{"bounding box", "the smallest box, along the axes, that holds all faces"},
    Definition{"bounding box min", "smallest x, y and z of the vertices that faces use"},
    Definition{"bounding box max", "largest x, y and z of the vertices that faces use"},
    Definition{"area", "sum of the areas of the faces"},
    Definition{"volume", "what the faces enclose; negative where they point inward"},
    Definition{
        "genus",
        "how many handles the surface has: a ball has none, a ring one. From vertices - edges "
        "+ faces = 2 - 2 genus - boundaries"},
    // Curvature.
    Definition{"curvature area", "the area round a vertex that its curvature is spread over"},
    Definition{"vertices without curvature, on a border", "there the surface ends"},
    Definition{"vertices without curvature, not one fan",
               "there the faces are no surface, or do not agree which side is outside"},
    Definition{"vertices without curvature, no area",
               "there the faces have no area that a curvature could be spread over"},
    Definition{
        "total angle defect",
        "what the angles of the faces lack of a full turn, summed over the vertices: 2 pi times "
        "vertices - edges + faces"},
    // Tolerances and repair.
    Definition{"degeneracy tolerance", "edges and altitudes shorter than this are defects"},
    Definition{"slit tolerance", "borders closer than this are the two sides of a slit"},
    Definition{"height tolerance", "a fold that is no higher than this is a foldover"},
    Definition{"maximum foldover angle", "in degrees: an edge whose faces are closer is a fold"},
    Definition{"maximum deviation",
               "no point of the surface may end farther than this from the other surface"},
    Definition{"largest deviation", "no point of the surface ended farther than this"},
    // Sets.
    Definition{"vertices inside another mesh", "their separation distance is negative"},
    Definition{"contained meshes", "meshes that lie inside another one"},
    Definition{"partly contained meshes", "meshes some components of which lie inside another one"},
};

/// The definition in the row of a table whose label it is; empty where there is none.
template <typename Rows>
std::string_view definition_in(const Rows& rows, std::string_view term) {
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const auto& row) { return row.quantity.info.label == term; });
  return found == rows.end() ? std::string_view() : found->quantity.info.definition;
}

}  // namespace

std::string_view definition_of(std::string_view term) {
  if (term == kSeparationDistance.info.label) return kSeparationDistance.info.definition;
  for (const std::string_view definition :
       {definition_in(kElementMeasures<Statistics>, term), definition_in(kCurvatures, term)}) {
    if (!definition.empty()) return definition;
  }
  const auto found =
      std::find_if(kDefinitions.begin(), kDefinitions.end(),
                   [&](const Definition& definition) { return definition.term == term; });
  return found == kDefinitions.end() ? std::string_view() : found->meaning;
}

std::string_view short_meaning(DefectCode code) {
  switch (code) {
    case DefectCode::Disjoint:
      return "a component beside the largest one";
    case DefectCode::Foldover:
      return "faces folded back onto the surface";
    case DefectCode::FlatFacet:
      return "a face that is all but a line";
    case DefectCode::DegenerateFacet:
      return "a face with an edge of all but no length";
    case DefectCode::Slit:
      return "borders that lie on each other and are not joined";
    case DefectCode::SelfIntersection:
      return "faces that run into each other";
    case DefectCode::NonManifold:
      return "an edge or vertex where sheets of faces meet";
    case DefectCode::VertexNormal:
      return "a normal of the file that points into the mesh";
    case DefectCode::Corrupt:
      return "records that make no mesh";
    case DefectCode::Hole:
      return "a border loop";
    case DefectCode::Flipped:
      return "faces turned against their neighbours";
    case DefectCode::Inward:
      return "a closed component that is inside out";
    case DefectCode::DuplicateFacet:
      return "faces with the same three vertices";
    case DefectCode::OrphanVertex:
      return "a vertex that no face uses";
    case DefectCode::Numbering:
      return "ids that do not count 1, 2, 3, ...";
  }
  return {};
}

}  // namespace meshalyzer
