#include "meshalyzer/repair/orient/outward_votes.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/repair/orient/side_votes.h"
#include "meshalyzer/spatial/box_tree.h"
#include "meshalyzer/spatial/ray_parity.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

namespace meshalyzer {
namespace {

/// A point is inside or outside where the winding number is no farther than this from a whole one.
constexpr double kSure = 0.25;

/// A patch that is asked.
struct Voter {
  Index patch = 0;
  SideVotes votes;
  std::vector<SurfaceSample> samples;
  /// Nothing where the patch means no solid: nothing is inside it then.
  std::unique_ptr<WindingNumbers> surface;
  Box3 box;
};

Voter make_voter(Index patch, std::vector<Corners> triangles) {
  Voter voter{.patch = patch, .votes = {}, .samples = {}, .surface = nullptr, .box = {}};
  for (const Corners& t : triangles) {
    for (const Vec3& p : t) {
      voter.box.extend(p);
    }
  }
  voter.samples = sample_surface(triangles);
  auto surface = std::make_unique<WindingNumbers>(std::move(triangles));
  voter.votes = count_votes(*surface, voter.samples);
  if (voter.votes.means_solid()) {
    voter.surface = std::move(surface);
  }
  return voter;
}

std::vector<Voter> ask(const OutwardBallot& ballot) {
  std::vector<Voter> voters;
  if (std::find(ballot.roles.begin(), ballot.roles.end(), PatchRole::Voter) == ballot.roles.end()) {
    return voters;
  }
  for (Index patch = 0; patch < ballot.patches.count; ++patch) {
    if (ballot.roles[patch] == PatchRole::Voter) {
      voters.push_back({.patch = patch, .votes = {}, .samples = {}, .surface = {}, .box = {}});
    }
  }
  const FacesByPart faces(ballot.patches.of_face, ballot.patches.count);
  parallel_chunks(voters.size(), 1, [&](Chunk chunk) {
    Voter& voter = voters[chunk.begin];
    std::vector<Corners> triangles;
    triangles.reserve(faces.of(voter.patch).size());
    for (const Index f : faces.of(voter.patch)) {
      triangles.push_back(corners_of(ballot.mesh.soup(), ballot.mesh.cut().side.faces[f]));
    }
    voter = make_voter(voter.patch, std::move(triangles));
  });
  return voters;
}

/// A patch that a point may be inside of.
struct Around {
  Index patch = 0;
  /// False: the point is on it, or as good as on it.
  bool is_sure = false;
};

/// What may be round a patch: voters that mean a solid, and shells.
class EncloserSearch {
 public:
  EncloserSearch(const OutwardBallot& ballot, std::span<const Voter> voters)
      : tree_(ballot.mesh.tree()),
        voters_(voters),
        boxes_(boxes_of(voters)),
        shells_(ballot.patches.of_face),
        n_patches_(ballot.patches.count) {
    for (Index& patch : shells_) {
      patch = ballot.roles[patch] == PatchRole::Shell ? patch : kNoIndex;
    }
    has_shells_ =
        std::any_of(shells_.begin(), shells_.end(), [](Index patch) { return patch != kNoIndex; });
  }

  /// The patches that a voter is inside of as far as its samples tell: some are, and none is
  /// outside.
  [[nodiscard]] std::vector<Index> enclosers(const Voter& voter) const {
    std::vector<Around> candidates = around(voter, voter.samples.front().point);
    for (std::size_t i = 1; i < voter.samples.size() && !candidates.empty(); ++i) {
      keep_common(around(voter, voter.samples[i].point), candidates);
    }
    std::vector<Index> patches;
    for (const Around& candidate : candidates) {
      if (candidate.is_sure) {
        patches.push_back(candidate.patch);
      }
    }
    return patches;
  }

 private:
  static std::vector<Box3> boxes_of(std::span<const Voter> voters) {
    std::vector<Box3> boxes(voters.size());
    for (std::size_t i = 0; i < voters.size(); ++i) {
      boxes[i] = voters[i].surface ? voters[i].box : Box3();
    }
    return boxes;
  }

