#include "meshalyzer/contour/contour_mesh.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/contour/bisection_grid.h"
#include "meshalyzer/contour/internal/surface_parts.h"
#include "meshalyzer/contour/mesh_region.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/closest_point.h"
#include "meshalyzer/spatial/self_intersection.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace meshalyzer {
namespace {

/// Where nothing is known yet, cells have edges of 1/32 of the grid's cube.
constexpr std::uint32_t kFirstLevel = 3 * 5;
/// Points of the mesh are taken at this distance, as a share of its diagonal.
constexpr double kSpacing = 1.0 / 128.0;
/// The sides of a face are looked at from this distance, as a share of the maximum deviation.
constexpr double kReach = 1.0 / 16.0;
/// A tetrahedron in which the contour is too far away is bisected so many times at once: once more,
/// and its edges are half as long.
constexpr std::uint32_t kBisections = 2;

/// A mesh, what is built for it, and points of the part of it that bounds its solid.
struct Target {
  explicit Target(const Soup& mesh)
      : soup(mesh), cut(build(mesh)), tree(cut), region(mesh, tree), closest(tree) {}

  const Soup& soup;
  CutMesh cut;
  FaceTree tree;
  MeshRegion region;
  ClosestPoints closest;
  SurfaceParts parts;
};

/// Faces that others meet, inside or outside of which a part of them may lie.
std::vector<std::uint8_t> intersecting_faces(const Target& target) {
  std::vector<std::uint8_t> result(target.soup.n_faces());
  for (const IntersectingPair& pair : find_self_intersections(target.cut, target.tree)) {
    result[pair.face_a] = 1;
    result[pair.face_b] = 1;
  }
  return result;
}

Soup soup_of(const Contour& contour) {
  Soup soup;
  soup.positions = contour.positions;
  soup.triangles = contour.triangles;
  return soup;
}

/// The distances of points from a surface; infinite where there is none.
std::vector<double> distances(const std::vector<Vec3>& points, const ClosestPoints& surface) {
  std::vector<double> result(points.size(), std::numeric_limits<double>::infinity());
  parallel_chunks(points.size(), [&](Chunk chunk) {
    Index hint = kNoIndex;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      if (const auto found = surface.find({.point = points[i], .hint = hint})) {
        result[i] = found->distance;
        hint = found->slot;
      }
    }
  });
  return result;
}

constexpr std::size_t kPointsATriangle = 4;

/// The corners and the middle of each triangle of a contour.
std::vector<Vec3> points_of(const Contour& contour) {
  std::vector<Vec3> points;
  points.reserve(kPointsATriangle * contour.triangles.size());
  for (const Triangle& t : contour.triangles) {
    const Vec3& a = contour.positions[t[0]];
    const Vec3& b = contour.positions[t[1]];
    const Vec3& c = contour.positions[t[2]];
    points.insert(points.end(), {a, b, c, (a + b + c) / 3.0});
  }
  return points;
}

/// Refines a grid until its contour is near the target.
class ContourSearch {
 public:
  ContourSearch(const Target& target, const BisectionGrid& grid, const ContourLimits& limits)
      : target_(target), grid_(grid), limits_(limits) {}

  ContouredMesh run() {
    refine_at_samples();
    while (true) {
      draw();
      measure();
      if (far_.empty()) return {soup_of(contour_), {}, deviation_, true};
      const std::size_t n_before = leaves_.size();
      for (const Index t : far_) refine(t, grid_.tetrahedron(t).level + kBisections);
      leaves_ = grid_.leaves();
      if (leaves_.size() > limits_.max_tetrahedra || leaves_.size() == n_before) {
        return {soup_of(contour_), {}, deviation_, false};
      }
    }
  }

 private:
  void refine_at_samples() {
    for (const Vec3& p : target_.parts.separating) {
      for (Index t = grid_.leaf_at(p); grid_.tetrahedron(t).level < kFirstLevel;
           t = grid_.leaf_at(p)) {
        grid_.bisect(t);
      }
    }
    leaves_ = grid_.leaves();
  }

  /// Bisects a tetrahedron and its parts.
  void refine(Index t, std::uint32_t level) {
    if (grid_.tetrahedron(t).level >= level) return;
    grid_.bisect(t);
    if (const auto halves = grid_.halves(t)) {
      for (const Index half : *halves) refine(half, level);
    }
  }

  void draw() {
    labels_ = label_vertices(grid_, leaves_, target_.region, labels_);
    contour_ = march_tetrahedra(grid_, leaves_, labels_, target_.region);
  }

  void measure() {
    far_.clear();
    deviation_ = 0.0;
    const Soup soup = soup_of(contour_);
    const CutMesh cut = build(soup);
    const FaceTree tree(cut);
    const ClosestPoints closest(tree);
    const std::vector<double> of_samples = distances(target_.parts.separating, closest);
    for (std::size_t i = 0; i < of_samples.size(); ++i) {
      note(of_samples[i], [&] { return grid_.leaf_at(target_.parts.separating[i]); });
    }
    const std::vector<Vec3> points = points_of(contour_);
    const std::vector<double> of_contour = distances(points, target_.closest);
    for (std::size_t i = 0; i < of_contour.size(); ++i) {
      if (of_contour[i] > limits_.max_deviation && target_.region.spans_hole_at(points[i])) {
        continue;
      }
      note(of_contour[i], [&] { return contour_.leaves[i / kPointsATriangle]; });
    }
  }

  template <typename Leaf>
  void note(double distance, const Leaf& leaf) {
    deviation_ = std::max(deviation_, distance);
    if (distance > limits_.max_deviation) far_.push_back(leaf());
  }

  const Target& target_;
  BisectionGrid grid_;
  const ContourLimits& limits_;
  std::vector<Index> leaves_;
  GridLabels labels_;
  Contour contour_;
  /// Tetrahedra in which the surfaces are too far apart.
  std::vector<Index> far_;
  double deviation_ = 0.0;
};

std::optional<BisectionGrid> grid_round(const Box3& box) {
  try {
    return BisectionGrid(box);
  } catch (const InvalidArgument&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<ContouredMesh> contour_mesh(const Soup& soup, const ContourLimits& limits) {
  if (!(limits.max_deviation > 0.0)) {
    throw InvalidArgument("the deviation of a contour is not positive");
  }
  Target target(soup);
  const auto grid = grid_round(target.tree.bounds());
  if (!grid) return std::nullopt;
  target.parts = divide_surface(soup, target.region, intersecting_faces(target),
                                {.spacing = kSpacing * target.tree.bounds().diagonal().norm(),
                                 .reach = kReach * limits.max_deviation});
  ContouredMesh result = ContourSearch(target, *grid, limits).run();
  result.walls = std::move(target.parts.walls);
  return result;
}

}  // namespace meshalyzer
