#include "meshalyzer/repair/replace/internal/broken_boxes.h"

#include "meshalyzer/base/box.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/repair/replace/internal/broken_solids.h"

#include <algorithm>
#include <cstddef>

namespace meshalyzer {
namespace {

/// A mesh with more places is broken as a whole.
constexpr std::size_t kMostBoxes = 32;

/// Adds a box to disjoint ones, and unites it with those that it meets.
void add_box(Box3 box, std::vector<Box3>& boxes) {
  for (std::size_t i = 0; i < boxes.size();) {
    if (!boxes[i].intersects(box)) {
      ++i;
      continue;
    }
    box.extend(boxes[i]);
    boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(i));
    // The larger box may meet those that were passed already.
    i = 0;
  }
  boxes.push_back(box);
}

}  // namespace

std::vector<Box3> boxes_round_broken_faces(const PreparedMesh& mesh, double margin) {
  std::vector<Box3> boxes;
  for (const Index face : find_broken_faces(mesh)) {
    add_box(grown(box_of(corners_of(mesh.soup(), face)), margin), boxes);
    if (boxes.size() > 16 * kMostBoxes) return {};
  }
  if (boxes.size() > kMostBoxes) boxes.clear();
  return boxes;
}

}  // namespace meshalyzer
