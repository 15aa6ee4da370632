#include "meshalyzer/base/items_by_group.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/prepared/shells.h"
#include "meshalyzer/repair/edits/internal/turned_face.h"
#include "meshalyzer/repair/orient/internal/side_votes.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/spatial/box_tree.h"
#include "meshalyzer/spatial/ray_parity.h"
#include "meshalyzer/topology/components.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The role of a region in a vote on the orientation of regions.
enum class RegionRole : std::uint8_t {
  /// The region is closed, and its orientation is known otherwise.
  Shell,
  /// The faces of the region vote.
  Voter,
  /// The region takes no part.
  None,
};

/// The input of vote_outward(). This holds references only.
struct OutwardQuery {
  const PassInput& input;
  /// The regions as find_oriented_regions() returns them.
  const Components& regions;
  /// #regions.
  std::span<const RegionRole> roles;
};

/// A point is inside or outside if its winding number is no farther than this from an integer.
constexpr double kSure = 0.25;

/// A region whose faces vote.
struct Voter {
  Index region = 0;
  SideVotes votes;
  std::vector<SurfaceSample> samples;
  /// Null if the region bounds no solid, so that nothing is inside it.
  std::unique_ptr<WindingNumbers> surface;
  Box3 box;
};

Voter make_voter(Index region, std::vector<Corners> triangles) {
  Voter voter{.region = region, .votes = {}, .samples = {}, .surface = nullptr, .box = {}};
  for (const Corners& t : triangles) voter.box.extend(box_of(t));
  voter.samples = sample_surface(triangles);
  auto surface = std::make_unique<WindingNumbers>(std::move(triangles));
  voter.votes = count_votes(*surface, voter.samples);
  if (voter.votes.bounds_solid()) voter.surface = std::move(surface);
  return voter;
}

std::vector<Voter> collect_voters(const OutwardQuery& query) {
  std::vector<Voter> voters;
  if (std::find(query.roles.begin(), query.roles.end(), RegionRole::Voter) == query.roles.end()) {
    return voters;
  }
  for (Index region = 0; region < query.regions.count; ++region) {
    if (query.roles[region] == RegionRole::Voter) {
      voters.push_back({.region = region, .votes = {}, .samples = {}, .surface = {}, .box = {}});
    }
  }
  const ItemsByGroup faces(query.regions.of_face, query.regions.count);
  parallel_chunks(voters.size(), 1, [&](Chunk chunk) {
    if (query.input.wants_to_stop()) return;
    Voter& voter = voters[chunk.begin];
    std::vector<Corners> triangles;
    triangles.reserve(faces[voter.region].size());
    for (const Index f : faces[voter.region]) {
      triangles.push_back(
          corners_of(query.input.mesh.soup(), query.input.mesh.cut().side.faces[f]));
    }
    voter = make_voter(voter.region, std::move(triangles));
  });
  return voters;
}

/// A region that a point may be inside of.
struct Around {
  Index region = 0;
  /// False if the point is on the region, or too near to it to tell.
  bool is_sure = false;
};

/// The regions that may enclose another one: voters that bound a solid, and shells.
class EncloserSearch {
 public:
  EncloserSearch(const OutwardQuery& query, std::span<const Voter> voters)
      : tree_(query.input.mesh.tree()),
        voters_(voters),
        boxes_(boxes_of(voters)),
        shells_(query.regions.of_face),
        n_regions_(query.regions.count) {
    for (Index& region : shells_) {
      region = query.roles[region] == RegionRole::Shell ? region : kNoIndex;
    }
    has_shells_ = std::any_of(shells_.begin(), shells_.end(),
                              [](Index region) { return region != kNoIndex; });
  }

  /// Returns the regions that a voter is inside of according to its samples: some samples are
  /// inside, and none is outside.
  [[nodiscard]] std::vector<Index> enclosers(const Voter& voter) const {
    std::vector<Around> candidates = around(voter, voter.samples.front().point);
    for (std::size_t i = 1; i < voter.samples.size() && !candidates.empty(); ++i) {
      keep_common(around(voter, voter.samples[i].point), candidates);
    }
    std::vector<Index> regions;
    for (const Around& candidate : candidates) {
      if (candidate.is_sure) regions.push_back(candidate.region);
    }
    return regions;
  }

 private:
  static std::vector<Box3> boxes_of(std::span<const Voter> voters) {
    std::vector<Box3> boxes(voters.size());
    for (std::size_t i = 0; i < voters.size(); ++i) {
      boxes[i] = voters[i].surface ? voters[i].box : Box3();
    }
    return boxes;
  }

