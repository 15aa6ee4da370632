#include "meshalyzer/repair/driver/internal/dropped_parts.h"

#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/exact/normal.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/repair/orient/bounds_solid.h"
#include "meshalyzer/topology/border.h"
#include "meshalyzer/topology/components.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace meshalyzer {
namespace {

/// A smaller fraction of the area of a cut sheet is not told: it is due to rounding.
constexpr double kLeastLostShare = 1e-9;

double area_of(const Soup& soup, Index face) {
  const auto [a, b, c] = corners_of(soup, face);
  return accurate_normal(a, b, c).norm() / 2.0;
}

double area_of(const Soup& soup, const std::vector<Index>& faces) {
  double area = 0.0;
  for (const Index face : faces) area += area_of(soup, face);
  return area;
}

/// Names some faces: "face 7 and 3 more".
std::string faces_text(const Soup& input, const std::vector<Index>& faces) {
  return "face " + std::to_string(input.face_ids.of(faces.front())) +
         (faces.size() == 1 ? "" : " and " + grouped(faces.size() - 1) + " more");
}

/// Describes a part by its area and faces: "0.25, with face 7 and 3 more".
std::string part_text(const Soup& input, const std::vector<Index>& faces) {
  return readable(area_of(input, faces)) + ", with " + faces_text(input, faces);
}

bool is_of_pass(const RepairLog& log, const LoggedOperation& operation, std::string_view pass) {
  return log.steps[operation.step].pass == pass;
}

/// Appends a note for each part that a pass has dropped: the reason, and what was dropped.
void append_dropped(const Soup& input, const RepairLog& log, std::string_view pass,
                    std::string_view reason, std::vector<std::string>& notes) {
  for (const LoggedOperation& operation : log.operations) {
    if (!is_of_pass(log, operation, pass)) continue;
    std::vector<Index> faces = operation.removed_faces;
    std::erase_if(faces, [&](Index key) {
      return key >= input.n_faces() || !is_in_complex(input.triangles[key]);
    });
    if (faces.empty()) continue;
    notes.push_back("dropped, because " + std::string(reason) + " of area " +
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

/// An open component of the input that cuts have changed.
struct OpenPart {
  /// Its faces that cuts have removed, or parts of them, ascending.
  std::vector<Index> removed;
  /// The area of these less that of what is left of them.
  double area_lost = 0.0;
  /// Tells whether anything of it is left.
  bool stays = false;
  bool is_cut_sheet = false;
};

/// Returns the faces of the input where sheets were cut and end.
std::vector<Index> faces_where_sheets_end(const TrackedMesh& repaired) {
  std::vector<Index> faces;
  if (repaired.sheet_cuts.empty()) return faces;
  const CutMesh cut = build(repaired.soup);
  for (const HalfedgeHandle border : find_border_edges(cut)) {
    const auto ends = file_ends(cut, border);
    const bool is_at_cut = std::all_of(ends.begin(), ends.end(),
                                       [&](Index v) { return repaired.is_where_sheet_was_cut(v); });
    const Index face = cut.side.face(cut.mesh.face_handle(border));
    const Index origin = repaired.origin_of_face(face);
    if (is_at_cut && origin != kNoIndex) faces.push_back(origin);
  }
  return faces;
}

void append_note(const Soup& input, const OpenPart& part, std::vector<std::string>& notes) {
  if (part.removed.empty()) return;
  if (!part.stays) {
    notes.push_back("dropped, because it lies inside a solid: an open part of area " +
                    part_text(input, part.removed));
  } else if (part.is_cut_sheet && part.area_lost > kLeastLostShare * area_of(input, part.removed)) {
    notes.push_back(
        "dropped, because it lies inside a solid that a sheet crosses: a part of area " +
        readable(part.area_lost) + ", of " + faces_text(input, part.removed));
  }
}

void append_sheets_inside(const Soup& input, const TrackedMesh& repaired, const RepairLog& log,
                          std::vector<std::string>& notes) {
  const std::vector<Index> removed = faces_removed_by_cuts(repaired, log);
  if (removed.empty()) return;
  const CutMesh cut = build(input);
  const Components components = find_edge_components(cut);
  const std::vector<Index> component_of =
      components_of_file_faces(cut, components, input.n_faces());
  const std::vector<std::uint8_t> is_closed = which_are_closed(cut, components);
  std::vector<OpenPart> parts(components.count);
  for (const Index face : removed) {
    const Index component = component_of[face];
    if (component == kNoIndex || is_closed[component] != 0) continue;
    parts[component].removed.push_back(face);
    parts[component].area_lost += area_of(input, face);
  }
  for (Index face = 0; face < repaired.soup.n_faces(); ++face) {
    const Index origin = repaired.origin_of_face(face);
    if (origin == kNoIndex || component_of[origin] == kNoIndex) continue;
    OpenPart& part = parts[component_of[origin]];
    part.stays = true;
    if (std::binary_search(part.removed.begin(), part.removed.end(), origin)) {
      part.area_lost -= area_of(repaired.soup, face);
    }
  }
  for (const Index face : faces_where_sheets_end(repaired)) {
    if (component_of[face] != kNoIndex) parts[component_of[face]].is_cut_sheet = true;
  }
  for (const OpenPart& part : parts) append_note(input, part, notes);
}

}  // namespace

void append_dropped_parts(const Soup& input, const TrackedMesh& repaired, const RepairLog& log,
                          std::vector<std::string>& notes) {
  append_dropped(input, log, "drop copies", "it lies on another part: a part", notes);
  append_dropped(input, log, "drop dividing walls", "it divides a solid: a wall", notes);
  append_dropped(input, log, "drop fragments", "it encloses nothing: a fragment", notes);
  append_sheets_inside(input, repaired, log, notes);
}

}  // namespace meshalyzer
