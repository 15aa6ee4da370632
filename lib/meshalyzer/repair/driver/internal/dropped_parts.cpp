#include "meshalyzer/repair/driver/internal/dropped_parts.h"

#include "meshalyzer/base/numbers.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/exact/normal.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/repair/orient/bounds_solid.h"
#include "meshalyzer/topology/components.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace meshalyzer {
namespace {

/// Describes a part by its area and faces: "0.25, with face 7 and 3 more".
std::string part_text(const Soup& input, const std::vector<Index>& faces) {
  double area = 0.0;
  for (const Index face : faces) {
    const auto [a, b, c] = corners_of(input, face);
    area += accurate_normal(a, b, c).norm() / 2.0;
  }
  return shortest(area) + ", with face " + std::to_string(input.face_ids.of(faces.front())) +
         (faces.size() == 1 ? "" : " and " + std::to_string(faces.size() - 1) + " more");
}

bool is_of_pass(const RepairLog& log, const LoggedOperation& operation, std::string_view pass) {
  return log.steps[operation.step].pass == pass;
}

void append_fragments(const Soup& input, const RepairLog& log, std::vector<std::string>& notes) {
  for (const LoggedOperation& operation : log.operations) {
    if (!is_of_pass(log, operation, "drop fragments")) continue;
    std::vector<Index> faces = operation.removed_faces;
    std::erase_if(faces, [&](Index key) {
      return key >= input.n_faces() || !is_in_complex(input.triangles[key]);
    });
    if (faces.empty()) continue;
    notes.push_back("dropped, because it encloses nothing: a fragment of area " +
                    part_text(input, faces));
  }
}

/// Returns the faces of the input that cuts have removed, or parts of them, ascending.
std::vector<Index> faces_removed_by_cuts(const TrackedMesh& repaired, const RepairLog& log) {
  std::vector<Index> faces;
  for (const LoggedOperation& operation : log.operations) {
    if (!is_of_pass(log, operation, "cut intersections") &&
        !is_of_pass(log, operation, "unite with itself")) {
      continue;
    }
    for (const Index key : operation.removed_faces) {
      const Index origin = repaired.origin_of_key(key);
      if (origin != kNoIndex) faces.push_back(origin);
    }
  }
  sort_unique(faces);
  return faces;
}

void append_sheets_inside(const Soup& input, const TrackedMesh& repaired, const RepairLog& log,
                          std::vector<std::string>& notes) {
  const std::vector<Index> removed = faces_removed_by_cuts(repaired, log);
  if (removed.empty()) return;
  const CutMesh cut = build(input);
  const Components components = find_edge_components(cut);
  const std::vector<Index> component_of =
      components_of_file_faces(cut, components, input.n_faces());
  std::vector<std::uint8_t> stays = which_are_closed(cut, components);
  for (Index face = 0; face < repaired.soup.n_faces(); ++face) {
    const Index origin = repaired.origin_of_face(face);
    if (origin != kNoIndex && component_of[origin] != kNoIndex) stays[component_of[origin]] = 1;
  }
  std::vector<std::vector<Index>> dropped(components.count);
  for (const Index face : removed) {
    const Index component = component_of[face];
    if (component != kNoIndex && stays[component] == 0) dropped[component].push_back(face);
  }
  for (const std::vector<Index>& faces : dropped) {
    if (faces.empty()) continue;
    notes.push_back("dropped, because it lies inside a solid: an open part of area " +
                    part_text(input, faces));
  }
}

}  // namespace

void append_dropped_parts(const Soup& input, const TrackedMesh& repaired, const RepairLog& log,
                          std::vector<std::string>& notes) {
  append_fragments(input, log, notes);
  append_sheets_inside(input, repaired, log, notes);
}

}  // namespace meshalyzer
