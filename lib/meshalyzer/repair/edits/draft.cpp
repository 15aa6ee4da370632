#include "meshalyzer/repair/edits/draft.h"

#include <numeric>
#include <utility>

namespace meshalyzer {

Draft make_draft(Soup soup) {
  Draft draft;
  draft.n_input_vertices = soup.n_vertices();
  draft.n_input_faces = soup.n_faces();
  draft.vertex_keys.resize(soup.n_vertices());
  draft.face_keys.resize(soup.n_faces());
  std::iota(draft.vertex_keys.begin(), draft.vertex_keys.end(), Index{0});
  std::iota(draft.face_keys.begin(), draft.face_keys.end(), Index{0});
  draft.soup = std::move(soup);
  return draft;
}

}  // namespace meshalyzer
