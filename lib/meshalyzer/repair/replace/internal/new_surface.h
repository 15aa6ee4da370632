#pragma once

#include "meshalyzer/mesh/soup.h"
#include "meshalyzer/repair/edits/edits.h"

#include <span>
#include <vector>

namespace meshalyzer {

/// A surface that takes the place of faces of a soup.
struct NewSurface {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  /// #triangles: the face of the soup that each was made of, or is nearest to.
  std::vector<Index> origins;
};

/// Adds the operation that replaces faces by a surface, and returns its number.
Index replace_faces(const Soup& soup, std::span<const Index> faces, const NewSurface& surface,
                    Edits& edits);

}  // namespace meshalyzer
