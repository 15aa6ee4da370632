#include "meshalyzer/contour/internal/surface_parts.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/spatial/triangle_contact.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

namespace meshalyzer {
namespace {

/// What lies inside a piece near its corner or edge is sampled this share of the way to its middle.
constexpr double kInwards = 1.0 / 64.0;

/// Divides one face into parts that separate the region and parts that do not.
class FaceDivision {
 public:
  /// @param soup    The mesh of the face.
  /// @param normal  The unit normal of the face.
  FaceDivision(const Soup& soup, const Region& region, const PartsResolution& resolution,
               const Vec3& normal)
      : soup_(soup), region_(region), resolution_(resolution), step_(normal * resolution.reach) {}

  /// Halves a face along its longest edges until its pieces are small enough, and tells which
  /// separate.
  ///
  /// @param others  The face and each of those that intersect it.
  void divide(const Corners& face, std::span<const std::array<Index, 2>> others, unsigned creases,
              SurfaceParts& parts) {
    const std::size_t n_separating = parts.separating.size();
    const std::size_t n_walls = parts.walls.size();
    for (const auto& [f, other] : others) others_.push_back(other);
    divide_piece(face, 0, parts);
    const bool any_separates = parts.separating.size() > n_separating;
    const bool any_is_wall = parts.walls.size() > n_walls;
    // If no other face meets this one, a property of all its pieces also holds at its edges. Faces
    // that lie closely over a part of it make its pieces differ.
    const bool may_change = !others.empty() || (any_separates && any_is_wall);
    if (any_separates || may_change) add_crease_points(face, may_change, creases, parts);
  }

 private:
  /// @param first  The faces that may meet the piece are those from here on in `others_`.
  void divide_piece(const Corners& t, std::size_t first, SurfaceParts& parts) {
    const Vec3 middle = centroid_of(t);
    const double length = longest_side(t);
    if (length > resolution_.spacing ||
        (length > resolution_.least_piece && may_change(t, middle, first))) {
      const std::size_t end = others_.size();
      for (const Corners& half : halve_longest_edge(t)) {
        for (std::size_t i = first; i < end; ++i) {
          if (meets(half, others_[i])) others_.push_back(others_[i]);
        }
        divide_piece(half, end, parts);
        others_.resize(end);
      }
    } else if (separates(middle)) {
      parts.separating.push_back(middle);
    } else {
      parts.walls.push_back(t);
    }
  }

  [[nodiscard]] std::optional<ContactKind> meets(const Corners& t, Index other) const {
    return find_contact(t, corners_of(soup_, other), Common::Nothing);
  }

  /// Tells whether one part of a piece may separate and another not.
  [[nodiscard]] bool may_change(const Corners& t, const Vec3& middle, std::size_t first) const {
    if (first == others_.size()) return false;
    const bool is_crossed =
        std::any_of(others_.begin() + static_cast<std::ptrdiff_t>(first), others_.end(),
                    [&](Index other) { return meets(t, other) == ContactKind::Crossing; });
    return is_crossed || changes_inside(t, middle);
  }

  [[nodiscard]] bool separates(const Vec3& p) const {
    return region_.contains_one_of(p + step_, p - step_);
  }

  /// Tells whether, at four sample points, one part of a piece separates and another does not.
  [[nodiscard]] bool changes_inside(const Corners& t, const Vec3& middle) const {
    const bool at_middle = separates(middle);
    return std::any_of(t.begin(), t.end(), [&](const Vec3& corner) {
      return separates(corner + kInwards * (middle - corner)) != at_middle;
    });
  }

  /// Tells whether a piece separates beside a point of its edge. At the point itself both samples
  /// may lie in the plane of a face on the other side of the edge.
  [[nodiscard]] bool separates_beside(const Vec3& p, const Vec3& middle) const {
    const Vec3 inwards = middle - p;
    return separates(p + std::min(kInwards, resolution_.reach / inwards.norm()) * inwards);
  }

  /// Adds points along creases, which centroids miss.
  void add_crease_points(const Corners& t, bool may_change, unsigned creases,
                         SurfaceParts& parts) const {
    const Vec3 middle = centroid_of(t);
    for (std::size_t i = 0; i < 3; ++i) {
      if ((creases >> i & 1U) == 0) continue;
      const Vec3 edge = t[(i + 1) % 3] - t[i];
      const double n = std::ceil(edge.norm() / resolution_.crease_spacing);
      for (double k = 0.0; k < n; ++k) {
        const Vec3 p = t[i] + edge * (k / n);
        if (!may_change || separates_beside(p, middle)) parts.separating.push_back(p);
      }
    }
  }

  const Soup& soup_;
  const Region& region_;
  const PartsResolution& resolution_;
  Vec3 step_;
  /// The faces that may meet the pieces that are being divided, each followed by its halves.
  std::vector<Index> others_;
};

/// Returns the pairs of a face with those that intersect it.
std::span<const std::array<Index, 2>> others_of(Index face, const FaceHints& hints) {
  const auto [first, last] = std::equal_range(
      hints.intersecting.begin(), hints.intersecting.end(), std::array{face, kNoIndex},
      [](const auto& a, const auto& b) { return a[0] < b[0]; });
  return {first, last};
}

}  // namespace

SurfaceParts divide_surface(const Soup& soup, const Region& region, const FaceHints& hints,
                            const PartsResolution& resolution, const StopQuery& wants_to_stop) {
  constexpr std::size_t kFaces = 64;
  std::vector<SurfaceParts> of_chunk(n_chunks(soup.n_faces(), kFaces));
  parallel_chunks(soup.n_faces(), kFaces, [&](Chunk chunk) {
    if (wants_to_stop()) return;
    for (std::size_t f = chunk.begin; f < chunk.end; ++f) {
      if (!is_in_complex(soup.triangles[f])) continue;
      const Corners face = corners_of(soup, static_cast<Index>(f));
      const Vec3 normal = normal_of(face);
      const double length = normal.norm();
      if (!(length > 0.0)) continue;
      FaceDivision(soup, region, resolution, normal / length)
          .divide(face, others_of(static_cast<Index>(f), hints), hints.creases[f],
                  of_chunk[chunk.number]);
    }
  });
  SurfaceParts all;
  for (const SurfaceParts& parts : of_chunk) {
    all.separating.insert(all.separating.end(), parts.separating.begin(), parts.separating.end());
    all.walls.insert(all.walls.end(), parts.walls.begin(), parts.walls.end());
  }
  return all;
}

}  // namespace meshalyzer
