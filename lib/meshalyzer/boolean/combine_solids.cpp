#include "meshalyzer/boolean/combine_solids.h"

#include "meshalyzer/arrangement/arrange.h"
#include "meshalyzer/arrangement/cells.h"
#include "meshalyzer/arrangement/corners_on_grids.h"
#include "meshalyzer/arrangement/round_vertices.h"
#include "meshalyzer/base/corners.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/base/require.h"
#include "meshalyzer/boolean/internal/boundary_pieces.h"
#include "meshalyzer/exact/exact_point.h"
#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/mesh/finite_positions.h"
#include "meshalyzer/mesh/require_records.h"
#include "meshalyzer/mesh/used_box.h"
#include "meshalyzer/spatial/self_intersection.h"
#include "meshalyzer/spatial/self_intersection_of.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

namespace meshalyzer {
namespace {

/// The rounds after the first may cut this many pairs together, beside a multiple of those that it
/// has cut.
constexpr std::size_t kMorePairsInRounds = 1000;
constexpr std::size_t kTimesFirstRound = 2;
/// Rounds that leave this many times more pairs than an earlier one, beside kMorePairsInRounds, are
/// taken to come to no end.
constexpr std::size_t kHopelessGrowth = 16;
/// The maximum memory for the digits of exact points, see ArrangeLimits. Those of a few million
/// pairs of faces need less if their coordinates have a common scale.
constexpr std::size_t kMostDigitBytes = std::size_t{1} << 29;

using Pairs = std::vector<IntersectingPair>;

void require_operands(const Operands& operands) {
  const Soup& soup = operands.soup;
  require_records(soup);
  if (operands.count == 0) throw InvalidArgument("combine_solids: there is no operand");
  if (operands.of_face.size() != soup.n_faces() ||
      std::any_of(operands.of_face.begin(), operands.of_face.end(),
                  [&](Index operand) { return operand >= operands.count; })) {
    throw InvalidArgument("combine_solids: a face belongs to no operand");
  }
  require_finite_positions(soup);
}

/// Refuses a rule by which the result would have no end: rounding takes the result for a solid.
void require_bounded(const InsideRule& rule, std::size_t n_operands) {
  require_function("combine_solids: the rule", rule);
  if (rule(std::vector<int>(n_operands, 0))) {
    throw InvalidArgument("combine_solids: by the rule, what is in no operand is inside");
  }
}

bool has_area(const std::vector<Vec3>& positions, const Triangle& t) {
  return is_in_complex(t) && !are_collinear(corners_of(positions, t));
}

/// Combines operands, round by round: the first round cuts and selects, later ones cut what
/// rounding has made intersect.
class Combination {
 public:
  /// @param positions  Where the vertices of the operands are in this attempt.
  Combination(const Operands& operands, std::vector<Vec3> positions, const CombineOptions& options)
      : options_(options), n_operands_(operands.count) {
    soup_.positions = std::move(positions);
    for (Index face = 0; face < operands.soup.n_faces(); ++face) {
      const Triangle& t = operands.soup.triangles[face];
      if (!has_area(soup_.positions, t)) continue;
      soup_.triangles.push_back(t);
      origins_.push_back({.corners = t, .origin = face});
      operand_of_.push_back(operands.of_face[face]);
    }
    limits_ = {.extent = used_extent(soup_),
               .max_deviation = options.max_deviation,
               .n_input_vertices = static_cast<Index>(soup_.n_vertices())};
  }

  CombinedSolid run(const InsideRule& rule) {
    result_.outcome = run_rounds(rule);
    for (std::size_t i = 0; i < origins_.size(); ++i) {
      origins_[i].corners = soup_.triangles[i];
    }
    result_.positions = std::move(soup_.positions);
    result_.faces = std::move(origins_);
    std::stable_sort(
        result_.faces.begin(), result_.faces.end(),
        [](const CombinedFace& a, const CombinedFace& b) { return a.origin < b.origin; });
    return std::move(result_);
  }

 private:
  CombineOutcome run_rounds(const InsideRule& rule) {
    if (options_.wants_to_stop()) return CombineOutcome::Stopped;
    {
      const CutMesh cut = build(soup_);
      const FaceTree tree(cut);
      const Pairs pairs =
          find_self_intersections(cut, tree, limits_of_search(options_.max_pairs)).listed;
      if (options_.wants_to_stop()) return CombineOutcome::Stopped;
      if (pairs.size() > options_.max_pairs) return CombineOutcome::TooManyPairs;
      result_.n_pairs = pairs.size();
      const CombineOutcome first = cut_pairs(cut, tree, pairs, rule);
      if (first != CombineOutcome::Done) return first;
    }
    n_operands_ = 1;
    return mend_rounding();
  }

