#include "meshalyzer/arrangement/corners_on_grids.h"
#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/repair/cut/internal/cut_edits.h"
#include "meshalyzer/repair/cut/internal/cut_surface.h"
#include "meshalyzer/repair/cut/internal/unfinished_parts.h"
#include "meshalyzer/repair/holes/internal/crossing_patches.h"
#include "meshalyzer/repair/passes.h"

#include <algorithm>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The maximum number of pairs for each face, beside those of CutLimits.
constexpr std::size_t kPairsAFace = 4;

/// How much may be cut.
struct CutLimits {
  /// The maximum number of pairs beside those for each face: a pair takes up to half a millisecond
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
  return refuse_at(
      face < input.mesh.soup().n_faces() ? face : kNoIndex,
      "the faces would be cut into too many pieces, or at points with too many digits");
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
  const std::size_t most = limits.more_pairs + kPairsAFace * mesh.soup().n_faces();
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

using Cut = std::function<CutSurface(const ChangesBefore&)>;
using EditsOf = std::function<PassResult(const CutSurface&)>;

/// Cuts, and makes edits of the surface. If nothing can be cut to the end, it is tried again with
/// vertices moved to points of a grid.
PassResult propose_cut(const PassInput& input, std::span<const Edits::AddedFace> patches,
                       const Cut& cut, const EditsOf& edits_of) {
  const CutSurface surface = cut({.patches = patches, .positions = {}});
  if (surface.has_too_many_pieces) return refuse_pieces(input, surface);
  PassResult result = edits_of(surface);
  if (!result.edits.empty() || surface.unfinished.empty()) return result;
  const Soup& soup = input.tracked.soup;
  const auto is_unfinished = which_are_of_unfinished_parts(surface, soup.n_faces());
  for (const std::vector<Vec3>& positions :
       corners_on_grids(soup, is_unfinished, input.limits.max_deviation)) {
    if (input.wants_to_stop()) break;
    const CutSurface of_grid = cut({patches, positions, surface.n_first_pairs});
    if (PassResult again = edits_of(of_grid); !again.edits.empty()) return again;
  }
  return result;
}

/// Does the same, and cuts with cut_keeping_pockets().
PassResult propose_cut_with_pockets(const PassInput& input,
                                    std::span<const Edits::AddedFace> patches, Sheets sheets,
                                    std::size_t more_pieces, const EditsOf& edits_of) {
  const auto cut = [&](const ChangesBefore& changes) {
    return cut_keeping_pockets(input, changes, sheets, more_pieces);
  };
  return propose_cut(input, patches, cut, edits_of);
}

}  // namespace

PassResult self_union(const PassInput& input, const SelfUnionOptions& options) {
  if (const std::string reason = reason_against(input.mesh, kLimitsOfGuarantee); !reason.empty()) {
    return refuse_all(input.mesh.intersecting_pairs().front(), reason);
  }
  const std::vector<Edits::AddedFace> patches = crossing_patches(input, options.fill);
  const auto edits_of = [&](const CutSurface& surface) {
    return cut_edits_as_one(input, patches, surface, options.lost);
  };
  return propose_cut_with_pockets(input, patches, Sheets::Left, kLimitsOfGuarantee.more_pieces,
                                  edits_of);
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
  if (input.operation_size == OperationSize::Smallest) {
    const auto edits_of = [&](const CutSurface& surface) {
      return cut_edits(input, patches, surface);
    };
    return propose_cut_with_pockets(input, patches, options.sheets, limits.more_pieces, edits_of);
  }
  const auto cut = [&](const ChangesBefore& changes) {
    return cut_surface(input, changes, {.sheets = options.sheets},
                       {.thin_facets = ThinFacets::Removed, .more_pieces = limits.more_pieces});
  };
  const auto edits_of = [&](const CutSurface& surface) {
    PassResult result = cut_edits(input, patches, surface);
    // Only pockets and thin facets are treated otherwise in smaller operations.
    result.has_smaller_operations = surface.has_pockets || surface.has_removed_facets;
    return result;
  };
  return propose_cut(input, patches, cut, edits_of);
}

}  // namespace meshalyzer
