#pragma once

#include "meshalyzer/base/lazy.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/prepared/intersection_counts.h"
#include "meshalyzer/prepared/shells.h"
#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/spatial/intersecting_pair.h"
#include "meshalyzer/spatial/pair_limits.h"
#include "meshalyzer/topology/components.h"

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace meshalyzer {

class PairListener;

/// A mesh with the structures that queries on it need, each built once and shared by all queries.
/// (JTS and GEOS call a geometry with such indices a PreparedGeometry.)
///
/// The constructor builds the half-edge mesh: O(#F) time, about 200 bytes per face. Everything else
/// is built at its first use and kept: each function states its cost. A mesh with a position that
/// is not finite has components, and nothing else: what needs the positions throws InvalidArgument.
/// Any number of threads may call at a time. The object cannot be moved, because its parts refer to
/// each other.
class PreparedMesh {
 public:
  /// Prepares a mesh whose records the caller keeps.
  ///
  /// @param soup         The records, which must outlive this object until release_soup().
  /// @param pair_limits  The limits of the search for intersecting pairs.
  /// @throws InvalidArgument  as build().
  explicit PreparedMesh(const Soup& soup, PairLimits pair_limits = {});
  /// Prepares a mesh and keeps its records.
  ///
  /// @throws InvalidArgument  as build(); and if the pointer is null.
  explicit PreparedMesh(std::shared_ptr<const Soup> soup, PairLimits pair_limits = {});
  PreparedMesh(const PreparedMesh&) = delete;
  PreparedMesh& operator=(const PreparedMesh&) = delete;

  /// Returns the records of the file.
  ///
  /// @throws InvalidArgument  after release_soup().
  [[nodiscard]] const Soup& soup() const;

  /// Releases the records, so that their memory is freed unless they are shared. No other function
  /// needs them.
  void release_soup() { soup_.reset(); }

  /// Returns the half-edge mesh, cut open where the mesh is not manifold: see build().
  [[nodiscard]] const CutMesh& cut() const { return cut_; }

  /// Returns the tree over the faces.
  ///
  /// @complexity O(#F log #F) time, 48 bytes a face.
  [[nodiscard]] const FaceTree& tree() const;

  /// Returns the components: see find_components().
  ///
  /// @complexity Near O(#F) time, 4 bytes a face.
  [[nodiscard]] const Components& components() const;

  /// Returns the box of each component: see bounding_boxes().
  ///
  /// @complexity O(#F) time.
  [[nodiscard]] const std::vector<Box3>& component_boxes() const&;
  /// Moves the boxes out for a caller that needs nothing else any more.
  [[nodiscard]] std::vector<Box3> component_boxes() &&;

  /// Returns the intersecting pairs of faces, see find_self_intersections(), or the first of them
  /// if the search is limited. It uses the tree.
  ///
  /// @complexity O(#F log #F + candidates) time.
  [[nodiscard]] const std::vector<IntersectingPair>& intersecting_pairs() const&;
  /// Moves the pairs out for a caller that needs nothing else any more.
  [[nodiscard]] std::vector<IntersectingPair> intersecting_pairs() &&;

  /// Sets the pairs if they are known already, so that they are not searched. It must be called
  /// before their first use.
  ///
  /// @param pairs  The pairs that find_self_intersections() would return.
  void set_intersecting_pairs(std::vector<IntersectingPair> pairs);

  /// Counts the intersecting pairs, listed or not. It triggers the search and uses the components.
  ///
  /// @complexity O(pairs) time in addition to the search; memory does not grow with their number.
  [[nodiscard]] const IntersectionCounts& intersection_counts() const;

  /// Tells whether a search for intersecting pairs has left out some: it had found enough or was
  /// told to stop, see PairLimits. It triggers no search.
  [[nodiscard]] bool was_intersection_search_cut() const {
    return pairs_.is_made() && !found_pairs().is_complete;
  }

  /// Returns the role of each component as the wall of a solid: see find_shells(). It builds the
  /// tree and finds the intersecting pairs only if there are several components and one of them is
  /// a shell.
  [[nodiscard]] const std::vector<Shell>& shells() const&;
  /// Moves the shells out for a caller that needs nothing else any more.
  [[nodiscard]] std::vector<Shell> shells() &&;

 private:
  [[nodiscard]] const FoundPairs& found_pairs() const;
  [[nodiscard]] FoundPairs search_intersecting_pairs() const;
  [[nodiscard]] IntersectionCounts count_intersecting_pairs(
      const std::function<bool(PairListener&)>& visit) const;

  std::shared_ptr<const Soup> soup_;
  CutMesh cut_;
  mutable Lazy<FaceTree> tree_;
  mutable Lazy<Components> components_;
  mutable Lazy<std::vector<Box3>> component_boxes_;
  PairLimits pair_limits_;
  mutable Lazy<FoundPairs> pairs_;
  mutable Lazy<IntersectionCounts> intersection_counts_;
  mutable Lazy<std::vector<Shell>> shells_;
};

}  // namespace meshalyzer
