#include "meshalyzer/repair/edits/tracked_mesh.h"

#include "meshalyzer/mesh/require_records.h"

#include <numeric>
#include <utility>

namespace meshalyzer {

TrackedMesh track_mesh(Soup soup) {
  require_records(soup);
  TrackedMesh tracked;
  tracked.n_input_vertices = soup.n_vertices();
  tracked.n_input_faces = soup.n_faces();
  tracked.vertex_keys.resize(soup.n_vertices());
  tracked.face_keys.resize(soup.n_faces());
  std::iota(tracked.vertex_keys.begin(), tracked.vertex_keys.end(), Index{0});
  std::iota(tracked.face_keys.begin(), tracked.face_keys.end(), Index{0});
  tracked.soup = std::move(soup);
  return tracked;
}

}  // namespace meshalyzer
