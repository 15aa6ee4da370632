#include "meshalyzer/repair/facets/internal/step_contacts.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/repair/rules/internal/contact_rule.h"
#include "meshalyzer/spatial/faces_meeting_box.h"

#include <algorithm>
#include <cstddef>

namespace meshalyzer {
namespace {

/// Where more faces are near to those of a step, or a step changes more, nothing is foreseen,
/// because comparing all with each other would take too long.
constexpr std::size_t kMostFacesNear = 1000;
constexpr std::size_t kMostFacesChanged = 64;

/// Tells whether two of some faces are in contact.
bool touch_each_other(const std::vector<PlacedFace>& faces) {
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (are_in_contact(faces[i], faces[j])) return true;
    }
  }
  return false;
}

bool touches_any(const PlacedFace& face, const std::vector<PlacedFace>& others) {
  return std::any_of(others.begin(), others.end(),
                     [&](const PlacedFace& other) { return are_in_contact(face, other); });
}

}  // namespace

/// The faces that a step changes, before and after it.
struct StepContacts::Change {
  /// Their numbers, ascending; without those that it adds.
  std::vector<Index> faces;
  std::vector<PlacedFace> before;
  std::vector<PlacedFace> after;
};

StepContacts::Change StepContacts::change_of(const MendStep& step) const {
  Change change;
  const auto add_after = [&](const Triangle& t) {
    if (t == kNoTriangle) return;
    change.after.push_back({t, now_.corners_after(step, t)});
  };
  for (const MendStep::NewCorners& changed : step.changed) {
    change.faces.push_back(changed.face);
    add_after(changed.corners);
  }
  sort_unique(change.faces);
  if (step.moved) {
    const std::vector<Index> listed = change.faces;
    for (const Index f : now_.faces_at(step.moved->vertex)) {
      if (std::binary_search(listed.begin(), listed.end(), f)) continue;
      change.faces.push_back(f);
      add_after(now_.triangle(f));
    }
    sort_unique(change.faces);
  }
  for (const MendStep::NewFace& added : step.added) add_after(added.corners);
  for (const Index f : change.faces) {
    const Triangle& t = now_.triangle(f);
    change.before.push_back({t, now_.corners(t)});
  }
  return change;
}

/// Returns the other faces that the changed ones may touch.
std::vector<Index> StepContacts::faces_near(const Change& change) const {
  std::vector<Index> near;
  for (const PlacedFace& face : change.after) {
    for (const Index f : find_faces_meeting(before_.tree(), box_of(face.corners))) {
      near.push_back(before_.cut().side.faces[f]);
    }
    for (const Index v : face.vertices) {
      if (v == now_.n_vertices()) continue;
      const auto round = now_.faces_at(v);
      near.insert(near.end(), round.begin(), round.end());
    }
  }
  sort_unique(near);
  std::erase_if(near, [&](Index f) {
    return !now_.has(f) || std::binary_search(change.faces.begin(), change.faces.end(), f);
  });
  return near;
}

bool StepContacts::are_made_by(const MendStep& step) const {
  const Change change = change_of(step);
  if (change.after.empty() || change.faces.size() > kMostFacesChanged) return false;
  const std::vector<Index> near = faces_near(change);
  if (near.size() > kMostFacesNear) return false;
  for (const Index f : near) {
    const Triangle& t = now_.triangle(f);
    const PlacedFace other{t, now_.corners(t)};
    if (touches_any(other, change.after) && !touches_any(other, change.before)) return true;
  }
  return touch_each_other(change.after) && !touch_each_other(change.before);
}

}  // namespace meshalyzer
