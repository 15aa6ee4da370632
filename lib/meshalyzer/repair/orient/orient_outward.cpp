#include "meshalyzer/prepared/shells.h"
#include "meshalyzer/repair/orient/outward_votes.h"
#include "meshalyzer/repair/orient/side_votes.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/topology/components.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meshalyzer {
namespace {

/// Finds the patches that point the wrong way. A patch with a flipped edge is left: the patch
/// beyond that edge would have to be turned with it.
class WrongPatches {
 public:
  explicit WrongPatches(const PreparedMesh& mesh)
      : mesh_(mesh),
        patches_(find_oriented_patches(mesh.cut())),
        component_(patches_.count),
        roles_(patches_.count) {
    const Components& components = mesh.components();
    const std::vector<std::uint8_t> is_shell = which_are_shells(mesh.cut(), components);
    for (std::size_t f = 0; f < patches_.of_face.size(); ++f) {
      const Index component = components.of_face[f];
      component_[patches_.of_face[f]] = component;
      roles_[patches_.of_face[f]] = is_shell[component] != 0 ? PatchRole::Shell : PatchRole::Voter;
    }
    for (const HalfedgeHandle h : mesh.cut().side.flipped_edges.halfedges) {
      const auto face = static_cast<std::size_t>(mesh.cut().mesh.face_handle(h).idx());
      roles_[patches_.of_face[face]] = PatchRole::None;
    }
  }

  [[nodiscard]] const Components& patches() const { return patches_; }

  /// #patches: 1 for those to be turned. A shell is one patch, and all of its component.
  [[nodiscard]] std::vector<std::uint8_t> find() const {
    std::vector<std::uint8_t> is_wrong =
        vote_outward({.mesh = mesh_, .patches = patches_, .roles = roles_});
    for (std::size_t p = 0; p < patches_.count; ++p) {
      if (roles_[p] == PatchRole::Shell) {
        is_wrong[p] = mesh_.shells()[component_[p]].outward.value_or(true) ? 0 : 1;
      }
    }
    return is_wrong;
  }

 private:
  const PreparedMesh& mesh_;
  Components patches_;
  /// By patch.
  std::vector<Index> component_;
  std::vector<PatchRole> roles_;
};

}  // namespace

PassResult orient_outward(const PassInput& input) {
  const WrongPatches wrong(input.mesh);
  const std::vector<std::uint8_t> is_wrong = wrong.find();
  PassResult result;
  std::vector<Index> operation(is_wrong.size(), kNoIndex);
  for (std::size_t f = 0; f < wrong.patches().of_face.size(); ++f) {
    const Index patch = wrong.patches().of_face[f];
    if (is_wrong[patch] == 0) {
      continue;
    }
    if (operation[patch] == kNoIndex) {
      operation[patch] = result.edits.begin_operation();
    }
    const Index face = input.mesh.cut().side.faces[f];
    result.edits.changed_faces.push_back(
        {operation[patch], face, turned_over(input.draft.soup.triangles[face])});
  }
  return result;
}

}  // namespace meshalyzer
