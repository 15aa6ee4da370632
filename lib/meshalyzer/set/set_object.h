#pragma once

#include "meshalyzer/base/lazy.h"
#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/spatial/closest_point.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace meshalyzer {

/// The faces of a mesh that enclose space: those of components in which every edge has exactly two
/// faces.
struct SolidParts {
  /// #components: 1 for those that enclose space.
  std::vector<std::uint8_t> is_solid;
  /// #mesh faces: 0 for faces of such a component, else kNoIndex.
  std::vector<Index> of_face;
  std::size_t count = 0;
};

/// The location of a point relative to a solid.
enum class Side : std::uint8_t { Outside, Inside, OnSurface };

/// Whether an object is prepared for queries of closest points, which takes additional memory.
enum class ClosestUse : std::uint8_t { Never, Prepared };

/// One mesh of a set, prepared for queries about its surroundings. Its tree and its components are
/// built by the constructor, so that its size is known; only the ids of its records are kept.
class SetObject {
 public:
  /// @param soup  The records, which are not needed afterwards.
  /// @complexity  O(#F log #F) time.
  explicit SetObject(const Soup& soup, ClosestUse use = ClosestUse::Never);
  /// Takes over a mesh that was prepared for its analysis, and the ids of its records.
  ///
  /// @param mesh  As MeshKept::ForNeighbours leaves it.
  /// @complexity  O(#F) time if its tree is built.
  SetObject(std::shared_ptr<const PreparedMesh> mesh, Ids vertex_ids, Ids face_ids,
            ClosestUse use = ClosestUse::Never);

  [[nodiscard]] const CutMesh& cut() const { return mesh_->cut(); }
  [[nodiscard]] const FaceTree& tree() const { return mesh_->tree(); }
  [[nodiscard]] const Components& components() const { return mesh_->components(); }
  [[nodiscard]] const std::vector<Box3>& component_boxes() const {
    return mesh_->component_boxes();
  }
  /// Returns the search structure for closest points, which is built when it is first needed.
  ///
  /// @pre         The object was made with ClosestUse::Prepared.
  /// @complexity  O(#F) time at its first use.
  [[nodiscard]] const ClosestPoints& closest() const {
    return closest_.get([this] { return ClosestPoints(tree()); });
  }
  /// Returns a file vertex of each component.
  [[nodiscard]] const std::vector<Index>& component_vertices() const { return component_vertices_; }
  /// Returns the file vertices that faces use, in the order of the tree: neighbours mostly follow
  /// each other.
  ///
  /// @complexity O(#V + #F).
  [[nodiscard]] std::vector<Index> used_vertices() const;
  [[nodiscard]] const Ids& vertex_ids() const { return vertex_ids_; }
  [[nodiscard]] const Ids& face_ids() const { return face_ids_; }
  /// Returns the box of the vertices that faces use; it is empty where there is no face.
  [[nodiscard]] const Box3& box() const { return box_; }

  /// Tells whether any of its components encloses anything.
  [[nodiscard]] bool is_solid() const { return solids_.count != 0; }
  /// Locates a point relative to the components that enclose space. The answer is exact: a ray from
  /// a point inside meets their faces an odd number of times, so that a cavity is outside.
  ///
  /// @complexity O(log #F + faces whose boxes the ray meets).
  [[nodiscard]] Side side_of(const Vec3& point) const;

  /// Estimates the bytes of memory that it takes.
  [[nodiscard]] std::uint64_t bytes() const;

 private:
  std::shared_ptr<const PreparedMesh> mesh_;
  ClosestUse use_;
  mutable Lazy<ClosestPoints> closest_;
  std::vector<Index> component_vertices_;
  SolidParts solids_;
  Box3 box_;
  Ids vertex_ids_;
  Ids face_ids_;
};

}  // namespace meshalyzer
