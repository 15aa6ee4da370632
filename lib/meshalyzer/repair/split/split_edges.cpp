#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/runs.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/rules/internal/fixed_vertices.h"
#include "meshalyzer/repair/split/internal/copy_vertices.h"
#include "meshalyzer/repair/split/internal/edge_incidences.h"
#include "meshalyzer/repair/split/internal/incident_faces.h"
#include "meshalyzer/repair/split/internal/walls_between_cells.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Determines the fans that the pairs of incidences leave at each vertex (Guéziec et al. 2001,
/// "Cutting and stitching: converting sets of polygons to manifold surfaces").
class EdgeCutter {
 public:
  /// @param mesh  The mesh of the input, which may have more faces here.
  /// @param soup  The same mesh, in which faces may be turned.
  EdgeCutter(const PassInput& input, const PreparedMesh& mesh, const Soup& soup)
      : input_(input),
        soup_(soup),
        incidences_(list_incidences(mesh.cut())),
        incident_(mesh.cut(), ends_of_edges(incidences_)),
        partner_(pair_incidences(input.tracked, mesh, incidences_, incident_)),
        fans_(incident_.n_places(), 0),
        has_too_many_fans_(incident_.size(), 0) {}

  [[nodiscard]] PassResult cut() {
    PassResult result;
    for (std::size_t entry = 0; entry < incident_.size(); ++entry) find_fans(entry);
    for (std::size_t edge = 0; edge < incidences_.size(); ++edge) {
      if (!is_held(edge)) take_apart(edge);
    }
    for (std::size_t edge = 0; edge < incidences_.size(); ++edge) {
      if (is_held(edge)) refuse(edge, result);
    }
    result.edits = copy_vertices(soup_, incident_, fans_, connected_entries());
    return result;
  }

 private:
  /// Tells whether a vertex must not get copies.
  [[nodiscard]] bool is_fixed(Index vertex) const { return !may_be_copied(input_, vertex); }
  [[nodiscard]] bool has_too_many_fans(Index vertex) const {
    return has_too_many_fans_[incident_.entry_of(vertex)] != 0;
  }
  /// Tells whether an edge cannot be split, because neither of its ends can.
  [[nodiscard]] bool is_held(std::size_t edge) const {
    const auto& ends = incidences_.ends[edge];
    return std::all_of(ends.begin(), ends.end(),
                       [&](Index v) { return is_fixed(v) || has_too_many_fans(v); });
  }

  void refuse(std::size_t edge, PassResult& result) const {
    const auto& ends = incidences_.ends[edge];
    const bool is_crowded =
        std::any_of(ends.begin(), ends.end(), [&](Index v) { return has_too_many_fans(v); });
    result.refused.push_back(
        {.code = DefectCode::NonManifold,
         .vertex = ends[0],
         .face = incidences_.faces[incidences_.begin[edge]],
         .reason = is_crowded ? "so many fans of faces meet at an end that all their copies of it "
                                "would touch"
                              : "the border of a face of the body would get more edges"});
  }

  /// Numbers the fans at a vertex, as incidences are paired now. A vertex that must not get copies,
  /// or would get too many, has one only.
  void find_fans(std::size_t entry) {
    const Index v = incident_.vertex(entry);
    if (is_fixed(v) || has_too_many_fans_[entry] != 0) return;
    const auto join = [&](std::span<const Spoke> spokes) {
      const Index begin = incidences_.begin[incidences_.edge_between(v, spokes.front().other)];
      std::vector<Index> partner;
      for (Index i = 0; i < spokes.size(); ++i) {
        const Index other = partner_[begin + i];
        partner.push_back(other == kNoIndex ? kNoIndex : other - begin);
      }
      return partner;
    };
    std::vector<Index> fans = find_fans_at(soup_, incident_, entry, join);
    if (are_too_many_fans(fans)) {
      has_too_many_fans_[entry] = 1;
      std::fill(fans.begin(), fans.end(), 0);
    }
    std::copy(fans.begin(), fans.end(),
              fans_.begin() + static_cast<std::ptrdiff_t>(incident_.begin(entry)));
  }

  /// Returns the fans of an incidence at the two ends of its edge, which will be the vertices of
  /// the edge.
  [[nodiscard]] std::array<Index, 2> new_ends(Index incidence) const {
    std::array<Index, 2> fans{};
    for (std::size_t i = 0; i < 2; ++i) {
      const std::size_t entry =
          incident_.entry_of(incidences_.ends[incidences_.edge_of[incidence]][i]);
      fans[i] =
          fans_[incident_.begin(entry) + incident_.place(entry, incidences_.faces[incidence])];
    }
    return fans;
  }

  /// Separates pairs of an edge that come together again at both its ends, so that both would be
  /// between the same two vertices. Each face is then joined to the one that the fans round the
  /// ends lead to: fans have two rims, so that no three faces stay together, and fans only become
  /// smaller.
  void take_apart(std::size_t edge) {
    std::vector<std::pair<std::array<Index, 2>, Index>> by_ends;
    for (Index incidence = incidences_.begin[edge]; incidence < incidences_.begin[edge + 1];
         ++incidence) {
      by_ends.emplace_back(new_ends(incidence), incidence);
    }
    std::sort(by_ends.begin(), by_ends.end());
    bool has_changed = false;
    const auto ends_of = [](const auto& incidence) { return incidence.first; };
    for_each_run(std::span(by_ends), ends_of, [&](const auto& together) {
      if (together.size() <= 2) return;
      for (const auto& [ends, incidence] : together) let_go(incidence);
      has_changed = true;
    });
    if (!has_changed) return;
    for (const Index v : incidences_.ends[edge]) find_fans(incident_.entry_of(v));
  }

