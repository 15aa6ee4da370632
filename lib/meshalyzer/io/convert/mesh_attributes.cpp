#include "meshalyzer/io/convert/mesh_attributes.h"

#include <numeric>

namespace meshalyzer {

FaceRecords single_triangles(std::size_t n) {
  FaceRecords faces;
  faces.first_triangle.resize(n + 1);
  std::iota(faces.first_triangle.begin(), faces.first_triangle.end(), Index{0});
  return faces;
}

std::vector<Index> corners_of(const FaceRecords& faces, const Soup& soup, Index record) {
  const Index first = faces.first_triangle[record];
  std::vector<Index> corners(soup.triangles[first].begin(), soup.triangles[first].end());
  for (Index t = first + 1; t < faces.first_triangle[record + 1]; ++t) {
    corners.push_back(soup.triangles[t][2]);
  }
  return corners;
}

void use_at_corners(MeshAttributes& attributes, const Soup& soup,
                    const std::vector<TexturePoint>& points) {
  if (points.empty()) {
    return;
  }
  attributes.n_texture_points = points.size();
  attributes.texture.clear();
  for (Index r = 0; r < attributes.faces.size(); ++r) {
    for (const Index corner : corners_of(attributes.faces, soup, r)) {
      attributes.texture.emplace_back(corner < points.size() ? points[corner] : TexturePoint{});
    }
  }
}

}  // namespace meshalyzer