  /// Returns the regions that another point is not outside of, either; certain if any point was.
  static void keep_common(const std::vector<Around>& others, std::vector<Around>& candidates) {
    std::erase_if(candidates, [&](Around& candidate) {
      const auto same = std::find_if(others.begin(), others.end(), [&](const Around& other) {
        return other.region == candidate.region;
      });
      if (same == others.end()) return true;
      candidate.is_sure = candidate.is_sure || same->is_sure;
      return false;
    });
  }

  [[nodiscard]] std::vector<Around> around(const Voter& voter, const Vec3& point) const {
    std::vector<Around> found;
    for (const Index i : boxes_.meeting(Box3(point))) {
      const Voter& other = voters_[i];
      if (&other == &voter) continue;
      const double winding = std::abs(other.surface->at(point));
      const bool is_sure = std::abs(winding - std::round(winding)) <= kSure;
      if (!is_sure || std::lround(winding) % 2 == 1) {
        found.push_back({other.region, is_sure});
      }
    }
    if (has_shells_) add_shells(point, found);
    return found;
  }

  void add_shells(const Vec3& point, std::vector<Around>& found) const {
    const PointLocation place = locate(tree_, {.of_face = shells_, .count = n_regions_}, point);
    for (const Index region : place.on) {
      if (region != kNoIndex) {
        found.push_back({region, false});
      }
    }
    for (const Index region : place.odd) {
      const bool is_on = std::binary_search(place.on.begin(), place.on.end(), region);
      if (region != kNoIndex && !is_on) {
        found.push_back({region, true});
      }
    }
  }

  const FaceTree& tree_;
  std::span<const Voter> voters_;
  BoxTree boxes_;
  /// #mesh faces: the region of those that are in a shell, else kNoIndex.
  std::vector<Index> shells_;
  std::size_t n_regions_;
  bool has_shells_ = false;
};

/// Patches that cross are not inside each other, even if they cross only slightly.
void drop_crossing(const OutwardQuery& query, std::vector<std::vector<Index>>& enclosers) {
  const SideTable& side = query.input.mesh.cut().side;
  for (const IntersectingPair& pair : query.input.mesh.intersecting_pairs()) {
    if (pair.kind == ContactKind::Crossing) {
      const Index a = query.regions.of_face[side.mesh_face(pair.face_a)];
      const Index b = query.regions.of_face[side.mesh_face(pair.face_b)];
      std::erase(enclosers[a], b);
      std::erase(enclosers[b], a);
    }
  }
}

/// Returns, by region, the regions that each voter with a clear vote is inside of.
std::vector<std::vector<Index>> find_enclosers(const OutwardQuery& query,
                                               const std::vector<Voter>& voters) {
  const EncloserSearch search(query, voters);
  std::vector<std::vector<Index>> enclosers(query.regions.count);
  parallel_chunks(voters.size(), 16, [&](Chunk chunk) {
    if (query.input.wants_to_stop()) return;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      if (voters[i].votes.is_clear()) enclosers[voters[i].region] = search.enclosers(voters[i]);
    }
  });
  if (std::any_of(enclosers.begin(), enclosers.end(), [](const auto& e) { return !e.empty(); })) {
    drop_crossing(query, enclosers);
  }
  return enclosers;
}

/// Finds the regions that are inside out by winding numbers: those that bound a solid, and clearly
/// have it on the wrong side.
///
/// Each region is judged by its own winding number alone, and the number of regions round it does
/// not depend on their orientations: so all of them or some may be turned at once, and a second run
/// turns none. A region inside an odd number of others, none of which it crosses, is the wall of a
/// cavity.
///
/// @return #regions: 1 for those to be turned.
std::vector<std::uint8_t> vote_outward(const OutwardQuery& query) {
  std::vector<std::uint8_t> is_wrong(query.regions.count, 0);
  const std::vector<Voter> voters = collect_voters(query);
  if (voters.empty()) return is_wrong;
  const std::vector<std::vector<Index>> enclosers = find_enclosers(query, voters);
  for (const Voter& voter : voters) {
    if (voter.votes.is_clear()) {
      const bool is_cavity = enclosers[voter.region].size() % 2 == 1;
      is_wrong[voter.region] = voter.votes.is_outward() == is_cavity ? 1 : 0;
    }
  }
  return is_wrong;
}

