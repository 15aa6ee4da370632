#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/base/items_by_group.h"
#include "meshalyzer/base/sum.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/defects/internal/places.h"
#include "meshalyzer/geometry/face_measures.h"
#include "meshalyzer/topology/components.h"
#include "meshalyzer/topology/edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace meshalyzer {
namespace {

/// Areas that differ by at most this share of the larger one count as equal.
constexpr double kSameArea = 1e-9;

/// The faces of a region that agree with each other.
struct Side {
  CompensatedSum area;
  std::size_t n_faces = 0;
};

/// The patches (see find_oriented_regions()) and the regions that they form when joined through
/// flipped edges. A region is named by its lowest patch, which is on its first side.
class Regions {
 public:
  explicit Regions(const CutMesh& cut)
      : cut_(cut), patches_(find_oriented_regions(cut)), sides_(2 * patches_.count) {
    join_patches();
    region_.resize(patches_.count);
    side_.resize(patches_.count);
    one_sided_.assign(patches_.count, 0);
    for (Index p = 0; p < patches_.count; ++p) {
      const Index as_is = sides_.find(2 * p);
      const Index turned = sides_.find(2 * p + 1);
      region_[p] = std::min(as_is, turned) / 2;
      side_[p] = as_is < turned ? 0 : 1;
      one_sided_[region_[p]] = as_is == turned ? 1 : 0;
    }
    choose_sides();
  }

  [[nodiscard]] std::size_t n_patches() const { return patches_.count; }
  [[nodiscard]] Index patch_of(std::size_t mesh_face) const { return patches_.of_face[mesh_face]; }
  [[nodiscard]] Index region_of(Index patch) const { return region_[patch]; }
  [[nodiscard]] bool is_one_sided(Index patch) const { return one_sided_[region_[patch]] != 0; }
  /// Tells whether a patch is on the side that is to be reversed.
  [[nodiscard]] bool is_turned(Index patch) const {
    return !is_one_sided(patch) && side_[patch] == turned_side_[region_[patch]];
  }

 private:
  /// Joins patches that must be reversed together. Each patch has two nodes, one for keeping it (2
  /// p) and one for reversing it (2 p + 1), as in find_orientability().
  void join_patches() {
    const CutEdges& flipped = cut_.side.flipped_edges;
    for (std::size_t i = 0; i < flipped.size(); ++i) {
      const Index p = patch_at(flipped[i].halfedges[0]);
      const Index q = patch_at(flipped[i].halfedges[1]);
      sides_.unite(2 * p, 2 * q + 1);
      sides_.unite(2 * p + 1, 2 * q);
    }
  }

  [[nodiscard]] Index patch_at(HalfedgeHandle h) const { return patches_.of(cut_.mesh, h); }

  void choose_sides() {
    std::vector<std::array<Side, 2>> sides(patches_.count);
    for (const FaceHandle f : cut_.mesh.all_faces()) {
      const Index p = patches_.of(f);
      const Corners t = face_corners(cut_.mesh, f);
      Side& side = sides[region_[p]][side_[p]];
      side.area.add(normal_of(t).norm());
      ++side.n_faces;
    }
    turned_side_.resize(patches_.count);
    std::transform(sides.begin(), sides.end(), turned_side_.begin(), smaller_side);
  }

  /// Returns the side with less area or, where areas are equal, fewer faces; if these are equal
  /// too, the second side, which does not have the lowest face. Areas too large for a double are
  /// equal.
  static std::uint8_t smaller_side(const std::array<Side, 2>& sides) {
    const double a = sides[0].area.value();
    const double b = sides[1].area.value();
    if (std::isfinite(a) && std::isfinite(b) && std::abs(a - b) > kSameArea * std::max(a, b)) {
      return a < b ? 0 : 1;
    }
    return sides[0].n_faces < sides[1].n_faces ? 0 : 1;
  }