  /// The patches that another point is not outside of, either; sure where any point was.
  static void keep_common(const std::vector<Around>& others, std::vector<Around>& candidates) {
    std::erase_if(candidates, [&](Around& candidate) {
      const auto same = std::find_if(others.begin(), others.end(), [&](const Around& other) {
        return other.patch == candidate.patch;
      });
      if (same == others.end()) {
        return true;
      }
      candidate.is_sure = candidate.is_sure || same->is_sure;
      return false;
    });
  }

  [[nodiscard]] std::vector<Around> around(const Voter& voter, const Vec3& point) const {
    std::vector<Around> found;
    for (const Index i : boxes_.meeting(Box3(point))) {
      const Voter& other = voters_[i];
      if (&other == &voter) {
        continue;
      }
      const double winding = std::abs(other.surface->at(point));
      const bool is_sure = std::abs(winding - std::round(winding)) <= kSure;
      if (!is_sure || std::lround(winding) % 2 == 1) {
        found.push_back({other.patch, is_sure});
      }
    }
    if (has_shells_) {
      add_shells(point, found);
    }
    return found;
  }

  void add_shells(const Vec3& point, std::vector<Around>& found) const {
    const PointLocation place = locate(tree_, {.of_face = shells_, .count = n_patches_}, point);
    for (const Index patch : place.on) {
      if (patch != kNoIndex) {
        found.push_back({patch, false});
      }
    }
    for (const Index patch : place.odd) {
      const bool is_on = std::binary_search(place.on.begin(), place.on.end(), patch);
      if (patch != kNoIndex && !is_on) {
        found.push_back({patch, true});
      }
    }
  }

  const FaceTree& tree_;
  std::span<const Voter> voters_;
  BoxTree boxes_;
  /// #mesh faces: the patch of those that are in a shell, else kNoIndex.
  std::vector<Index> shells_;
  std::size_t n_patches_;
  bool has_shells_ = false;
};

/// Patches that cross are not inside each other, however little crosses.
void drop_crossing(const OutwardBallot& ballot, std::vector<std::vector<Index>>& enclosers) {
  const SideTable& side = ballot.mesh.cut().side;
  for (const IntersectingPair& pair : ballot.mesh.intersecting_pairs()) {
    if (pair.kind == ContactKind::Crossing) {
      const Index a = ballot.patches.of_face[side.mesh_face(pair.face_a)];
      const Index b = ballot.patches.of_face[side.mesh_face(pair.face_b)];
      std::erase(enclosers[a], b);
      std::erase(enclosers[b], a);
    }
  }
}

/// By patch: those that each voter with a clear vote is inside of.
std::vector<std::vector<Index>> find_enclosers(const OutwardBallot& ballot,
                                               const std::vector<Voter>& voters) {
  const EncloserSearch search(ballot, voters);
  std::vector<std::vector<Index>> enclosers(ballot.patches.count);
  parallel_chunks(voters.size(), 16, [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      if (voters[i].votes.is_clear()) {
        enclosers[voters[i].patch] = search.enclosers(voters[i]);
      }
    }
  });
  if (std::any_of(enclosers.begin(), enclosers.end(), [](const auto& e) { return !e.empty(); })) {
    drop_crossing(ballot, enclosers);
  }
  return enclosers;
}

}  // namespace

std::vector<std::uint8_t> vote_outward(const OutwardBallot& ballot) {
  std::vector<std::uint8_t> is_wrong(ballot.patches.count, 0);
  const std::vector<Voter> voters = ask(ballot);
  if (voters.empty()) {
    return is_wrong;
  }
  const std::vector<std::vector<Index>> enclosers = find_enclosers(ballot, voters);
  for (const Voter& voter : voters) {
    if (voter.votes.is_clear()) {
      const bool is_cavity = enclosers[voter.patch].size() % 2 == 1;
      is_wrong[voter.patch] = voter.votes.is_outward() == is_cavity ? 1 : 0;
    }
  }
  return is_wrong;
}

}  // namespace meshalyzer
