#pragma once

#include "meshalyzer/repair/facets/internal/step_contacts.h"
#include "meshalyzer/repair/facets/internal/working_mesh.h"
#include "meshalyzer/repair/pass.h"

#include <algorithm>

namespace meshalyzer {

/// The limits of mending, and the vertices it may change. This refers to the input of the pass.
class MendRules {
 public:
  /// @param contacts  Forbids the steps that make contact; null if these are permitted.
  explicit MendRules(const PassInput& input, const StepContacts* contacts = nullptr)
      : input_(input), contacts_(contacts) {}

  [[nodiscard]] double tolerance() const { return input_.tolerances.degeneracy; }
  [[nodiscard]] double max_deviation() const { return input_.limits.max_deviation; }
  [[nodiscard]] Groups groups() const { return input_.limits.groups; }
  [[nodiscard]] Index group(const WorkingMesh& mesh, Index face) const {
    return group_of(input_.tracked.soup, mesh.original(face));
  }
  /// Tells whether faces of several groups meet at a vertex.
  [[nodiscard]] bool is_between_groups(const WorkingMesh& mesh, Index vertex) const {
    const auto faces = mesh.faces_at(vertex);
    if (input_.tracked.soup.groups.empty() || faces.empty()) return false;
    const Index first = group(mesh, faces[0]);
    return std::any_of(faces.begin(), faces.end(),
                       [&](Index f) { return group(mesh, f) != first; });
  }
  [[nodiscard]] bool forbids(const MendStep& step) const {
    return contacts_ != nullptr && contacts_->are_made_by(step);
  }
  /// Tells whether a vertex must stay at its position.
  [[nodiscard]] bool is_fixed(const WorkingMesh& mesh, Index vertex) const {
    return (!mesh.is_added(vertex) && input_.limits.is_fixed(input_.tracked, vertex)) ||
           (groups() == Groups::Faces && is_between_groups(mesh, vertex));
  }

 private:
  const PassInput& input_;
  const StepContacts* contacts_;
};

/// A vertex with more faces is not removed, because examining its surroundings again and again
/// would take too long.
inline constexpr std::size_t kMostFacesRoundVertex = 1000;

}  // namespace meshalyzer
