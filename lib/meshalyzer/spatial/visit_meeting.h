#pragma once

#include "meshalyzer/spatial/face_tree.h"
#include "meshalyzer/spatial/tree_width.h"

#include <bit>
#include <cstddef>

namespace meshalyzer {

/// Does the work of visit_meeting() for the faces below FaceTree::node(level, i).
template <typename Visit>
bool visit_meeting_below(const FaceTree& tree, std::size_t level, std::size_t i, const TreeBox& box,
                         const Visit& visit) {
  for (unsigned bits = tree.node(level, i).meeting(box); bits != 0; bits &= bits - 1) {
    const std::size_t child = kTreeWidth * i + static_cast<std::size_t>(std::countr_zero(bits));
    const bool goes_on =
        level == 0 ? visit(child) : visit_meeting_below(tree, level - 1, child, box, visit);
    if (!goes_on) return false;
  }
  return true;
}

/// Calls `visit` with the slot of each face of a tree whose box meets a box, ascending, until it
/// returns false.
///
/// @param box   A box in the tree's coordinates, bounded along at least one axis.
/// @return      False if `visit` has returned false.
/// @complexity  O(log #F + found) for boxes that are spread out.
template <typename Visit>
bool visit_meeting(const FaceTree& tree, const TreeBox& box, const Visit& visit) {
  return tree.n_faces() == 0 || visit_meeting_below(tree, tree.n_levels() - 1, 0, box, visit);
}

}  // namespace meshalyzer
