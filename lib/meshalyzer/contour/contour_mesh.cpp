#include "meshalyzer/contour/contour_mesh.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/require.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/contour/bisection_grid.h"
#include "meshalyzer/contour/internal/surface_parts.h"
#include "meshalyzer/contour/mesh_region.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/mesh/finite_positions.h"
#include "meshalyzer/spatial/closest_point.h"
#include "meshalyzer/spatial/self_intersection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The initial cells round the mesh have edges of 1/32 of the grid's cube, or of about this
/// multiple of the maximum deviation if that is larger.
constexpr double kMostHalvings = 5.0;
constexpr double kFirstCell = 4.0;
/// Points of the mesh are taken at this distance, as a share of its diagonal, or at the maximum
/// deviation if that is larger.
constexpr double kSpacing = 1.0 / 128.0;
/// The sides of a face are sampled at this distance, as a share of the maximum deviation.
constexpr double kReach = 1.0 / 16.0;
/// Points along creases are taken at this distance, as a multiple of the maximum deviation.
constexpr double kCreaseSpacing = 2.0;
/// The approximate largest number of points along creases, and of pieces of faces.
constexpr double kMostPieces = 1e5;
/// An edge is a crease if the normals of its faces differ by more than about four degrees.
constexpr double kCosCrease = 0.9975;
/// The largest number of bisections at a time of a tetrahedron in which the contour is too far
/// away.
constexpr double kMostBisections = 6.0;

/// A mesh with its search structures.
struct SearchedMesh {
  explicit SearchedMesh(const Soup& mesh) : soup(mesh), cut(build(mesh)), tree(cut) {}

  const Soup& soup;
  CutMesh cut;
  FaceTree tree;
};

/// A mesh, its solid, and points of the part of it that bounds the solid.
struct Target {
  explicit Target(const Soup& soup) : mesh(soup), region(soup, mesh.tree), closest(mesh.tree) {}

  SearchedMesh mesh;
  MeshRegion region;
  ClosestPoints closest;
  SurfaceParts parts;
};

/// Returns the faces that may have a part in a box.
Soup faces_in(const Soup& soup, const Box3& box) {
  Soup result;
  result.positions = soup.positions;
  for (const Triangle& t : soup.triangles) {
    if (!is_in_complex(t)) continue;
    Box3 around;
    for (const Index v : t) around.extend(soup.positions[v]);
    if (around.intersects(box)) result.triangles.push_back(t);
  }
  return result;
}

