#include "meshalyzer/spatial/face_tree.h"

#include "meshalyzer/base/box.h"
#include "meshalyzer/base/eight_lanes.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/mesh/unbuild.h"
#include "meshalyzer/spatial/face_order.h"
#include "meshalyzer/spatial/tree_width.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace meshalyzer {
namespace {

/// Faces are far if a few of them make the box this many times wider than that of the others.
constexpr double kMuchWider = 1024.0;
/// Far faces are few if they are at most the square root of this multiple of all: the boxes of any
/// two of them may meet.
constexpr std::size_t kFarFacesSquared = 64;
/// Of many faces about so many are looked at to find where most of them are.
constexpr std::size_t kSampledTriangles = 512;
/// The coordinate of boxes beyond which there is nothing, if there are far faces.
constexpr float kFarPlace = 2.0F;

/// Returns a box round most of the corners of faces: that of the middle three quarters of a sample
/// along each axis, and four times its width round it. It is empty if these are at one place.
Box3 box_of_most(std::span<const Triangle> triangles, const FaceTree& tree) {
  const std::size_t step = triangles.size() / kSampledTriangles | 1U;
  std::vector<double> sample;
  Vec3 low;
  Vec3 high;
  for (Eigen::Index k = 0; k < 3; ++k) {
    sample.clear();
    for (std::size_t i = 0; i < triangles.size(); i += step) {
      sample.push_back(tree.placed(triangles[i][i % 3])[k]);
    }
    std::sort(sample.begin(), sample.end());
    low[k] = sample[sample.size() / 8];
    high[k] = sample[sample.size() - 1 - sample.size() / 8];
  }
  const double margin = 4.0 * (high - low).maxCoeff();
  return margin > 0.0 ? Box3(low.array() - margin, high.array() + margin) : Box3();
}

/// Returns the number of leaves; a tree without faces also has one.
std::size_t n_leaves_of(std::size_t n_faces) {
  return std::max<std::size_t>(1, n_chunks(n_faces, kTreeWidth));
}

}  // namespace

EightBoxes EightBoxes::empty() {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  EightBoxes boxes;
  for (std::size_t k = 0; k < 3; ++k) {
    boxes.min[k].fill(infinity);
    boxes.max[k].fill(-infinity);
  }
  return boxes;
}

unsigned EightBoxes::meeting(const TreeBox& other) const {
  EightFlags apart{};
  for (std::size_t k = 0; k < 3; ++k) {
    apart = apart | (EightFloats::all(other.high[k]) < EightFloats::load(min[k])) |
            (EightFloats::load(max[k]) < EightFloats::all(other.low[k]));
  }
  return ~apart.bits() & 0xFFU;
}

TreeBox TreeBox::around(const EightBoxes& boxes) {
  TreeBox box;
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<float, 8> low = boxes.min[k];
    std::array<float, 8> high = boxes.max[k];
    // Halves are compared with each other, several numbers at a time.
    for (std::size_t half = 4; half > 0; half /= 2) {
      for (std::size_t i = 0; i < half; ++i) {
        low[i] = std::min(low[i], low[i + half]);
        high[i] = std::max(high[i], high[i + half]);
      }
    }
    box.low[k] = low[0];
    box.high[k] = high[0];
  }
  return box;
}

std::vector<EightBoxes> boxes_above(std::span<const EightBoxes> below) {
  std::vector<EightBoxes> level(n_chunks(below.size(), kTreeWidth), EightBoxes::empty());
  parallel_chunks(below.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      level[i / kTreeWidth].set(i % kTreeWidth, TreeBox::around(below[i]));
    }
  });
  return level;
}

FaceTree::FaceTree(const CutMesh& cut) : points_(cut.mesh.points(), cut.mesh.n_vertices()) {
  make(unbuild(cut));
}

FaceTree::FaceTree(const CutMesh& cut, std::span<const Index> mesh_faces)
    : points_(cut.mesh.points(), cut.mesh.n_vertices()) {
  std::vector<Triangle> triangles;
  triangles.reserve(mesh_faces.size());
  for (const Index f : mesh_faces) {
    triangles.push_back(unbuild_face(cut, FaceHandle(static_cast<int>(f))));
  }
  make(std::move(triangles));
  for (Index& face : mesh_faces_) face = mesh_faces[face];
}

FaceTree::FaceTree(const FaceTree& other, const BoxFrame& frame)
    : points_(other.points_),
      frame_(frame),
      margin_(frame.rounding(other.bounds_)),
      bounds_(other.bounds_) {
  std::vector<Triangle> triangles(other.n_faces());
  for (std::size_t i = 0; i < triangles.size(); ++i) triangles[i] = other.triangle(i);
  make(std::move(triangles));
  for (Index& face : mesh_faces_) face = other.mesh_faces_[face];
}

void FaceTree::make(std::vector<Triangle> triangles) {
  choose_map(triangles);
  order_faces(triangles);
  triangles = {};
  box_faces();
  box_levels();
  mark_far_leaves();
}

