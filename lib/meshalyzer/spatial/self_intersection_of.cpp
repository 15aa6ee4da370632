#include "meshalyzer/spatial/self_intersection_of.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/spatial/faces_near.h"
#include "meshalyzer/spatial/long_face_tree.h"
#include "meshalyzer/spatial/pair_collector.h"
#include "meshalyzer/spatial/self_intersection_search.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace meshalyzer {
namespace {

/// The number of leaves that one task searches.
constexpr std::size_t kMarkedLeavesPerChunk = 1024;

/// A tree over all faces is worth its time if there is a given one for so many of them.
constexpr std::size_t kFacesPerGiven = 16;

/// Returns for each mesh face whether it is one of the given file faces.
std::vector<std::uint8_t> marked(const SideTable& side, std::span<const Index> file_faces) {
  std::vector<std::uint8_t> marks(side.faces.size());
  for (const Index face : file_faces) {
    const std::size_t f = side.mesh_face(face);
    if (f < marks.size() && side.faces[f] == face) {
      marks[f] = 1;
    }
  }
  return marks;
}

/// Returns for each leaf which of its eight faces are marked, as bits.
std::vector<std::uint8_t> lanes_of(const FaceTree& tree, std::span<const std::uint8_t> marks) {
  std::vector<std::uint8_t> lanes(tree.n_leaves());
  parallel_chunks(lanes.size(), kMarkedLeavesPerChunk, [&](Chunk chunk) {
    const std::size_t end = std::min(8 * chunk.end, tree.n_faces());
    for (std::size_t slot = 8 * chunk.begin; slot < end; ++slot) {
      const unsigned bit = unsigned{marks[tree.mesh_face(slot)]} << (slot % 8);
      lanes[slot / 8] = static_cast<std::uint8_t>(lanes[slot / 8] | bit);
    }
  });
  return lanes;
}

}  // namespace

std::vector<IntersectingPair> find_self_intersections_of(const CutMesh& cut, const FaceTree& tree,
                                                         std::span<const Index> faces) {
  return find_self_intersections_of(cut, tree, faces, PairLimits()).listed;
}

FoundPairs find_self_intersections_of(const CutMesh& cut, const FaceTree& tree,
                                      std::span<const Index> faces, const PairLimits& limits) {
  if (tree.n_faces() == 0 || faces.empty()) {
    return {};
  }
  const std::optional<FaceTree> turned =
      is_worth_a_tree(faces.size(), tree.n_faces()) ? turned_for_long_faces(tree) : std::nullopt;
  const FaceTree& searched = turned ? *turned : tree;
  const SlabTree slabs(searched);
  const FanTree fans(searched);
  const std::vector<std::uint8_t> wanted = lanes_of(searched, marked(cut.side, faces));
  PairCollector collector(limits.max_listed);
  const bool is_complete = search_self_intersections(
      {.cut = cut, .tree = searched, .slabs = slabs, .fans = fans, .wanted = wanted}, limits,
      collector);
  FoundPairs found = collector.take();
  found.is_complete = is_complete;
  return found;
}

FoundPairs find_self_intersections_of(const CutMesh& cut, const Soup& soup,
                                      std::span<const Index> faces, const PairLimits& limits) {
  std::vector<Box3> boxes;
  boxes.reserve(faces.size());
  for (const Index face : faces) {
    if (is_in_complex(soup.triangles[face])) boxes.push_back(box_of(corners_of(soup, face)));
  }
  std::vector<Index> near = find_faces_near(soup, boxes);
  for (Index& face : near) face = static_cast<Index>(cut.side.mesh_face(face));
  return find_self_intersections_of(cut, FaceTree(cut, near), faces, limits);
}

bool is_worth_a_tree(std::size_t n_given_faces, std::size_t n_faces) {
  return n_given_faces * kFacesPerGiven >= n_faces;
}

}  // namespace meshalyzer
