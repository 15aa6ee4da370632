#include "meshalyzer/repair/holes/internal/triangulate_loop.h"

#include "meshalyzer/base/parallel.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <tuple>

namespace meshalyzer {
namespace {

/// The cost of a triangulation: the less the better, the first figures first.
struct Weight {
  std::uint32_t n_collinear = 0;
  std::uint32_t n_thin = 0;
  double bend = 0.0;
  double cost = 0.0;

  friend bool operator<(const Weight& a, const Weight& b) {
    return std::tie(a.n_collinear, a.n_thin, a.bend, a.cost) <
           std::tie(b.n_collinear, b.n_thin, b.bend, b.cost);
  }
};

constexpr Weight kImpossible{.n_collinear = std::numeric_limits<std::uint32_t>::max()};

Weight joined(const Weight& a, const Weight& b) {
  return {.n_collinear = a.n_collinear + b.n_collinear,
          .n_thin = a.n_thin + b.n_thin,
          .bend = std::max(a.bend, b.bend),
          .cost = a.cost + b.cost};
}

/// The best triangulation of the part of the loop between two of its corners.
struct Part {
  Weight weight;
  /// The corner of the triangle on the chord that cuts the part off.
  std::uint32_t tip = 0;
  /// The normal of that triangle; for a single edge, that of the face beyond.
  Vec3 normal = Vec3::Zero();

  [[nodiscard]] bool is_possible() const { return weight.n_collinear != kImpossible.n_collinear; }
};

/// The number of parts that are worth a task of their own.
constexpr std::size_t kPartsPerTask = 32;

class Triangulator {
 public:
  Triangulator(const LoopPolygon& polygon, const LoopRules& rules)
      : polygon_(polygon), rules_(rules), n_(polygon.size()), parts_(n_ * (n_ - 1) / 2) {
    for (std::size_t i = 0; i + 1 < n_; ++i) part(i, i + 1).normal = polygon.normals[i];
  }

  [[nodiscard]] std::optional<std::vector<Triangle>> run() {
    for (std::size_t length = 2; length < n_; ++length) {
      // All that a part depends on is shorter.
      parallel_chunks(n_ - length, kPartsPerTask, [&](Chunk chunk) {
        for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
          part(i, i + length) = best(i, i + length);
        }
      });
    }
    if (!part(0, n_ - 1).is_possible()) return std::nullopt;
    return triangles();
  }

 private:
  [[nodiscard]] Part& part(std::size_t i, std::size_t j) { return parts_[j * (j - 1) / 2 + i]; }

  [[nodiscard]] bool is_closing(std::size_t i, std::size_t j) const {
    return i == 0 && j + 1 == n_;
  }

  [[nodiscard]] Triangle corners(std::size_t i, std::size_t k, std::size_t j) const {
    return {polygon_.vertices[i], polygon_.vertices[k], polygon_.vertices[j]};
  }

  [[nodiscard]] Part best(std::size_t i, std::size_t j) {
    Part found{.weight = kImpossible};
    if (!is_closing(i, j) && !rules_.allows_chord(polygon_.vertices[i], polygon_.vertices[j])) {
      return found;
    }
    for (std::size_t k = i + 1; k < j; ++k) {
      const Part& left = part(i, k);
      const Part& right = part(k, j);
      if (!left.is_possible() || !right.is_possible()) continue;
      const Weight sum = joined(left.weight, right.weight);
      if (!(sum < found.weight) || !rules_.allows_triangle(corners(i, k, j))) continue;
      const Part candidate = with_triangle(sum, i, k, j);
      if (candidate.weight < found.weight) found = candidate;
    }
    return found;
  }

  /// Combines two parts and the triangle between them.
  [[nodiscard]] Part with_triangle(const Weight& parts, std::size_t i, std::size_t k,
                                   std::size_t j) {
    const CandidateTriangle triangle = measure_candidate(polygon_.points[i], polygon_.points[k],
                                                         polygon_.points[j], polygon_.thin);
    Part result{.weight = parts, .tip = static_cast<std::uint32_t>(k), .normal = triangle.normal};
    result.weight.n_collinear += triangle.fault == TriangleFault::Collinear ? 1 : 0;
    result.weight.n_thin += triangle.fault == TriangleFault::Thin ? 1 : 0;
    result.weight.cost += triangle.cost;
    if (rules_.weight == LoopWeight::BendThenArea) {
      double& bend = result.weight.bend;
      bend = std::max(bend, bend_between(triangle.normal, part(i, k).normal));
      bend = std::max(bend, bend_between(triangle.normal, part(k, j).normal));
      if (is_closing(i, j)) {
        bend = std::max(bend, bend_between(triangle.normal, polygon_.normals.back()));
      }
    }
    return result;
  }

  [[nodiscard]] std::vector<Triangle> triangles() {
    std::vector<Triangle> result;
    result.reserve(n_ - 2);
    std::vector<std::array<std::size_t, 2>> open{{0, n_ - 1}};
    while (!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      if (j == i + 1) continue;
      const std::size_t k = part(i, j).tip;
      result.push_back(corners(i, k, j));
      open.push_back({k, j});
      open.push_back({i, k});
    }
    return result;
  }

  const LoopPolygon& polygon_;
  const LoopRules& rules_;
  std::size_t n_;
  /// The index of the part between corners i < j is j (j - 1) / 2 + i.
  std::vector<Part> parts_;
};

}  // namespace

std::optional<std::vector<Triangle>> triangulate_loop(const LoopPolygon& polygon,
                                                      const LoopRules& rules) {
  return Triangulator(polygon, rules).run();
}

}  // namespace meshalyzer
