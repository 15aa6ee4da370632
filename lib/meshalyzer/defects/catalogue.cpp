#include "meshalyzer/defects/catalogue.h"

#include "meshalyzer/base/enum_table.h"

#include <algorithm>

namespace meshalyzer {
namespace {

constexpr std::array<CatalogueEntry, kDefectCodes> kCatalogue{{
    {.code = DefectCode::Disjoint,
     .name = "disjoint",
     .summary = "a component beside the largest one",
     .severity = Severity::Warning,
     .meaning = "The mesh has more than one component (faces joined through shared vertices). "
                "There is one defect for each component beyond the largest; the largest has the "
                "most faces, and of equal ones it is the first.",
     .value = "The component's number of faces.",
     .measured = {.before = "", .one = "face", .many = "faces"},
     .elements = "The component's first face, and the middle of it.",
     .fix = "Only where asked for: each component is written to a file of its own (the option "
            "`separate`), or the small ones are dropped (`keep-largest`).",
     .fix_summary = "meshfixer separates or drops it where asked to",
     .passes = "separate or keep largest",
     .fixed_by_default = false},
    {.code = DefectCode::Foldover,
     .name = "foldover",
     .summary = "faces folded back onto the surface",
     .severity = Severity::Error,
     .meaning = "A region of faces is folded back onto its surroundings: its normals are opposed "
                "to those of its neighbours, and it lies within the height tolerance of them. "
                "The edges round it are folds, whose smaller face angle is at most the max "
                "fold-over angle.",
     .value = "The largest distance of the region from its surroundings; limit: the height "
              "tolerance.",
     .measured = {.before = "height"},
     .elements = "The faces of the region, the edges of the folds, and a point of the region.",
     .fix = "A vertex of the region is moved back to where its faces unfold, or it is removed "
            "and its place is closed. If nothing else is possible, in a closed mesh, its walls "
            "are moved apart.",
     .fix_summary = "meshfixer unfolds it",
     .passes = "remove foldovers, lift foldovers",
     .fixed_by_default = true},
    {.code = DefectCode::FlatFacet,
     .name = "flat-facet",
     .summary = "a face that is nearly a line",
     .severity = Severity::Error,
     .meaning = "A face has an altitude below the degeneracy tolerance, but no edge below it. A "
                "face of zero area (exact) is always flat.",
     .value = "The shortest altitude; limit: the degeneracy tolerance.",
     .measured = {.before = "altitude"},
     .elements = "The face, and the middle of it.",
     .fix = "Its longest edge is flipped, or the face beyond that edge is split; the edges next to "
            "a very short one are brought together. If nothing else is possible, it is widened.",
     .fix_summary = "meshfixer mends it",
     .passes = "mend facets, widen facets",
     .fixed_by_default = true},
    {.code = DefectCode::DegenerateFacet,
     .name = "degenerate-facet",
     .summary = "a face with an edge of nearly no length",
     .severity = Severity::Error,
     .meaning =
         "A face has an edge shorter than the degeneracy tolerance, or names a vertex twice. "
         "It is flat too, but reported only as this. An edge of length 0 (exact) is always "
         "degenerate.",
     .value = "The length of the shortest edge, 0 where a vertex is named twice; limit: the "
              "degeneracy tolerance.",
     .measured = {.before = "shortest edge"},
     .elements = "The face, its edges that are too short, the vertex that it names twice, and the "
                 "middle of the shortest edge.",
     .fix = "A face that names a vertex twice is dropped; otherwise the short edge is collapsed "
            "to a point. If nothing else is possible, the facet is widened.",
     .fix_summary = "meshfixer mends it",
     .passes = "mend facets, widen facets",
     .fixed_by_default = true},
    {.code = DefectCode::Slit,
     .name = "slit",
     .summary = "borders that lie on each other and are not joined",
     .severity = Severity::Error,
     .meaning = "Border edges lie on each other: the two sides of a chain of edges were never "
                "joined. Their ends are within the slit tolerance.",
     .value = "The largest gap; limit: the slit tolerance.",
     .measured = {.before = "gap"},
     .elements = "The border edges of both sides, and a point of the slit.",
     .fix = "The two sides are welded.",
     .fix_summary = "meshfixer joins it",
     .passes = "weld borders",
     .fixed_by_default = true},
    {.code = DefectCode::SelfIntersection,
     .name = "self-intersection",
     .summary = "faces that run into each other",
     .severity = Severity::Error,
     .meaning = "Faces share a point that is not on a vertex or edge which both have. There is "
                "one defect for each connected patch of intersecting faces.",
     .value = "The number of intersecting pairs in the patch.",
     .measured = {.before = "", .one = "pair", .many = "pairs"},
     .elements = "The faces, the pairs with their kinds, and a point of the patch.",
     .fix = "Duplicate faces, folds, and seams that were never welded, are mended as such. Other "
            "faces are cut where they meet, and the pieces that do not bound the solid that the "
            "faces enclose are dropped: by exact winding numbers where the faces are closed, by "
            "estimates where they nearly are. Of a sheet the pieces inside solids that it crosses "
            "are dropped, and the others stay. Parts that lie on others, face on face, are "
            "dropped. Loose faces are left.",
     .fix_summary = "meshfixer mends it",
     .passes = "weld borders, drop duplicates, drop copies, remove foldovers, refill tangles or "
               "cut intersections",
     .fixed_by_default = true},
    {.code = DefectCode::NonManifold,
     .name = "non-manifold",
     .summary = "an edge or vertex where sheets of faces meet",
     .severity = Severity::Error,
     .meaning = "An edge has more than two faces, or the faces round a vertex that is on no such "
                "edge are more than one fan.",
     .value = "The number of faces at the edge, or of fans at the vertex.",
     .measured = {.before = "", .one = "faces at it", .many = "faces at it"},
     .elements = "The edge or the vertex, the faces there, and its place.",
     .fix = "The mesh is cut at the edge, and its faces are paired by angle so that each solid "
            "stays closed; a wall that is stored once between two cells is doubled, or dropped "
            "with the option `solid`; each fan gets a vertex of its own. The copies are moved "
            "apart by the "
            "smallest step after which nothing touches, unless the option `keep-contact` is "
            "given.",
     .fix_summary = "meshfixer splits it",
     .passes = "drop dividing walls, split edges, split vertices and part contacts, cut off tips",
     .fixed_by_default = true},
    {.code = DefectCode::VertexNormal,
     .name = "vertex-normal",
     .summary = "a normal of the file that points into the mesh",
     .severity = Severity::Warning,
     .meaning = "A normal that the file gives at a vertex points into the mesh: its dot product "
                "with the normal of every face at the vertex is below 0 (exact). If a vertex has "
                "several normals, one such normal is enough. Faces of zero area do not count.",
     .value = "",
     .elements = "The vertex, and its place.",
     .fix = "The normal is computed anew from the faces at the vertex that have it.",
     .fix_summary = "meshfixer renews it",
     .passes = "renew normals",
     .fixed_by_default = true},
    {.code = DefectCode::Corrupt,
     .name = "corrupt",
     .summary = "records that make no mesh",
     .severity = Severity::Error,
     .meaning = "The data make no mesh: faces name a vertex that no record defines (one defect "
                "for each missing id), records repeat an id (one defect for each id), a "
                "coordinate is NaN or infinite, or a line of a `.mesh` file is the remains of a "
                "torn record. Files with such a coordinate are refused when they are read; if a "
                "program made the mesh, the search finds no defect that depends on positions.",
     .value = "The number of records that have the id.",
     .measured = {.before = "", .one = "records", .many = "records"},
     .elements = "The faces that name the missing vertex, and a defined corner of them; the "
                 "records that have the id, and their places; the vertex whose position is not "
                 "finite. The message gives the id or line in words.",
     .fix = "Faces with a missing vertex and repeated vertex records are dropped, a face record "
            "that repeats an id gets a new one, and torn lines are not written. Positions that "
            "are not finite cannot be mended.",
     .fix_summary = "meshfixer mends it",
     .passes = "drop corrupt records",
     .fixed_by_default = true},
    {.code = DefectCode::Hole,
     .name = "hole",
     .summary = "a border loop",
     .severity = Severity::Error,
     .meaning = "A chain of edges with one face each forms a border that is no slit. There is "
                "one defect for each boundary.",
     .value = "The length of the boundary.",
     .measured = {.before = "length"},
     .elements = "The border edges in walking order, and a point of the border.",
     .fix = "The hole is filled by a patch that intersects nothing. A sheet, which bounds no "
            "solid, is left open unless filling is asked for by name.",
     .fix_summary = "meshfixer fills it; in a sheet, with --fix hole",
     .passes = "fill holes, drop fragments",
     .fixed_by_default = true},
    {.code = DefectCode::Flipped,
     .name = "flipped",
     .summary = "faces turned against their neighbours",
     .severity = Severity::Error,
     .meaning = "Both faces of an edge cross it in the same direction. There is one defect for "
                "each patch of faces that must be turned for all to be consistent, which is the "
                "smaller side by area. A component that no turning makes consistent has one "
                "defect, which is not fixable.",
     .value = "",
     .elements = "The faces to be turned, the edges crossed twice in the same direction, and a "
                 "point of them.",
     .fix = "The faces are turned.",
     .fix_summary = "meshfixer turns them",
     .passes = "orient consistently",
     .fixed_by_default = true},
    {.code = DefectCode::Inward,
     .name = "inward",
     .summary = "a closed component that is inside out",
     .severity = Severity::Error,
     .meaning = "A closed, manifold and consistent component points the wrong way: into its "
                "solid or, if it is the wall of a cavity, out of the cavity.",
     .value = "The component's volume.",
     .measured = {.before = "volume"},
     .elements = "The component's first face, and a point of it.",
     .fix = "The component is turned.",
     .fix_summary = "meshfixer turns it",
     .passes = "orient outward",
     .fixed_by_default = true},
    {.code = DefectCode::DuplicateFacet,
     .name = "duplicate-facet",
     .summary = "faces with the same three vertices",
     .severity = Severity::Error,
     .meaning = "Faces have the same three vertices, in whatever order. There is one defect for "
                "each set of equal faces.",
     .value = "The number of faces in the set.",
     .measured = {.before = "", .one = "faces", .many = "faces"},
     .elements = "The faces, and the middle of them.",
     .fix = "If several faces face the same way, all but the first are dropped. If two solids "
            "have a wall in common, with a face for each, each solid keeps its own, and the "
            "solids are moved apart.",
     .fix_summary = "meshfixer drops the copies",
     .passes = "drop duplicates",
     .fixed_by_default = true},
    {.code = DefectCode::OrphanVertex,
     .name = "orphan-vertex",
     .summary = "a vertex that no face uses",
     .severity = Severity::Warning,
     .meaning = "No face uses the vertex. A record that repeats an id is not an orphan, but "
                "`corrupt`.",
     .value = "",
     .elements = "The vertex, and its place.",
     .fix = "The vertex is dropped.",
     .fix_summary = "meshfixer drops it",
     .passes = "drop orphans",
     .fixed_by_default = true},
    {.code = DefectCode::Numbering,
     .name = "numbering",
     .summary = "ids that do not count 1, 2, 3, ...",
     .severity = Severity::Warning,
     .meaning = "Ids are not 1, 2, ..., n in file order. There is one defect for the vertices "
                "and one for the faces. Only `.mesh` files have ids of their own.",
     .value = "The first id that is wrong; limit: the correct id.",
     .measured = {.before = "id"},
     .elements = "The vertex or face that has this id, and its place.",
     .fix = "Only where asked for: the option `renumber` numbers them anew.",
     .fix_summary = "meshfixer renumbers where asked to",
     .passes = "renumber",
     .fixed_by_default = false},
}};

static_assert(is_in_enum_order(kCatalogue, &CatalogueEntry::code));

}  // namespace

std::span<const CatalogueEntry> defect_catalogue() {
  return kCatalogue;
}

const CatalogueEntry& catalogue_entry(DefectCode code) {
  return kCatalogue[static_cast<std::size_t>(code)];
}

std::string_view defect_name(DefectCode code) {
  return catalogue_entry(code).name;
}

std::optional<DefectCode> defect_code(std::string_view name) {
  const auto* const found =
      std::find_if(kCatalogue.begin(), kCatalogue.end(),
                   [&](const CatalogueEntry& entry) { return entry.name == name; });
  if (found == kCatalogue.end()) return std::nullopt;
  return found->code;
}

Defect make_defect(DefectCode code) {
  Defect defect;
  defect.code = code;
  defect.severity = catalogue_entry(code).severity;
  return defect;
}

}  // namespace meshalyzer