  const CutMesh& cut_;
  Components patches_;
  DisjointSets sides_;
  /// The region of each patch, and the side of that on which it is.
  std::vector<Index> region_;
  std::vector<std::uint8_t> side_;
  /// #regions: 1 if no reversal makes the region consistent.
  std::vector<std::uint8_t> one_sided_;
  std::vector<std::uint8_t> turned_side_;
};

/// Makes the defects of the patches to be reversed and of one-sided regions, each at its lowest
/// face.
class Listing {
 public:
  Listing(const PreparedMesh& mesh, const Regions& regions)
      : mesh_(mesh), regions_(regions), number_(regions.n_patches(), kNoIndex) {}

  DefectList list() {
    const std::vector<Index> defect_of_face = number_faces();
    const std::vector<Index> defect_of_edge = number_edges();
    const ItemsByGroup faces(defect_of_face, is_fixable_.size());
    const ItemsByGroup edges(defect_of_edge, is_fixable_.size());
    DefectList defects;
    for (std::size_t i = 0; i < is_fixable_.size(); ++i) {
      defects.push_back(describe(faces[i], edges[i], is_fixable_[i] != 0));
    }
    return defects;
  }

 private:
  /// Returns the number of the defect that a patch belongs to; new ones are numbered as they come.
  Index number_of(Index patch) {
    const bool one_sided = regions_.is_one_sided(patch);
    Index& number = number_[one_sided ? regions_.region_of(patch) : patch];
    if (number == kNoIndex) {
      number = static_cast<Index>(is_fixable_.size());
      is_fixable_.push_back(one_sided ? 0 : 1);
    }
    return number;
  }

  /// Returns the defect of each mesh face, kNoIndex if it stays as it is.
  std::vector<Index> number_faces() {
    std::vector<Index> defect_of(mesh_.cut().side.faces.size(), kNoIndex);
    for (std::size_t f = 0; f < defect_of.size(); ++f) {
      const Index patch = regions_.patch_of(f);
      if (regions_.is_turned(patch) || regions_.is_one_sided(patch)) {
        defect_of[f] = number_of(patch);
      }
    }
    return defect_of;
  }

  /// Returns the defect of each flipped edge: that of the one of its two patches that is to be
  /// reversed, or of the region if that is one-sided.
  std::vector<Index> number_edges() {
    const CutMesh& cut = mesh_.cut();
    const auto patch_at = [&](HalfedgeHandle h) {
      return regions_.patch_of(static_cast<std::size_t>(cut.mesh.face_handle(h).idx()));
    };
    std::vector<Index> defect_of;
    for (std::size_t i = 0; i < cut.side.flipped_edges.size(); ++i) {
      const auto halfedges = cut.side.flipped_edges[i].halfedges;
      const Index second = patch_at(halfedges[1]);
      defect_of.push_back(number_of(regions_.is_turned(second) ? second : patch_at(halfedges[0])));
    }
    return defect_of;
  }

  [[nodiscard]] Defect describe(std::span<const Index> faces, std::span<const Index> edges,
                                bool is_fixable) const {
    const CutMesh& cut = mesh_.cut();
    Defect defect = make_defect(DefectCode::Flipped);
    defect.fixable = is_fixable;
    for (const Index f : faces) defect.faces.push_back(cut.side.faces[f]);
    for (const Index e : edges) {
      const auto ends = ascending_file_ends(cut, cut.side.flipped_edges[e].halfedges[0]);
      if (defect.edges.empty()) defect.positions = {middle_of_edge(mesh_.soup(), ends)};
      defect.edges.push_back(ends);
    }
    return defect;
  }

  const PreparedMesh& mesh_;
  const Regions& regions_;
  /// #patches: the defect of each patch, or of the region that it names; kNoIndex for none.
  std::vector<Index> number_;
  /// #defects: 0 for those of one-sided regions.
  std::vector<std::uint8_t> is_fixable_;
};

}  // namespace

DefectList find_flipped(const PreparedMesh& mesh) {
  if (mesh.cut().side.flipped_edges.size() == 0) {
    return {};
  }
  const Regions regions(mesh.cut());
  return Listing(mesh, regions).list();
}

}  // namespace meshalyzer
