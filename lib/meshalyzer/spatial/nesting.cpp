#include "meshalyzer/spatial/nesting.h"

#include "meshalyzer/base/items_by_group.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/spatial/box_tree.h"
#include "meshalyzer/spatial/ray_parity.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {
namespace {

/// Returns the slots of the tree by part.
ItemsByGroup group_slots(const FaceTree& tree, const FaceParts& parts) {
  return ItemsByGroup(parts.count, [&](const auto& use) {
    for (std::size_t slot = 0; slot < tree.n_faces(); ++slot) {
      use(parts.of_face[tree.mesh_face(slot)], static_cast<Index>(slot));
    }
  });
}

/// Returns the boxes of the closed parts, and empty boxes for the others.
std::vector<Box3> closed_only(const NestingInput& input) {
  std::vector<Box3> boxes(input.boxes.begin(), input.boxes.end());
  for (std::size_t part = 0; part < boxes.size(); ++part) {
    if (input.is_closed[part] == 0) boxes[part].setEmpty();
  }
  return boxes;
}

/// The relations of a part that touches another without crossing it.
struct TouchingPart {
  Index part = 0;
  bool seen_inside = false;
  bool seen_outside = false;

  [[nodiscard]] bool is_seen() const { return seen_inside || seen_outside; }
};

/// Returns the middle of a segment, unless rounding moves it off the segment.
std::optional<Vec3> exact_middle(const Vec3& a, const Vec3& b) {
  const Vec3 middle = a / 2 + b / 2;
  if (!are_collinear(a, b, middle)) return std::nullopt;
  return middle;
}

/// Returns points of a triangle, exactly on it: the middles of its edges, and one within.
std::vector<Vec3> middles_of(const Corners& t) {
  std::vector<Vec3> middles;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::optional<Vec3> of_edge = exact_middle(t[k], t[(k + 1) % 3]);
    if (!of_edge) continue;
    middles.push_back(*of_edge);
    const std::optional<Vec3> within = exact_middle(*of_edge, t[(k + 2) % 3]);
    if (within) middles.push_back(*within);
  }
  return middles;
}

bool contains(const std::vector<Index>& sorted, Index x) {
  return std::binary_search(sorted.begin(), sorted.end(), x);
}

class Nester {
 public:
  Nester(const FaceTree& tree, const NestingInput& input)
      : tree_(tree),
        input_(input),
        slots_(group_slots(tree, input.parts)),
        box_tree_(closed_only(input)),
        contacts_(input.parts.count) {
    for (const PartContact& contact : input.contacts) {
      contacts_[contact.a].push_back({contact.b, contact.crosses});
      contacts_[contact.b].push_back({contact.a, contact.crosses});
    }
  }

