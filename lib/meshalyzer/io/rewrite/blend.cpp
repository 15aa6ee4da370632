#include "meshalyzer/io/rewrite/blend.h"

#include <algorithm>
#include <cstddef>

namespace meshalyzer {
namespace {

using Relation = ElementOrigin::Relation;

/// Returns the weights of the corners at the point of a triangle that is nearest to a place
/// (Ericson, Real-Time Collision Detection, 5.1.5).
std::array<double, 3> nearest_weights(const Vec3& p, const Corners& t) {
  const Vec3 ab = t[1] - t[0];
  const Vec3 ac = t[2] - t[0];
  const std::array<double, 3> along_ab = {ab.dot(p - t[0]), ab.dot(p - t[1]), ab.dot(p - t[2])};
  const std::array<double, 3> along_ac = {ac.dot(p - t[0]), ac.dot(p - t[1]), ac.dot(p - t[2])};
  if (along_ab[0] <= 0.0 && along_ac[0] <= 0.0) {
    return {1.0, 0.0, 0.0};
  }
  if (along_ab[1] >= 0.0 && along_ac[1] <= along_ab[1]) {
    return {0.0, 1.0, 0.0};
  }
  if (along_ac[2] >= 0.0 && along_ab[2] <= along_ac[2]) {
    return {0.0, 0.0, 1.0};
  }
  const double c = along_ab[0] * along_ac[1] - along_ab[1] * along_ac[0];
  if (c <= 0.0 && along_ab[0] >= 0.0 && along_ab[1] <= 0.0) {
    const double share = along_ab[0] / (along_ab[0] - along_ab[1]);
    return {1.0 - share, share, 0.0};
  }
  const double b = along_ab[2] * along_ac[0] - along_ab[0] * along_ac[2];
  if (b <= 0.0 && along_ac[0] >= 0.0 && along_ac[2] <= 0.0) {
    const double share = along_ac[0] / (along_ac[0] - along_ac[2]);
    return {1.0 - share, 0.0, share};
  }
  const double a = along_ab[1] * along_ac[2] - along_ab[2] * along_ac[1];
  const double to_c = along_ac[1] - along_ab[1];
  const double to_b = along_ab[2] - along_ac[2];
  if (a <= 0.0 && to_c >= 0.0 && to_b >= 0.0) {
    const double share = to_c / (to_c + to_b);
    return {0.0, 1.0 - share, share};
  }
  return {a / (a + b + c), b / (a + b + c), c / (a + b + c)};
}

/// Finds the blends of added vertices, first of those that lie on a face of the source.
class VertexBlender {
 public:
  explicit VertexBlender(const EditedMesh& mesh)
      : mesh_(mesh),
        n_old_(static_cast<std::size_t>(
            std::find_if(mesh.vertices.begin(), mesh.vertices.end(),
                         [](const ElementOrigin& o) { return o.relation != Relation::Same; }) -
            mesh.vertices.begin())),
        blends_(mesh.vertices.size() - n_old_) {}

  std::vector<Blend> find() {
    for (std::size_t i = 0; i < blends_.size(); ++i) {
      const Index copied = mesh_.vertices[n_old_ + i].record;
      if (copied != kNoIndex) {
        blends_[i] = single_blend(copied);
      }
    }
    if (!blends_.empty()) {
      blend_on_faces();
      while (spread()) {
      }
    }
    return std::move(blends_);
  }

 private:
  void blend_on_faces() {
    for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
      const Index model = model_of(mesh_.faces[f]);
      if (model == kNoIndex || !has_all_corners(mesh_.source.triangles[model])) {
        continue;
      }
      for (const Index v : mesh_.soup.triangles[f]) {
        if (v != kNoIndex && v >= n_old_ && blends_[v - n_old_].is_empty()) {
          blends_[v - n_old_] = blend_at(mesh_.soup.positions[v], corners_of(mesh_.source, model),
                                         mesh_.source.triangles[model]);
        }
      }
    }
  }

  /// Gives vertices without a blend that of a neighbour. Returns true if any got one.
  bool spread() {
    bool has_spread = false;
    for (const Triangle& t : mesh_.soup.triangles) {
      const auto* const known = std::find_if(t.begin(), t.end(), [&](Index v) { return knows(v); });
      for (const Index v : t) {
        if (known != t.end() && v != kNoIndex && !knows(v)) {
          blends_[v - n_old_] = single_blend(main_of(*known));
          has_spread = true;
        }
      }
    }
    return has_spread;
  }

  [[nodiscard]] bool knows(Index v) const {
    return v != kNoIndex && (v < n_old_ || !blends_[v - n_old_].is_empty());
  }
  [[nodiscard]] Index main_of(Index v) const {
    return v < n_old_ ? mesh_.vertices[v].record : blends_[v - n_old_].main_item();
  }

  const EditedMesh& mesh_;
  std::size_t n_old_;
  std::vector<Blend> blends_;
};

}  // namespace

Index model_of(const ElementOrigin& origin) {
  const bool has_model = origin.relation == Relation::Same || origin.relation == Relation::MadeOf;
  return has_model ? origin.record : kNoIndex;
}

Index Blend::main_item() const {
  const auto* const largest = std::max_element(weights.begin(), weights.end());
  return items[static_cast<std::size_t>(largest - weights.begin())];
}

Blend single_blend(Index item) {
  Blend blend;
  blend.items[0] = item;
  blend.weights[0] = 1.0;
  return blend;
}

Blend blend_at(const Vec3& place, const Corners& corners, const std::array<Index, 3>& items) {
  const std::array<double, 3> weights = nearest_weights(place, corners);
  Blend blend;
  std::size_t n = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    // The weights are NaN if all corners nearly coincide.
    if (weights[k] > 0.0) {
      blend.items[n] = items[k];
      blend.weights[n++] = weights[k];
    }
  }
  return n == 0 ? single_blend(items[0]) : blend;
}

std::vector<Blend> added_vertex_blends(const EditedMesh& mesh) {
  return VertexBlender(mesh).find();
}

}  // namespace meshalyzer