/// Returns the pairs of faces that intersect each other, each in both orders, ascending.
std::vector<std::array<Index, 2>> intersecting_faces(const SearchedMesh& mesh) {
  std::vector<std::array<Index, 2>> result;
  for (const IntersectingPair& pair : find_self_intersections(mesh.cut, mesh.tree)) {
    result.push_back({pair.face_a, pair.face_b});
    result.push_back({pair.face_b, pair.face_a});
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// Marks the faces that intersect others.
std::vector<std::uint8_t> faces_of(const std::vector<std::array<Index, 2>>& pairs,
                                   std::size_t n_faces) {
  std::vector<std::uint8_t> result(n_faces);
  for (const auto& [face, other] : pairs) result[face] = 1;
  return result;
}

/// The size of the faces that are marked.
struct MarkedSize {
  /// The length of their edges.
  double length = 0.0;
  double area = 0.0;
};

MarkedSize size_of(const Soup& soup, const std::vector<std::uint8_t>& faces) {
  MarkedSize size;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    if (faces[f] == 0) continue;
    const auto [a, b, c] = corners_of(soup, f);
    size.length += (b - a).norm() + (c - b).norm() + (a - c).norm();
    const double area = normal_of(a, b, c).norm() / 2.0;
    // Products of coordinates that are too large for a double may cancel.
    size.area += std::isnan(area) ? std::numeric_limits<double>::infinity() : area;
  }
  return size;
}

/// Returns the size down to which faces can be divided without too many pieces. Many layers of
/// faces may lie in a box, so that its diagonal does not limit them.
double size_of_pieces(double area) {
  // A piece has at least a quarter of the square of the size, on average.
  return 2.0 * std::sqrt(area / kMostPieces);
}

/// Marks the edges where the surface bends, or ends.
std::vector<std::uint8_t> find_creases(const SearchedMesh& searched) {
  std::vector<std::uint8_t> result(searched.soup.n_faces());
  const TriMesh& mesh = searched.cut.mesh;
  const auto normal = [&](FaceHandle f) {
    return normal_of(corners_of(searched.soup, searched.cut.side.face(f))).stableNormalized();
  };
  const auto mark = [&](HalfedgeHandle h) {
    if (mesh.is_boundary(h)) return;
    const Index face = searched.cut.side.face(mesh.face_handle(h));
    const Triangle& t = searched.soup.triangles[face];
    const Index from = searched.cut.side.vertex(mesh.from_vertex_handle(h));
    const auto k = std::find(t.begin(), t.end(), from) - t.begin();
    result[face] = static_cast<std::uint8_t>(result[face] | 1U << static_cast<unsigned>(k));
  };
  for (const EdgeHandle e : mesh.edges()) {
    const HalfedgeHandle h = mesh.halfedge_handle(e, 0);
    const HalfedgeHandle opposite = mesh.halfedge_handle(e, 1);
    if (mesh.is_boundary(e)) {
      mark(h);
      mark(opposite);
    } else if (normal(mesh.face_handle(h)).dot(normal(mesh.face_handle(opposite))) < kCosCrease) {
      // One entry for each place is enough.
      mark(h);
    }
  }
  return result;
}

Soup soup_of(const Contour& contour) {
  Soup soup;
  soup.positions = contour.positions;
  soup.triangles = contour.triangles;
  return soup;
}

/// Returns the distances of points to a surface, infinite if it is empty: exactly where they are
/// larger than `limit`, and the largest of the others; of the rest, upper bounds up to that.
std::vector<double> largest_distances(const std::vector<Vec3>& points, const ClosestPoints& surface,
                                      double limit) {
  std::vector<double> result(points.size(), std::numeric_limits<double>::infinity());
  parallel_chunks(points.size(), [&](Chunk chunk) {
    Index hint = kNoIndex;
    double largest_within = 0.0;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      // Most points are no farther away than one before them, which takes one face to see.
      const auto found =
          surface.find({.point = points[i], .hint = hint, .near_enough = largest_within});
      if (!found) continue;
      result[i] = found->distance;
      hint = found->slot;
      if (found->distance <= limit) largest_within = std::max(largest_within, found->distance);
    }
  });
  return result;
}

/// Returns the vertices of a contour and the centroids of its triangles, each beside its
/// neighbours.
std::vector<Vec3> points_of(const Contour& contour) {
  std::vector<Vec3> points;
  points.reserve(contour.positions.size() + contour.triangles.size());
  std::vector<std::uint8_t> is_added(contour.positions.size());
  for (const Triangle& t : contour.triangles) {
    for (const Index v : t) {
      if (is_added[v] == 0) points.push_back(contour.positions[v]);
      is_added[v] = 1;
    }
    points.push_back(
        centroid_of({contour.positions[t[0]], contour.positions[t[1]], contour.positions[t[2]]}));
  }
  return points;
}

/// Refines a grid until its contour is near the target.
class ContourSearch {
 public:
  ContourSearch(const Target& target, const BisectionGrid& grid, const ContourLimits& limits)
      : target_(target), grid_(grid), limits_(limits) {}

  /// @return Nothing if it was to stop.
  std::optional<ContouredMesh> run() {
    refine_at_samples();
    while (!limits_.wants_to_stop()) {
      draw();
      measure();
      if (far_.empty()) return result(true);
      const std::size_t n_before = leaves_.size();
      refine_far();
      leaves_ = grid_.leaves();
      if (is_too_large() || leaves_.size() == n_before) {
        return result(false);
      }
    }
    return std::nullopt;
  }

 private:
  void refine_at_samples() {
    const double cube = grid_.step() * BisectionGrid::kSize;
    const double halvings = std::log2(cube / (kFirstCell * limits_.max_deviation));
    const auto level = 3 * static_cast<std::uint32_t>(std::clamp(halvings, 1.0, kMostHalvings));
    for (const Vec3& p : target_.parts.separating) refine_at(p, level);
    leaves_ = grid_.leaves();
  }

  /// Bisects the tetrahedra round the points that are too far away.
  void refine_far() {
    std::vector<std::uint32_t> levels;
    levels.reserve(far_.size());
    for (const auto& [point, distance] : far_) {
      const double halvings = 2.0 * std::log2(distance / limits_.max_deviation);
      const double n = std::clamp(std::ceil(halvings), 1.0, kMostBisections);
      levels.push_back(grid_.tetrahedron(grid_.leaf_at(point)).level +
                       static_cast<std::uint32_t>(n));
    }
    for (std::size_t i = 0; i < far_.size() && !is_too_large(); ++i) {
      refine_at(far_[i].first, levels[i]);
    }
  }

