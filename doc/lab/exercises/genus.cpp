#include "genus.h"

#include <stdexcept>

namespace lab {

std::optional<int> genus_of_closed_shell(int /*n_vertices*/, int /*n_edges*/, int /*n_faces*/) {
  // In C++, 1 / 2 is 0: look whether the division leaves a rest before you divide.
  throw std::logic_error("not done yet: exercise 6 a");
}

int euler_number(const TriMesh& /*mesh*/) {
  // mesh.n_vertices() counts orphans too; mesh.is_isolated(vertex) knows them.
  throw std::logic_error("not done yet: exercise 6 b");
}

int n_boundaries(const TriMesh& /*mesh*/) {
  // Take a half-edge without a face that you have not been at, and follow next till you are back.
  throw std::logic_error("not done yet: exercise 6 c");
}

int n_components(const TriMesh& /*mesh*/) {
  // Paint: from a vertex that has no paint, paint all that can be reached along edges. An orphan
  // is no component.
  throw std::logic_error("not done yet: exercise 6 d");
}

int genus(const TriMesh& /*mesh*/) {
  // Each component keeps V - E + F = 2 - 2 genus - boundaries. Add these up over the components.
  throw std::logic_error("not done yet: exercise 6 e");
}

}  // namespace lab
