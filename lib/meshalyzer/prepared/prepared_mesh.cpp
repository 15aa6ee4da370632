#include "meshalyzer/prepared/prepared_mesh.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/geometry/extent.h"
#include "meshalyzer/spatial/self_intersection.h"

#include <utility>

namespace meshalyzer {
namespace {

/// A pointer to what somebody else owns.
std::shared_ptr<const Soup> borrow(const Soup& soup) {
  return {std::shared_ptr<const Soup>(), &soup};
}

}  // namespace

PreparedMesh::PreparedMesh(const Soup& soup) : PreparedMesh(borrow(soup)) {}

PreparedMesh::PreparedMesh(std::shared_ptr<const Soup> soup)
    : soup_(std::move(soup)), cut_(build(*soup_)) {}

const Soup& PreparedMesh::soup() const {
  if (!soup_) throw InvalidArgument("the records of this mesh were released");
  return *soup_;
}

const FaceTree& PreparedMesh::tree() const {
  return tree_.get([this] { return FaceTree(cut_); });
}

const Components& PreparedMesh::components() const {
  return components_.get([this] { return find_components(cut_); });
}

const std::vector<Box3>& PreparedMesh::component_boxes() const {
  return component_boxes_.get([this] {
    const Components& parts = components();
    return bounding_boxes(cut_.mesh, {.of_face = parts.of_face, .count = parts.count});
  });
}

const std::vector<IntersectingPair>& PreparedMesh::intersecting_pairs() const& {
  return pairs_.get([this] { return find_self_intersections(cut_, tree(), max_pairs_); });
}

std::vector<IntersectingPair> PreparedMesh::intersecting_pairs() && {
  static_cast<void>(std::as_const(*this).intersecting_pairs());
  return pairs_.take();
}

void PreparedMesh::set_intersecting_pairs(std::vector<IntersectingPair> pairs) {
  static_cast<void>(pairs_.get([&] { return std::move(pairs); }));
}

const std::vector<Shell>& PreparedMesh::shells() const {
  return shells_.get([this] { return find_shells(*this); });
}

}  // namespace meshalyzer
