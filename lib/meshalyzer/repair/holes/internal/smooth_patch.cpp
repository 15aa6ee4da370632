#include "meshalyzer/repair/holes/internal/smooth_patch.h"

#include "meshalyzer/repair/holes/internal/refine_patch.h"
#include "meshalyzer/topology/edges.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The weights are those of the previous surface: they are recomputed this number of times.
constexpr std::size_t kReweightings = 4;
/// Cotangents of the angles of needles are clamped to this range.
constexpr double kLeastWeight = 1e-3;
constexpr double kGreatestWeight = 1e3;
/// A factorisation that certainly takes more multiplications is not made; a patch of 20,000 new
/// vertices with six edges each takes a twentieth of them.
constexpr double kMaxMultiplications = 2e8;

using SparseMatrix = Eigen::SparseMatrix<double>;
using Solver = Eigen::SimplicialLDLT<SparseMatrix>;
using Places = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// A patch together with the faces beyond its loop. New vertices come first, then those of the
/// loop, then others.
struct Surroundings {
  std::vector<Triangle> triangles;
  std::vector<Vec3> points;
  std::size_t n_new = 0;
  std::size_t n_loop = 0;

  /// Returns the number of vertices with all their faces here.
  [[nodiscard]] std::size_t n_whole() const { return n_new + n_loop; }
};

class SurroundingsMaker {
 public:
  SurroundingsMaker(const PreparedMesh& mesh, const WorkingPatch& patch)
      : cut_(mesh.cut()), patch_(patch) {
    result_.n_loop = patch.names.size();
    result_.n_new = patch.mesh.n_vertices() - patch.names.size();
  }

  [[nodiscard]] Surroundings run(const HoleLoop& loop) {
    add_patch();
    std::unordered_set<int> has_face;
    for (const HalfedgeHandle h : loop.halfedges) {
      if (!h.is_valid()) continue;
      for (const FaceHandle f : cut_.mesh.vf_range(cut_.mesh.to_vertex_handle(h))) {
        if (has_face.insert(f.idx()).second) add_face(f);
      }
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] Index number_in_patch(VertexHandle v) const {
    const auto i = static_cast<std::size_t>(v.idx());
    return static_cast<Index>(patch_.is_new(v) ? i - result_.n_loop : i + result_.n_new);
  }

  void add_patch() {
    const TriMesh& mesh = patch_.mesh;
    result_.points.resize(mesh.n_vertices());
    for (const VertexHandle v : mesh.vertices()) {
      const Index i = number_in_patch(v);
      result_.points[i] = mesh.point(v);
      if (!patch_.is_new(v)) numbers_[patch_.names[static_cast<std::size_t>(v.idx())]] = i;
    }
    for (const FaceHandle f : mesh.faces()) {
      Triangle t{};
      std::size_t k = 0;
      for (const VertexHandle v : mesh.fv_range(f)) t[k++] = number_in_patch(v);
      result_.triangles.push_back(t);
    }
  }

  void add_face(FaceHandle f) {
    Triangle t{};
    std::size_t k = 0;
    for (const VertexHandle v : cut_.mesh.fv_range(f)) {
      const auto [at, is_first] =
          numbers_.try_emplace(cut_.side.vertex(v), static_cast<Index>(result_.points.size()));
      if (is_first) result_.points.push_back(cut_.mesh.point(v));
      t[k++] = at->second;
    }
    result_.triangles.push_back(t);
  }

  const CutMesh& cut_;
  const WorkingPatch& patch_;
  Surroundings result_;
  /// File vertex to number.
  std::unordered_map<Index, Index> numbers_;
};

/// Translates and scales the points so that the loop has a size of about 1 at the origin.
struct Frame {
  Vec3 centre;
  double size = 1.0;

  explicit Frame(const Surroundings& all) {
    Box3 box;
    for (std::size_t i = all.n_new; i < all.n_whole(); ++i) box.extend(all.points[i]);
    centre = 0.5 * box.min() + 0.5 * box.max();
    size = (0.5 * box.max() - 0.5 * box.min()).stableNorm();
  }
  [[nodiscard]] bool is_usable() const { return centre.allFinite() && size > 0.0; }
  [[nodiscard]] Vec3 into(const Vec3& p) const { return (p - centre) / size; }
  [[nodiscard]] Vec3 out_of(const Vec3& p) const { return p * size + centre; }
};

/// Returns the Laplacian of all vertices with all their faces, by row, each divided by the root of
/// the vertex's area: the squares of its values add up to the energy.
SparseMatrix make_laplacian(const Surroundings& all) {
  std::vector<Eigen::Triplet<double>> weights;
  std::vector<double> areas(all.points.size(), 0.0);
  const auto connect = [&](Index a, Index b, double weight) {
    if (a >= all.n_whole()) return;
    weights.emplace_back(static_cast<int>(a), static_cast<int>(b), weight);
    weights.emplace_back(static_cast<int>(a), static_cast<int>(a), -weight);
  };
  double whole_area = 0.0;
  for (const Triangle& t : all.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = t[(k + 1) % 3];
      const Index b = t[(k + 2) % 3];
      const Vec3 to_a = all.points[a] - all.points[t[k]];
      const Vec3 to_b = all.points[b] - all.points[t[k]];
      const double twice_area = to_a.cross(to_b).norm();
      const double cotangent = to_a.dot(to_b) / std::max(twice_area, 1e-300);
      const double weight = 0.5 * std::clamp(cotangent, kLeastWeight, kGreatestWeight);
      connect(a, b, weight);
      connect(b, a, weight);
      areas[t[k]] += twice_area / 6.0;
      whole_area += twice_area / 6.0;
    }
  }
  const double least = 1e-9 * whole_area / static_cast<double>(all.points.size());
  Eigen::VectorXd scale(static_cast<Eigen::Index>(all.n_whole()));
  for (std::size_t i = 0; i < all.n_whole(); ++i) {
    scale[static_cast<Eigen::Index>(i)] = 1.0 / std::sqrt(std::max(areas[i], least));
  }
  SparseMatrix laplacian(static_cast<Eigen::Index>(all.n_whole()),
                         static_cast<Eigen::Index>(all.points.size()));
  laplacian.setFromTriplets(weights.begin(), weights.end());
  return scale.asDiagonal() * laplacian;
}

