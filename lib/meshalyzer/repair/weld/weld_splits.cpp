#include "meshalyzer/repair/weld/weld_splits.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/repair/driver/merge_rule.h"
#include "meshalyzer/repair/driver/orientation_rule.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>

namespace meshalyzer {
namespace {

/// The faces at each vertex, flat.
class FacesAtVertices {
 public:
  explicit FacesAtVertices(const Soup& soup) : begin_(soup.n_vertices() + 1, 0) {
    for_each_corner(soup, [&](Index, Index v) { ++begin_[v]; });
    Index sum = 0;
    for (Index& begin : begin_) begin = sum += begin;
    faces_.resize(sum);
    for_each_corner(soup, [&](Index f, Index v) { faces_[--begin_[v]] = f; });
  }

  [[nodiscard]] std::span<const Index> operator[](Index v) const {
    return std::span(faces_).subspan(begin_[v], begin_[v + 1] - begin_[v]);
  }

 private:
  template <typename Visit>
  static void for_each_corner(const Soup& soup, Visit&& visit) {
    for (Index f = 0; f < soup.n_faces(); ++f) {
      for (const Index v : soup.triangles[f]) {
        if (v != kNoIndex) visit(f, v);
      }
    }
  }

  std::vector<Index> begin_;
  std::vector<Index> faces_;
};

/// Two vertices that become one, the one that stays first; equal where they are one already.
struct JoinedPair {
  Index stays = 0;
  Index goes = 0;
};

/// How a crack is closed.
struct Split {
  Index face = 0;
  /// The pairs at the edge's start and end.
  std::array<JoinedPair, 2> ends;
  /// What becomes of the face, by the vertices that are there now.
  std::vector<Triangle> parts;
};

class Splitter {
 public:
  explicit Splitter(WeldState& state)
      : state_(state), soup_(state.rules.input.tracked.soup), faces_at_(soup_) {}

  void close(const WeldChain& chain) {
    const WeldEdge& edge = state_.edges[chain.edge];
    if (is_any_busy(chain)) return;
    if (parts_groups(chain)) return refuse(chain, "the edge between two groups may get no vertex");
    const std::optional<Split> split = plan(chain);
    if (!split) return refuse(chain, "the ends of the crack would have to go too far");
    if (!parts_face_one_way(*split)) return refuse(chain, reason_of(MergeRejection::TurnOver));
    if (meets_chain_elsewhere(chain)) return refuse(chain, reason_of(MergeRejection::NonManifold));
    if (const MergeRejection rejection = rejection_of(*split); rejection != MergeRejection::None) {
      return refuse(chain, reason_of(rejection));
    }
    write(*split);
    for (const Index v : chain.vertices) state_.is_busy[v] = 1;
    for (const Index v : {edge.from, edge.to, edge.third}) state_.is_busy[v] = 1;
  }

 private:
  [[nodiscard]] bool is_any_busy(const WeldChain& chain) const {
    const WeldEdge& edge = state_.edges[chain.edge];
    const auto is_busy = [&](Index v) { return state_.is_busy[v] != 0; };
    return is_busy(edge.from) || is_busy(edge.to) || is_busy(edge.third) ||
           std::any_of(chain.vertices.begin(), chain.vertices.end(), is_busy);
  }

  /// Tells whether the crack is between two groups that are faces of a body.
  [[nodiscard]] bool parts_groups(const WeldChain& chain) const {
    return state_.rules.input.limits.groups == Groups::Faces &&
           group_of(soup_, state_.edges[chain.edge].face) != group_of(soup_, chain.face);
  }

  void refuse(const WeldChain& chain, std::string_view reason) {
    const WeldEdge& edge = state_.edges[chain.edge];
    state_.result.refused.push_back({.code = DefectCode::Slit,
                                     .vertex = std::min(edge.from, edge.to),
                                     .face = std::min(edge.face, chain.face),
                                     .reason = std::string(reason)});
  }

  /// Returns which vertices stay, and what becomes of the face; nothing where the ends may not be
  /// joined.
  [[nodiscard]] std::optional<Split> plan(const WeldChain& chain) const {
    const WeldEdge& edge = state_.edges[chain.edge];
    const std::optional<JoinedPair> start = join(edge.from, chain.vertices.back());
    const std::optional<JoinedPair> end = join(edge.to, chain.vertices.front());
    if (!start || !end || edge.from == chain.vertices.front() || edge.to == chain.vertices.back() ||
        chain.vertices.front() == chain.vertices.back()) {
      return std::nullopt;
    }
    Split split{.face = edge.face, .ends = {*start, *end}, .parts = {}};
    // From the edge's start to its end: the first part stands in for the face.
    std::vector<Index> along(chain.vertices.rbegin(), chain.vertices.rend());
    along.front() = edge.from;
    along.back() = edge.to;
    const Triangle& whole = soup_.triangles[edge.face];
    for (std::size_t i = 1; i < along.size(); ++i) {
      Triangle part = whole;
      std::replace(part.begin(), part.end(), edge.to, along[i]);
      if (i > 1) std::replace(part.begin(), part.end(), edge.from, along[i - 1]);
      split.parts.push_back(part);
    }
    return split;
  }

