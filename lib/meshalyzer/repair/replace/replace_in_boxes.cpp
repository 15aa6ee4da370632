#include "meshalyzer/contour/contour_mesh.h"
#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/repair/cut/internal/cut_edits.h"
#include "meshalyzer/repair/replace/internal/broken_boxes.h"
#include "meshalyzer/repair/replace/internal/mesh_operands.h"
#include "meshalyzer/repair/replace/internal/replacements.h"
#include "meshalyzer/repair/replace/internal/usable_contour.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Grids of all boxes together with more tetrahedra are not made, because they would take more than
/// some seconds.
constexpr std::size_t kMaxTetrahedraInBoxes = 150'000;
/// Boxes that hold a larger share of the faces are not replaced: the whole solid is, instead.
constexpr double kLargestShareInBoxes = 0.5;
/// Above this number of pairs cutting would take longer than a replacement of the whole solid.
constexpr std::size_t kMostPairsAtBoxes = 200'000;
/// Rounding may take this share of the deviation.
constexpr double kShareOfRounding = 0.1;

/// By the ends of an edge, the lower first: how much oftener faces run along it from there than
/// towards it.
using EdgeBalance = std::map<std::array<Index, 2>, int>;

/// #positions: the number of the box that holds each; kNoIndex where none does.
std::vector<Index> boxes_of(const std::vector<Vec3>& positions, const std::vector<Box3>& boxes) {
  std::vector<Index> box_of(positions.size(), kNoIndex);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const auto box = std::find_if(boxes.begin(), boxes.end(),
                                  [&](const Box3& b) { return b.contains(positions[v]); });
    if (box != boxes.end()) box_of[v] = static_cast<Index>(box - boxes.begin());
  }
  return box_of;
}

/// The operands of box i, beside the mesh outside the boxes: the box and the contour that is put
/// into it.
constexpr Index operand_of_box(Index i) {
  return 1 + 2 * i;
}
constexpr Index operand_of_contour(Index i) {
  return 2 + 2 * i;
}

void add_cuboid(const Box3& box, Index operand, MeshOperands& operands) {
  // Corner k has the larger coordinate along axis a where bit a of k is set; the faces are oriented
  // outwards.
  static constexpr std::array<Triangle, 12> kFaces{{{0, 2, 3},
                                                    {0, 3, 1},
                                                    {4, 5, 7},
                                                    {4, 7, 6},
                                                    {0, 1, 5},
                                                    {0, 5, 4},
                                                    {2, 6, 7},
                                                    {2, 7, 3},
                                                    {0, 4, 6},
                                                    {0, 6, 2},
                                                    {1, 3, 7},
                                                    {1, 7, 5}}};
  std::array<Vec3, 8> corners;
  for (int k = 0; k < 8; ++k) corners.at(k) = box.corner(static_cast<Box3::CornerType>(k));
  operands.add_solid(corners, kFaces, operand);
}

/// Returns the rule for the inside: in a box inside the contour, elsewhere inside the mesh.
InsideRule rule_of_boxes(std::size_t n_boxes) {
  return [n_boxes](std::span<const int> windings) {
    for (Index i = 0; i < n_boxes; ++i) {
      if (windings[operand_of_box(i)] >= 1) return windings[operand_of_contour(i)] >= 1;
    }
    return windings[MeshOperands::kMesh] >= 1;
  };
}

/// Proposes to replace what lies in boxes.
class ReplacingInBoxes {
 public:
  ReplacingInBoxes(const PassInput& input, const BoxOptions& options)
      : input_(input),
        options_(options),
        soup_(input.tracked.soup),
        boxes_(boxes_round_broken_faces(input.mesh, options.margin)),
        box_of_(boxes_of(soup_.positions, boxes_)),
        operands_(soup_) {}

  Replacement run() {
    if (!(options_.max_deviation > 0.0)) return refuse("no deviation is left for a replacement");
    if (boxes_.empty()) return refuse("it is broken in too many places");
    if (!add_rest()) return refuse("the boxes round the broken places hold most of the mesh");
    if (const char* reason = add_contours()) return refuse(reason);
    const CombinedSolid solid =
        operands_.combine(1 + 2 * boxes_.size(), rule_of_boxes(boxes_.size()),
                          {.max_deviation = kShareOfRounding * options_.max_deviation,
                           .max_pairs = kMostPairsAtBoxes,
                           .wants_to_stop = input_.wants_to_stop});
    if (solid.outcome != CombineOutcome::Done) {
      return refuse("the replacement cannot be united with the rest");
    }
    return replacement_from(solid);
  }

