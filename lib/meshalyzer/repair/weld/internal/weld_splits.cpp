#include "meshalyzer/repair/weld/internal/weld_splits.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/base/triangle_vertices.h"
#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/mesh/vertex_faces.h"
#include "meshalyzer/repair/rules/internal/merge_rule.h"
#include "meshalyzer/repair/rules/internal/orientation_rule.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>

namespace meshalyzer {
namespace {

/// Two vertices that become one, the one that stays first; equal if they already are one.
struct JoinedPair {
  Index stays = 0;
  Index goes = 0;
};

/// A face that is split, and its parts, with the present vertices as corners. The first part
/// replaces the face.
struct FaceSplit {
  Index face = 0;
  std::vector<Triangle> parts;
};

/// The way in which a crack is closed.
struct Closing {
  /// The pairs at both ends of the crack.
  std::array<JoinedPair, 2> ends;
  std::vector<FaceSplit> faces;

  [[nodiscard]] bool splits(Index f) const {
    return std::any_of(faces.begin(), faces.end(),
                       [&](const FaceSplit& split) { return split.face == f; });
  }
};

class Splitter {
 public:
  explicit Splitter(WeldState& state)
      : state_(state), soup_(state.rules.input.tracked.soup), faces_at_(soup_) {}

  void close(const WeldCrack& crack) {
    if (is_any_busy(crack)) return;
    if (parts_groups(crack)) return refuse(crack, "the edge between two groups may get no vertex");
    const std::optional<Closing> closing = plan(crack);
    if (!closing) return refuse(crack, "the ends of the crack would have to move too far");
    if (!parts_face_one_way(*closing)) return refuse(crack, reason_of(MergeRejection::TurnOver));
    if (meets_itself_elsewhere(crack)) return refuse(crack, reason_of(MergeRejection::NonManifold));
    if (const MergeRejection rejection = rejection_of(*closing);
        rejection != MergeRejection::None) {
      return refuse(crack, reason_of(rejection));
    }
    write(*closing);
    for (const Index v : touched_vertices(crack)) state_.is_busy[v] = 1;
  }

 private:
  /// Returns the vertices of the crack and of the faces that are split.
  [[nodiscard]] std::vector<Index> touched_vertices(const WeldCrack& crack) const {
    std::vector<Index> touched = crack.vertices;
    for (const EdgeSplit& split : crack.splits) {
      const WeldEdge& edge = state_.edges[split.edge];
      touched.insert(touched.end(), {edge.from, edge.to, edge.third});
    }
    return touched;
  }

  [[nodiscard]] bool is_any_busy(const WeldCrack& crack) const {
    const std::vector<Index> touched = touched_vertices(crack);
    return std::any_of(touched.begin(), touched.end(),
                       [&](Index v) { return state_.is_busy[v] != 0; });
  }

  /// Tells whether the crack is between two groups that are faces of a body.
  [[nodiscard]] bool parts_groups(const WeldCrack& crack) const {
    return state_.rules.input.limits.groups == Groups::Faces &&
           std::any_of(crack.faces.begin(), crack.faces.end(), [&](Index f) {
             return group_of(soup_, f) != group_of(soup_, crack.faces.front());
           });
  }

  void refuse(const WeldCrack& crack, std::string_view reason) {
    const WeldEdge& edge = state_.edges[crack.splits.front().edge];
    state_.result.refused.push_back(
        {.code = DefectCode::Slit,
         .vertex = std::min(edge.from, edge.to),
         .face = *std::min_element(crack.faces.begin(), crack.faces.end()),
         .reason = std::string(reason)});
  }

  /// Returns the vertices that stay and the new faces; nothing if the ends may not be joined.
  [[nodiscard]] std::optional<Closing> plan(const WeldCrack& crack) const {
    const std::optional<JoinedPair> first = join(crack.ends[0][0], crack.ends[0][1]);
    const std::optional<JoinedPair> last = join(crack.ends[1][0], crack.ends[1][1]);
    if (!first || !last || are_mixed(crack)) return std::nullopt;
    Closing closing{.ends = {*first, *last}, .faces = {}};
    for (const EdgeSplit& split : crack.splits) closing.faces.push_back(split_face(split));
    return closing;
  }

  /// Tells whether an end of the crack is its other end too.
  [[nodiscard]] static bool are_mixed(const WeldCrack& crack) {
    const auto& [first, last] = crack.ends;
    return first[0] == last[0] || first[0] == last[1] || first[1] == last[0] || first[1] == last[1];
  }

  [[nodiscard]] FaceSplit split_face(const EdgeSplit& split) const {
    const WeldEdge& edge = state_.edges[split.edge];
    std::vector<Index> along{edge.from};
    along.insert(along.end(), split.inner.begin(), split.inner.end());
    along.push_back(edge.to);
    FaceSplit result{.face = edge.face, .parts = {}};
    for (std::size_t i = 1; i < along.size(); ++i) {
      Triangle part = soup_.triangles[edge.face];
      std::replace(part.begin(), part.end(), edge.to, along[i]);
      if (i > 1) std::replace(part.begin(), part.end(), edge.from, along[i - 1]);
      result.parts.push_back(part);
    }
    return result;
  }

  [[nodiscard]] std::optional<JoinedPair> join(Index a, Index b) const {
    const WeldRules& rules = state_.rules;
    const bool a_stays = is_preferred(rules, a, b);
    const JoinedPair pair{.stays = a_stays ? a : b, .goes = a_stays ? b : a};
    if (soup_.positions[a] == soup_.positions[b]) return pair;
    if (rules.input.limits.is_fixed(rules.input.tracked, pair.goes)) return std::nullopt;
    return pair;
  }

