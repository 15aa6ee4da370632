#include "meshalyzer/repair/driver/internal/changed_places.h"

#include "meshalyzer/base/sort_unique.h"

#include <algorithm>

namespace meshalyzer {

Box3 box_of_face(const Soup& soup, Index face) {
  Box3 box;
  for (const Index v : soup.triangles[face]) {
    if (v != kNoIndex) box.extend(soup.positions[v]);
  }
  return box;
}

ChangedPlaces::ChangedPlaces(const TrackedMesh& before, const AffectedElements& affected)
    : changed_(find_changed(before, affected)), tree_(changed_.boxes) {
  on_origins_.reserve(affected.faces_before.size());
  for (const AffectedElement& entry : affected.faces_before) {
    on_origins_.push_back({before.origin_of_key(entry.key), entry.operation});
  }
  sort_unique(on_origins_);
}

ChangedPlaces::Changed ChangedPlaces::find_changed(const TrackedMesh& before,
                                                   const AffectedElements& affected) {
  Changed changed;
  for (Index face = 0; face < before.soup.n_faces(); ++face) {
    for (const AffectedElement& entry :
         operations_on(affected.faces_before, before.face_keys[face])) {
      changed.boxes.push_back(box_of_face(before.soup, face));
      changed.operations.push_back(entry.operation);
    }
  }
  return changed;
}

std::vector<Index> ChangedPlaces::on(Index input_face) const {
  std::vector<Index> operations;
  for (auto entry =
           std::lower_bound(on_origins_.begin(), on_origins_.end(), OnOrigin{input_face, 0});
       entry != on_origins_.end() && (*entry)[0] == input_face; ++entry) {
    operations.push_back((*entry)[1]);
  }
  return operations;
}

std::vector<Index> ChangedPlaces::near(const Box3& box) const {
  std::vector<Index> operations;
  for (const Index i : tree_.meeting(box)) operations.push_back(changed_.operations[i]);
  sort_unique(operations);
  return operations;
}

}  // namespace meshalyzer