  void let_go(Index incidence) {
    if (partner_[incidence] != kNoIndex) partner_[partner_[incidence]] = kNoIndex;
    partner_[incidence] = kNoIndex;
  }

  /// The fans at the two ends of an edge are handled together.
  [[nodiscard]] DisjointSets connected_entries() const {
    DisjointSets connected(incident_.size());
    for (const auto& [a, b] : incidences_.ends) {
      connected.unite(static_cast<Index>(incident_.entry_of(a)),
                      static_cast<Index>(incident_.entry_of(b)));
    }
    return connected;
  }

  const PassInput& input_;
  const Soup& soup_;
  EdgeIncidences incidences_;
  IncidentFaces incident_;
  /// #incidences: see pair_incidences().
  std::vector<Index> partner_;
  /// The fan of each incident face, entry by entry.
  std::vector<Index> fans_;
  /// #entries: 1 for vertices that get no copies because of are_too_many_fans().
  std::vector<std::uint8_t> has_too_many_fans_;
};

/// Returns the faces of those of the walls that may be doubled, ascending.
std::vector<Index> walls_to_double(const PassInput& input,
                                   const std::vector<std::vector<Index>>& sets) {
  std::vector<Index> walls;
  for (const std::vector<Index>& set : sets) {
    const bool may_come_apart = std::all_of(set.begin(), set.end(), [&](Index face) {
      const Triangle& t = input.mesh.soup().triangles[face];
      return std::all_of(t.begin(), t.end(), [&](Index v) { return may_be_copied(input, v); });
    });
    if (may_come_apart) walls.insert(walls.end(), set.begin(), set.end());
  }
  std::sort(walls.begin(), walls.end());
  return walls;
}

Triangle opposed(const Triangle& t) {
  return {t[0], t[2], t[1]};
}

/// Splits a mesh with an opposed copy of each of some walls behind its own faces.
class WallSplitter {
 public:
  WallSplitter(const PassInput& input, std::span<const Index> walls)
      : input_(input), n_faces_(static_cast<Index>(input.mesh.soup().n_faces())), walls_(walls) {}

  /// @param inward  Faces that are paired as if they were turned, so that each points out of its
  ///                cell: then orientations alternate round the edges of walls.
  [[nodiscard]] PassResult split(std::span<const Index> inward) {
    const Soup& soup = input_.mesh.soup();
    Soup doubled;
    doubled.positions = soup.positions;
    doubled.triangles = soup.triangles;
    for (const Index wall : walls_) doubled.triangles.push_back(opposed(soup.triangles[wall]));
    Soup outward = doubled;
    for (const Index face : inward) outward.triangles[face] = opposed(soup.triangles[face]);
    const PreparedMesh mesh(outward);
    PassResult result = EdgeCutter(input_, mesh, doubled).cut();
    for (Refusal& refusal : result.refused) refusal.face = file_face(refusal.face);
    add_copies(result.edits);
    return result;
  }

 private:
  [[nodiscard]] Index file_face(Index face) const {
    return face < n_faces_ ? face : walls_[face - n_faces_];
  }

  /// Makes added faces of the changed copies, and of those whose originals have changed: each wall
  /// of which neither has is left as it was.
  void add_copies(Edits& edits) const {
    std::vector<std::uint8_t> is_added(walls_.size(), 0);
    std::vector<Edits::ChangedFace> changed;
    changed.swap(edits.changed_faces);
    for (const Edits::ChangedFace& face : changed) {
      if (face.face < n_faces_) {
        edits.changed_faces.push_back(face);
      } else {
        is_added[face.face - n_faces_] = 1;
        edits.added_faces.push_back(
            {.op = face.op, .corners = face.corners, .prototype = file_face(face.face)});
      }
    }
    for (const Edits::ChangedFace& face : edits.changed_faces) {
      const auto wall = std::lower_bound(walls_.begin(), walls_.end(), face.face);
      if (wall == walls_.end() || *wall != face.face) continue;
      if (is_added[static_cast<std::size_t>(wall - walls_.begin())] != 0) continue;
      edits.added_faces.push_back({.op = face.op,
                                   .corners = opposed(input_.mesh.soup().triangles[face.face]),
                                   .prototype = face.face});
    }
  }

  const PassInput& input_;
  Index n_faces_;
  std::span<const Index> walls_;
};

}  // namespace

PassResult split_edges(const PassInput& input, SharedWalls shared) {
  if (input.mesh.cut().side.non_manifold_edges.size() == 0) return {};
  WallsBetweenCells found;
  // Without any deviation the copies could not be moved apart.
  if (shared == SharedWalls::Doubled && input.limits.max_deviation > 0.0) {
    found = find_walls_between_cells(input.mesh, input.wants_to_stop);
  }
  const std::vector<Index> walls = walls_to_double(input, found.sets);
  if (walls.empty()) return EdgeCutter(input, input.mesh, input.mesh.soup()).cut();
  return WallSplitter(input, walls).split(found.inward);
}

}  // namespace meshalyzer
