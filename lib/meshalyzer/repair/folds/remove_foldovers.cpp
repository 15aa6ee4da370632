#include "meshalyzer/defects/finders.h"
#include "meshalyzer/exact/normal.h"
#include "meshalyzer/repair/folds/fold_outline.h"
#include "meshalyzer/repair/folds/fold_star.h"
#include "meshalyzer/repair/folds/fold_trial.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/sort_unique.h"
#include "meshalyzer/spatial/closest_point.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Regions with more to be put back than this are left: all of it is compared with all.
constexpr std::size_t kMaxFaces = 128;
constexpr std::size_t kMaxAround = 512;

constexpr std::string_view kNoWay =
    "no vertex of it can be moved or taken away, within the deviation, so that it unfolds";

bool contains(const std::vector<Index>& sorted, Index item) {
  return std::binary_search(sorted.begin(), sorted.end(), item);
}

Vec3 normal_of(const PlacedFace& face) {
  return accurate_normal(face.corners[0], face.corners[1], face.corners[2]).stableNormalized();
}

/// A foldover by its elements in the mesh.
struct Region {
  /// Mesh faces, ascending.
  std::vector<Index> faces;
  /// File vertices of these, ascending.
  std::vector<Index> vertices;
  /// The lowest file face.
  Index name = kNoIndex;
};

/// A vertex of a region moved to where it unfolds.
struct VertexMove {
  Index vertex = kNoIndex;
  Vec3 to;
  double quality = -1.0;
  /// Faces that must stay as they are for it: mesh faces.
  std::vector<Index> faces;
};

/// Takes foldovers of a mesh away one by one, as long as they are far enough from each other.
class FoldoverRemover {
 public:
  FoldoverRemover(const PassInput& input, const std::vector<Defect>& foldovers)
      : input_(input),
        soup_(input.mesh.soup()),
        cut_(input.mesh.cut()),
        is_turned_over_(cut_.mesh.n_faces(), 0),
        is_used_(cut_.mesh.n_faces(), 0) {
    for (const Defect& foldover : foldovers) {
      for (const Index f : foldover.faces) is_turned_over_[cut_.side.mesh_face(f)] = 1;
    }
  }

  void treat(const Defect& foldover) {
    const Region region = region_of(foldover);
    reason_ = kNoWay;
    if (move(region) || (reaches_border(region) && drop(region)) || replace_one(region) ||
        replace_all(region)) {
      return;
    }
    result_.refused.push_back(
        {.code = DefectCode::Foldover, .face = region.name, .reason = std::string(reason_)});
  }

  [[nodiscard]] PassResult take() { return std::move(result_); }

 private:
  [[nodiscard]] Region region_of(const Defect& foldover) const;
  [[nodiscard]] bool reaches_border(const Region& region) const;
  [[nodiscard]] bool may_change(Index vertex) const;
  [[nodiscard]] PlacedFace placed(Index mesh_face) const;
  [[nodiscard]] std::vector<Index> faces_around(const FoldStar& star) const;
  [[nodiscard]] bool claim(const std::vector<Index>& faces);

  bool drop(const Region& region);
  [[nodiscard]] bool has_one_crease(const std::vector<HalfedgeHandle>& outline) const;
  [[nodiscard]] bool overlaps_itself_below(const Region& region) const;

  bool move(const Region& region);
  [[nodiscard]] VertexMove best_move(Index vertex) const;
  [[nodiscard]] std::optional<double> try_move(const FoldStar& star, const VertexMove& move) const;

  bool replace_one(const Region& region);
  bool replace_all(const Region& region);
  bool replace(const Region& region, const std::vector<Index>& vertices);
  [[nodiscard]] std::vector<PlacedFace> patch_for(const FoldStar& star) const;
  [[nodiscard]] bool is_near(const FoldStar& star, const std::vector<PlacedFace>& patch,
                             Index vertex);
  void put_patch(const FoldStar& star, const std::vector<PlacedFace>& patch);

  const PassInput& input_;
  const Soup& soup_;
  const CutMesh& cut_;
  /// #mesh faces: those of any foldover.
  std::vector<std::uint8_t> is_turned_over_;
  /// #mesh faces: those that an operation has changed, or goes by.
  std::vector<std::uint8_t> is_used_;
  /// Made when first needed.
  std::optional<ClosestPoints> closest_;
  /// #mesh faces: those that closest_ is not to find.
  std::vector<std::uint8_t> is_left_out_;
  /// Why the region at hand is left.
  std::string_view reason_;
  PassResult result_;
};

