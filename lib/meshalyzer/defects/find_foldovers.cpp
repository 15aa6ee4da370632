#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/defects/internal/places.h"
#include "meshalyzer/defects/internal/sheet_cover.h"
#include "meshalyzer/exact/normal.h"
#include "meshalyzer/exact/predicates.h"
#include "meshalyzer/geometry/edge_measures.h"
#include "meshalyzer/geometry/face_measures.h"
#include "meshalyzer/topology/edges.h"
#include "meshalyzer/topology/join_through_cuts.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <vector>

namespace meshalyzer {
namespace {

/// The positions of the ends of an edge, and of the third corners of its two faces.
struct EdgePlaces {
  const Vec3& a;
  const Vec3& b;
  const Vec3& c;
  const Vec3& d;
};

EdgePlaces edge_places(const TriMesh& mesh, HalfedgeHandle h) {
  const HalfedgeHandle opposite = mesh.opposite_halfedge_handle(h);
  return {mesh.point(mesh.from_vertex_handle(h)), mesh.point(mesh.to_vertex_handle(h)),
          mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(h))),
          mesh.point(mesh.to_vertex_handle(mesh.next_halfedge_handle(opposite)))};
}

/// Tells whether the angle between the faces is surely above 90 degrees, because their normals are
/// at less than 90 degrees. The products are off by about 2^-50 of the lengths that are multiplied;
/// the answer is no if a squared edge length overflows or underflows.
bool is_surely_blunt(const EdgePlaces& p) {
  const Vec3 edge = p.b - p.a;
  const Vec3 u = p.c - p.a;
  const Vec3 v = p.d - p.a;
  const double dot = edge.cross(u).dot(v.cross(edge));
  const double size = edge.squaredNorm();
  return dot > 0.0 && dot * dot > 1e-24 * size * size * u.squaredNorm() * v.squaredNorm() &&
         size > 1e-60;
}

bool is_fold_edge(const TriMesh& mesh, HalfedgeHandle h, double max_angle) {
  const EdgePlaces p = edge_places(mesh, h);
  if (max_angle < 90.0 && is_surely_blunt(p)) return false;
  if (are_collinear(p.a, p.b, p.c) || are_collinear(p.a, p.b, p.d)) return false;
  const double angle = edge_angle_degrees(mesh, h);
  return std::min(angle, 360.0 - angle) <= max_angle;
}

/// Finds the folds: edges with two consistently oriented faces of non-zero area, the smaller angle
/// between which is at most `max_angle` degrees.
///
/// @return     A half-edge of each, in order of the mesh's edges.
/// @complexity O(#E), with only a few operations for each edge that is not sharp.
std::vector<HalfedgeHandle> find_folds(const TriMesh& mesh, double max_angle) {
  const auto is_fold = [&](Index i) {
    const EdgeHandle e(static_cast<int>(i));
    return !mesh.is_boundary(e) && is_fold_edge(mesh, mesh.halfedge_handle(e, 0), max_angle);
  };
  std::vector<HalfedgeHandle> folds;
  for (const Index i : parallel_filter(mesh.n_edges(), is_fold)) {
    folds.push_back(mesh.halfedge_handle(EdgeHandle(static_cast<int>(i)), 0));
  }
  return folds;
}

/// A fold between two patches, each given by its lowest face.
struct Crease {
  HalfedgeHandle fold;
  std::array<Index, 2> patches;
};

/// A maximal set of faces connected through edges that are no folds, which a fold separates from
/// another such set.
struct Patch {
  /// Mesh faces, ascending.
  std::vector<Index> faces;
  double area = 0.0;
  /// Numbers of the patches beyond its folds, ascending.
  std::vector<Index> neighbours;
  /// The folds between it and its neighbours.
  std::vector<HalfedgeHandle> folds;
  /// The distance to its neighbours, if it lies on them.
  std::optional<double> distance;
};

