#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/defects/finders.h"
#include "meshalyzer/defects/internal/places.h"
#include "meshalyzer/exact/normal.h"
#include "meshalyzer/exact/predicates.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

namespace meshalyzer {
namespace {

/// Returns the distance of two points; it neither overflows early nor loses digits to underflow.
double length_between(const Vec3& from, const Vec3& to) {
  const Vec3 difference = to - from;
  const double size = difference.cwiseAbs().maxCoeff();
  return size > 1e-100 && size < 1e100 ? difference.norm() : difference.stableNorm();
}

/// Returns the lengths of the edges from corner k to corner k + 1.
std::array<double, 3> edge_lengths(const Corners& p) {
  return {length_between(p[0], p[1]), length_between(p[1], p[2]), length_between(p[2], p[0])};
}

Vec3 difference_in_units(const Vec3& from, const Vec3& to, double unit) {
  return unit > 1.0 ? Vec3((to / 2 - from / 2) / (unit / 2)) : Vec3((to - from) / unit);
}

/// Returns twice the area in units of the longest edge.
double altitude_in_units(const Corners& p, double longest) {
  const double unit = std::min(longest, std::numeric_limits<double>::max());
  const Vec3 u = difference_in_units(p[0], p[1], unit);
  const Vec3 v = difference_in_units(p[0], p[2], unit);
  return accurate_normal(Vec3::Zero(), u, v).stableNorm() * unit;
}

/// Returns the shortest altitude, that on the longest edge. It is 0 exactly if the corners are
/// collinear.
double shortest_altitude(const Corners& p, double longest) {
  // Squares of lengths in this range neither overflow nor underflow.
  const bool is_usual = longest > 1e-100 && longest < 1e100;
  if (are_collinear(p)) return 0.0;
  const double altitude =
      is_usual ? accurate_normal(p).stableNorm() / longest : altitude_in_units(p, longest);
  return std::max(altitude, std::numeric_limits<double>::denorm_min());
}

/// A quick test that recognises most faces that are not thin.
class Glance {
 public:
  /// Squares beyond the range of double become 0 or infinite; a positive answer of
  /// is_surely_thick() is still right.
  explicit Glance(double tolerance) : least_(tolerance * tolerance * 1.0001) {}

  /// Tells whether surely no edge and no altitude is 0 or below the tolerance. The answer is no for
  /// a face that names a vertex twice.
  [[nodiscard]] bool is_surely_thick(const Corners& p) const {
    const Vec3 u = p[1] - p[0];
    const Vec3 v = p[2] - p[0];
    const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (v - u).squaredNorm()});
    const double twice_area = u.cross(v).squaredNorm();
    // The altitude on the longest edge is the shortest, and no longer than any edge. The product is
    // accurate enough if the face is no sliver: see accurate_normal().
    return longest > 1e-140 && longest < 1e140 && twice_area > 2e-11 * longest * longest &&
           twice_area > least_ * longest;
  }

 private:
  double least_;
};

/// Examines the faces of a soup one by one.
class ThinFacetFinder {
 public:
  ThinFacetFinder(const Soup& soup, double tolerance)
      : soup_(soup), tolerance_(tolerance), glance_(tolerance) {}

  [[nodiscard]] DefectList find_in(Chunk chunk) const {
    DefectList found;
    for (std::size_t f = chunk.begin; f < chunk.end; ++f) {
      const Triangle& t = soup_.triangles[f];
      if (!has_all_corners(t)) continue;
      const Corners p = corners_of(soup_.positions, t);
      if (!glance_.is_surely_thick(p)) look_closely(static_cast<Index>(f), p, found);
    }
    return found;
  }

 private:
  [[nodiscard]] bool is_short(double length) const { return length < tolerance_ || length == 0.0; }

  void look_closely(Index face, const Corners& p, DefectList& found) const {
    const std::array<double, 3> lengths = edge_lengths(p);
    const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());
    if (is_short(*shortest)) {
      found.push_back(degenerate(face, lengths));
      return;
    }
    const double altitude = shortest_altitude(p, *longest);
    if (!is_short(altitude)) return;
    Defect defect = make_defect(DefectCode::FlatFacet);
    defect.faces = {face};
    defect.positions = middle_of_face(soup_, face);
    defect.value = altitude;
    defect.limit = tolerance_;
    found.push_back(defect);
  }

  /// Returns the defect of a degenerate facet. If it names a vertex twice, that vertex is at an
  /// edge of length 0.
  [[nodiscard]] Defect degenerate(Index face, const std::array<double, 3>& lengths) const {
    const Triangle& t = soup_.triangles[face];
    const auto shortest = static_cast<std::size_t>(
        std::min_element(lengths.begin(), lengths.end()) - lengths.begin());
    Defect defect = make_defect(DefectCode::DegenerateFacet);
    defect.faces = {face};
    defect.positions = {middle_of_edge(soup_, {t[shortest], t[(shortest + 1) % 3]})};
    defect.value = lengths[shortest];
    defect.limit = tolerance_;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
      if (low == high) {
        defect.vertices = {low};
      } else if (is_short(lengths[k])) {
        defect.edges.push_back({low, high});
      }
    }
    // Two sides of a face that names a vertex twice are one edge.
    sort_unique(defect.edges);
    return defect;
  }

  const Soup& soup_;
  double tolerance_;
  Glance glance_;
};

}  // namespace

DefectList find_thin_facets(const PreparedMesh& mesh, const Tolerances& tolerances) {
  const Soup& soup = mesh.soup();
  const ThinFacetFinder finder(soup, tolerances.degeneracy);
  auto parts =
      map_chunks<DefectList>(soup.n_faces(), [&](Chunk chunk) { return finder.find_in(chunk); });
  DefectList defects;
  for (DefectList& part : parts) {
    const std::size_t n = part.size();
    defects.append(std::move(part), n);
  }
  return defects;
}

}  // namespace meshalyzer
