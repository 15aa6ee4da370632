#include "meshalyzer/repair/cut/internal/cut_edits.h"

#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/triangle_vertices.h"
#include "meshalyzer/repair/cut/internal/face_edges.h"
#include "meshalyzer/repair/orient/bounds_solid.h"
#include "meshalyzer/topology/components.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace meshalyzer {
namespace {

/// The reason why a part is left unchanged.
enum class Obstacle : std::uint8_t { None, Unfinished, Sheet, Loose, Fixed, Lost };

std::string reason_of(Obstacle obstacle) {
  switch (obstacle) {
    case Obstacle::None:
      return "";
    case Obstacle::Unfinished:
      return "rounding the points of the cut makes faces intersect again and again";
    case Obstacle::Sheet:
      return "the surface is a sheet: nothing tells which part of it to drop";
    case Obstacle::Loose:
      return "the faces are loose: most of their edges have no other face";
    case Obstacle::Fixed:
      return "it meets a vertex that must stay as it is";
    case Obstacle::Lost:
      return "a component that may be a cavity would be dropped as a whole";
  }
  return "";
}

class CutEdits {
 public:
  CutEdits(const PassInput& input, std::span<const Edits::AddedFace> patches,
           const CutSurface& surface)
      : input_(input),
        soup_(input.tracked.soup),
        patches_(patches),
        surface_(surface),
        parts_(soup_.n_faces() + patches.size()),
        obstacles_(soup_.n_faces() + patches.size(), Obstacle::None) {}

  PassResult make() {
    find_changes();
    join_parts();
    find_obstacles();
    return edits();
  }

  PassResult make_as_one(LostParts lost) {
    find_changes();
    join_parts();
    find_obstacles();
    if (lost == LostParts::Allowed) {
      std::replace(obstacles_.begin(), obstacles_.end(), Obstacle::Lost, Obstacle::None);
    }
    for (const Index face : changed_) {
      const Obstacle obstacle = obstacles_[parts_.find(face)];
      if (obstacle == Obstacle::None) continue;
      refuse(face, obstacle);
      return std::move(result_);
    }
    for (Index face = 1; face < obstacles_.size(); ++face) parts_.unite(0, face);
    return edits();
  }

 private:
  PassResult edits() {
    remove_faces();
    move_vertices();
    add_faces();
    add_walls();
    return std::move(result_);
  }

  [[nodiscard]] bool is_moved(Index vertex) const {
    return surface_.positions[vertex] != soup_.positions[vertex];
  }

  [[nodiscard]] bool has_moved_corner(const Triangle& t) const {
    return std::any_of(t.begin(), t.end(), [&](Index v) { return is_moved(v); });
  }

  void find_changes() {
    is_same_.assign(surface_.triangles.size(), 0);
    std::vector<std::uint8_t> stays(soup_.n_faces(), 0);
    for (std::size_t i = 0; i < surface_.triangles.size(); ++i) {
      const Index face = surface_.origins[i];
      const bool is_same =
          face < soup_.n_faces() && has_same_cycle(surface_.triangles[i], soup_.triangles[face]);
      if (!is_same) continue;
      is_same_[i] = 1;
      stays[face] = 1;
    }
    for (Index face = 0; face < soup_.n_faces(); ++face) {
      if (!is_in_complex(soup_.triangles[face])) continue;
      if (stays[face] == 0) removed_.push_back(face);
      if (stays[face] == 0 || has_moved_corner(soup_.triangles[face])) changed_.push_back(face);
    }
  }

  /// Faces that have a vertex in common change together.
  void join_parts() {
    for (const auto& [a, b] : surface_.ties) parts_.unite(a, b);
    std::vector<Index> face_at(surface_.positions.size(), kNoIndex);
    const auto join_at = [&](const Triangle& corners, Index face) {
      for (const Index v : corners) {
        if (face_at[v] == kNoIndex) face_at[v] = face;
        parts_.unite(face_at[v], face);
      }
    };
    for (const Index face : changed_) join_at(soup_.triangles[face], face);
    for (std::size_t i = 0; i < surface_.triangles.size(); ++i) {
      if (is_same_[i] == 0) join_at(surface_.triangles[i], surface_.origins[i]);
    }
  }

