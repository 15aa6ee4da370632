// Closest points side by side with CGAL's AABB tree. That package is under the GPL, so it may be
// measured against, but never be linked to the library nor installed: this program is neither.

#include "big_meshes.h"
#include "meshalyzer/geometry/vertex_normals.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/closest_point.h"

#include <benchmark/benchmark.h>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <cmath>
#include <random>
#include <string_view>
#include <vector>

namespace {

using namespace meshalyzer;

constexpr std::size_t kFaces = 86000;

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using CgalTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 cgal_point(const Vec3& p) {
  return {p.x(), p.y(), p.z()};
}

/// One mesh in both trees, and the points to ask for.
struct Scene {
  Soup soup = bench::big_mesh("wavy", kFaces);
  CutMesh cut = build(soup);
  FaceTree tree{cut};
  ClosestPoints closest{tree};
  Triangles triangles;
  CgalTree cgal_tree;
  /// The mesh's vertices moved outward by 0 ... 10 edges, in the order of the file, which goes
  /// round the torus.
  std::vector<Vec3> nearby;
  /// In the mesh's bounding box, at random.
  std::vector<Vec3> anywhere;

  Scene() {
    for (const Triangle& t : soup.triangles) {
      triangles.emplace_back(cgal_point(soup.positions[t[0]]), cgal_point(soup.positions[t[1]]),
                             cgal_point(soup.positions[t[2]]));
    }
    cgal_tree.insert(triangles.begin(), triangles.end());
    cgal_tree.build();
    cgal_tree.accelerate_distance_queries();
    std::mt19937 random(1);
    std::uniform_real_distribution<> real(0.0, 1.0);
    const Triangle& first = soup.triangles.front();
    const double edge = (soup.positions[first[0]] - soup.positions[first[1]]).norm();
    const std::vector<Vec3> normals = vertex_normals(cut);
    for (std::size_t i = 0; i < normals.size(); ++i) {
      nearby.push_back(soup.positions[i] + 10 * edge * real(random) * normals[i]);
    }
    const Box3& box = tree.bounds();
    for (std::size_t i = 0; i < normals.size(); ++i) {
      const Vec3 share(real(random), real(random), real(random));
      anywhere.push_back(box.min() + share.cwiseProduct(box.sizes()));
    }
  }
};

const Scene& scene() {
  static const Scene held;
  return held;
}

void per_query(benchmark::State& state, std::size_t n) {
  state.counters["s_per_query"] =
      benchmark::Counter(static_cast<double>(n), benchmark::Counter::kIsIterationInvariantRate |
                                                     benchmark::Counter::kInvert);
}

enum class Hint { None, Previous };

void ours(benchmark::State& state, std::vector<Vec3> Scene::*points, Hint hint) {
  const std::vector<Vec3>& queries = scene().*points;
  for (auto _ : state) {
    Index previous = kNoIndex;
    for (const Vec3& p : queries) {
      const auto found = scene().closest.find({.point = p, .hint = previous});
      previous = hint == Hint::Previous ? found->slot : kNoIndex;
      benchmark::DoNotOptimize(found->distance);
    }
  }
  per_query(state, queries.size());
}

void ours_in_cone(benchmark::State& state) {
  // 60 degrees round the direction from the vertex moved outward back to the mesh.
  const std::vector<Vec3> normals = vertex_normals(scene().cut);
  for (auto _ : state) {
    Index previous = kNoIndex;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      const auto found = scene().closest.find(
          {.point = scene().nearby[i], .cone = Cone{-normals[i], 0.5}, .hint = previous});
      previous = found ? found->slot : kNoIndex;
      benchmark::DoNotOptimize(previous);
    }
  }
  per_query(state, normals.size());
}

void cgal(benchmark::State& state, std::vector<Vec3> Scene::*points, Hint hint) {
  const std::vector<Vec3>& queries = scene().*points;
  const CgalTree& tree = scene().cgal_tree;
  for (auto _ : state) {
    auto previous = tree.any_reference_point_and_id();
    for (const Vec3& p : queries) {
      const auto found = hint == Hint::Previous
                             ? tree.closest_point_and_primitive(cgal_point(p), previous)
                             : tree.closest_point_and_primitive(cgal_point(p));
      previous = found;
      benchmark::DoNotOptimize(CGAL::squared_distance(cgal_point(p), found.first));
    }
  }
  per_query(state, queries.size());
}

BENCHMARK_CAPTURE(ours, nearby, &Scene::nearby, Hint::None)->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(ours, nearby_hinted, &Scene::nearby, Hint::Previous)->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(ours, anywhere, &Scene::anywhere, Hint::None)->MeasureProcessCPUTime();
BENCHMARK(ours_in_cone)->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(cgal, nearby, &Scene::nearby, Hint::None)->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(cgal, nearby_hinted, &Scene::nearby, Hint::Previous)->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(cgal, anywhere, &Scene::anywhere, Hint::None)->MeasureProcessCPUTime();

}  // namespace

BENCHMARK_MAIN();
