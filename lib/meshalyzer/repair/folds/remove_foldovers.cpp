#include "meshalyzer/base/corners.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/base/triangle_vertices.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/exact/normal.h"
#include "meshalyzer/repair/folds/internal/candidate_faces.h"
#include "meshalyzer/repair/folds/internal/face_disc.h"
#include "meshalyzer/repair/folds/internal/fold_outline.h"
#include "meshalyzer/repair/folds/internal/layer_join.h"
#include "meshalyzer/repair/passes.h"
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

/// Regions with more replacement faces are left, because all of these are compared in pairs.
constexpr std::size_t kMaxFaces = 128;
constexpr std::size_t kMaxAround = 512;

constexpr std::string_view kNoWay =
    "no vertex of it can be moved or taken away, within the deviation, so that it unfolds";

bool contains(const std::vector<Index>& sorted, Index item) {
  return std::binary_search(sorted.begin(), sorted.end(), item);
}

/// A foldover by its elements in the mesh.
struct FoldedRegion {
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
  /// Mesh faces that must stay unchanged for it.
  std::vector<Index> faces;
};

/// Removes foldovers of a mesh one by one, as long as they are far enough from each other.
class FoldoverRemover {
 public:
  FoldoverRemover(const PassInput& input, const DefectList& foldovers)
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
    const FoldedRegion region = region_of(foldover);
    reason_ = kNoWay;
    if (move(region) || (reaches_border(cut_, region.faces) && drop(region)) ||
        replace_one(region) || replace_all(region) || join_layers(region)) {
      return;
    }
    result_.refused.push_back(
        {.code = DefectCode::Foldover, .face = region.name, .reason = std::string(reason_)});
  }

  [[nodiscard]] PassResult take() { return std::move(result_); }

 private:
  [[nodiscard]] FoldedRegion region_of(const Defect& foldover) const;
  [[nodiscard]] bool keeps_group_borders() const;
  [[nodiscard]] bool may_change(Index vertex) const;
  [[nodiscard]] PlacedFace placed(Index mesh_face) const;
  [[nodiscard]] bool claim(const std::vector<Index>& faces);

  bool drop(const FoldedRegion& region);
  [[nodiscard]] bool overlaps_itself_below(const FoldedRegion& region) const;

  bool move(const FoldedRegion& region);
  [[nodiscard]] VertexMove best_move(Index vertex) const;
  [[nodiscard]] std::optional<double> try_move(const FaceDisc& disc, const VertexMove& move) const;

  bool replace_one(const FoldedRegion& region);
  bool replace_all(const FoldedRegion& region);
  bool replace(const FoldedRegion& region, const std::vector<Index>& vertices);
  [[nodiscard]] std::vector<PlacedFace> replacement_for(const FaceDisc& disc) const;
  [[nodiscard]] bool is_near(const FaceDisc& disc, const std::vector<PlacedFace>& replacement,
                             Index vertex);
  void put_replacement(const FaceDisc& disc, const std::vector<PlacedFace>& replacement);

  bool join_layers(const FoldedRegion& region);
  [[nodiscard]] std::optional<LayerJoin> join_at(HalfedgeHandle crease) const;
  [[nodiscard]] bool may_go(const LayerJoin& join) const;
  [[nodiscard]] std::vector<Index> faces_at(const LayerJoin& join) const;
  void put_join(const LayerJoin& join);

  const PassInput& input_;
  const Soup& soup_;
  const CutMesh& cut_;
  /// Non-zero for each mesh face that is part of a foldover.
  std::vector<std::uint8_t> is_turned_over_;
  /// Non-zero for each mesh face that an operation has changed, or relies on.
  std::vector<std::uint8_t> is_used_;
  /// The tree is built when it is first needed.
  std::optional<ClosestPoints> closest_;
  /// Non-zero for each mesh face that closest_ is to ignore.
  std::vector<std::uint8_t> is_left_out_;
  /// The reason why the current region is left.
  std::string_view reason_;
  PassResult result_;
};

FoldedRegion FoldoverRemover::region_of(const Defect& foldover) const {
  FoldedRegion region;
  region.name = foldover.faces.front();
  for (const Index f : foldover.faces) {
    region.faces.push_back(static_cast<Index>(cut_.side.mesh_face(f)));
    const Triangle& t = soup_.triangles[f];
    region.vertices.insert(region.vertices.end(), t.begin(), t.end());
  }
  sort_unique(region.vertices);
  return region;
}