  /// Returns the limits of a search that ends where there are more pairs than a number.
  [[nodiscard]] PairLimits limits_of_search(std::size_t max_pairs) const {
    return {.max_found = max_pairs + 1, .wants_to_stop = options_.wants_to_stop};
  }

  /// What a round has left: how many pairs of faces intersect, and the members that describe it.
  struct RoundResult {
    std::size_t n_pairs = 0;
    Soup soup;
    std::vector<CombinedFace> origins;
    double largest_move = 0.0;
  };

  void return_to(RoundResult before) {
    soup_ = std::move(before.soup);
    origins_ = std::move(before.origins);
    result_.largest_move = before.largest_move;
  }

  /// Cuts the rounded result, now one solid that may intersect itself, until no faces intersect. If
  /// it comes to no end, the result is that of the round that has left the fewest.
  CombineOutcome mend_rounding() {
    std::size_t n_pairs_left = kMorePairsInRounds + kTimesFirstRound * result_.n_pairs;
    std::optional<RoundResult> best;
    for (;;) {
      const CutMesh cut = build(soup_);
      const FaceTree tree(cut);
      // Rounding that makes things worse may leave millions of pairs, none of which is cut.
      const std::size_t most =
          best ? std::min(n_pairs_left, kMorePairsInRounds + kHopelessGrowth * best->n_pairs)
               : n_pairs_left;
      const Pairs pairs =
          find_self_intersections_of(cut, tree, new_faces_, limits_of_search(most)).listed;
      if (options_.wants_to_stop()) return CombineOutcome::Stopped;
      if (pairs.empty()) return CombineOutcome::Done;
      if (round_ == kRoundingRounds || pairs.size() > most) {
        if (best && best->n_pairs < pairs.size()) return_to(std::move(*best));
        return CombineOutcome::Unfinished;
      }
      if (!best || pairs.size() < best->n_pairs) {
        best = {pairs.size(), soup_, origins_, result_.largest_move};
      }
      n_pairs_left -= pairs.size();
      operand_of_.assign(soup_.n_faces(), 0);
      const CombineOutcome outcome = cut_pairs(cut, tree, pairs, union_rule());
      if (outcome == CombineOutcome::Stopped) return outcome;
      if (outcome == CombineOutcome::TooManyPoints) {
        return_to(std::move(*best));
        return CombineOutcome::Unfinished;
      }
    }
  }

  /// Cuts the soup along its intersecting pairs, and replaces it by the rounded boundary of what is
  /// inside.
  /// @return  Done; or TooManyPoints or Stopped, and then the soup is as it was.
  CombineOutcome cut_pairs(const CutMesh& cut, const FaceTree& tree, const Pairs& pairs,
                           const InsideRule& rule) {
    const std::optional<Arrangement> arrangement =
        arrange_within(soup_, pairs,
                       {.max_digit_bytes = kMostDigitBytes,
                        .max_crossings = options_.max_crossings,
                        .wants_to_stop = options_.wants_to_stop});
    if (options_.wants_to_stop()) return CombineOutcome::Stopped;
    if (!arrangement) return CombineOutcome::TooManyPoints;
    const Cells cells = find_cells(soup_, *arrangement);
    if (options_.wants_to_stop()) return CombineOutcome::Stopped;
    take(*arrangement, find_boundary_pieces({soup_, cut, tree, *arrangement, cells}, operand_of_,
                                            n_operands_, rule));
    ++round_;
    return CombineOutcome::Done;
  }

  /// Replaces the soup by the rounded boundary of a solid.
  void take(const Arrangement& a, const std::vector<BoundaryPiece>& boundary) {
    std::vector<std::uint8_t> was_cut(soup_.n_faces(), 0);
    for (const Index face : a.cut_faces) was_cut[face] = 1;
    RoundedVertices rounded = round_vertices(a, rounding_of_round(round_, limits_));
    std::vector<Triangle> triangles;
    std::vector<CombinedFace> origins;
    new_faces_.clear();
    double largest = 0.0;
    for (const BoundaryPiece& part : boundary) {
      Triangle t = a.pieces[part.piece];
      for (const Index v : t) largest = std::max(largest, move_of(v, a, rounded));
      for (Index& v : t) v = rounded.stands_for[v];
      const bool is_new = was_cut[part.face] != 0 || t != a.pieces[part.piece];
      if (part.is_turned) std::swap(t[1], t[2]);
      if (is_new && !has_area(rounded.positions, t)) continue;
      if (is_new) new_faces_.push_back(static_cast<Index>(triangles.size()));
      triangles.push_back(t);
      origins.push_back(origin_of(part, a));
    }
    result_.largest_move += largest;
    soup_.positions = std::move(rounded.positions);
    soup_.triangles = std::move(triangles);
    origins_ = std::move(origins);
  }