  [[nodiscard]] static Triangle joined(Triangle t, const Closing& closing) {
    for (const JoinedPair& end : closing.ends) {
      std::replace(t.begin(), t.end(), end.goes, end.stays);
    }
    return t;
  }

  /// Tells whether all parts face the same side as the whole faces, and have an area.
  [[nodiscard]] bool parts_face_one_way(const Closing& closing) const {
    return std::all_of(closing.faces.begin(), closing.faces.end(), [&](const FaceSplit& split) {
      const Corners whole = corners_of(soup_, split.face);
      return !are_collinear(whole) &&
             std::all_of(split.parts.begin(), split.parts.end(), [&](const Triangle& part) {
               const Triangle t = joined(part, closing);
               return is_in_complex(t) && keeps_orientation(whole, corners_of(soup_.positions, t));
             });
    });
  }

  /// Tells whether a vertex that an edge gets already has an edge to the third corner of its face.
  [[nodiscard]] bool meets_itself_elsewhere(const WeldCrack& crack) const {
    return std::any_of(crack.splits.begin(), crack.splits.end(), [&](const EdgeSplit& split) {
      const Index third = state_.edges[split.edge].third;
      return std::any_of(split.inner.begin(), split.inner.end(),
                         [&](Index v) { return are_neighbours(v, third); });
    });
  }

  [[nodiscard]] bool are_neighbours(Index v, Index w) const {
    const std::span<const Index> faces = faces_at_.at(v);
    return std::any_of(faces.begin(), faces.end(),
                       [&](Index f) { return has_corner(soup_.triangles[f], w); });
  }

  /// Returns the other faces with an end of the crack, ascending.
  [[nodiscard]] std::vector<Index> faces_at_ends(const Closing& closing) const {
    std::vector<Index> faces;
    for (const JoinedPair& end : closing.ends) {
      if (end.stays == end.goes) continue;
      for (const Index v : {end.stays, end.goes}) {
        faces.insert(faces.end(), faces_at_.at(v).begin(), faces_at_.at(v).end());
      }
    }
    sort_unique(faces);
    return faces;
  }

  /// Returns the violations that joining the ends would cause for the faces there, with the parts
  /// in place of the whole faces.
  [[nodiscard]] MergeRejection rejection_of(const Closing& closing) const {
    std::vector<Triangle> triangles;
    for (const FaceSplit& split : closing.faces) {
      triangles.insert(triangles.end(), split.parts.begin(), split.parts.end());
    }
    for (const Index f : faces_at_ends(closing)) {
      const Triangle& t = soup_.triangles[f];
      if (!closing.splits(f) && is_in_complex(t)) triangles.push_back(t);
    }
    std::vector<Index> vertices;
    for (const Triangle& t : triangles) vertices.insert(vertices.end(), t.begin(), t.end());
    for (const JoinedPair& end : closing.ends) vertices.push_back(end.stays);
    sort_unique(vertices);
    return rejection_of(triangles, vertices, closing);
  }

  /// Does the same for a mesh of these faces and vertices only.
  [[nodiscard]] MergeRejection rejection_of(std::span<const Triangle> triangles,
                                            std::span<const Index> vertices,
                                            const Closing& closing) const {
    const auto local = [&](Index v) {
      return static_cast<Index>(std::lower_bound(vertices.begin(), vertices.end(), v) -
                                vertices.begin());
    };
    Soup part;
    for (const Index v : vertices) part.positions.push_back(soup_.positions[v]);
    for (const Triangle& t : triangles) {
      part.triangles.push_back({local(t[0]), local(t[1]), local(t[2])});
    }
    std::vector<Index> representative(vertices.size());
    std::iota(representative.begin(), representative.end(), Index{0});
    for (const JoinedPair& end : closing.ends) representative[local(end.goes)] = local(end.stays);
    std::vector<Index> all(triangles.size());
    std::iota(all.begin(), all.end(), Index{0});
    const std::vector<MergeRejection> rejections = check_merges(part, representative, all);
    const auto found =
        std::find_if(rejections.begin(), rejections.end(),
                     [](MergeRejection rejection) { return rejection != MergeRejection::None; });
    return found == rejections.end() ? MergeRejection::None : *found;
  }

  void write(const Closing& closing) {
    Edits& edits = state_.result.edits;
    const Index op = edits.begin_operation();
    for (const FaceSplit& split : closing.faces) {
      edits.changed_faces.push_back({op, split.face, joined(split.parts.front(), closing)});
      for (std::size_t i = 1; i < split.parts.size(); ++i) {
        edits.added_faces.push_back({.op = op,
                                     .corners = joined(split.parts[i], closing),
                                     .prototype = split.face,
                                     .fills_hole = false});
      }
    }
    for (const Index f : faces_at_ends(closing)) {
      for (const Index v : soup_.triangles[f]) {
        if (v != kNoIndex) state_.is_busy[v] = 1;
      }
      const Triangle t = joined(soup_.triangles[f], closing);
      if (!closing.splits(f) && t != soup_.triangles[f]) edits.changed_faces.push_back({op, f, t});
    }
  }

  WeldState& state_;
  const Soup& soup_;
  VertexFaces faces_at_;
};

}  // namespace

void add_split_operations(WeldState& state, std::span<const WeldCrack> cracks) {
  if (cracks.empty()) return;
  Splitter splitter(state);
  for (const WeldCrack& crack : cracks) splitter.close(crack);
}

}  // namespace meshalyzer