  /// Returns the closed parts that enclose a part, ascending.
  [[nodiscard]] std::vector<Index> enclosers(Index part) const {
    const Vec3& first = tree_.point(tree_.triangle(slots_[part].front())[0]);
    std::vector<Index> near = box_tree_.meeting(Box3(first));
    std::erase_if(near, [&](Index other) {
      return other == part || !input_.boxes[other].contains(input_.boxes[part]);
    });
    if (near.empty()) {
      return {};  // this is the usual case in a crowd of separate parts and saves a ray through all
                  // of it
    }
    std::vector<Index> found = locate(tree_, input_.parts, first, far_x(near)).odd;
    std::erase_if(found,
                  [&](Index other) { return !contains(near, other) || touches(part, other); });
    for (const TouchingPart& other : look_at_touching(part)) {
      if (other.seen_inside && !other.seen_outside) {
        found.push_back(other.part);
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  struct Contact {
    Index part;
    bool crosses;
  };

  [[nodiscard]] bool is_closed(Index part) const { return input_.is_closed[part] != 0; }

  /// Returns the x at which a ray that locates a point relative to these parts may end.
  [[nodiscard]] double far_x(const std::vector<Index>& parts) const {
    double far = -std::numeric_limits<double>::infinity();
    for (const Index part : parts) {
      far = std::max(far, input_.boxes[part].max().x());
    }
    return far;
  }

  [[nodiscard]] bool touches(Index part, Index other) const {
    const auto found = std::lower_bound(
        contacts_[part].begin(), contacts_[part].end(), other,
        [](const Contact& contact, Index wanted) { return contact.part < wanted; });
    return found != contacts_[part].end() && found->part == other;
  }

  /// Locates a part relative to the closed parts that it touches without crossing: its vertices,
  /// and relative to those that all vertices lie on, its middles too.
  [[nodiscard]] std::vector<TouchingPart> look_at_touching(Index part) const {
    std::vector<TouchingPart> others;
    std::vector<Index> parts;
    for (const Contact& contact : contacts_[part]) {
      if (!contact.crosses && is_closed(contact.part)) {
        others.push_back({.part = contact.part});
        parts.push_back(contact.part);
      }
    }
    if (others.empty()) {
      return others;
    }
    const double far = far_x(parts);
    for (const Index vertex : vertices_of(part)) look_from(tree_.point(vertex), far, others);
    const auto unseen = std::stable_partition(
        others.begin(), others.end(), [](const TouchingPart& other) { return other.is_seen(); });
    const std::span<TouchingPart> rest(unseen, others.end());
    if (rest.empty()) return others;
    for (const Index slot : slots_[part]) {
      for (const Vec3& point : middles_of(tree_.corners(slot))) look_from(point, far, rest);
    }
    return others;
  }

  /// Notes on which side of other parts a point is, unless it is on them.
  ///
  /// @param far  The far_x() of these parts, or more.
  void look_from(const Vec3& point, double far, std::span<TouchingPart> others) const {
    const PointLocation place = locate(tree_, input_.parts, point, far);
    for (TouchingPart& other : others) {
      if (!contains(place.on, other.part)) {
        (contains(place.odd, other.part) ? other.seen_inside : other.seen_outside) = true;
      }
    }
  }

  [[nodiscard]] std::vector<Index> vertices_of(Index part) const {
    std::vector<Index> vertices;
    for (const Index slot : slots_[part]) {
      const Triangle& t = tree_.triangle(slot);
      vertices.insert(vertices.end(), t.begin(), t.end());
    }
    sort_unique(vertices);
    return vertices;
  }

  const FaceTree& tree_;
  const NestingInput& input_;
  ItemsByGroup slots_;
  BoxTree box_tree_;
  /// The contacts of each part, ascending because NestingInput::contacts is.
  std::vector<std::vector<Contact>> contacts_;
};

}  // namespace

Nesting find_nesting(const FaceTree& tree, const NestingInput& input) {
  const std::size_t n = input.parts.count;
  Nesting nesting{std::vector<Index>(n, 0), std::vector<Index>(n, kNoIndex)};
  const auto n_closed =
      std::count_if(input.is_closed.begin(), input.is_closed.end(), [](auto c) { return c != 0; });
  if (n < 2 || n_closed == 0) {
    return nesting;
  }
  const Nester nester(tree, input);
  std::vector<std::vector<Index>> enclosers(n);
  parallel_chunks(n, 16, [&](Chunk chunk) {
    for (std::size_t part = chunk.begin; part < chunk.end; ++part) {
      enclosers[part] = nester.enclosers(static_cast<Index>(part));
      nesting.depth[part] = static_cast<Index>(enclosers[part].size());
    }
  });
  for (std::size_t part = 0; part < n; ++part) {
    // The innermost of the enclosing parts is itself enclosed by the most parts.
    const auto deepest =
        std::max_element(enclosers[part].begin(), enclosers[part].end(),
                         [&](Index a, Index b) { return nesting.depth[a] < nesting.depth[b]; });
    if (deepest != enclosers[part].end()) {
      nesting.inside[part] = *deepest;
    }
  }
  return nesting;
}

}  // namespace meshalyzer