Region FoldoverRemover::region_of(const Defect& foldover) const {
  Region region;
  region.name = foldover.faces.front();
  for (const Index f : foldover.faces) {
    region.faces.push_back(static_cast<Index>(cut_.side.mesh_face(f)));
    const Triangle& t = soup_.triangles[f];
    region.vertices.insert(region.vertices.end(), t.begin(), t.end());
  }
  sort_unique(region.vertices);
  return region;
}

bool FoldoverRemover::reaches_border(const Region& region) const {
  return std::any_of(region.faces.begin(), region.faces.end(), [&](Index f) {
    for (const HalfedgeHandle h : cut_.mesh.fh_range(FaceHandle(static_cast<int>(f)))) {
      if (cut_.mesh.is_boundary(cut_.mesh.opposite_halfedge_handle(h))) return true;
    }
    return false;
  });
}

/// Whether a vertex may be moved or taken away.
bool FoldoverRemover::may_change(Index vertex) const {
  if (input_.limits.is_fixed(input_.draft, vertex) || !is_inner(cut_, vertex)) return false;
  if (input_.limits.groups == Groups::Names || soup_.groups.empty()) return true;
  Index group = kNoIndex;
  bool is_first = true;
  for (const FaceHandle f : cut_.mesh.vf_range(VertexHandle(static_cast<int>(vertex)))) {
    const Index here = group_of(soup_, cut_.side.face(f));
    if (!is_first && here != group) return false;
    group = here;
    is_first = false;
  }
  return true;
}

PlacedFace FoldoverRemover::placed(Index mesh_face) const {
  const Index face = cut_.side.faces[mesh_face];
  return {soup_.triangles[face], corners_of(soup_, face)};
}

/// Mesh faces that have a vertex of the outline, and are not of the star; ascending.
std::vector<Index> FoldoverRemover::faces_around(const FoldStar& star) const {
  std::vector<Index> around;
  for (const HalfedgeHandle h : star.outline) {
    for (const FaceHandle f : cut_.mesh.vf_range(cut_.mesh.from_vertex_handle(h))) {
      const auto face = static_cast<Index>(f.idx());
      if (!contains(star.faces, face)) around.push_back(face);
    }
  }
  sort_unique(around);
  return around;
}

/// Takes faces for an operation; not where another one has one of them.
bool FoldoverRemover::claim(const std::vector<Index>& faces) {
  const bool is_free =
      std::all_of(faces.begin(), faces.end(), [&](Index f) { return is_used_[f] == 0; });
  if (is_free) {
    for (const Index f : faces) is_used_[f] = 1;
  }
  return is_free;
}

// Ears: regions that are folded along one line, from border to border, onto a single sheet.

/// Whether folds and border edges each are one run of the outline.
bool FoldoverRemover::has_one_crease(const std::vector<HalfedgeHandle>& outline) const {
  std::size_t changes = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const HalfedgeHandle next = outline[(i + 1) % outline.size()];
    const auto is_border = [&](HalfedgeHandle h) {
      return cut_.mesh.is_boundary(cut_.mesh.opposite_halfedge_handle(h));
    };
    if (is_border(outline[i]) != is_border(next)) ++changes;
  }
  return changes == 2;
}

/// Whether faces that touch the region would still meet each other without it: then it is the
/// middle of three sheets.
bool FoldoverRemover::overlaps_itself_below(const Region& region) const {
  std::vector<Index> around;
  for (const Index v : region.vertices) {
    for (const FaceHandle f : cut_.mesh.vf_range(VertexHandle(static_cast<int>(v)))) {
      const auto face = static_cast<Index>(f.idx());
      if (!contains(region.faces, face)) around.push_back(face);
    }
  }
  sort_unique(around);
  if (around.size() > kMaxAround) return true;
  std::vector<PlacedFace> faces;
  for (const Index f : around) faces.push_back(placed(f));
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (is_contact(faces[i], faces[j])) return true;
    }
  }
  return false;
}

bool FoldoverRemover::drop(const Region& region) {
  const std::vector<HalfedgeHandle> outline = outline_of(cut_.mesh, region.faces);
  const bool is_ear = !outline.empty() && has_one_crease(outline) &&
                      region.vertices.size() * 2 == region.faces.size() + outline.size() + 2;
  if (!is_ear || overlaps_itself_below(region)) {
    reason_ = "without it the sheet would fall apart, or still lie on itself";
    return false;
  }
  std::vector<Index> faces = region.faces;
  for (const Index v : region.vertices) {
    const VertexHandle vertex(static_cast<int>(v));
    bool stays = false;
    for (const FaceHandle f : cut_.mesh.vf_range(vertex)) {
      faces.push_back(static_cast<Index>(f.idx()));
      stays = stays || !contains(region.faces, static_cast<Index>(f.idx()));
    }
    if (!stays && input_.limits.is_fixed(input_.draft, v)) {
      reason_ = "a vertex of it must stay";
      return false;
    }
  }
  sort_unique(faces);
  if (!claim(faces)) return true;
  const Index op = result_.edits.begin_operation();
  for (const Index f : region.faces) {
    result_.edits.removed_faces.push_back({op, cut_.side.faces[f]});
  }
  return true;
}