  [[nodiscard]] std::optional<JoinedPair> join(Index a, Index b) const {
    const WeldRules& rules = state_.rules;
    const bool a_stays = is_preferred(rules, a, b);
    const JoinedPair pair{.stays = a_stays ? a : b, .goes = a_stays ? b : a};
    if (soup_.positions[a] == soup_.positions[b]) return pair;
    if (rules.input.limits.is_fixed(rules.input.tracked, pair.goes)) return std::nullopt;
    return pair;
  }

  [[nodiscard]] Triangle joined(Triangle t, const Split& split) const {
    for (const JoinedPair& end : split.ends) std::replace(t.begin(), t.end(), end.goes, end.stays);
    return t;
  }

  [[nodiscard]] Corners corners(const Triangle& t) const {
    return {soup_.positions[t[0]], soup_.positions[t[1]], soup_.positions[t[2]]};
  }
  /// Tells whether all parts face to the side that the whole face does, and have an area.
  [[nodiscard]] bool parts_face_one_way(const Split& split) const {
    const Corners whole = corners(soup_.triangles[split.face]);
    return !are_collinear(whole[0], whole[1], whole[2]) &&
           std::all_of(split.parts.begin(), split.parts.end(), [&](const Triangle& part) {
             const Triangle t = joined(part, split);
             return is_in_complex(t) && keeps_orientation(whole, corners(t));
           });
  }
  /// Tells whether an inner vertex of the chain has an edge to the face's third corner already.
  [[nodiscard]] bool meets_chain_elsewhere(const WeldChain& chain) const {
    const Index third = state_.edges[chain.edge].third;
    return std::any_of(chain.vertices.begin() + 1, chain.vertices.end() - 1, [&](Index v) {
      const auto faces = faces_at_[v];
      return std::any_of(faces.begin(), faces.end(), [&](Index f) {
        const Triangle& t = soup_.triangles[f];
        return std::find(t.begin(), t.end(), third) != t.end();
      });
    });
  }

  /// Returns the other faces with an end of the crack, ascending.
  [[nodiscard]] std::vector<Index> faces_at_ends(const Split& split) const {
    std::vector<Index> faces;
    for (const JoinedPair& end : split.ends) {
      if (end.stays == end.goes) continue;
      for (const Index v : {end.stays, end.goes}) {
        faces.insert(faces.end(), faces_at_[v].begin(), faces_at_[v].end());
      }
    }
    sort_unique(faces);
    return faces;
  }

  /// Returns what joining the ends would do to the faces there, the parts in the place of the
  /// whole.
  [[nodiscard]] MergeRejection rejection_of(const Split& split) const {
    std::vector<Triangle> triangles = split.parts;
    for (const Index f : faces_at_ends(split)) {
      const Triangle& t = soup_.triangles[f];
      if (f != split.face && is_in_complex(t)) triangles.push_back(t);
    }
    std::vector<Index> vertices;
    for (const Triangle& t : triangles) vertices.insert(vertices.end(), t.begin(), t.end());
    for (const JoinedPair& end : split.ends) vertices.push_back(end.stays);
    sort_unique(vertices);
    return rejection_of(triangles, vertices, split);
  }

  /// Does the same, of a mesh of these faces and vertices only.
  [[nodiscard]] MergeRejection rejection_of(std::span<const Triangle> triangles,
                                            std::span<const Index> vertices,
                                            const Split& split) const {
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
    for (const JoinedPair& end : split.ends) representative[local(end.goes)] = local(end.stays);
    std::vector<Index> all(triangles.size());
    std::iota(all.begin(), all.end(), Index{0});
    const std::vector<MergeRejection> rejections = check_merges(part, representative, all);
    const auto found =
        std::find_if(rejections.begin(), rejections.end(),
                     [](MergeRejection rejection) { return rejection != MergeRejection::None; });
    return found == rejections.end() ? MergeRejection::None : *found;
  }

  void write(const Split& split) {
    Edits& edits = state_.result.edits;
    const Index op = edits.begin_operation();
    edits.changed_faces.push_back({op, split.face, joined(split.parts.front(), split)});
    for (std::size_t i = 1; i < split.parts.size(); ++i) {
      edits.added_faces.push_back({.op = op,
                                   .corners = joined(split.parts[i], split),
                                   .like = split.face,
                                   .fills_hole = false});
    }
    for (const Index f : faces_at_ends(split)) {
      for (const Index v : soup_.triangles[f]) {
        if (v != kNoIndex) state_.is_busy[v] = 1;
      }
      const Triangle t = joined(soup_.triangles[f], split);
      if (f != split.face && t != soup_.triangles[f]) edits.changed_faces.push_back({op, f, t});
    }
  }

  WeldState& state_;
  const Soup& soup_;
  FacesAtVertices faces_at_;
};

}  // namespace

void add_split_operations(WeldState& state, std::span<const WeldChain> chains) {
  if (chains.empty()) return;
  Splitter splitter(state);
  for (const WeldChain& chain : chains) splitter.close(chain);
}

}  // namespace meshalyzer
