#include "meshalyzer/repair/replace/internal/shell_choice.h"

#include "meshalyzer/geometry/volume.h"
#include "meshalyzer/repair/orient/bounds_solid.h"
#include "meshalyzer/topology/components.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace meshalyzer {
namespace {

/// #components: 1 for those in whose box one of the points lies.
std::vector<std::uint8_t> which_hold(const CutMesh& cut, const Components& components,
                                     const std::vector<Vec3>& points) {
  const std::vector<Box3> boxes = bounding_boxes(cut.mesh, {components.of_face, components.count});
  std::vector<std::uint8_t> holds(components.count, 0);
  for (std::size_t part = 0; part < components.count; ++part) {
    const auto is_inside = [&](const Vec3& point) { return boxes[part].contains(point); };
    holds[part] = std::any_of(points.begin(), points.end(), is_inside) ? 1 : 0;
  }
  return holds;
}

}  // namespace

ChosenShells choose_shells(const PassInput& input, const ShellChoice& choice) {
  const CutMesh& cut = input.mesh.cut();
  const Components components = find_edge_components(cut);
  const std::vector<std::uint8_t> is_closed = which_are_closed(cut, components);
  const auto key_of = [&](std::size_t f) { return input.tracked.face_keys[cut.side.faces[f]]; };
  std::vector<std::uint8_t> is_chosen = which_hold(cut, components, choice.hidden_points);
  for (std::size_t part = 0; part < components.count; ++part) {
    if (is_closed[part] != 0) is_chosen[part] = 0;
  }
  const auto& named = choice.face_keys;
  for (std::size_t f = 0; f < components.of_face.size(); ++f) {
    const Index part = components.of_face[f];
    if (is_chosen[part] != 0 || (is_closed[part] != 0 && !choice.closed_too)) continue;
    is_chosen[part] = std::binary_search(named.begin(), named.end(), key_of(f)) ? 1 : 0;
  }
  ChosenShells chosen;
  for (std::size_t f = 0; f < components.of_face.size(); ++f) {
    const Index part = components.of_face[f];
    if (is_chosen[part] != 0) {
      chosen.face_keys.push_back(key_of(f));
    } else if (is_closed[part] == 0) {
      chosen.other_open_keys.push_back(key_of(f));
    }
  }
  std::sort(chosen.face_keys.begin(), chosen.face_keys.end());
  std::sort(chosen.other_open_keys.begin(), chosen.other_open_keys.end());
  return chosen;
}

}  // namespace meshalyzer