/// Joins faces through all edges except folds. A cut of the mesh does not bound a region: the
/// surface continues beyond it.
DisjointSets join_faces(const CutMesh& cut, const std::vector<HalfedgeHandle>& folds) {
  const TriMesh& mesh = cut.mesh;
  std::vector<std::uint8_t> is_fold(mesh.n_edges(), 0);
  for (const HalfedgeHandle h : folds) {
    is_fold[static_cast<std::size_t>(mesh.edge_handle(h).idx())] = 1;
  }
  DisjointSets faces(mesh.n_faces());
  for (const EdgeHandle e : mesh.all_edges()) {
    if (mesh.is_boundary(e) || is_fold[static_cast<std::size_t>(e.idx())] != 0) continue;
    faces.unite(static_cast<Index>(mesh.face_handle(mesh.halfedge_handle(e, 0)).idx()),
                static_cast<Index>(mesh.face_handle(mesh.halfedge_handle(e, 1)).idx()));
  }
  join_through_cuts(mesh, cut.side.flipped_edges, faces);
  join_through_cuts(mesh, cut.side.non_manifold_edges, faces);
  return faces;
}

/// The patches of a mesh that folds separate from each other.
class FoldedPatches {
 public:
  FoldedPatches(const CutMesh& cut, const std::vector<HalfedgeHandle>& folds) {
    DisjointSets sets = join_faces(cut, folds);
    std::vector<Index> roots;
    const std::vector<Crease> creases = find_creases(cut.mesh, folds, sets);
    for (const Crease& crease : creases) {
      roots.insert(roots.end(), crease.patches.begin(), crease.patches.end());
    }
    if (roots.empty()) return;
    sort_unique(roots);
    patches_.resize(roots.size());
    number_faces(cut.mesh, roots, sets);
    join_patches(creases);
  }

  [[nodiscard]] std::vector<Patch>& patches() { return patches_; }
  /// Returns the patch of each mesh face, kNoIndex if no fold separates it from another patch.
  [[nodiscard]] const std::vector<Index>& of_face() const { return of_face_; }

 private:
  [[nodiscard]] static std::vector<Crease> find_creases(const TriMesh& mesh,
                                                        const std::vector<HalfedgeHandle>& folds,
                                                        DisjointSets& sets) {
    std::vector<Crease> creases;
    for (const HalfedgeHandle h : folds) {
      const Index a = sets.find(static_cast<Index>(mesh.face_handle(h).idx()));
      const Index b = sets.find(static_cast<Index>(mesh.opposite_face_handle(h).idx()));
      if (a != b) creases.push_back({h, {a, b}});
    }
    return creases;
  }

  /// @param roots  The lowest faces of the patches, ascending.
  void number_faces(const TriMesh& mesh, const std::vector<Index>& roots, DisjointSets& sets) {
    of_face_.assign(mesh.n_faces(), kNoIndex);
    for (std::size_t i = 0; i < roots.size(); ++i) of_face_[roots[i]] = static_cast<Index>(i);
    for (Index f = 0; f < of_face_.size(); ++f) {
      of_face_[f] = of_face_[sets.find(f)];
      if (of_face_[f] == kNoIndex) continue;
      Patch& patch = patches_[of_face_[f]];
      const Corners t = face_corners(mesh, FaceHandle(static_cast<int>(f)));
      patch.faces.push_back(f);
      patch.area += accurate_normal(t[0], t[1], t[2]).stableNorm() / 2;
    }
  }

  void join_patches(const std::vector<Crease>& creases) {
    for (const Crease& crease : creases) {
      const Index a = of_face_[crease.patches[0]];
      const Index b = of_face_[crease.patches[1]];
      patches_[a].neighbours.push_back(b);
      patches_[b].neighbours.push_back(a);
      patches_[a].folds.push_back(crease.fold);
      patches_[b].folds.push_back(crease.fold);
    }
    for (Patch& patch : patches_) sort_unique(patch.neighbours);
  }

  std::vector<Patch> patches_;
  std::vector<Index> of_face_;
};

/// Tells whether a patch may fit on its neighbours: a sheet with more area than those below it
/// protrudes somewhere, possibly within a large tolerance.
bool has_room(const std::vector<Patch>& patches, const Patch& patch) {
  // The areas of two triangulations of the same sheet may differ by this share.
  constexpr double kSlack = 1e-6;
  double room = 0.0;
  for (const Index other : patch.neighbours) room += patches[other].area;
  return patch.area <= room * (1.0 + kSlack);
}

