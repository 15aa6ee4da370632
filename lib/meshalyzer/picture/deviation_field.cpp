#include "meshalyzer/picture/deviation_field.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/picture/internal/drawn_surface.h"
#include "meshalyzer/spatial/closest_point.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace meshalyzer {

Field deviation_field(const Soup& soup, const PreparedMesh& other) {
  constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
  Field field{FieldName::Deviation, FieldPlace::Vertices, FieldKind::Magnitude,
              std::vector<double>(soup.n_vertices(), kNoValue)};
  if (other.cut().side.faces.empty()) return field;
  const std::vector<std::uint8_t> is_drawn =
      used_vertices(soup, triangles_of(soup, drawable_faces(soup)));
  const ClosestPoints closest_points(other.tree());
  parallel_chunks(soup.n_vertices(), [&](Chunk chunk) {
    Index hint = kNoIndex;
    for (std::size_t v = chunk.begin; v < chunk.end; ++v) {
      if (is_drawn[v] == 0) continue;
      const std::optional<SurfacePoint> closest =
          closest_points.find({.point = soup.positions[v], .hint = hint, .near_enough = 0.0});
      if (!closest) continue;
      field.values[v] = closest->distance;
      hint = closest->slot;
    }
  });
  return field;
}

}  // namespace meshalyzer
