#pragma once

#include "meshalyzer/mesh/tri_mesh.h"

#include <cstddef>
#include <iterator>
#include <type_traits>

namespace meshalyzer {

// The one-ring of a vertex: everything that touches it. Seen from the side the normals point to:
//
//          c -------- b            The outgoing half-edges run v -> a, v -> b, v -> c, ...: each
//         / \        / \           has the face of the same number on its left.
//        /   \  2   /   \          To step counter-clockwise from v -> a: the half-edge before it
//       /  3  \    /  1  \         in its face 1 is b -> v, and the opposite of that is v -> b.
//      /       \  /       \        On a border the last outgoing half-edge has no face on its left,
//     d ------- v -------- a       so nothing follows it; it is the one OpenMesh begins with at v.

/// Goes round a vertex counter-clockwise and gives an `Element` at each step: a vertex, a face or
/// an outgoing half-edge.
///
/// The iterator holds two half-edges and the mesh, allocates nothing, and stays valid as long as
/// the connectivity of the mesh is not changed. Elements are handles, returned by value.
template <typename Element>
class OneRingIterator {
 public:
  using iterator_concept = std::forward_iterator_tag;
  // A C++17 forward iterator would have to return references.
  using iterator_category = std::input_iterator_tag;
  using value_type = Element;
  using difference_type = std::ptrdiff_t;
  using pointer = void;
  using reference = Element;

  /// Constructs the end of every ring.
  OneRingIterator() = default;
  /// Starts at the first half-edge of a ring, or at the end if there is none.
  OneRingIterator(const TriMesh& mesh, HalfedgeHandle first)
      : mesh_(&mesh), first_(first), current_(first) {}

  [[nodiscard]] Element operator*() const {
    if constexpr (std::is_same_v<Element, VertexHandle>) {
      return mesh_->to_vertex_handle(current_);
    } else if constexpr (std::is_same_v<Element, FaceHandle>) {
      return mesh_->face_handle(current_);
    } else {
      return current_;
    }
  }

  OneRingIterator& operator++() {
    current_ = following();
    return *this;
  }
  OneRingIterator operator++(int) {
    const OneRingIterator before = *this;
    ++*this;
    return before;
  }

  /// Compares two iterators of one ring.
  [[nodiscard]] friend bool operator==(const OneRingIterator& a, const OneRingIterator& b) {
    return a.current_ == b.current_;
  }

 private:
  /// Returns the next outgoing half-edge, or an invalid one at the end.
  [[nodiscard]] HalfedgeHandle following() const {
    if (mesh_->is_boundary(current_)) {
      return HalfedgeHandle();
    }
    const HalfedgeHandle next =
        mesh_->opposite_halfedge_handle(mesh_->prev_halfedge_handle(current_));
    const bool has_element = !std::is_same_v<Element, FaceHandle> || !mesh_->is_boundary(next);
    return next != first_ && has_element ? next : HalfedgeHandle();
  }

  const TriMesh* mesh_ = nullptr;
  HalfedgeHandle first_;
  HalfedgeHandle current_;
};

/// The ring round a vertex as a forward range. It only refers to the mesh.
template <typename Element>
class OneRing {
 public:
  OneRing(const TriMesh& mesh, VertexHandle v) : begin_(mesh, first(mesh, v)) {}

  [[nodiscard]] OneRingIterator<Element> begin() const { return begin_; }
  [[nodiscard]] OneRingIterator<Element> end() const { return {}; }
  [[nodiscard]] bool empty() const { return begin() == end(); }

 private:
  /// Returns the half-edge with which the ring begins. If the vertex lies on a border, its own
  /// half-edge runs along the border and is the last of the fan; a step over the gap leads to the
  /// first.
  static HalfedgeHandle first(const TriMesh& mesh, VertexHandle v) {
    const HalfedgeHandle h = mesh.halfedge_handle(v);
    return h.is_valid() && mesh.is_boundary(h)
               ? mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(h))
               : h;
  }

  OneRingIterator<Element> begin_;
};

/// Returns the half-edges that leave a vertex, counter-clockwise seen from the side its normals
/// point to.
///
/// An inner vertex with n faces has n half-edges, beginning with any of them. A border vertex has n
/// + 1, from the clockwise-most edge to the last, whose half-edge is the only one without a face.
/// An isolated vertex has none.
///
///     for (const HalfedgeHandle h : one_ring_halfedges(mesh, v)) { ... }
///
/// A mesh vertex has one fan: if a vertex of the file has several, its copies have the others (see
/// SideTable).
[[nodiscard]] inline OneRing<HalfedgeHandle> one_ring_halfedges(const TriMesh& mesh,
                                                                VertexHandle v) {
  return {mesh, v};
}

/// Returns the neighbours of a vertex: the far ends of one_ring_halfedges(), in the same order.
[[nodiscard]] inline OneRing<VertexHandle> one_ring_vertices(const TriMesh& mesh, VertexHandle v) {
  return {mesh, v};
}

/// Returns the n faces round a vertex: those on the left of one_ring_halfedges(), in the same
/// order.
[[nodiscard]] inline OneRing<FaceHandle> one_ring_faces(const TriMesh& mesh, VertexHandle v) {
  return {mesh, v};
}

}  // namespace meshalyzer