  [[nodiscard]] ContouredMesh result(bool is_within) const {
    return {.soup = soup_of(contour_),
            .walls = {},
            .deviation = deviation_,
            .n_tetrahedra = grid_.n_leaves(),
            .is_within = is_within};
  }

  [[nodiscard]] bool is_too_large() const { return grid_.n_leaves() > limits_.max_tetrahedra; }

  /// Bisects the tetrahedron that contains a point until it has a level, which may be beyond the
  /// highest.
  void refine_at(const Vec3& point, std::uint32_t level) {
    const std::uint32_t last = std::min(level, BisectionGrid::kMaxLevel);
    for (Index t = grid_.leaf_at(point); grid_.tetrahedron(t).level < last;
         t = grid_.leaf_at(point)) {
      grid_.bisect(t);
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
    const double limit = limits_.max_deviation;
    const std::vector<Vec3>& samples = target_.parts.separating;
    const std::vector<double> of_samples = largest_distances(samples, closest, limit);
    for (std::size_t i = 0; i < samples.size(); ++i) note(samples[i], of_samples[i]);

    std::vector<Vec3> points = points_of(contour_);
    if (limits_.within) {
      std::erase_if(points, [&](const Vec3& point) { return !limits_.within->contains(point); });
    }
    const std::vector<double> of_points = largest_distances(points, target_.closest, limit);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (of_points[i] > limit && target_.region.spans_hole_at(points[i])) continue;
      note(points[i], of_points[i]);
    }
  }

  void note(const Vec3& point, double distance) {
    deviation_ = std::max(deviation_, distance);
    if (distance > limits_.max_deviation) far_.emplace_back(point, distance);
  }

  const Target& target_;
  BisectionGrid grid_;
  const ContourLimits& limits_;
  std::vector<Index> leaves_;
  GridLabels labels_;
  Contour contour_;
  /// The points of one surface that are too far from the other, with their distances.
  std::vector<std::pair<Vec3, double>> far_;
  double deviation_ = 0.0;
};

/// Divides those faces that may have a part in a box, and leaves out what lies outside.
SurfaceParts divide_near(const Box3& box, const Target& target, const ContourLimits& limits) {
  const Soup near = faces_in(target.mesh.soup, box);
  const SearchedMesh searched(near);
  const FaceHints hints{intersecting_faces(searched), find_creases(searched)};
  const double least = kCreaseSpacing * limits.max_deviation;
  const MarkedSize all = size_of(near, std::vector<std::uint8_t>(near.n_faces(), 1));
  const MarkedSize creased = size_of(near, hints.creases);
  const MarkedSize crossed = size_of(near, faces_of(hints.intersecting, near.n_faces()));
  SurfaceParts parts = divide_surface(
      near, target.region, hints,
      {.spacing = std::max(
           {kSpacing * box.diagonal().norm(), limits.max_deviation, size_of_pieces(all.area)}),
       .reach = kReach * limits.max_deviation,
       .crease_spacing = std::max(least, creased.length / kMostPieces),
       .least_piece =
           std::max({least, crossed.length / kMostPieces, size_of_pieces(crossed.area)})},
      limits.wants_to_stop);
  if (limits.within) {
    std::erase_if(parts.separating, [&](const Vec3& point) { return !box.contains(point); });
    std::erase_if(parts.walls,
                  [&](const Corners& wall) { return !box.contains(centroid_of(wall)); });
  }
  return parts;
}

std::optional<BisectionGrid> grid_round(const Box3& box) {
  try {
    return BisectionGrid(box);
  } catch (const InvalidArgument&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<ContouredMesh> contour_mesh(const Soup& soup, const ContourLimits& limits) {
  require_positive_length("the maximum deviation of a contour", limits.max_deviation);
  require_finite_positions(soup);
  Target target(soup);
  const Box3 box = limits.within.value_or(target.mesh.tree.bounds());
  const auto grid = grid_round(box);
  if (!grid) return std::nullopt;
  target.parts = divide_near(box, target, limits);
  std::optional<ContouredMesh> result = ContourSearch(target, *grid, limits).run();
  if (result) result->walls = std::move(target.parts.walls);
  return result;
}

}  // namespace meshalyzer
