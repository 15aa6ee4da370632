#include "curvature_peers.h"
#include "meshalyzer/geometry/curvature.h"
#include "meshalyzer/mesh/build.h"
#include "support/curved_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/core.h>
#include <functional>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <vector>

namespace meshalyzer::bench {
namespace {

constexpr std::size_t kLevels = 4;
/// The level that methods are compared at.
constexpr std::size_t kCompared = 2;
/// Surfaces where all tangents are principal directions have none to be right about.
constexpr double kUmbilic = 1e-6;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A mesh, and what is true of it.
struct Case {
  std::vector<shapes::TrueCurvature> truth;
  CutMesh cut;
};

/// The meshes of a surface in one meshing, coarse to fine.
struct Series {
  shapes::Surface surface = shapes::Surface::Sphere;
  shapes::Meshing meshing = shapes::Meshing::Regular;
  std::vector<Case> cases{};
};

std::vector<Series> make_series() {
  std::vector<Series> all;
  for (const shapes::Surface surface : shapes::kSurfaces) {
    for (const shapes::Meshing meshing : shapes::kMeshings) {
      Series& series = all.emplace_back(Series{.surface = surface, .meshing = meshing});
      for (std::size_t level = 1; level <= kLevels; ++level) {
        const shapes::CurvedShape shape = shapes::curved_shape(surface, meshing, level);
        series.cases.push_back({shape.truth, build(shape.soup)});
      }
    }
  }
  return all;
}

/// The errors of a quantity on a mesh; relative, or in degrees.
struct Error {
  double typical = 0.0;
  double largest = 0.0;
};

/// Leaves out the sphere, which has no principal directions and comes first.
std::span<const Series> but_spheres(std::span<const Series> all) {
  return all.subspan(shapes::kMeshings.size());
}

/// Errors over vertices, relative to the root mean square of what is true, or to 1 (the surfaces
/// are of size 1) where that is zero. A missing answer counts as 0.
class RelativeError {
 public:
  void add(double estimate, double truth) {
    const double error = (std::isfinite(estimate) ? estimate : 0.0) - truth;
    sum_ += error * error;
    largest_ = std::max(largest_, std::abs(error));
    true_sum_ += truth * truth;
    n_ += 1.0;
  }
  [[nodiscard]] Error error() const {
    const double scale = std::sqrt(true_sum_ / n_);
    const double unit = scale > 1e-9 ? scale : 1.0;
    return {std::sqrt(sum_ / n_) / unit, largest_ / unit};
  }

