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

/// A mesh with what questions about it need, each built once: whoever asks the same mesh several
/// things hands the same PreparedMesh on. (JTS and GEOS call a geometry with such indices a
/// PreparedGeometry.)
///
/// The half-edge mesh is built at once: O(#F) time, about 200 bytes a face. All else is built when
/// it is first asked for, and kept as long as this lives: each function says what it costs. Any
/// number of threads may ask at a time. It stays where it is, since its parts refer to each other.
class PreparedMesh {
 public:
  /// Prepares a mesh of which the caller keeps the records.
  ///
  /// @param soup  Must outlive this, or what is left of this after release_soup().
  explicit PreparedMesh(const Soup& soup);
  /// Prepares a mesh and keeps its records.
  explicit PreparedMesh(std::shared_ptr<const Soup> soup);
  PreparedMesh(const PreparedMesh&) = delete;
  PreparedMesh& operator=(const PreparedMesh&) = delete;

  /// The records of the file.
  ///
  /// @throws InvalidArgument  after release_soup().
  [[nodiscard]] const Soup& soup() const;

  /// Gives up the records, so that their memory is free unless somebody else holds them. Nothing
  /// else that can be asked for needs them.
  void release_soup() { soup_.reset(); }

  /// The half-edge mesh, cut open where the mesh is not manifold: see build().
  [[nodiscard]] const CutMesh& cut() const { return cut_; }

  /// The tree over the faces.
  ///
  /// @complexity O(#F log #F) time, 48 bytes a face.
  [[nodiscard]] const FaceTree& tree() const;

  /// The components: see find_components().
  ///
  /// @complexity Near O(#F) time, 4 bytes a face.
  [[nodiscard]] const Components& components() const;

  /// The box of each component: see bounding_boxes().
  ///
  /// @complexity O(#F) time.
  [[nodiscard]] const std::vector<Box3>& component_boxes() const;

  /// The pairs of faces that intersect: see find_self_intersections(), or the first of them where
  /// limit_intersecting_pairs() says so. Asks for the tree.
  ///
  /// @complexity O(#F log #F + candidates) time.
  [[nodiscard]] const std::vector<IntersectingPair>& intersecting_pairs() const&;
  /// Returns the same for one who needs nothing else any more.
  [[nodiscard]] std::vector<IntersectingPair> intersecting_pairs() &&;

  /// Says what the pairs are where they are known already, so that nobody searches them. Must be
  /// called before anybody asks for them.
  ///
  /// @param pairs  What find_self_intersections() would return.
  void set_intersecting_pairs(std::vector<IntersectingPair> pairs);

  /// Has the search for intersecting pairs end early, or list only some of what it finds, for one
  /// who need not know them all. Must be called before anybody asks for them.
  void limit_intersecting_pairs(PairLimits limits) { limits_ = std::move(limits); }

  /// Tells whether the search for intersecting pairs ended because it had found enough. Asks for
  /// them.
  [[nodiscard]] bool are_intersecting_pairs_cut() const {
    return intersecting_pairs().size() >= limits_.max_found;
  }

  /// Counts the intersecting pairs, those that are not listed too. Asks for them and for the
  /// components.
  ///
  /// @complexity O(pairs) time beside that of the search; memory does not grow with their number.
  [[nodiscard]] const IntersectionCounts& intersection_counts() const;

  /// Tells whether a search for intersecting pairs was told to stop before its end; searches none.
  [[nodiscard]] bool was_intersection_search_stopped() const {
    return intersection_counts_.is_made() && intersection_counts().was_stopped;
  }

  /// Returns what each component is as the wall of a solid: see find_shells(). Builds the tree and
  /// finds the intersecting pairs only where there are several components and one of them is a
  /// shell.
  [[nodiscard]] const std::vector<Shell>& shells() const;

 private:
  [[nodiscard]] std::vector<IntersectingPair> search_intersecting_pairs() const;
  [[nodiscard]] IntersectionCounts count_intersecting_pairs(
      const std::function<bool(PairListener&)>& visit) const;

  std::shared_ptr<const Soup> soup_;
  CutMesh cut_;
  mutable Lazy<FaceTree> tree_;
  mutable Lazy<Components> components_;
  mutable Lazy<std::vector<Box3>> component_boxes_;
  PairLimits limits_;
  mutable Lazy<std::vector<IntersectingPair>> pairs_;
  mutable Lazy<IntersectionCounts> intersection_counts_;
  mutable Lazy<std::vector<Shell>> shells_;
};

}  // namespace meshalyzer
