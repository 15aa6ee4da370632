#include "meshalyzer/set/edge_neighbourhood.h"

#include <limits>

namespace meshalyzer {
namespace {

constexpr double kUnreached = std::numeric_limits<double>::infinity();

}  // namespace

ItemsByGroup slots_by_vertex(const FaceTree& tree, std::size_t n_file_vertices) {
  return ItemsByGroup(n_file_vertices, [&](const auto& use) {
    for (std::size_t slot = 0; slot < tree.n_faces(); ++slot) {
      for (const Index v : tree.triangle(slot)) use(v, static_cast<Index>(slot));
    }
  });
}

EdgeNeighbourhood::EdgeNeighbourhood(const FaceTree& tree, const ItemsByGroup& slots)
    : tree_(tree),
      slots_(slots),
      length_to_(slots.size(), kUnreached),
      is_marked_(tree.n_faces(), 0) {}

std::span<const std::uint8_t> EdgeNeighbourhood::mark_within(Index file_vertex, double length) {
  reset();
  reach(file_vertex, 0.0);
  while (!next_.empty()) {
    const auto [so_far, vertex] = next_.top();
    next_.pop();
    // Otherwise a shorter path was found after this one was queued.
    if (so_far == length_to_[vertex]) {
      go_on_from(vertex, length);
    }
  }
  return is_marked_;
}

void EdgeNeighbourhood::go_on_from(Index vertex, double length_limit) {
  for (const Index slot : slots_[vertex]) {
    is_marked_[tree_.mesh_face(slot)] = 1;
    for (const Index other : tree_.triangle(slot)) {
      const double length = length_to_[vertex] + (tree_.point(other) - tree_.point(vertex)).norm();
      if (length <= length_limit && length < length_to_[other]) {
        reach(other, length);
      }
    }
  }
}

void EdgeNeighbourhood::reset() {
  for (const Index vertex : reached_) {
    length_to_[vertex] = kUnreached;
    for (const Index slot : slots_[vertex]) {
      is_marked_[tree_.mesh_face(slot)] = 0;
    }
  }
  reached_.clear();
}

void EdgeNeighbourhood::reach(Index vertex, double length) {
  if (length_to_[vertex] == kUnreached) {
    reached_.push_back(vertex);
  }
  length_to_[vertex] = length;
  next_.emplace(length, vertex);
}

}  // namespace meshalyzer