// Dragged vertices: moved back.

bool FoldoverRemover::move(const Region& region) {
  VertexMove best;
  for (const Index v : region.vertices) {
    if (!may_change(v)) continue;
    VertexMove candidate = best_move(v);
    if (candidate.quality > best.quality) best = std::move(candidate);
  }
  if (best.vertex == kNoIndex) return false;
  if (!claim(best.faces)) return true;
  const Index op = result_.edits.begin_operation();
  result_.edits.moved_vertices.push_back({op, best.vertex, best.to});
  return true;
}

/// The best place for a vertex on the way to the middle of where it sees all its faces.
VertexMove FoldoverRemover::best_move(Index vertex) const {
  VertexMove best;
  const std::array<Index, 1> vertices{vertex};
  const std::optional<FoldStar> star = star_of(cut_, vertices);
  if (!star || star->faces.size() > kMaxFaces) return best;
  std::vector<Vec3> outline;
  for (const HalfedgeHandle h : star->outline) {
    outline.push_back(cut_.mesh.point(cut_.mesh.from_vertex_handle(h)));
  }
  const std::optional<Vec3> middle = middle_of_kernel(outline);
  if (!middle) return best;
  const Vec3& from = soup_.positions[vertex];
  const double way = (*middle - from).stableNorm();
  // Rounding must not take it beyond the limit.
  const double farthest = std::min(1.0, input_.limits.max_deviation * (1.0 - 1e-12) / way);
  if (!(farthest > 0.0)) return best;
  for (const double part : {1.0, 0.75, 0.5, 0.25, 0.125}) {
    VertexMove move{vertex, from + part * farthest * (*middle - from), -1.0, {}};
    const std::optional<double> quality = try_move(*star, move);
    if (!quality || *quality <= best.quality) continue;
    move.quality = *quality;
    best = std::move(move);
  }
  if (best.vertex == kNoIndex) return best;
  best.faces = faces_around(*star);
  best.faces.insert(best.faces.end(), star->faces.begin(), star->faces.end());
  return best;
}

/// How well the faces are shaped if all that were turned over turn back, no other turns over, and
/// none touches any but what still is turned over; else nothing.
std::optional<double> FoldoverRemover::try_move(const FoldStar& star,
                                                const VertexMove& move) const {
  std::vector<PlacedFace> faces;
  for (const Index f : star.faces) {
    const PlacedFace before = placed(f);
    PlacedFace after = before;
    for (std::size_t i = 0; i < 3; ++i) {
      if (after.vertices[i] == move.vertex) after.corners[i] = move.to;
    }
    const double turn = normal_of(before).dot(normal_of(after));
    if (!(is_turned_over_[f] != 0 ? turn < 0.0 : turn > 0.0)) return std::nullopt;
    faces.push_back(after);
  }
  std::vector<PlacedFace> around;
  for (const Index f : faces_around(star)) {
    if (is_turned_over_[f] == 0) around.push_back(placed(f));
  }
  if (around.size() > kMaxAround) return std::nullopt;
  return quality_of(
      {faces, around, input_.tolerances.max_foldover_angle, input_.tolerances.degeneracy});
}

// All else: the faces at some vertices are taken out, and their outline is triangulated.

/// Takes a vertex away that all of the region is round.
bool FoldoverRemover::replace_one(const Region& region) {
  return std::any_of(region.vertices.begin(), region.vertices.end(), [&](Index v) {
    const bool is_hub = std::all_of(region.faces.begin(), region.faces.end(), [&](Index f) {
      const Triangle& t = soup_.triangles[cut_.side.faces[f]];
      return std::find(t.begin(), t.end(), v) != t.end();
    });
    return is_hub && replace(region, {v});
  });
}

bool FoldoverRemover::replace_all(const Region& region) {
  return region.vertices.size() <= kMaxFaces && replace(region, region.vertices);
}