/// Tells whether the mesh has groups that must keep their borders.
bool FoldoverRemover::keeps_group_borders() const {
  return input_.limits.groups == Groups::Faces && !soup_.groups.empty();
}

/// Tells whether a vertex may be moved or removed.
bool FoldoverRemover::may_change(Index vertex) const {
  if (input_.limits.is_fixed(input_.tracked, vertex) || !is_inner(cut_, vertex)) return false;
  if (!keeps_group_borders()) return true;
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

/// Claims faces for an operation, unless another one has one of them.
bool FoldoverRemover::claim(const std::vector<Index>& faces) {
  const auto is_taken = [&](Index f) { return is_used_[f] != 0; };
  if (std::any_of(faces.begin(), faces.end(), is_taken)) return false;
  for (const Index f : faces) is_used_[f] = 1;
  return true;
}

// Handles ears: regions that are folded along one line, from border to border, onto a single sheet.

/// Tells whether faces that touch the region would still intersect each other without it: then it
/// is the middle of three sheets.
bool FoldoverRemover::overlaps_itself_below(const FoldedRegion& region) const {
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
      if (are_in_contact(faces[i], faces[j])) return true;
    }
  }
  return false;
}

bool FoldoverRemover::drop(const FoldedRegion& region) {
  const std::vector<HalfedgeHandle> outline = outline_of(cut_.mesh, region.faces);
  const bool is_ear = !outline.empty() && has_one_crease(cut_, outline) &&
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
    if (!stays && input_.limits.is_fixed(input_.tracked, v)) {
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

// Handles dragged vertices, which are moved back.

bool FoldoverRemover::move(const FoldedRegion& region) {
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

/// Returns the best position for a vertex on the way to the middle of those that see all its faces.
VertexMove FoldoverRemover::best_move(Index vertex) const {
  VertexMove best;
  const std::array<Index, 1> vertices{vertex};
  const std::optional<FaceDisc> disc = find_disc(cut_, vertices);
  if (!disc || disc->faces.size() > kMaxFaces) return best;
  std::vector<Vec3> outline;
  for (const HalfedgeHandle h : disc->outline) {
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
    const std::optional<double> quality = try_move(*disc, move);
    if (!quality || *quality <= best.quality) continue;
    move.quality = *quality;
    best = std::move(move);
  }
  if (best.vertex == kNoIndex) return best;
  best.faces = faces_around(cut_, *disc);
  best.faces.insert(best.faces.end(), disc->faces.begin(), disc->faces.end());
  return best;
}

/// Returns the shape quality of the faces if all that were turned over turn back, no other turns
/// over, and none touches any that does not stay turned over; else nothing.
std::optional<double> FoldoverRemover::try_move(const FaceDisc& disc,
                                                const VertexMove& move) const {
  std::vector<PlacedFace> faces;
  for (const Index f : disc.faces) {
    const PlacedFace before = placed(f);
    PlacedFace after = before;
    for (std::size_t i = 0; i < 3; ++i) {
      if (after.vertices[i] == move.vertex) after.corners[i] = move.to;
    }
    const double turn = unit_normal(before.corners).dot(unit_normal(after.corners));
    if (!(is_turned_over_[f] != 0 ? turn < 0.0 : turn > 0.0)) return std::nullopt;
    faces.push_back(after);
  }
  std::vector<PlacedFace> around;
  for (const Index f : faces_around(cut_, disc)) {
    if (is_turned_over_[f] == 0) around.push_back(placed(f));
  }
  if (around.size() > kMaxAround) return std::nullopt;
  return quality_of(
      {faces, around, input_.tolerances.max_foldover_angle, input_.tolerances.degeneracy});
}

// Handles other regions: the faces at some vertices are removed, and their outline triangulated.

/// Removes a vertex that all of the region surrounds.
bool FoldoverRemover::replace_one(const FoldedRegion& region) {
  return std::any_of(region.vertices.begin(), region.vertices.end(), [&](Index v) {
    const bool is_hub = std::all_of(region.faces.begin(), region.faces.end(), [&](Index f) {
      return has_corner(soup_.triangles[cut_.side.faces[f]], v);
    });
    return is_hub && replace(region, {v});
  });
}

bool FoldoverRemover::replace_all(const FoldedRegion& region) {
  return region.vertices.size() <= kMaxFaces && replace(region, region.vertices);
}

bool FoldoverRemover::replace(const FoldedRegion& region, const std::vector<Index>& vertices) {
  if (!std::all_of(vertices.begin(), vertices.end(), [&](Index v) { return may_change(v); })) {
    return false;
  }
  const std::optional<FaceDisc> disc = find_disc(cut_, vertices);
  if (!disc || disc->faces.size() > kMaxFaces) return false;
  const std::vector<PlacedFace> replacement = replacement_for(*disc);
  if (replacement.empty() || !std::all_of(vertices.begin(), vertices.end(), [&](Index v) {
        return is_near(*disc, replacement, v);
      })) {
    return false;
  }
  std::vector<Index> faces = faces_around(cut_, *disc);
  if (faces.size() > kMaxAround) return false;
  std::vector<PlacedFace> around;
  for (const Index f : faces) around.push_back(placed(f));
  if (!quality_of({replacement, around, input_.tolerances.max_foldover_angle,
                   input_.tolerances.degeneracy})) {
    return false;
  }
  faces.insert(faces.end(), disc->faces.begin(), disc->faces.end());
  faces.insert(faces.end(), region.faces.begin(), region.faces.end());
  if (claim(faces)) put_replacement(*disc, replacement);
  return true;
}

/// Returns a triangulation of the outline of a disc; empty if there is none.
std::vector<PlacedFace> FoldoverRemover::replacement_for(const FaceDisc& disc) const {
  const TriMesh& mesh = cut_.mesh;
  std::vector<VertexHandle> vertices;
  std::vector<Vec3> outline;
  for (const HalfedgeHandle h : disc.outline) {
    vertices.push_back(mesh.from_vertex_handle(h));
    outline.push_back(mesh.point(vertices.back()));
  }
  const auto is_taken_out = [&](FaceHandle f) {
    return f.is_valid() && contains(disc.faces, static_cast<Index>(f.idx()));
  };
  const auto triangles = cut_ears(outline, [&](Index a, Index b) {
    const HalfedgeHandle h = mesh.find_halfedge(vertices[a], vertices[b]);
    return !h.is_valid() ||
           (is_taken_out(mesh.face_handle(h)) && is_taken_out(mesh.opposite_face_handle(h)));
  });
  std::vector<PlacedFace> replacement;
  for (const Triangle& t : triangles) {
    replacement.push_back({{cut_.side.vertex(vertices[t[0]]), cut_.side.vertex(vertices[t[1]]),
                            cut_.side.vertex(vertices[t[2]])},
                           corners_of(outline, t)});
  }
  return replacement;
}

/// Tells whether a removed vertex is within the deviation of the replacement, or of a remaining
/// face, since it was dragged over those.
bool FoldoverRemover::is_near(const FaceDisc& disc, const std::vector<PlacedFace>& replacement,
                              Index vertex) {
  const Vec3& point = soup_.positions[vertex];
  const double bound = input_.limits.max_deviation;
  const bool is_on_replacement =
      std::any_of(replacement.begin(), replacement.end(), [&](const PlacedFace& face) {
        return closest_on_triangle(face.corners, point).distance <= bound;
      });
  if (is_on_replacement) return true;
  if (!closest_) {
    closest_.emplace(input_.mesh.tree());
    is_left_out_.assign(cut_.mesh.n_faces(), 0);
  }
  for (const Index f : disc.faces) is_left_out_[f] = 1;
  const auto found = closest_->find({.point = point, .within = bound, .excluded = is_left_out_});
  for (const Index f : disc.faces) is_left_out_[f] = 0;
  return found.has_value();
}

void FoldoverRemover::put_replacement(const FaceDisc& disc,
                                      const std::vector<PlacedFace>& replacement) {
  Edits& edits = result_.edits;
  const Index op = edits.begin_operation();
  for (const Index f : disc.faces) edits.removed_faces.push_back({op, cut_.side.faces[f]});
  for (const PlacedFace& face : replacement) {
    // The prototype is the old face at the same edge of the outline, if there is one.
    Index prototype = cut_.side.faces[disc.faces.front()];
    for (const HalfedgeHandle h : disc.outline) {
      const auto& t = face.vertices;
      const Index from = cut_.side.vertex(cut_.mesh.from_vertex_handle(h));
      const Index to = cut_.side.vertex(cut_.mesh.to_vertex_handle(h));
      const auto begin = std::find(t.begin(), t.end(), from);
      if (begin == t.end() || t[(begin - t.begin() + 1) % 3] != to) continue;
      prototype = cut_.side.face(cut_.mesh.face_handle(h));
    }
    edits.added_faces.push_back({.op = op, .corners = face.vertices, .prototype = prototype});
  }
}

// Handles folds whose layers have the same corners: what lies on each other goes.

bool FoldoverRemover::join_layers(const FoldedRegion& region) {
  for (const Index f : region.faces) {
    for (const HalfedgeHandle h : cut_.mesh.fh_range(FaceHandle(static_cast<int>(f)))) {
      const std::optional<LayerJoin> join = join_at(h);
      if (!join) continue;
      if (claim(faces_at(*join))) put_join(*join);
      return true;
    }
  }
  return false;
}

/// Returns how the layers at an edge are joined if they are no farther apart than those of a fold.
std::optional<LayerJoin> FoldoverRemover::join_at(HalfedgeHandle crease) const {
  for (const HalfedgeHandle h : {crease, cut_.mesh.opposite_halfedge_handle(crease)}) {
    if (cut_.mesh.is_boundary(h)) return std::nullopt;
    for (const VertexHandle v : cut_.mesh.fv_range(cut_.mesh.face_handle(h))) {
      if (!is_inner(cut_, cut_.side.vertex(v))) return std::nullopt;
    }
  }
  for (const HalfedgeHandle h : {crease, cut_.mesh.opposite_halfedge_handle(crease)}) {
    std::optional<LayerJoin> join = join_layers_at(cut_.mesh, h);
    if (!join || !may_change(cut_.side.vertex(join->merged)) || !may_go(*join)) continue;
    const Vec3 way = cut_.mesh.point(join->kept) - cut_.mesh.point(join->merged);
    const double farthest = std::min(input_.tolerances.height, input_.limits.max_deviation);
    if (way.stableNorm() <= farthest) return join;
  }
  return std::nullopt;
}

/// Tells whether layers may go: those of two groups stay if these must keep their borders.
bool FoldoverRemover::may_go(const LayerJoin& join) const {
  if (!keeps_group_borders()) return true;
  return std::all_of(join.layers.begin(), join.layers.end(), [&](const auto& layers) {
    return group_of(soup_, cut_.side.face(layers[0])) == group_of(soup_, cut_.side.face(layers[1]));
  });
}

/// Returns the mesh faces at all vertices of the layers, in ascending order.
std::vector<Index> FoldoverRemover::faces_at(const LayerJoin& join) const {
  std::vector<Index> faces;
  for (const auto& layers : join.layers) {
    for (const FaceHandle layer : layers) {
      for (const VertexHandle v : cut_.mesh.fv_range(layer)) {
        for (const FaceHandle f : cut_.mesh.vf_range(v)) {
          faces.push_back(static_cast<Index>(f.idx()));
        }
      }
    }
  }
  sort_unique(faces);
  return faces;
}

void FoldoverRemover::put_join(const LayerJoin& join) {
  Edits& edits = result_.edits;
  const Index op = edits.begin_operation();
  const Index kept = cut_.side.vertex(join.kept);
  const Index merged = cut_.side.vertex(join.merged);
  for (const auto& layers : join.layers) {
    for (const FaceHandle f : layers) edits.removed_faces.push_back({op, cut_.side.face(f)});
  }
  for (const FaceHandle f : join.changed) {
    const Index face = cut_.side.face(f);
    edits.changed_faces.push_back({op, face, with_corner(soup_.triangles[face], merged, kept)});
  }
}

}  // namespace

PassResult remove_foldovers(const PassInput& input) {
  const DefectList foldovers = find_foldovers(input.mesh, input.tolerances, input.wants_to_stop);
  if (foldovers.empty()) return {};
  FoldoverRemover remover(input, foldovers);
  for (const Defect& foldover : foldovers) {
    if (input.wants_to_stop()) break;
    remover.treat(foldover);
  }
  return remover.take();
}

}  // namespace meshalyzer