/// Two components, the lower first.
using ComponentPair = std::pair<Index, Index>;

/// Returns the pairs of components some of whose faces lie on each other, ascending; nothing if no
/// component is inside another.
std::vector<ComponentPair> components_on_each_other(const PreparedMesh& mesh) {
  const std::vector<Shell>& shells = mesh.shells();
  if (std::none_of(shells.begin(), shells.end(),
                   [](const Shell& shell) { return shell.inside != kNoIndex; })) {
    return {};
  }
  const SideTable& side = mesh.cut().side;
  const std::vector<Index>& component_of = mesh.components().of_face;
  std::vector<ComponentPair> found;
  for (const IntersectingPair& pair : mesh.intersecting_pairs()) {
    if (pair.kind != ContactKind::CoplanarOverlap && pair.kind != ContactKind::Duplicate) continue;
    const Index a = component_of[side.mesh_face(pair.face_a)];
    const Index b = component_of[side.mesh_face(pair.face_b)];
    if (a != b) found.push_back(std::minmax(a, b));
  }
  sort_unique(found);
  return found;
}

/// Finds the regions that are inside out. A region with a flipped edge is left, because the region
/// beyond that edge would have to be turned with it.
class WrongRegions {
 public:
  explicit WrongRegions(const PassInput& input)
      : input_(input),
        regions_(find_oriented_regions(input.mesh.cut())),
        component_(regions_.count),
        roles_(regions_.count),
        on_each_other_(components_on_each_other(input.mesh)) {
    const CutMesh& cut = input.mesh.cut();
    const Components& components = input.mesh.components();
    const std::vector<std::uint8_t> is_shell = which_are_shells(cut, components);
    for (std::size_t f = 0; f < regions_.of_face.size(); ++f) {
      const Index component = components.of_face[f];
      component_[regions_.of_face[f]] = component;
      roles_[regions_.of_face[f]] =
          is_shell[component] != 0 ? RegionRole::Shell : RegionRole::Voter;
    }
    for (const HalfedgeHandle h : cut.side.flipped_edges.halfedges) {
      const auto face = static_cast<std::size_t>(cut.mesh.face_handle(h).idx());
      roles_[regions_.of_face[face]] = RegionRole::None;
    }
  }

  [[nodiscard]] const Components& regions() const { return regions_; }

  /// #regions: 1 for those to be turned. A shell is one region, and all of its component.
  [[nodiscard]] std::vector<std::uint8_t> find() const {
    std::vector<std::uint8_t> is_wrong =
        vote_outward({.input = input_, .regions = regions_, .roles = roles_});
    for (std::size_t p = 0; p < regions_.count; ++p) {
      if (roles_[p] == RegionRole::Shell) is_wrong[p] = is_wrong_shell(component_[p]) ? 1 : 0;
    }
    return is_wrong;
  }

 private:
  /// A shell that lies on the one round it, face on face, is turned with that one. No wall of a
  /// cavity does so: the two are solids that overlap if they face the same way, else a solid and a
  /// hole in it.
  [[nodiscard]] bool is_wrong_shell(Index component) const {
    const Shell& shell = input_.mesh.shells()[component];
    const bool is_on_encloser =
        shell.inside != kNoIndex &&
        std::binary_search(on_each_other_.begin(), on_each_other_.end(),
                           ComponentPair(std::minmax(component, shell.inside)));
    if (is_on_encloser) return is_wrong_shell(shell.inside);
    return !shell.outward.value_or(true);
  }

  const PassInput& input_;
  Components regions_;
  /// The component and the role of each region.
  std::vector<Index> component_;
  std::vector<RegionRole> roles_;
  /// See components_on_each_other().
  std::vector<ComponentPair> on_each_other_;
};

}  // namespace

PassResult orient_outward(const PassInput& input) {
  const WrongRegions wrong(input);
  const std::vector<std::uint8_t> is_wrong = wrong.find();
  PassResult result;
  std::vector<Index> operation(is_wrong.size(), kNoIndex);
  for (std::size_t f = 0; f < wrong.regions().of_face.size(); ++f) {
    const Index region = wrong.regions().of_face[f];
    if (is_wrong[region] == 0) continue;
    if (operation[region] == kNoIndex) operation[region] = result.edits.begin_operation();
    const Index face = input.mesh.cut().side.faces[f];
    result.edits.changed_faces.push_back(turned_face(input.tracked.soup, operation[region], face));
  }
  return result;
}

}  // namespace meshalyzer
