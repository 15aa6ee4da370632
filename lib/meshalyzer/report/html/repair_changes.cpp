#include "meshalyzer/report/html/repair_changes.h"

#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/report/html/defect_list.h"
#include "meshalyzer/report/key_ids.h"
#include "meshalyzer/report/text/short_list.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace meshalyzer {
namespace {

/// Returns "face 3" or "faces 3 4 7 and 9 more".
std::string face_list(const std::vector<std::int64_t>& ids) {
  std::string text = ids.size() == 1 ? "face" : "faces";
  append_ids(text, ids, ListLength::Short);
  return text;
}

std::vector<Index> joined(std::vector<Index> a, const std::vector<Index>& b) {
  a.insert(a.end(), b.begin(), b.end());
  sort_unique(a);
  return a;
}

bool have_common_edge(const Triangle& a, const Triangle& b) {
  return std::count_if(a.begin(), a.end(),
                       [&](Index v) { return std::find(b.begin(), b.end(), v) != b.end(); }) >= 2;
}

/// The changes that are listed for one mesh.
struct ListedChanges {
  ShownChanges shown;
  /// The number of listed changes of each pass.
  std::map<std::string_view, std::size_t> counts;

  /// Tells whether another change of a pass can be listed.
  [[nodiscard]] bool has_room(const std::string& pass) { return counts[pass] < kListedOfACode; }

  void add(const std::string& pass, std::string text, ChangedPlace place) {
    ++counts[pass];
    shown.changes.push_back({pass, std::move(text)});
    shown.places.push_back(std::move(place));
  }
};

/// Finds the changes in the log, operation by operation.
class ChangeFinder {
 public:
  ChangeFinder(const RepairReport& report, const Soup& input, const Soup& final_soup)
      : report_(report), input_(input), final_(final_soup), ids_(report) {
    Index n_before = 0;
    for (std::size_t i = 0; i < report.meshes.size(); ++i) {
      take_mesh(report.result.meshes[i].tracked, report.meshes[i], n_before);
      n_before += static_cast<Index>(report.meshes[i].name.n_faces);
    }
  }

  RepairChanges find() {
    for (const LoggedOperation& operation : report_.result.log.operations) {
      add_before(operation);
      add_after(operation);
    }
    return {std::move(before_.shown), std::move(after_.shown)};
  }

 private:
  /// Records the final position of the faces of a mesh, and the faces from which they were made, by
  /// key.
  void take_mesh(const TrackedMesh& tracked, const FinalMesh& mesh, Index n_before) {
    const std::size_t n_keys = tracked.n_face_keys();
    place_of_.resize(std::max(place_of_.size(), n_keys), kNoIndex);
    origin_of_.resize(place_of_.size(), kNoIndex);
    for (Index face = 0; face < tracked.face_keys.size(); ++face) {
      const Index record = mesh.face_records.empty() ? face : mesh.face_records[face];
      if (record >= mesh.name.n_faces) continue;
      place_of_[tracked.face_keys[face]] = n_before + record;
      origin_of_[tracked.face_keys[face]] = tracked.origin_of_face(face);
    }
  }

  void add_before(const LoggedOperation& operation) {
    const std::string& pass = report_.result.log.steps[operation.step].pass;
    if (!before_.has_room(pass)) return;
    std::vector<Index> faces = joined(operation.removed_faces, operation.changed_faces);
    std::erase_if(faces, [&](Index key) { return key >= input_.n_faces(); });
    if (faces.empty()) return;
    const bool is_dropped = operation.added_faces.empty() && operation.changed_faces.empty();
    const std::string_view verb = is_dropped ? " dropped" : " changed";
    std::string text = face_list(ids_.faces(faces)) += verb;
    before_.add(pass, std::move(text), {.faces = std::move(faces), .edges = {}});
  }

  void add_after(const LoggedOperation& operation) {
    const std::string& pass = report_.result.log.steps[operation.step].pass;
    if (!after_.has_room(pass)) return;
    std::vector<Index> keys = joined(operation.added_faces, operation.changed_faces);
    std::erase_if(keys,
                  [&](Index key) { return key >= place_of_.size() || place_of_[key] == kNoIndex; });
    if (keys.empty()) return;
    ChangedPlace place{.faces = {}, .edges = find_seam(keys)};
    for (const Index key : keys) place.faces.push_back(place_of_[key]);
    std::string text = face_list(ids_.faces(keys));
    if (!place.edges.empty()) {
      text += ", a seam of ";
      text += counted(place.edges.size(), "edge", "edges");
    }
    after_.add(pass, std::move(text), std::move(place));
  }

  /// Returns the edges at which faces meet that were made from faces without a common edge.
  [[nodiscard]] std::vector<std::array<Index, 2>> find_seam(const std::vector<Index>& keys) const {
    struct Side {
      std::array<Index, 2> edge;
      Index origin;
    };
    std::vector<Side> sides;
    for (const Index key : keys) {
      const Triangle& t = final_.triangles[place_of_[key]];
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
        sides.push_back({{low, high}, origin_of_[key]});
      }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
      return std::pair(a.edge, a.origin) < std::pair(b.edge, b.origin);
    });
    std::vector<std::array<Index, 2>> seam;
    for (std::size_t i = 1; i < sides.size(); ++i) {
      if (sides[i].edge == sides[i - 1].edge && lay_apart(sides[i - 1].origin, sides[i].origin)) {
        seam.push_back(sides[i].edge);
      }
    }
    return seam;
  }

  [[nodiscard]] bool lay_apart(Index a, Index b) const {
    return a != kNoIndex && b != kNoIndex && a != b &&
           !have_common_edge(input_.triangles[a], input_.triangles[b]);
  }

  const RepairReport& report_;
  const Soup& input_;
  const Soup& final_;
  KeyIds ids_;
  /// The position of each face among the faces of all meshes, by key.
  std::vector<Index> place_of_;
  std::vector<Index> origin_of_;
  ListedChanges before_;
  ListedChanges after_;
};

}  // namespace

RepairChanges find_changes(const RepairReport& report, const Soup& input, const Soup& final_soup) {
  return ChangeFinder(report, input, final_soup).find();
}

}  // namespace meshalyzer