  void find_obstacles() {
    for (const Index face : surface_.unfinished) {
      obstacles_[parts_.find(face)] = Obstacle::Unfinished;
    }
    for (const Index face : surface_.of_uncut_sheets) {
      obstacles_[parts_.find(face)] = Obstacle::Sheet;
    }
    for (const Index face : surface_.loose) obstacles_[parts_.find(face)] = Obstacle::Loose;
    for (const Index face : changed_) {
      if (!input_.limits.has_fixed_corner(input_.tracked, face)) continue;
      obstacles_[parts_.find(face)] = Obstacle::Fixed;
    }
    find_lost_components();
  }

  /// The orientation of an open component, or beside a hole, is too uncertain for all of it to be
  /// taken for walls within a solid: it may be a cavity.
  void find_lost_components() {
    const CutMesh& cut = input_.mesh.cut();
    const Components components = find_edge_components(cut);
    const std::vector<Index> component_of =
        components_of_file_faces(cut, components, soup_.n_faces());
    std::vector<std::uint8_t> is_lost = which_are_closed(cut, components);
    for (std::uint8_t& lost : is_lost) lost = lost == 0 ? 1 : 0;
    const std::vector<std::uint8_t> has_patch = parts_with_patches();
    for (const Index face : changed_) {
      if (has_patch[parts_.find(face)] != 0) is_lost[component_of[face]] = 1;
    }
    for (const Index face : surface_.origins) {
      if (face < soup_.n_faces()) is_lost[component_of[face]] = 0;
    }
    if (std::none_of(is_lost.begin(), is_lost.end(), [](auto lost) { return lost != 0; })) return;
    const std::vector<std::uint8_t> bounds =
        bounds_solid(input_.mesh, components, input_.wants_to_stop);
    for (const Index face : changed_) {
      const Index component = component_of[face];
      if (is_lost[component] != 0 && bounds[component] != 0) {
        obstacles_[parts_.find(face)] = Obstacle::Lost;
      }
    }
  }

  /// Marks the parts that a patch belongs to with 1, by their lowest faces.
  [[nodiscard]] std::vector<std::uint8_t> parts_with_patches() {
    std::vector<std::uint8_t> has_patch(obstacles_.size(), 0);
    for (std::size_t face = soup_.n_faces(); face < obstacles_.size(); ++face) {
      has_patch[parts_.find(static_cast<Index>(face))] = 1;
    }
    return has_patch;
  }

  void remove_faces() {
    operations_.assign(obstacles_.size(), kNoIndex);
    std::vector<std::uint8_t> is_refused(soup_.n_faces(), 0);
    for (const Index face : changed_) {
      const Index part = parts_.find(face);
      if (obstacles_[part] != Obstacle::None) {
        if (std::exchange(is_refused[part], 1) == 0) refuse(face, obstacles_[part]);
        continue;
      }
      if (operations_[part] == kNoIndex) operations_[part] = result_.edits.begin_operation();
    }
    for (const Index face : removed_) {
      const Index op = operations_[parts_.find(face)];
      if (op != kNoIndex) result_.edits.removed_faces.push_back({op, face});
    }
    // A patch that is left as it is changes no other face.
    for (std::size_t i = 0; i < surface_.triangles.size(); ++i) {
      const Index part = parts_.find(surface_.origins[i]);
      if (is_same_[i] != 0 || obstacles_[part] != Obstacle::None) continue;
      if (operations_[part] == kNoIndex) operations_[part] = result_.edits.begin_operation();
    }
  }

  void refuse(Index face, Obstacle obstacle) {
    result_.refused.push_back(
        {.code = DefectCode::SelfIntersection, .face = face, .reason = reason_of(obstacle)});
  }

  /// #positions: 1 for those where sheets were cut: the new vertices of sheets, and the vertices of
  /// the input through which they were cut, as ends of non-manifold edges.
  [[nodiscard]] std::vector<std::uint8_t> places_of_sheet_cuts() const {
    std::vector<std::uint8_t> found(surface_.positions.size(), 0);
    if (surface_.of_sheets.empty()) return found;
    std::fill(found.begin() + static_cast<std::ptrdiff_t>(soup_.n_vertices()), found.end(), 1);
    const std::vector<FaceEdge> edges = sorted_edges(surface_.triangles);
    for (std::size_t i = 2; i < edges.size(); ++i) {
      if (edges[i].ends != edges[i - 2].ends) continue;
      for (const Index v : edges[i].ends) found[v] = 1;
    }
    const std::vector<std::uint8_t> is_of_sheet = vertices_of_sheets();
    for (std::size_t v = 0; v < found.size(); ++v) {
      if (is_of_sheet[v] == 0) found[v] = 0;
    }
    return found;
  }

