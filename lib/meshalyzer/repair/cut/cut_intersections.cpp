#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/repair/cut/internal/cut_edits.h"
#include "meshalyzer/repair/cut/internal/cut_surface.h"
#include "meshalyzer/repair/holes/internal/crossing_patches.h"
#include "meshalyzer/repair/passes.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// How much may be cut.
struct CutLimits {
  /// The maximum number of pairs beyond the number of faces: a pair takes about half a millisecond
  /// in all, and two kilobytes.
  std::size_t more_pairs;
  /// The maximum number of times that cuts may meet each other. It is only an estimate of how long
  /// it takes to find the number of pieces: faces in one plane, as at the crossings of a grating,
  /// have much fewer.
  double most_crossings;
  /// See PieceRules.
  std::size_t more_pieces;
};

constexpr CutLimits kUsualLimits{100'000, 1e7, PieceRules{}.more_pieces};
/// Where the result is to be good, there is no other way left than to cut, or to replace all.
constexpr CutLimits kLimitsOfGuarantee{200'000, 1e8, 1'000'000};

PassResult refuse_at(Index face, const std::string& reason) {
  PassResult result;
  result.refused.push_back({.code = DefectCode::SelfIntersection, .face = face, .reason = reason});
  return result;
}

PassResult refuse_all(const IntersectingPair& first, const std::string& reason) {
  return refuse_at(first.face_a, reason);
}

PassResult refuse_pieces(const PassInput& input, const CutSurface& surface) {
  const Index face = surface.unfinished.front();
  return refuse_at(face < input.mesh.soup().n_faces() ? face : kNoIndex,
                   "the faces would be cut into too many pieces");
}

/// Returns an upper bound of the number of times that cuts meet: the cut between two faces is met
/// by faces that intersect both.
double most_crossings(const Soup& soup, const std::vector<IntersectingPair>& pairs) {
  std::vector<double> n_partners(soup.n_faces(), 0.0);
  for (const IntersectingPair& pair : pairs) {
    ++n_partners[pair.face_a];
    ++n_partners[pair.face_b];
  }
  double sum = 0.0;
  for (const IntersectingPair& pair : pairs) {
    sum += std::min(n_partners[pair.face_a], n_partners[pair.face_b]);
  }
  return sum;
}

/// Returns the reason why cutting would take too long; empty if it would not.
std::string reason_against(const PreparedMesh& mesh, const CutLimits& limits) {
  const auto& pairs = mesh.intersecting_pairs();
  const std::size_t most = limits.more_pairs + mesh.soup().n_faces();
  if (pairs.size() > most) {
    return grouped(pairs.size()) + " pairs of faces intersect, and no more than " + grouped(most) +
           " are cut";
  }
  if (most_crossings(mesh.soup(), pairs) > limits.most_crossings) {
    return "so many faces intersect each other at one place that cutting them would take too long";
  }
  return "";
}

/// Tells whether sheets were cut and are not yet split from the solids that they cross. Until then
/// nothing tells their borders from holes of the solids.
bool has_sheets_to_split(const PassInput& input) {
  return !input.tracked.sheet_cuts.empty() && input.mesh.cut().side.non_manifold_edges.size() != 0;
}

}  // namespace

PassResult self_union(const PassInput& input, const SelfUnionOptions& options) {
  if (const std::string reason = reason_against(input.mesh, kLimitsOfGuarantee); !reason.empty()) {
    return refuse_all(input.mesh.intersecting_pairs().front(), reason);
  }
  const std::vector<Edits::AddedFace> patches = crossing_patches(input, options.fill);
  const CutSurface surface =
      cut_keeping_pockets(input, patches, Sheets::Left, kLimitsOfGuarantee.more_pieces);
  if (surface.has_too_many_pieces) return refuse_pieces(input, surface);
  return cut_edits_as_one(input, patches, surface, options.lost);
}

PassResult cut_intersections(const PassInput& input, const CutOptions& options) {
  const auto& pairs = input.mesh.intersecting_pairs();
  const CutLimits& limits = options.is_for_guarantee ? kLimitsOfGuarantee : kUsualLimits;
  if (const std::string reason = reason_against(input.mesh, limits); !reason.empty()) {
    return refuse_all(pairs.front(), reason);
  }
  if (input.limits.groups == Groups::Faces) {
    const auto first = std::find_if(pairs.begin(), pairs.end(), [](const IntersectingPair& pair) {
      return pair.kind != ContactKind::Unwelded;
    });
    if (first == pairs.end()) return {};
    return refuse_all(*first, "the groups are faces of a body, whose borders get no new vertices");
  }
  std::vector<Edits::AddedFace> patches;
  if (options.fill && !has_sheets_to_split(input)) patches = crossing_patches(input, *options.fill);
  if (pairs.empty() && patches.empty()) return {};
  if (input.operation_size == OperationSize::Normal) {
    const CutSurface surface =
        cut_surface(input, patches, {.sheets = options.sheets},
                    {.thin_facets = ThinFacets::Removed, .more_pieces = limits.more_pieces});
    if (surface.has_too_many_pieces) return refuse_pieces(input, surface);
    PassResult result = cut_edits(input, patches, surface);
    // Only pockets and thin facets are treated otherwise in smaller operations.
    result.has_smaller_operations = surface.has_pockets || surface.has_removed_facets;
    return result;
  }
  const CutSurface surface =
      cut_keeping_pockets(input, patches, options.sheets, limits.more_pieces);
  if (surface.has_too_many_pieces) return refuse_pieces(input, surface);
  return cut_edits(input, patches, surface);
}

}  // namespace meshalyzer
