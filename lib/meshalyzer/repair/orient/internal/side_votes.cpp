#include "meshalyzer/repair/orient/internal/side_votes.h"

#include "meshalyzer/base/triangle.h"
#include "meshalyzer/spatial/unit_scale.h"

#include <cmath>
#include <numeric>

namespace meshalyzer {
namespace {

constexpr std::size_t kMaxSamples = 192;
/// The threshold half-way between a flat sheet (0) and a closed surface (1/2), for the winding
/// number on a face, which is half-way between those on its two sides.
constexpr double kSeparates = 0.25;

Vec3 middle_of(const Corners& t) {
  // The order of the sum makes exchanging the last two change no bit.
  return t[0] / 3 + (t[1] / 3 + t[2] / 3);
}

std::vector<double> areas_of(std::span<const Corners> triangles) {
  const UnitScale scale(triangles);
  std::vector<double> areas(triangles.size());
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const auto& [a, b, c] = triangles[i];
    areas[i] = normal_of(scale(a), scale(b), scale(c)).norm();
  }
  return areas;
}

std::vector<SurfaceSample> sample_all(std::span<const Corners> triangles,
                                      std::span<const double> areas) {
  std::vector<SurfaceSample> samples;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (areas[i] > 0.0) {
      samples.push_back({middle_of(triangles[i]), areas[i]});
    }
  }
  return samples;
}

std::vector<SurfaceSample> sample_some(std::span<const Corners> triangles,
                                       std::span<const double> areas) {
  const double step = std::accumulate(areas.begin(), areas.end(), 0.0) / kMaxSamples;
  std::vector<SurfaceSample> samples;
  double reached = 0.0;
  double next = step / 2;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    reached += areas[i];
    double area = 0.0;
    for (; next < reached; next += step) area += step;
    if (area > 0.0) {
      samples.push_back({middle_of(triangles[i]), area});
    }
  }
  return samples;
}

}  // namespace

std::vector<SurfaceSample> sample_surface(std::span<const Corners> triangles) {
  const std::vector<double> areas = areas_of(triangles);
  return triangles.size() <= kMaxSamples ? sample_all(triangles, areas)
                                         : sample_some(triangles, areas);
}

SideVotes count_votes(const WindingNumbers& surface, std::span<const SurfaceSample> samples) {
  SideVotes votes;
  for (const SurfaceSample& sample : samples) {
    votes.area += sample.area;
    const double winding = surface.at(sample.point);
    if (std::abs(winding) > kSeparates && std::abs(winding) < 1.0 - kSeparates) {
      (winding > 0.0 ? votes.outward : votes.inward) += sample.area;
    }
  }
  return votes;
}

}  // namespace meshalyzer