  /// #positions: 1 for the vertices of cut sheets.
  [[nodiscard]] std::vector<std::uint8_t> vertices_of_sheets() const {
    std::vector<std::uint8_t> is_of_sheet(obstacles_.size(), 0);
    for (const Index face : surface_.of_sheets) is_of_sheet[face] = 1;
    std::vector<std::uint8_t> found(surface_.positions.size(), 0);
    for (std::size_t i = 0; i < surface_.triangles.size(); ++i) {
      if (is_of_sheet[surface_.origins[i]] == 0) continue;
      for (const Index v : surface_.triangles[i]) found[v] = 1;
    }
    return found;
  }

  void move_vertices() {
    std::vector<std::uint8_t> is_done(soup_.n_vertices(), 0);
    for (std::size_t i = 0; i < surface_.triangles.size(); ++i) {
      const Index op = operations_[parts_.find(surface_.origins[i])];
      if (op == kNoIndex) continue;
      for (const Index v : surface_.triangles[i]) {
        if (v >= soup_.n_vertices() || !is_moved(v) || std::exchange(is_done[v], 1) != 0) continue;
        result_.edits.moved_vertices.push_back({op, v, surface_.positions[v]});
      }
    }
  }

  void add_faces() {
    const auto n_vertices = static_cast<Index>(soup_.n_vertices());
    std::vector<std::uint8_t> is_sheet_cut = places_of_sheet_cuts();
    std::vector<Index> number(surface_.positions.size() - n_vertices, kNoIndex);
    for (std::size_t i = 0; i < surface_.triangles.size(); ++i) {
      const Index op = operations_[parts_.find(surface_.origins[i])];
      if (is_same_[i] != 0 || op == kNoIndex) continue;
      Triangle corners = surface_.triangles[i];
      for (Index& v : corners) {
        const bool is_cut_here = std::exchange(is_sheet_cut[v], 0) != 0;
        if (v >= n_vertices) {
          Index& added = number[v - n_vertices];
          if (added == kNoIndex) {
            added = n_vertices + static_cast<Index>(result_.edits.added_vertices.size());
            result_.edits.added_vertices.push_back({.op = op, .position = surface_.positions[v]});
          }
          v = added;
        }
        if (is_cut_here) result_.edits.sheet_cuts.push_back({op, v});
      }
      const Index origin = surface_.origins[i];
      const bool fills_hole = origin >= soup_.n_faces();
      result_.edits.added_faces.push_back(
          {.op = op,
           .corners = corners,
           .prototype = fills_hole ? patches_[origin - soup_.n_faces()].prototype : origin,
           .fills_hole = fills_hole});
    }
  }

  void add_walls() {
    for (const InteriorWall& wall : surface_.walls) {
      const Index op = operations_[parts_.find(wall.face)];
      const Index face = wall.face < soup_.n_faces() ? wall.face : kNoIndex;
      if (op != kNoIndex) result_.edits.interior_walls.push_back({op, {wall.corners, face}});
    }
  }

  const PassInput& input_;
  const Soup& soup_;
  std::span<const Edits::AddedFace> patches_;
  const CutSurface& surface_;
  DisjointSets parts_;
  /// The obstacle of each part, by its lowest face.
  std::vector<Obstacle> obstacles_;
  std::vector<Index> operations_;
  std::vector<std::uint8_t> is_same_;
  /// The faces that are removed, and those that get other corners or have some that move;
  /// ascending.
  std::vector<Index> removed_;
  std::vector<Index> changed_;
  PassResult result_;
};

}  // namespace

PassResult cut_edits(const PassInput& input, std::span<const Edits::AddedFace> patches,
                     const CutSurface& surface) {
  return CutEdits(input, patches, surface).make();
}

PassResult cut_edits_as_one(const PassInput& input, std::span<const Edits::AddedFace> patches,
                            const CutSurface& surface, LostParts lost) {
  return CutEdits(input, patches, surface).make_as_one(lost);
}

}  // namespace meshalyzer
