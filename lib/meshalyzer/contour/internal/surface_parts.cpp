#include "meshalyzer/contour/internal/surface_parts.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/triangle.h"

#include <algorithm>
#include <cmath>

namespace meshalyzer {
namespace {

/// Divides one face into parts that separate the region and parts that do not.
class FaceDivision {
 public:
  /// @param normal  The unit normal of the face.
  FaceDivision(const Region& region, const PartsResolution& resolution, const Vec3& normal)
      : region_(region), resolution_(resolution), step_(normal * resolution.reach) {}

  /// Halves a face along its longest edges until its pieces are small enough, and tells which
  /// separate.
  void divide(const Corners& face, bool may_change_inside, unsigned creases,
              SurfaceParts& parts) const {
    const std::size_t n_before = parts.separating.size();
    std::vector<Corners> open{face};
    while (!open.empty()) {
      const Corners t = open.back();
      open.pop_back();
      const Vec3 middle = centroid_of(t);
      const double length = longest_side(t);
      if (length > resolution_.spacing ||
          (may_change_inside && length > resolution_.least_piece && changes_inside(t, middle))) {
        const auto [first, second] = halve_longest_edge(t);
        open.push_back(second);
        open.push_back(first);
      } else if (separates(middle)) {
        parts.separating.push_back(middle);
      } else {
        parts.walls.push_back(t);
      }
    }
    // If no other face meets this one, a property of its interior also holds at its edges.
    const bool any_separates = parts.separating.size() > n_before;
    if (any_separates || may_change_inside) {
      add_crease_points(face, may_change_inside, creases, parts);
    }
  }

 private:
  [[nodiscard]] bool separates(const Vec3& p) const {
    return region_.contains_one_of(p + step_, p - step_);
  }

  /// Tells whether, at four sample points, one part of a piece separates and another does not.
  [[nodiscard]] bool changes_inside(const Corners& t, const Vec3& middle) const {
    constexpr double kInwards = 1.0 / 64.0;
    const bool at_middle = separates(middle);
    return std::any_of(t.begin(), t.end(), [&](const Vec3& corner) {
      return separates(corner + kInwards * (middle - corner)) != at_middle;
    });
  }

  /// Adds points along creases, which centroids miss.
  void add_crease_points(const Corners& t, bool may_change_inside, unsigned creases,
                         SurfaceParts& parts) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if ((creases >> i & 1U) == 0) continue;
      const Vec3 edge = t[(i + 1) % 3] - t[i];
      const double n = std::ceil(edge.norm() / resolution_.crease_spacing);
      for (double k = 0.0; k < n; ++k) {
        const Vec3 p = t[i] + edge * (k / n);
        if (!may_change_inside || separates(p)) parts.separating.push_back(p);
      }
    }
  }

  const Region& region_;
  const PartsResolution& resolution_;
  Vec3 step_;
};

}  // namespace

SurfaceParts divide_surface(const Soup& soup, const Region& region, const FaceHints& hints,
                            const PartsResolution& resolution) {
  constexpr std::size_t kFaces = 64;
  std::vector<SurfaceParts> of_chunk(n_chunks(soup.n_faces(), kFaces));
  parallel_chunks(soup.n_faces(), kFaces, [&](Chunk chunk) {
    for (std::size_t f = chunk.begin; f < chunk.end; ++f) {
      if (!is_in_complex(soup.triangles[f])) continue;
      const Corners face = corners_of(soup, static_cast<Index>(f));
      const Vec3 normal = normal_of(face);
      const double length = normal.norm();
      if (!(length > 0.0)) continue;
      FaceDivision(region, resolution, normal / length)
          .divide(face, hints.changes_inside[f] != 0, hints.creases[f], of_chunk[chunk.number]);
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
