#include "meshalyzer/repair/edits/internal/edited_corner_normals.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Finds the normals of the corners of faces, and the list that these refer to.
class CornerNormals {
 public:
  explicit CornerNormals(const FaceModels& models)
      : models_(models), normals_(models.before().normals) {}

  void set(Soup& result) && {
    result.corner_normals.clear();
    result.corner_normals.reserve(models_.triangles().size());
    for (std::size_t f = 0; f < models_.triangles().size(); ++f) {
      Triangle corners = models_.is_old(f)     ? carried_over(f)
                         : models_.is_patch(f) ? kNoTriangle
                                               : of_part(f);
      if (models_.turns_normals(f)) turn(corners);
      result.corner_normals.push_back(corners);
    }
    result.normals = std::move(normals_);
  }

 private:
  /// Returns the normals of an old face: a vertex that stays keeps its normal, as does one that
  /// became another at the same place; any other gets that of the corner that it replaces.
  [[nodiscard]] Triangle carried_over(std::size_t f) const {
    const Index model = models_.model_of(f);
    Triangle result = models_.before().corner_normals[model];
    for (std::size_t k = 0; k < 3; ++k) {
      const Index here = normal_of(model, models_.triangles()[f][k]);
      if (here != kNoIndex) result[k] = here;
    }
    return result;
  }

  /// Returns the normals of an added face: those of its model. A face has normals at all of its
  /// corners or at none.
  Triangle of_part(std::size_t f) {
    const Index model = models_.model_of(f);
    Triangle result = kNoTriangle;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index corner = models_.triangles()[f][k];
      result[k] = normal_of(model, corner);
      if (result[k] != kNoIndex) continue;
      const std::optional<Vec3> normal = models_.normal_at(f, corner);
      if (!normal) return kNoTriangle;
      result[k] = listed(model, *normal);
    }
    return result;
  }

  /// Returns the normal of an old face at the corner that is, or was copied from, a certain vertex,
  /// or else is at its place; kNoIndex if there is none, as for a corner that is missing.
  [[nodiscard]] Index normal_of(Index face, Index vertex) const {
    if (vertex == kNoIndex) return kNoIndex;
    const Soup& before = models_.before();
    const Triangle& t = before.triangles[face];
    const Index old = models_.old_vertex(vertex);
    const auto* found = std::find(t.begin(), t.end(), old);
    if (old == kNoIndex || found == t.end()) {
      found = std::find_if(t.begin(), t.end(), [&](Index v) {
        return v != kNoIndex && before.positions[v] == models_.place_of(vertex);
      });
    }
    return found == t.end()
               ? kNoIndex
               : before.corner_normals[face][static_cast<std::size_t>(found - t.begin())];
  }

  /// Returns the number of a normal on a face, which is most often one of its corners'.
  Index listed(Index model, const Vec3& normal) {
    for (const Index known : models_.before().corner_normals[model]) {
      if (normals_[known] == normal) return known;
    }
    normals_.push_back(normal);
    return static_cast<Index>(normals_.size() - 1);
  }

  void turn(Triangle& corners) {
    for (Index& normal : corners) {
      if (normal == kNoIndex) continue;
      turned_.resize(normals_.size(), kNoIndex);
      const Index old = normal;
      if (turned_[old] == kNoIndex) {
        turned_[old] = static_cast<Index>(normals_.size());
        normals_.emplace_back(-normals_[old]);
      }
      normal = turned_[old];
    }
  }

  const FaceModels& models_;
  std::vector<Vec3> normals_;
  /// By normal: the number of the opposite one; kNoIndex if there is none yet.
  std::vector<Index> turned_;
};

}  // namespace

void set_corner_normals(const FaceModels& models, Soup& result) {
  CornerNormals(models).set(result);
}

}  // namespace meshalyzer