std::array<float, 3> FaceTree::map_within(const Vec3& point, float farthest) const {
  std::array<float, 3> place = map(point);
  for (float& x : place) x = std::clamp(x, -farthest, farthest);
  return place;
}

bool FaceTree::is_far(const Vec3& point) const {
  if (limit_ > kFarPlace) return false;
  const std::array<float, 3> place = map(point);
  return std::any_of(place.begin(), place.end(), [](float x) { return std::abs(x) > 1.0F; });
}

TreeBox FaceTree::box_of(const Triangle& t) const {
  const Vec3 a = placed(t[0]);
  const Vec3 b = placed(t[1]);
  const Vec3 c = placed(t[2]);
  // The map is monotone, so it takes the corners of the box to those of the box of the places.
  return {map(a.cwiseMin(b).cwiseMin(c).array() - margin_),
          map(a.cwiseMax(b).cwiseMax(c).array() + margin_)};
}

Box3 FaceTree::box_of_places(std::span<const Triangle> triangles) const {
  const auto boxes = map_chunks<Box3>(triangles.size(), [&](Chunk chunk) {
    Box3 box;
    for (const Triangle& t : triangles.subspan(chunk.begin, chunk.end - chunk.begin)) {
      for (const Index v : t) box.extend(placed(v));
    }
    return box;
  });
  Box3 all;
  for (const Box3& box : boxes) all.extend(box);
  return all;
}

void FaceTree::choose_map(std::span<const Triangle> triangles) {
  const Box3 all = box_of_places(triangles);
  if (!frame_) bounds_ = all;
  if (!all.isEmpty() && !choose_map_of_most(triangles, all)) set_map(all);
}

/// Chooses the map for all but a few far faces. Does nothing and returns false if there are none.
///
/// @param all  The box of all places.
bool FaceTree::choose_map_of_most(std::span<const Triangle> triangles, const Box3& all) {
  const Box3 most = box_of_most(triangles, *this);
  const auto half_width = [](const Box3& box) { return half_widths_of(box).maxCoeff(); };
  if (most.isEmpty() || !(half_width(all) > kMuchWider * half_width(most))) return false;
  const auto is_outside = [&](Index v) { return !most.contains(placed(v)); };
  const auto n_far = static_cast<std::size_t>(std::count_if(
      triangles.begin(), triangles.end(),
      [&](const Triangle& t) { return std::any_of(t.begin(), t.end(), is_outside); }));
  if (n_far * n_far > kFarFacesSquared * triangles.size()) return false;
  set_map(most);
  limit_ = kFarPlace;
  return true;
}

/// Maps a box to -1 ... 1.
void FaceTree::set_map(const Box3& box) {
  centre_ = middle_of(box);
  const double half = half_widths_of(box).maxCoeff();
  scale_ = half > 0.0 ? std::min(1.0 / half, std::numeric_limits<double>::max()) : 1.0;
}

void FaceTree::mark_far_leaves() {
  if (limit_ > kFarPlace) return;
  is_far_leaf_.assign(n_leaves(), 0);
  for (std::size_t slot = 0; slot < n_faces(); ++slot) {
    const Triangle t = triangle(slot);
    if (std::any_of(t.begin(), t.end(), [&](Index v) { return is_far(placed(v)); })) {
      is_far_leaf_[slot / kTreeWidth] = 1;
    }
  }
}

void FaceTree::order_faces(std::span<const Triangle> triangles) {
  std::vector<FaceMiddle> items(triangles.size());
  parallel_chunks(items.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const TreeBox box = box_of(triangles[i]);
      for (std::size_t k = 0; k < 3; ++k) {
        // Zero has one sign only, so that it has one key.
        items[i].middle[k] = box.low[k] + box.high[k] + 0.0F;
      }
      items[i].face = static_cast<Index>(i);
    }
  });
  order_for_tree(items, triangles, points_);
  EightFaces none;
  for (auto& corner : none.corners) {
    corner.fill(kNoIndex);
  }
  faces_.assign(n_leaves_of(items.size()), none);
  mesh_faces_.resize(items.size());
  parallel_chunks(items.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      mesh_faces_[i] = items[i].face;
      for (std::size_t k = 0; k < 3; ++k) {
        faces_[i / kTreeWidth].corners[k][i % kTreeWidth] = triangles[items[i].face][k];
      }
    }
  });
}

void FaceTree::box_faces() {
  levels_.emplace_back(n_leaves_of(n_faces()), EightBoxes::empty());
  parallel_chunks(n_faces(), [&](Chunk chunk) {
    for (std::size_t slot = chunk.begin; slot < chunk.end; ++slot) {
      levels_.front()[slot / kTreeWidth].set(slot % kTreeWidth, box_of(triangle(slot)));
    }
  });
}

void FaceTree::box_levels() {
  while (levels_.back().size() > 1) levels_.push_back(boxes_above(levels_.back()));
}

}  // namespace meshalyzer