 private:
  double sum_ = 0.0;
  double true_sum_ = 0.0;
  double largest_ = 0.0;
  double n_ = 0.0;
};

bool is_inner(const Case& c, std::size_t v) {
  return !c.cut.mesh.is_boundary(VertexHandle(static_cast<int>(v)));
}

using Column = std::vector<double> Curvature::*;
using Truth = double shapes::TrueCurvature::*;

Error error_of(const Case& c, VertexArea area, Column column, Truth truth) {
  const Curvature curvature = measure_curvature(c.cut, area);
  RelativeError error;
  for (std::size_t v = 0; v < c.truth.size(); ++v) {
    if (is_inner(c, v)) error.add((curvature.*column)[v], c.truth[v].*truth);
  }
  return error.error();
}

/// Returns the error of k1 and k2 together.
Error principal_error(const Case& c, const std::vector<PrincipalEstimate>& estimates) {
  RelativeError error;
  for (std::size_t v = 0; v < c.truth.size(); ++v) {
    if (!is_inner(c, v)) continue;
    error.add(estimates[v].k1, c.truth[v].k1);
    error.add(estimates[v].k2, c.truth[v].k2);
  }
  return error.error();
}

/// Degrees in the tangent plane, each weighted by k1 - k2; NaN where a method has no directions.
Error direction_error(const Case& c, const std::vector<PrincipalEstimate>& estimates) {
  Error error;
  double weights = 0.0;
  for (std::size_t v = 0; v < c.truth.size(); ++v) {
    const shapes::TrueCurvature& truth = c.truth[v];
    const double weight = truth.k1 - truth.k2;
    if (!is_inner(c, v) || weight < kUmbilic) continue;
    const Vec3& d = estimates[v].direction1;
    const double angle = d.isZero(0.0) ? kNone
                                       : std::atan2(std::abs(d.dot(truth.direction2)),
                                                    std::abs(d.dot(truth.direction1)));
    error.typical += weight * angle * 180 / std::numbers::pi;
    error.largest = std::max(error.largest, angle * 180 / std::numbers::pi);
    weights += weight;
  }
  if (weights > 0.0) error.typical /= weights;
  return error;
}

/// A way to estimate principal curvatures, ours or a published one.
struct Method {
  std::string name;
  std::function<std::vector<PrincipalEstimate>(const CutMesh&)> estimate;
};

std::vector<PrincipalEstimate> ours(const CutMesh& cut) {
  const Curvature curvature = measure_curvature(cut);
  std::vector<PrincipalEstimate> result(curvature.state.size());
  for (std::size_t v = 0; v < result.size(); ++v) {
    result[v] = {curvature.k1[v], curvature.k2[v], curvature.direction1[v],
                 curvature.direction2[v]};
  }
  return result;
}

std::vector<Method> methods() {
  std::vector<Method> all{{"**meshalyzer**", ours}};
  for (const CurvatureMethod& published : published_methods()) {
    all.push_back({std::string(published.name),
                   [=](const CutMesh& cut) { return published.estimate(cut.mesh); }});
  }
  return all;
}

/// A figure that is measured of a mesh, and its name in a table.
struct Measure {
  std::string name;
  std::function<Error(const Case&)> error;
};

/// Two digits, or a dash for none.
std::string cell(double value) {
  return std::isnan(value) ? "-" : fmt::format("{:.2g}", value);
}

/// One row a surface, meshing and measure: the error at each level, the order that the last two
/// tell, and the largest error at the last.
void print_table(std::string_view title, std::span<const Series> all,
                 const std::vector<Measure>& measures) {
  fmt::print("\n### {}\n\n| surface | meshing | by |", title);
  for (std::size_t level = 1; level <= kLevels; ++level) fmt::print(" level {} |", level);
  fmt::print(" order | largest |\n|---|---|---|---:|---:|---:|---:|---:|---:|\n");
  for (const Series& series : all) {
    for (const Measure& measure : measures) {
      fmt::print("| {} | {} | {} |", shapes::surface_name(series.surface),
                 shapes::meshing_name(series.meshing), measure.name);
      std::vector<Error> errors;
      for (const Case& c : series.cases) {
        errors.push_back(measure.error(c));
        fmt::print(" {} |", cell(errors.back().typical));
      }
      const double before = errors[kLevels - 2].typical;
      const double last = errors[kLevels - 1].typical;
      // Rounding has no order.
      const bool has_order = before > 1e-9 && last > 1e-9;
      fmt::print(" {} | {} |\n", has_order ? fmt::format("{:.1f}", std::log2(before / last)) : "",
                 cell(errors[kLevels - 1].largest));
    }
  }
}

void print_areas(std::string_view title, std::span<const Series> all, Column column, Truth truth) {
  std::vector<Measure> measures;
  for (const VertexArea area :
       {VertexArea::Mixed, VertexArea::Voronoi, VertexArea::Barycentric, VertexArea::OneRing}) {
    measures.push_back({std::string(area_name(area)),
                        [=](const Case& c) { return error_of(c, area, column, truth); }});
  }
  print_table(title, all, measures);
}

void print_methods(std::string_view title, std::span<const Series> all,
                   Error (*error)(const Case&, const std::vector<PrincipalEstimate>&)) {
  std::vector<Measure> measures;
  for (const Method& method : methods()) {
    measures.push_back({std::string(method.name),
                        [=](const Case& c) { return error(c, method.estimate(c.cut)); }});
  }
  print_table(title, all, measures);
}

/// The middle and the largest of a method's errors over the surfaces.
std::array<double, 2> over_surfaces(std::span<const Series> all, shapes::Meshing meshing,
                                    const Method& method,
                                    Error (*error)(const Case&,
                                                   const std::vector<PrincipalEstimate>&)) {
  std::vector<double> errors;
  for (const Series& series : all) {
    if (series.meshing != meshing) continue;
    const Case& c = series.cases[kCompared];
    errors.push_back(error(c, method.estimate(c.cut)).typical);
  }
  std::sort(errors.begin(), errors.end());
  return {(errors[(errors.size() - 1) / 2] + errors[errors.size() / 2]) / 2, errors.back()};
}

void print_summary(std::span<const Series> all) {
  fmt::print("\n### Methods over all surfaces, level {}\n\n| method |", kCompared + 1);
  for (const shapes::Meshing meshing : shapes::kMeshings) {
    fmt::print(" {}: median | worst | degrees |", shapes::meshing_name(meshing));
  }
  fmt::print("\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const Method& method : methods()) {
    fmt::print("| {} |", method.name);
    for (const shapes::Meshing meshing : shapes::kMeshings) {
      const auto [median, worst] = over_surfaces(all, meshing, method, principal_error);
      const auto [degrees, _] = over_surfaces(but_spheres(all), meshing, method, direction_error);
      fmt::print(" {} | {} | {} |", cell(median), cell(worst), cell(degrees));
    }
    fmt::print("\n");
  }
}

}  // namespace
}  // namespace meshalyzer::bench

/// Prints how right the curvatures are on surfaces of known curvature, and how right published
/// methods are, as Markdown.
int main() {
  using namespace meshalyzer;
  using namespace meshalyzer::bench;
  const std::vector<Series> all = make_series();
  print_summary(all);
  print_areas("Gaussian curvature", all, &Curvature::gaussian, &shapes::TrueCurvature::gaussian);
  print_areas("Mean curvature", all, &Curvature::mean, &shapes::TrueCurvature::mean);
  print_methods("Principal curvatures", all, principal_error);
  print_methods("Principal directions, degrees", but_spheres(all), direction_error);
  return 0;
}