/// Returns the numbers of the patches that lie on their neighbours, the smallest first. It skips
/// parts of the surface all of whose patches do: sheets that lie on each other everywhere are not
/// foldovers.
std::vector<Index> find_candidates(const std::vector<Patch>& patches) {
  DisjointSets parts(patches.size());
  for (Index i = 0; i < patches.size(); ++i) {
    for (const Index other : patches[i].neighbours) parts.unite(i, other);
  }
  std::vector<std::uint8_t> has_ground(patches.size(), 0);
  for (Index i = 0; i < patches.size(); ++i) {
    if (!patches[i].distance) has_ground[parts.find(i)] = 1;
  }
  std::vector<Index> candidates;
  for (Index i = 0; i < patches.size(); ++i) {
    if (patches[i].distance && has_ground[parts.find(i)] != 0) candidates.push_back(i);
  }
  std::sort(candidates.begin(), candidates.end(), [&](Index a, Index b) {
    const auto key = [&](Index i) {
      return std::tuple(patches[i].area, patches[i].faces.size(), patches[i].faces.front());
    };
    return key(a) < key(b);
  });
  return candidates;
}

/// Measures how far a patch is from others.
///
/// @param under  The numbers of these patches, ascending.
std::optional<double> measure_cover(const std::vector<Patch>& patches, const Patch& patch,
                                    const std::vector<Index>& under, SheetCover& cover) {
  // Looking at this many faces takes less time than a search in the tree.
  constexpr std::size_t kFewFaces = 32;
  std::vector<Index> faces;
  for (const Index other : under) {
    const std::vector<Index>& more = patches[other].faces;
    if (faces.size() + more.size() > kFewFaces) {
      return cover.measure({.faces = patch.faces, .under = under, .faces_under = std::nullopt});
    }
    faces.insert(faces.end(), more.begin(), more.end());
  }
  std::sort(faces.begin(), faces.end());
  return cover.measure({.faces = patch.faces, .under = under, .faces_under = faces});
}

/// Decides which patches are foldovers, the smallest first: the patches that lie on neighbours
/// which are not foldovers themselves.
///
/// @return The numbers of the foldovers, ascending.
std::vector<Index> choose_foldovers(std::vector<Patch>& patches, SheetCover& cover) {
  std::vector<std::uint8_t> is_foldover(patches.size(), 0);
  for (const Index i : find_candidates(patches)) {
    std::vector<Index> under;
    for (const Index other : patches[i].neighbours) {
      if (is_foldover[other] == 0) under.push_back(other);
    }
    if (under.empty()) continue;
    if (under.size() < patches[i].neighbours.size()) {
      patches[i].distance = measure_cover(patches, patches[i], under, cover);
    }
    is_foldover[i] = patches[i].distance ? 1 : 0;
  }
  std::vector<Index> foldovers;
  for (Index i = 0; i < patches.size(); ++i) {
    if (is_foldover[i] != 0) foldovers.push_back(i);
  }
  return foldovers;
}

Defect describe(const PreparedMesh& mesh, const Patch& patch, double height_tolerance) {
  const CutMesh& cut = mesh.cut();
  Defect defect = make_defect(DefectCode::Foldover);
  for (const Index f : patch.faces) defect.faces.push_back(cut.side.faces[f]);
  for (const HalfedgeHandle h : patch.folds) {
    defect.edges.push_back(ascending_file_ends(cut, h));
  }
  std::sort(defect.edges.begin(), defect.edges.end());
  defect.positions = middle_of_face(mesh.soup(), defect.faces.front());
  defect.value = patch.distance;
  defect.limit = height_tolerance;
  return defect;
}

}  // namespace

DefectList find_foldovers(const PreparedMesh& mesh, const Tolerances& tolerances,
                          const StopQuery& wants_to_stop) {
  const std::vector<HalfedgeHandle> folds =
      find_folds(mesh.cut().mesh, tolerances.max_foldover_angle);
  if (folds.empty()) return {};
  FoldedPatches folded(mesh.cut(), folds);
  std::vector<Patch>& patches = folded.patches();
  if (patches.empty()) return {};
  SheetCover cover(mesh, folded.of_face(), tolerances.height, wants_to_stop);
  for (Patch& patch : patches) {
    if (!has_room(patches, patch)) continue;
    patch.distance = measure_cover(patches, patch, patch.neighbours, cover);
  }
  DefectList defects;
  for (const Index i : choose_foldovers(patches, cover)) {
    defects.push_back(describe(mesh, patches[i], tolerances.height));
  }
  return defects;
}

}  // namespace meshalyzer
