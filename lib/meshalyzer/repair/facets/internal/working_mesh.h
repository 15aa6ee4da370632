#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/base/items_by_group.h"
#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/repair/facets/internal/mend_step.h"
#include "meshalyzer/spatial/triangle_contact.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace meshalyzer {

/// The complex of a soup on which repairs are tried. It holds the connectivity as each vertex's
/// list of faces, whatever the topology, and which faces are thin. Faces keep their numbers; added
/// ones come after those of the soup.
class WorkingMesh {
 public:
  /// @param thin_faces  Thin faces of the complex.
  /// @complexity        O(#V + #F).
  WorkingMesh(const Soup& soup, std::span<const Index> thin_faces, double tolerance);

  /// Returns the corners of a face; all are kNoIndex if it was removed or was never in the complex.
  [[nodiscard]] const Triangle& triangle(Index face) const { return triangles_[face]; }
  [[nodiscard]] bool has(Index face) const { return triangles_[face][0] != kNoIndex; }
  [[nodiscard]] std::size_t n_faces() const { return triangles_.size(); }
  [[nodiscard]] std::size_t n_vertices() const { return positions_.size(); }
  [[nodiscard]] const Vec3& position(Index vertex) const { return positions_[vertex]; }
  [[nodiscard]] Corners corners(const Triangle& t) const { return corners_of(positions_, t); }
  /// Returns the corners that a face would have after a step.
  [[nodiscard]] Corners corners_after(const MendStep& step, const Triangle& t) const;
  [[nodiscard]] bool is_thin(Index face) const { return is_thin_[face] != 0; }
  /// Returns the face of the soup that a face is, or was modelled on when it was added.
  [[nodiscard]] Index original(Index face) const {
    return face < n_original_faces_ ? face : prototypes_[face - n_original_faces_];
  }

  /// Tells whether a step has added a vertex.
  [[nodiscard]] bool is_added(Index vertex) const { return vertex >= faces_.size(); }
  /// Returns the vertex of the soup that an added one is a copy of.
  [[nodiscard]] Index copied_from(Index added) const { return copied_from_[added - faces_.size()]; }

  /// Returns the faces at a vertex, in no particular but a reproducible order. The result is valid
  /// until the next step.
  [[nodiscard]] std::span<const Index> faces_at(Index vertex) const;
  /// Returns the faces at an edge, in the same sense.
  [[nodiscard]] std::vector<Index> faces_at(Index a, Index b) const;
  [[nodiscard]] bool are_joined(Index a, Index b) const;
  /// Returns the vertices that share a face with a vertex, ascending.
  [[nodiscard]] std::vector<Index> neighbours(Index vertex) const;

  /// Applies a step.
  void make(const MendStep& step);

 private:
  std::vector<Index>& own_faces(Index vertex);
  void detach(Index face);
  void attach(Index face, const Triangle& corners);
  void check(Index face);

  std::vector<Triangle> triangles_;
  std::vector<Vec3> positions_;
  std::vector<std::uint8_t> is_thin_;
  std::size_t n_original_faces_;
  std::vector<Index> prototypes_;
  double tolerance_;
  /// #V: the initial faces of each vertex.
  ItemsByGroup faces_;
  /// #added vertices.
  std::vector<Index> copied_from_;
  /// The faces of those vertices where they have changed.
  std::unordered_map<Index, std::vector<Index>> changed_;
};

}  // namespace meshalyzer
