#include "meshalyzer/repair/holes/internal/refine_patch.h"

#include "meshalyzer/base/triangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_map>

namespace meshalyzer {
namespace {

/// The factor by which a patch may become denser than its surroundings: Liepa's alpha.
const double kDensity = std::sqrt(2.0);
/// Each round splits a triangle once at most, which about halves the edges' lengths in two rounds.
constexpr std::size_t kMaxSplitRounds = 40;
constexpr std::size_t kMaxSweeps = 20;

/// Returns the mean length of the mesh's edges at a vertex.
double mean_edge_length(const TriMesh& mesh, VertexHandle v) {
  double sum = 0.0;
  std::size_t n = 0;
  for (const VertexHandle w : mesh.vv_range(v)) {
    sum += (mesh.point(w) - mesh.point(v)).norm();
    ++n;
  }
  return sum / static_cast<double>(n);
}

double area_of(const TriMesh& mesh) {
  double area = 0.0;
  for (const FaceHandle f : mesh.faces()) area += mesh.calc_face_area(f);
  return area;
}

/// The four corners of the two triangles at an edge: its ends, then those opposite, the first on
/// the side of half-edge 0.
struct Diamond {
  VertexHandle a, b, left, right;
};

Diamond diamond_of(const TriMesh& mesh, EdgeHandle e) {
  const HalfedgeHandle h = mesh.halfedge_handle(e, 0);
  const HalfedgeHandle o = mesh.opposite_halfedge_handle(h);
  return {mesh.from_vertex_handle(h), mesh.to_vertex_handle(h),
          mesh.to_vertex_handle(mesh.next_halfedge_handle(h)),
          mesh.to_vertex_handle(mesh.next_halfedge_handle(o))};
}

class Refiner {
 public:
  Refiner(const FillTask& task, std::size_t max_new, WorkingPatch& patch)
      : task_(task), max_new_(max_new), patch_(patch), mesh_(patch.mesh) {}

  void run(const HoleLoop& loop) {
    if (patch_.spacing.empty()) {
      read_spacing(loop);
    } else {
      flip_edges();
    }
    for (std::size_t round = 0; round < kMaxSplitRounds && split_faces(); ++round) flip_edges();
  }

 private:
  [[nodiscard]] double& spacing(VertexHandle v) {
    return patch_.spacing[static_cast<std::size_t>(v.idx())];
  }

  /// Computes the target lengths round the loop, and enlarges them if they would require too many
  /// vertices.
  void read_spacing(const HoleLoop& loop) {
    std::unordered_map<Index, double> length_at;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (!loop.halfedges[i].is_valid()) continue;
      const TriMesh& beyond = task_.mesh.cut().mesh;
      length_at[loop.vertices[i]] =
          mean_edge_length(beyond, beyond.to_vertex_handle(loop.halfedges[i]));
    }
    double mean_square = 0.0;
    for (const Index v : patch_.names) {
      const double length = length_at[v];
      patch_.spacing.push_back(length);
      mean_square += length * length / static_cast<double>(patch_.names.size());
    }
    // A vertex corresponds to two equilateral triangles, each with an area of sqrt(3) / 4 of the
    // squared edge.
    const double n_expected = area_of(mesh_) / (0.5 * std::sqrt(3.0) * mean_square);
    const double excess = n_expected / static_cast<double>(max_new_);
    if (!(excess > 1.0)) return;
    for (double& s : patch_.spacing) s *= std::sqrt(excess);
  }

  /// Inserts a vertex into each triangle that is too large.
  ///
  /// @return Whether there was any.
  bool split_faces() {
    const std::size_t n_faces = mesh_.n_faces();
    const std::size_t n_most = patch_.names.size() + 2 * max_new_;
    bool has_split = false;
    if (task_.wants_to_stop()) return false;
    for (std::size_t i = 0; i < n_faces && mesh_.n_vertices() < n_most; ++i) {
      has_split |= split_if_large(FaceHandle(static_cast<int>(i)));
    }
    return has_split;
  }

  bool split_if_large(FaceHandle face) {
    std::array<VertexHandle, 3> corners;
    std::copy_n(mesh_.cfv_iter(face), 3, corners.begin());
    Vec3 middle = Vec3::Zero();
    double wanted = 0.0;
    for (const VertexHandle v : corners) {
      middle += mesh_.point(v) / 3.0;
      wanted += spacing(v) / 3.0;
    }
    const bool is_large = std::all_of(corners.begin(), corners.end(), [&](VertexHandle v) {
      const double distance = kDensity * (mesh_.point(v) - middle).norm();
      return distance > wanted && distance > spacing(v);
    });
    if (!is_large) return false;
    const VertexHandle added = mesh_.add_vertex(middle);
    mesh_.split(face, added);
    patch_.spacing.push_back(wanted);
    return true;
  }

  void flip_edges() {
    for (std::size_t sweep = 0; sweep < kMaxSweeps && !task_.wants_to_stop(); ++sweep) {
      bool has_flipped = false;
      for (std::size_t i = 0; i < mesh_.n_edges(); ++i) {
        const EdgeHandle e(static_cast<int>(i));
        if (!should_flip(e)) continue;
        mesh_.flip(e);
        has_flipped = true;
      }
      if (!has_flipped) return;
    }
  }

  [[nodiscard]] bool should_flip(EdgeHandle e) const {
    if (mesh_.is_boundary(e)) return false;
    const Diamond d = diamond_of(mesh_, e);
    return opposite_angles_exceed_half_turn(d) && stays_upright(d) && !exists(d) &&
           mesh_.is_flip_ok(e);
  }

  [[nodiscard]] bool opposite_angles_exceed_half_turn(const Diamond& d) const {
    const auto cot = [&](VertexHandle v) {
      const Vec3 to_a = mesh_.point(d.a) - mesh_.point(v);
      const Vec3 to_b = mesh_.point(d.b) - mesh_.point(v);
      return to_a.dot(to_b) / std::max(to_a.cross(to_b).norm(), std::numeric_limits<double>::min());
    };
    // The sine of the sum has the sign of the sum of cotangents. The limit is a little above zero,
    // so that rounding never flips an edge to and fro.
    return cot(d.left) + cot(d.right) < -1e-9;
  }

  /// Tells whether both triangles after a flip face the same side as those before.
  [[nodiscard]] bool stays_upright(const Diamond& d) const {
    const Vec3& a = mesh_.point(d.a);
    const Vec3& b = mesh_.point(d.b);
    const Vec3& left = mesh_.point(d.left);
    const Vec3& right = mesh_.point(d.right);
    const Vec3 before = normal_of(a, b, left) + normal_of(b, a, right);
    return normal_of(right, left, a).dot(before) > 0.0 &&
           normal_of(left, right, b).dot(before) > 0.0;
  }

  /// Tells whether the mesh has the edge that a flip would make.
  [[nodiscard]] bool exists(const Diamond& d) const {
    if (patch_.is_new(d.left) || patch_.is_new(d.right)) return false;
    return task_.existing.contains(patch_.names[static_cast<std::size_t>(d.left.idx())],
                                   patch_.names[static_cast<std::size_t>(d.right.idx())]);
  }

  const FillTask& task_;
  std::size_t max_new_;
  WorkingPatch& patch_;
  TriMesh& mesh_;
};

}  // namespace

void refine_patch(const FillTask& task, const HoleLoop& loop, std::size_t max_new,
                  WorkingPatch& patch) {
  Refiner(task, max_new, patch).run(loop);
}

}  // namespace meshalyzer
