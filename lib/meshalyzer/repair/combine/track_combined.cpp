#include "meshalyzer/repair/combine/track_combined.h"

#include "meshalyzer/mesh/orphans.h"
#include "meshalyzer/repair/combine/internal/number_from_one.h"
#include "meshalyzer/repair/edits/apply_edits.h"
#include "meshalyzer/repair/edits/edits.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Makes edits of one operation that turns a mesh into the result.
class CombinedEdits {
 public:
  CombinedEdits(const Soup& source, const CombinedSolid& solid)
      : soup_(source),
        solid_(solid),
        stays_(source.n_faces(), 0),
        added_(solid.positions.size() - source.n_vertices(), kNoIndex) {}

  Edits make() {
    op_ = edits_.begin_operation();
    find_model();
    for (const CombinedFace& face : solid_.faces) take(face);
    for (Index f = 0; f < stays_.size(); ++f) {
      if (stays_[f] == 0) edits_.removed_faces.push_back({op_, f});
    }
    move_vertices();
    remove_orphans();
    return std::move(edits_);
  }

 private:
  [[nodiscard]] bool is_of_source(const CombinedFace& face) const {
    return face.origin < soup_.n_faces();
  }

  /// Patches are modelled on the first face of the source of which a part stays.
  void find_model() {
    const auto found = std::find_if(solid_.faces.begin(), solid_.faces.end(),
                                    [&](const CombinedFace& face) { return is_of_source(face); });
    if (found != solid_.faces.end()) model_ = found->origin;
  }

  void take(const CombinedFace& face) {
    const std::optional<Triangle> corners = whole_face(solid_, soup_, face);
    if (!corners) {
      add(face);
      return;
    }
    stays_[face.origin] = 1;
    if (!face.is_turned && *corners == soup_.triangles[face.origin]) return;
    edits_.changed_faces.push_back(
        {.op = op_, .face = face.origin, .corners = {}, .turns_normals = face.is_turned});
    for (std::size_t k = 0; k < 3; ++k) {
      edits_.changed_faces.back().corners[k] = named((*corners)[k]);
    }
  }

  void add(const CombinedFace& face) {
    Triangle corners = face.corners;
    for (Index& v : corners) v = named(v);
    edits_.added_faces.push_back({.op = op_,
                                  .corners = corners,
                                  .prototype = is_of_source(face) ? face.origin : model_,
                                  .fills_hole = !is_of_source(face)});
  }

  /// Returns how the edits name a vertex of the result, and adds it if it is new.
  Index named(Index v) {
    const auto n_vertices = static_cast<Index>(soup_.n_vertices());
    if (v < n_vertices) return v;
    Index& number = added_[v - n_vertices];
    if (number == kNoIndex) {
      number = n_vertices + static_cast<Index>(edits_.added_vertices.size());
      edits_.added_vertices.push_back({.op = op_, .position = solid_.positions[v]});
    }
    return number;
  }

  void move_vertices() {
    for (Index v = 0; v < soup_.n_vertices(); ++v) {
      if (solid_.positions[v] == soup_.positions[v]) continue;
      edits_.moved_vertices.push_back({op_, v, solid_.positions[v]});
    }
  }

  /// Vertices that lose their last face are dropped without being named.
  void remove_orphans() {
    for (const Index v : find_orphan_vertices(soup_, {})) {
      edits_.removed_vertices.push_back({op_, v});
    }
  }

  const Soup& soup_;
  const CombinedSolid& solid_;
  std::vector<std::uint8_t> stays_;
  /// By added vertex: its number among those that are used.
  std::vector<Index> added_;
  Index model_ = 0;
  Index op_ = 0;
  Edits edits_;
};

}  // namespace

TrackedMesh track_combined(const Soup& source, const CombinedSolid& solid) {
  TrackedMesh tracked = track_mesh(source);
  tracked = apply_edits(tracked, CombinedEdits(source, solid).make());
  number_from_one(tracked);
  return tracked;
}

bool is_unchanged(const Soup& source, const CombinedSolid& solid) {
  if (solid.faces.size() != source.n_faces()) return false;
  // The faces are in order of their origins.
  for (Index f = 0; f < source.n_faces(); ++f) {
    const CombinedFace& face = solid.faces[f];
    if (face.origin != f || face.corners != source.triangles[f]) return false;
    for (const Index v : face.corners) {
      if (solid.positions[v] != source.positions[v]) return false;
    }
  }
  return true;
}

}  // namespace meshalyzer
