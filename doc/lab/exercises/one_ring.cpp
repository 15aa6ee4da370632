#include "one_ring.h"

#include <stdexcept>

namespace lab {

std::vector<HalfedgeHandle> outgoing_halfedges(const TriMesh& /*mesh*/, VertexHandle /*vertex*/) {
  // From one outgoing half-edge to the next one counter-clockwise: the pair of its previous. Stop
  // when you are back where you began. On the border, where must you begin?
  throw std::logic_error("not done yet: exercise 2 a");
}

std::vector<VertexHandle> one_ring_vertices(const TriMesh& /*mesh*/, VertexHandle /*vertex*/) {
  throw std::logic_error("not done yet: exercise 2 b");
}

std::vector<FaceHandle> one_ring_faces(const TriMesh& /*mesh*/, VertexHandle /*vertex*/) {
  // The hole beside a border is no face.
  throw std::logic_error("not done yet: exercise 2 c");
}

bool is_on_border(const TriMesh& /*mesh*/, VertexHandle /*vertex*/) {
  throw std::logic_error("not done yet: exercise 2 d");
}

}  // namespace lab
