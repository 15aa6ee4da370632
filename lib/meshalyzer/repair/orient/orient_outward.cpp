#include "meshalyzer/prepared/shells.h"
#include "meshalyzer/repair/orient/internal/outward_votes.h"
#include "meshalyzer/repair/orient/internal/side_votes.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/topology/components.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meshalyzer {
namespace {

/// Finds the regions that point the wrong way. A region with a flipped edge is left: the region
/// beyond that edge would have to be turned with it.
class WrongRegions {
 public:
  explicit WrongRegions(const PreparedMesh& mesh)
      : mesh_(mesh),
        regions_(find_oriented_regions(mesh.cut())),
        component_(regions_.count),
        roles_(regions_.count) {
    const Components& components = mesh.components();
    const std::vector<std::uint8_t> is_shell = which_are_shells(mesh.cut(), components);
    for (std::size_t f = 0; f < regions_.of_face.size(); ++f) {
      const Index component = components.of_face[f];
      component_[regions_.of_face[f]] = component;
      roles_[regions_.of_face[f]] =
          is_shell[component] != 0 ? RegionRole::Shell : RegionRole::Voter;
    }
    for (const HalfedgeHandle h : mesh.cut().side.flipped_edges.halfedges) {
      const auto face = static_cast<std::size_t>(mesh.cut().mesh.face_handle(h).idx());
      roles_[regions_.of_face[face]] = RegionRole::None;
    }
  }

  [[nodiscard]] const Components& regions() const { return regions_; }

  /// #regions: 1 for those to be turned. A shell is one region, and all of its component.
  [[nodiscard]] std::vector<std::uint8_t> find() const {
    std::vector<std::uint8_t> is_wrong =
        vote_outward({.mesh = mesh_, .regions = regions_, .roles = roles_});
    for (std::size_t p = 0; p < regions_.count; ++p) {
      if (roles_[p] == RegionRole::Shell) {
        is_wrong[p] = mesh_.shells()[component_[p]].outward.value_or(true) ? 0 : 1;
      }
    }
    return is_wrong;
  }

 private:
  const PreparedMesh& mesh_;
  Components regions_;
  /// The component and the role of each region.
  std::vector<Index> component_;
  std::vector<RegionRole> roles_;
};

}  // namespace

PassResult orient_outward(const PassInput& input) {
  const WrongRegions wrong(input.mesh);
  const std::vector<std::uint8_t> is_wrong = wrong.find();
  PassResult result;
  std::vector<Index> operation(is_wrong.size(), kNoIndex);
  for (std::size_t f = 0; f < wrong.regions().of_face.size(); ++f) {
    const Index region = wrong.regions().of_face[f];
    if (is_wrong[region] == 0) continue;
    if (operation[region] == kNoIndex) operation[region] = result.edits.begin_operation();
    const Index face = input.mesh.cut().side.faces[f];
    result.edits.changed_faces.push_back(
        {operation[region], face, turned_over(input.tracked.soup.triangles[face])});
  }
  return result;
}

}  // namespace meshalyzer