/// Returns a number of multiplications that the factorisation of the system takes about, or fewer:
/// the new vertices beside one with d of them form a dense block of d columns. Where a loop reaches
/// far out, its patch may have vertices with thousands of edges.
double multiplications_of(const SparseMatrix& movable) {
  std::vector<double> n_beside(static_cast<std::size_t>(movable.rows()), 0.0);
  for (Eigen::Index column = 0; column < movable.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator it(movable, column); it; ++it) {
      n_beside[static_cast<std::size_t>(it.row())] += 1.0;
    }
  }
  double sum = 0.0;
  for (const double d : n_beside) sum += d * d * d;
  return sum;
}

/// Moves the new vertices to the minimum of the energy, for the weights of the present surface.
///
/// @param solver  Has analysed the pattern of the system in the first round: no weight is 0, so
///                that it is the same in all.
/// @return        Whether there is a minimum, and it takes no more than the work allowed.
bool relax(Surroundings& all, std::size_t round, Solver& solver) {
  const SparseMatrix laplacian = make_laplacian(all);
  const auto n_new = static_cast<Eigen::Index>(all.n_new);
  const auto n_fixed = static_cast<Eigen::Index>(all.points.size()) - n_new;
  Places fixed(n_fixed, 3);
  for (Eigen::Index i = 0; i < n_fixed; ++i) {
    fixed.row(i) = all.points[static_cast<std::size_t>(n_new + i)].transpose();
  }
  const SparseMatrix movable = laplacian.leftCols(n_new);
  if (multiplications_of(movable) > kMaxMultiplications) return false;
  const SparseMatrix transposed = movable.transpose();
  const SparseMatrix system = transposed * movable;
  const Places held = laplacian.rightCols(n_fixed) * fixed;
  if (round == 0) solver.analyzePattern(system);
  solver.factorize(system);
  if (solver.info() != Eigen::Success) return false;
  const Places places = solver.solve(-(transposed * held));
  if (!places.allFinite()) return false;
  for (Eigen::Index i = 0; i < n_new; ++i) {
    all.points[static_cast<std::size_t>(i)] = places.row(i).transpose();
  }
  return true;
}

/// Moves the new vertices of a patch so that the surface is bent as evenly as possible: minimises
/// the bi-Laplacian energy with cotangent weights, while the loop and the faces beyond it stay
/// unchanged (Botsch et al. 2010, "Polygon Mesh Processing", section 4.3; Liepa 2003).
///
/// @return      Whether there is a minimum that is found with limited work, and the task is not to
///              stop; if not, all vertices stay.
/// @complexity  That of a sparse factorisation of n rows, about O(n^1.5).
bool fair_patch(const FillTask& task, const HoleLoop& loop, WorkingPatch& patch) {
  Surroundings all = SurroundingsMaker(task.mesh, patch).run(loop);
  const Frame frame(all);
  if (all.n_new == 0 || !frame.is_usable()) return false;
  for (Vec3& p : all.points) p = frame.into(p);
  Solver solver;
  for (std::size_t round = 0; round < kReweightings; ++round) {
    if (task.wants_to_stop() || !relax(all, round, solver)) return false;
  }
  for (std::size_t i = 0; i < all.n_new; ++i) {
    const VertexHandle v(static_cast<int>(all.n_loop + i));
    patch.mesh.set_point(v, frame.out_of(all.points[i]));
  }
  return true;
}

}  // namespace

std::optional<Patch> smooth_patch(const FillTask& task, const HoleLoop& loop, const Patch& patch,
                                  std::size_t max_new) {
  const Soup& soup = task.mesh.soup();
  PatchSoup own = make_soup(soup, patch);
  WorkingPatch working{.mesh = build(own.soup).mesh, .names = std::move(own.vertices)};
  if (working.mesh.n_vertices() != working.names.size()) return std::nullopt;
  refine_patch(task, loop, max_new, working);
  if (!fair_patch(task, loop, working)) return std::nullopt;
  // A patch that has bulged is coarser than its surroundings.
  refine_patch(task, loop, max_new, working);
  if (!fair_patch(task, loop, working)) return std::nullopt;

  Patch result;
  const std::size_t n_loop = working.names.size();
  for (std::size_t i = n_loop; i < working.mesh.n_vertices(); ++i) {
    const Vec3& place = working.mesh.point(VertexHandle(static_cast<int>(i)));
    if (!place.allFinite()) return std::nullopt;
    result.added.push_back(place);
  }
  const auto first_added = static_cast<Index>(soup.n_vertices());
  for (const FaceHandle f : working.mesh.faces()) {
    Triangle t{};
    std::size_t k = 0;
    for (const VertexHandle v : working.mesh.fv_range(f)) {
      const auto i = static_cast<std::size_t>(v.idx());
      t[k++] = i < n_loop ? working.names[i] : static_cast<Index>(first_added + i - n_loop);
    }
    result.triangles.push_back(t);
  }
  return result;
}

}  // namespace meshalyzer