bool FoldoverRemover::replace(const Region& region, const std::vector<Index>& vertices) {
  if (!std::all_of(vertices.begin(), vertices.end(), [&](Index v) { return may_change(v); })) {
    return false;
  }
  const std::optional<FoldStar> star = star_of(cut_, vertices);
  if (!star || star->faces.size() > kMaxFaces) return false;
  const std::vector<PlacedFace> patch = patch_for(*star);
  if (patch.empty() || !std::all_of(vertices.begin(), vertices.end(),
                                    [&](Index v) { return is_near(*star, patch, v); })) {
    return false;
  }
  std::vector<Index> faces = faces_around(*star);
  if (faces.size() > kMaxAround) return false;
  std::vector<PlacedFace> around;
  for (const Index f : faces) around.push_back(placed(f));
  if (!quality_of(
          {patch, around, input_.tolerances.max_foldover_angle, input_.tolerances.degeneracy})) {
    return false;
  }
  faces.insert(faces.end(), star->faces.begin(), star->faces.end());
  faces.insert(faces.end(), region.faces.begin(), region.faces.end());
  if (claim(faces)) put_patch(*star, patch);
  return true;
}

/// A triangulation of the outline of a star; empty where there is none.
std::vector<PlacedFace> FoldoverRemover::patch_for(const FoldStar& star) const {
  const TriMesh& mesh = cut_.mesh;
  std::vector<VertexHandle> vertices;
  std::vector<Vec3> outline;
  for (const HalfedgeHandle h : star.outline) {
    vertices.push_back(mesh.from_vertex_handle(h));
    outline.push_back(mesh.point(vertices.back()));
  }
  const auto is_taken_out = [&](FaceHandle f) {
    return f.is_valid() && contains(star.faces, static_cast<Index>(f.idx()));
  };
  const auto triangles = cut_ears(outline, [&](Index a, Index b) {
    const HalfedgeHandle h = mesh.find_halfedge(vertices[a], vertices[b]);
    return !h.is_valid() ||
           (is_taken_out(mesh.face_handle(h)) && is_taken_out(mesh.opposite_face_handle(h)));
  });
  std::vector<PlacedFace> patch;
  for (const Triangle& t : triangles) {
    patch.push_back({{cut_.side.vertex(vertices[t[0]]), cut_.side.vertex(vertices[t[1]]),
                      cut_.side.vertex(vertices[t[2]])},
                     {outline[t[0]], outline[t[1]], outline[t[2]]}});
  }
  return patch;
}

/// Whether a vertex that is taken away is within the deviation of the patch, or of a face that
/// stays: it was dragged over those.
bool FoldoverRemover::is_near(const FoldStar& star, const std::vector<PlacedFace>& patch,
                              Index vertex) {
  const Vec3& point = soup_.positions[vertex];
  const double bound = input_.limits.max_deviation;
  const bool is_on_patch = std::any_of(patch.begin(), patch.end(), [&](const PlacedFace& face) {
    return closest_on_triangle(face.corners, point).distance <= bound;
  });
  if (is_on_patch) return true;
  if (!closest_) {
    closest_.emplace(input_.mesh.tree());
    is_left_out_.assign(cut_.mesh.n_faces(), 0);
  }
  for (const Index f : star.faces) is_left_out_[f] = 1;
  const auto found = closest_->find({.point = point, .within = bound, .excluded = is_left_out_});
  for (const Index f : star.faces) is_left_out_[f] = 0;
  return found.has_value();
}

void FoldoverRemover::put_patch(const FoldStar& star, const std::vector<PlacedFace>& patch) {
  Edits& edits = result_.edits;
  const Index op = edits.begin_operation();
  for (const Index f : star.faces) edits.removed_faces.push_back({op, cut_.side.faces[f]});
  for (const PlacedFace& face : patch) {
    // Of the old face at the same edge of the outline, if it has one.
    Index like = cut_.side.faces[star.faces.front()];
    for (const HalfedgeHandle h : star.outline) {
      const auto& t = face.vertices;
      const Index from = cut_.side.vertex(cut_.mesh.from_vertex_handle(h));
      const Index to = cut_.side.vertex(cut_.mesh.to_vertex_handle(h));
      for (std::size_t i = 0; i < 3; ++i) {
        if (t[i] == from && t[(i + 1) % 3] == to) like = cut_.side.face(cut_.mesh.face_handle(h));
      }
    }
    edits.added_faces.push_back({.op = op, .corners = face.vertices, .like = like});
  }
}

}  // namespace

PassResult remove_foldovers(const PassInput& input) {
  const std::vector<Defect> foldovers = find_foldovers(input.mesh, input.tolerances);
  if (foldovers.empty()) return {};
  FoldoverRemover remover(input, foldovers);
  for (const Defect& foldover : foldovers) remover.treat(foldover);
  return remover.take();
}

}  // namespace meshalyzer
