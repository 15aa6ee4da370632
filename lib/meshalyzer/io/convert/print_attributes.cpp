#include "meshalyzer/io/convert/print_attributes.h"

#include <algorithm>
#include <cmath>

namespace meshalyzer {

std::vector<TexturePoint> texture_of_vertices(const MeshAttributes& attributes, const Soup& soup) {
  if (attributes.texture.empty()) {
    return {};
  }
  std::vector<std::optional<TexturePoint>> points(soup.n_vertices());
  for (Index r = 0; r < attributes.faces.size(); ++r) {
    std::size_t at = first_corner(attributes.faces, r);
    for (const Index corner : corners_of(attributes.faces, soup, r)) {
      const std::optional<TexturePoint>& point = attributes.texture[at++];
      if (corner == kNoIndex) {
        continue;
      }
      if (!point || (points[corner] && *points[corner] != *point)) {
        return {};
      }
      points[corner] = point;
    }
  }
  std::vector<TexturePoint> all;
  all.reserve(points.size());
  for (const std::optional<TexturePoint>& point : points) {
    all.push_back(point.value_or(TexturePoint{0.0, 0.0}));
  }
  return all;
}

bool are_bytes(const std::vector<std::optional<Rgba>>& colours) {
  constexpr double kThreeDecimals = 0.0005 * 255.0 * 1.01;
  return std::all_of(colours.begin(), colours.end(), [](const std::optional<Rgba>& colour) {
    return !colour || std::all_of(colour->begin(), colour->end(), [](double part) {
      const double byte = part * 255.0;
      return byte >= 0.0 && byte <= 255.0 && std::abs(byte - std::round(byte)) <= kThreeDecimals;
    });
  });
}

bool have_opacity(const std::vector<std::optional<Rgba>>& colours) {
  return std::any_of(colours.begin(), colours.end(), [](const std::optional<Rgba>& colour) {
    return colour && (*colour)[3] != 1.0;
  });
}

}  // namespace meshalyzer
