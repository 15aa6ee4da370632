#pragma once

#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/spatial/intersecting_pair.h"

#include <mutex>
#include <vector>

namespace meshalyzer {

/// A soup and what questions about it need: its half-edge mesh, a tree over its faces, and, once
/// somebody has asked for them, its intersecting pairs. Stays where it is, since the tree refers to
/// the mesh; the soup must outlive it. Safe to read from several threads.
class PreparedMesh {
 public:
  /// @complexity O(#F log #F).
  explicit PreparedMesh(const Soup& soup) : soup_(soup), cut_(build(soup)), tree_(cut_) {}
  PreparedMesh(const PreparedMesh&) = delete;
  PreparedMesh& operator=(const PreparedMesh&) = delete;

  [[nodiscard]] const Soup& soup() const { return soup_; }
  [[nodiscard]] const CutMesh& cut() const { return cut_; }
  [[nodiscard]] const FaceTree& tree() const { return tree_; }

  /// As find_self_intersections(): searched when first asked for.
  [[nodiscard]] const std::vector<IntersectingPair>& intersecting_pairs() const;

  /// Tells the pairs, where they are known already, so that nobody searches them. Call before
  /// anybody asks.
  ///
  /// @param pairs  What find_self_intersections() would return.
  void know_intersecting_pairs(std::vector<IntersectingPair> pairs);

 private:
  const Soup& soup_;
  CutMesh cut_;
  FaceTree tree_;
  mutable std::once_flag pairs_known_;
  mutable std::vector<IntersectingPair> pairs_;
};

}  // namespace meshalyzer