 private:
  /// Adds the faces that are not in a box, closed by cones that lie in the boxes, where nothing
  /// depends on them.
  /// @return Whether that is most of the mesh, and could be closed.
  bool add_rest() {
    EdgeBalance balance;
    std::size_t n_replaced = 0;
    for (Index face = 0; face < soup_.n_faces(); ++face) {
      const Triangle& t = soup_.triangles[face];
      if (!is_in_complex(t)) continue;
      if (box_of_[t[0]] != kNoIndex && box_of_[t[0]] == box_of_[t[1]] &&
          box_of_[t[0]] == box_of_[t[2]]) {
        ++n_replaced;
        continue;
      }
      operands_.add_face(t, face);
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = t[k];
        const Index b = t[(k + 1) % 3];
        // Where an end is outside, no face was replaced or is broken.
        if (box_of_[a] == kNoIndex || box_of_[a] != box_of_[b]) continue;
        balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
      }
    }
    const auto n_faces = static_cast<double>(soup_.n_faces());
    return static_cast<double>(n_replaced) <= kLargestShareInBoxes * n_faces && add_cones(balance);
  }

  /// Closes a surface by triangles between its border edges and the middles of their boxes.
  bool add_cones(const EdgeBalance& balance) {
    std::vector<Index> apexes;
    for (const Box3& box : boxes_) apexes.push_back(operands_.add_vertex(box.center()));
    for (const auto& [ends, count] : balance) {
      if (count == 0) continue;
      const Index box = box_of_[ends[0]];
      if (are_collinear(soup_.positions[ends[0]], soup_.positions[ends[1]], boxes_[box].center())) {
        return false;
      }
      const bool runs_forward = count > 0;
      for (int i = 0; i < std::abs(count); ++i) {
        operands_.add_face({ends[runs_forward ? 1 : 0], ends[runs_forward ? 0 : 1], apexes[box]});
      }
    }
    return true;
  }

  /// @return Why that is not possible; null if it is.
  const char* add_contours() {
    for (Index i = 0; i < boxes_.size(); ++i) {
      std::optional<ContouredMesh> made =
          contour_mesh(soup_, {.max_deviation = (1.0 - kShareOfRounding) * options_.max_deviation,
                               .max_tetrahedra = kMaxTetrahedraInBoxes / boxes_.size(),
                               .within = boxes_[i],
                               .wants_to_stop = input_.wants_to_stop});
      if (const char* reason = reason_against(made, input_.wants_to_stop)) return reason;
      deviation_ = std::max(deviation_, made->deviation);
      walls_.insert(walls_.end(), made->walls.begin(), made->walls.end());
      add_cuboid(boxes_[i], operand_of_box(i), operands_);
      operands_.add_solid(made->soup.positions, made->soup.triangles, operand_of_contour(i));
    }
    return nullptr;
  }

  Replacement replacement_from(const CombinedSolid& solid) const {
    const CutSurface surface = operands_.surface_of(solid, input_);
    Replacement replacement;
    replacement.result = cut_edits_as_one(input_, {}, surface, options_.lost);
    replacement.deviation = deviation_ + solid.largest_move;
    Edits& edits = replacement.result.edits;
    if (edits.n_operations == 0) return replacement;
    for (const Corners& wall : walls_) edits.interior_walls.push_back({0, {wall}});
    return replacement;
  }

  [[nodiscard]] Replacement refuse(const char* reason) const {
    Replacement replacement;
    replacement.result.refused.push_back({.code = DefectCode::SelfIntersection, .reason = reason});
    return replacement;
  }

  const PassInput& input_;
  const BoxOptions& options_;
  const Soup& soup_;
  std::vector<Box3> boxes_;
  /// #V: the box that holds each.
  std::vector<Index> box_of_;
  MeshOperands operands_;
  std::vector<Corners> walls_;
  double deviation_ = 0.0;
};

}  // namespace

Replacement replace_in_boxes(const PassInput& input, const BoxOptions& options) {
  return ReplacingInBoxes(input, options).run();
}

}  // namespace meshalyzer
