#include "meshalyzer/repair/cut/internal/cut_edits.h"
#include "meshalyzer/repair/cut/internal/cut_surface.h"
#include "meshalyzer/repair/holes/internal/crossing_patches.h"
#include "meshalyzer/repair/passes.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Cutting takes about two kilobytes a pair.
constexpr std::size_t kMostPairsCut = 2'000'000;
/// Pockets are forgotten where they have at most this share of the area of what stays.
constexpr double kLargestForgotten = 0.25;

PassResult refuse_all(const IntersectingPair& first, const std::string& reason) {
  PassResult result;
  result.refused.push_back(
      {.code = DefectCode::SelfIntersection, .face = first.face_a, .reason = reason});
  return result;
}

}  // namespace

PassResult cut_intersections(const PassInput& input, const CutOptions& options) {
  const auto& pairs = input.mesh.intersecting_pairs();
  const auto first = std::find_if(pairs.begin(), pairs.end(), [](const IntersectingPair& pair) {
    return pair.kind != ContactKind::Unwelded;
  });
  if (pairs.size() > kMostPairsCut) {
    return refuse_all(pairs.front(), std::to_string(pairs.size()) +
                                         " pairs of faces intersect, and no more than " +
                                         std::to_string(kMostPairsCut) + " are cut");
  }
  if (input.limits.groups == Groups::Faces) {
    if (first == pairs.end()) return {};
    return refuse_all(*first, "the groups are faces of a body, whose borders get no new vertices");
  }
  const std::vector<Edits::AddedFace> patches =
      options.fill ? crossing_patches(input, *options.fill) : std::vector<Edits::AddedFace>();
  if (first == pairs.end() && patches.empty()) return {};
  if (input.operation_size == OperationSize::Normal) {
    return cut_edits(input, patches, cut_surface(input, patches, Pockets::Dropped));
  }
  CutSurface surface = cut_surface(input, patches, Pockets::Kept);
  if (!surface.unfinished.empty()) {
    CutSurface solid = cut_surface(input, patches, Pockets::Forgotten);
    const bool is_better = solid.unfinished.empty() && solid.pocket_share <= kLargestForgotten;
    if (is_better) surface = std::move(solid);
  }
  return cut_edits(input, patches, surface);
}

}  // namespace meshalyzer