  [[nodiscard]] CombinedFace origin_of(const BoundaryPiece& part, const Arrangement& a) const {
    CombinedFace origin = origins_[part.face];
    for (const PieceSource& source : a.sources_of(part.piece)) {
      const bool is_itself = source.face == part.face;
      if (is_itself && part.is_turned == (source.sign > 0)) origin.is_turned = !origin.is_turned;
      const bool is_other = operand_of_[source.face] != operand_of_[part.face];
      origin.is_common = origin.is_common || is_other || origins_[source.face].is_common;
    }
    return origin;
  }

  /// Returns how far rounding moves a vertex of an arrangement.
  [[nodiscard]] static double move_of(Index v, const Arrangement& a,
                                      const RoundedVertices& rounded) {
    const double move = (rounded.positions[rounded.stands_for[v]] - a.positions[v]).stableNorm();
    return v < a.n_input_vertices ? move
                                  : move + a.exact.made(v - a.n_input_vertices).rest.stableNorm();
  }

  const CombineOptions& options_;
  /// The number of operands in this round; after the first, there is one solid.
  std::size_t n_operands_;
  std::size_t round_ = 0;
  RoundingLimits limits_;
  /// The soup that this round cuts, with positions and faces only.
  Soup soup_;
  /// The origin of each face of the soup, without its corners.
  std::vector<CombinedFace> origins_;
  std::vector<Index> operand_of_;
  /// The faces that the last round has made, ascending.
  std::vector<Index> new_faces_;
  CombinedSolid result_;
};

/// Tells for each face whether it intersects another one.
std::vector<std::uint8_t> which_intersect(const Soup& soup) {
  const CutMesh cut = build(soup);
  std::vector<std::uint8_t> found(soup.n_faces(), 0);
  for (const IntersectingPair& pair : find_self_intersections(cut, FaceTree(cut))) {
    found[pair.face_a] = 1;
    found[pair.face_b] = 1;
  }
  return found;
}

double largest_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, (a[i] - b[i]).stableNorm());
  }
  return largest;
}

/// Combines operands with the vertices of intersecting faces moved to the points of a grid.
///
/// @return  Nothing if that comes to no end on any grid.
std::optional<CombinedSolid> combine_on_grid(const Operands& operands, const InsideRule& rule,
                                             const CombineOptions& options) {
  const Soup& soup = operands.soup;
  for (const std::vector<Vec3>& positions :
       corners_on_grids(soup, which_intersect(soup), options.max_deviation)) {
    CombinedSolid solid = Combination(operands, positions, options).run(rule);
    solid.largest_move += largest_distance(positions, soup.positions);
    if (solid.outcome == CombineOutcome::Done || solid.outcome == CombineOutcome::Stopped) {
      return solid;
    }
  }
  return std::nullopt;
}

}  // namespace

CombinedSolid combine_solids(const Operands& operands, const InsideRule& rule,
                             const CombineOptions& options) {
  require_operands(operands);
  require_bounded(rule, operands.count);
  require_length("the maximum deviation", options.max_deviation);
  CombinedSolid solid = Combination(operands, operands.soup.positions, options).run(rule);
  if (solid.outcome != CombineOutcome::Unfinished) return solid;
  std::optional<CombinedSolid> on_grid = combine_on_grid(operands, rule, options);
  return on_grid ? std::move(*on_grid) : std::move(solid);
}

std::optional<Triangle> whole_face(const CombinedSolid& solid, const Soup& source,
                                   const CombinedFace& face) {
  if (face.origin >= source.n_faces()) return std::nullopt;
  Triangle before = source.triangles[face.origin];
  if (face.is_turned) std::swap(before[1], before[2]);
  Triangle corners = face.corners;
  for (int i = 0; i < 3; ++i) {
    const auto is_there = [&](Index now, Index then) {
      return now == then || solid.positions[now] == source.positions[then];
    };
    if (std::equal(corners.begin(), corners.end(), before.begin(), is_there)) return corners;
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  }
  return std::nullopt;
}

Soup as_soup(const CombinedSolid& solid) {
  std::vector<Triangle> triangles(solid.faces.size());
  std::transform(solid.faces.begin(), solid.faces.end(), triangles.begin(),
                 [](const CombinedFace& face) { return face.corners; });
  return compact_soup(solid.positions, std::move(triangles));
}

}  // namespace meshalyzer
