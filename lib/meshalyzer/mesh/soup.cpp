#include "meshalyzer/mesh/soup.h"

#include "meshalyzer/base/corners.h"

#include <algorithm>
#include <utility>

namespace meshalyzer {

std::string_view format_name(Format format) {
  switch (format) {
    case Format::Mesh:
      return "mesh";
    case Format::Inria:
      return "inria";
    case Format::Obj:
      return "obj";
    case Format::Off:
      return "off";
    case Format::Stl:
      return "stl";
    case Format::Ply:
      return "ply";
  }
  return "";
}

std::array<Vec3, 3> corners_of(const Soup& soup, Index face) {
  return corners_of(soup.positions, soup.triangles[face]);
}

bool have_equal_corners(const Soup& soup, Index a, Index b) {
  const std::array<Vec3, 3> of_a = corners_of(soup, a);
  const std::array<Vec3, 3> of_b = corners_of(soup, b);
  return std::is_permutation(of_a.begin(), of_a.end(), of_b.begin());
}

Soup compact_soup(const std::vector<Vec3>& positions, std::vector<Triangle> triangles) {
  Soup compact;
  std::vector<Index> numbers(positions.size(), kNoIndex);
  for (Triangle& t : triangles) {
    for (Index& v : t) {
      Index& number = numbers[v];
      if (number == kNoIndex) {
        number = static_cast<Index>(compact.positions.size());
        compact.positions.push_back(positions[v]);
      }
      v = number;
    }
  }
  compact.triangles = std::move(triangles);
  return compact;
}

Index group_of(const Soup& soup, Index face) {
  // A group without faces begins where the next one does: the last group that begins here counts.
  const auto after =
      std::upper_bound(soup.groups.begin(), soup.groups.end(), face,
                       [](Index wanted, const Group& group) { return wanted < group.first_face; });
  return after == soup.groups.begin() ? kNoIndex
                                      : static_cast<Index>(after - soup.groups.begin() - 1);
}

}  // namespace meshalyzer
