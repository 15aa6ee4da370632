#include "big_meshes.h"
#include "meshalyzer/arrangement/arrange.h"
#include "meshalyzer/geometry/curvature.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/io/write.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/picture/scene.h"
#include "meshalyzer/repair/driver/internal/face_distance.h"
#include "meshalyzer/repair/driver/internal/searched_surface.h"
#include "meshalyzer/spatial/mutual_intersection.h"
#include "meshalyzer/spatial/self_intersection.h"
#include "meshalyzer/spatial/winding_number.h"
#include "meshalyzer/topology/components.h"

#include <benchmark/benchmark.h>

#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace meshalyzer;

constexpr std::size_t kFaces = 1000000;

const Soup& soup_of(const std::string& kind) {
  static std::string held;
  static Soup soup;
  if (held != kind) {
    soup = bench::big_mesh(kind, kFaces);
    held = kind;
  }
  return soup;
}

void per_face(benchmark::State& state, std::size_t faces) {
  state.counters["s_per_face"] =
      benchmark::Counter(static_cast<double>(faces), benchmark::Counter::kIsIterationInvariantRate |
                                                         benchmark::Counter::kInvert);
}

void parse_mesh_text(benchmark::State& state) {
  const std::string text = print_mesh(soup_of("wavy"), Format::Mesh);
  for (auto _ : state) {
    benchmark::DoNotOptimize(parse_mesh(text, "wavy.mesh"));
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(text.size() * state.iterations()));
}
BENCHMARK(parse_mesh_text)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void build_half_edges(benchmark::State& state) {
  const Soup& soup = soup_of("wavy");
  for (auto _ : state) {
    benchmark::DoNotOptimize(build(soup));
  }
  per_face(state, soup.n_faces());
}
BENCHMARK(build_half_edges)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void find_components_wavy(benchmark::State& state) {
  const CutMesh cut = build(soup_of("wavy"));
  for (auto _ : state) {
    benchmark::DoNotOptimize(find_components(cut));
  }
  per_face(state, cut.mesh.n_faces());
}
BENCHMARK(find_components_wavy)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void curvature(benchmark::State& state, const std::string& kind) {
  const CutMesh cut = build(soup_of(kind));
  for (auto _ : state) {
    benchmark::DoNotOptimize(measure_curvature(cut));
  }
  per_face(state, cut.mesh.n_faces());
}
BENCHMARK_CAPTURE(curvature, wavy, "wavy")->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(curvature, shuffled, "shuffled")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

/// Makes the scene of a page of a big mesh, with its defects known.
void scene_with_all_fields(benchmark::State& state) {
  const Soup& soup = soup_of("damaged");
  const PreparedMesh mesh(soup);
  const DefectReport report = find_defects(mesh);
  for (auto _ : state) {
    benchmark::DoNotOptimize(make_scene({mesh, &report}, computed_field_names()));
  }
  per_face(state, soup.n_faces());
}
BENCHMARK(scene_with_all_fields)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void self_intersections(benchmark::State& state, const std::string& kind) {
  const CutMesh cut = build(soup_of(kind));
  for (auto _ : state) {
    const FaceTree tree(cut);
    benchmark::DoNotOptimize(find_self_intersections(cut, tree));
  }
  per_face(state, cut.mesh.n_faces());
}
BENCHMARK_CAPTURE(self_intersections, wavy, "wavy")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(self_intersections, flat, "flat")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(self_intersections, crossing, "crossing")
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

/// A fifth of the faces: the search for pairs apart.
void arrangement_of_crossing(benchmark::State& state) {
  const Soup soup = bench::big_mesh("crossing", kFaces / 5);
  const CutMesh cut = build(soup);
  const std::vector<IntersectingPair> pairs = find_self_intersections(cut, FaceTree(cut));
  for (auto _ : state) {
    benchmark::DoNotOptimize(arrange(soup, pairs));
  }
  state.counters["s_per_pair"] = benchmark::Counter(
      static_cast<double>(pairs.size()),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(arrangement_of_crossing)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

void self_intersections_of_slivers(benchmark::State& state) {
  const CutMesh cut = build(bench::big_mesh("slivers", 20000));
  for (auto _ : state) {
    const FaceTree tree(cut);
    benchmark::DoNotOptimize(find_self_intersections(cut, tree));
  }
  per_face(state, cut.mesh.n_faces());
}
BENCHMARK(self_intersections_of_slivers)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

/// A mesh of half the faces against a copy of it, scaled and then moved: the search alone, without
/// the trees.
void mutual_intersection(benchmark::State& state, const std::string& kind, double scale,
                         const Vec3& by) {
  Soup soup = bench::big_mesh(kind, kFaces / 2);
  const CutMesh a = build(soup);
  for (Vec3& p : soup.positions) {
    p = scale * p + by;
  }
  const CutMesh b = build(soup);
  const FaceTree tree_a(a);
  const FaceTree tree_b(b);
  for (auto _ : state) {
    benchmark::DoNotOptimize(find_intersections(a, tree_a, b, tree_b));
  }
  per_face(state, tree_a.n_faces() + tree_b.n_faces());
}
BENCHMARK_CAPTURE(mutual_intersection, apart, "wavy", 0.45, Vec3(0, 0, 0))
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(mutual_intersection, crossing, "wavy", 0.97, Vec3(0, 0, 0))
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(mutual_intersection, identical, "wavy", 1.0, Vec3(0, 0, 0))
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();
BENCHMARK_CAPTURE(mutual_intersection, slivers, "slivers", 0.99, Vec3(0, 0, 0))
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

/// @param step  Every face with a number that this divides is left out; 0 leaves out none.
void winding_numbers(benchmark::State& state, std::size_t step, ExpectedQueries expected) {
  const Soup soup = bench::big_mesh("wavy", kFaces / 10);
  std::vector<Corners> triangles;
  Box3 box;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    if (step != 0 && f % step == 0) continue;
    triangles.push_back(corners_of(soup, f));
    for (const Vec3& p : triangles.back()) box.extend(p);
  }
  const WindingNumbers numbers(std::move(triangles), expected);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (auto _ : state) {
    const double x = share(random);
    const double y = share(random);
    const Vec3 place = box.min() + box.sizes().cwiseProduct(Vec3(x, y, share(random)));
    benchmark::DoNotOptimize(numbers.at_both(place, place + Vec3::Constant(1e-6)));
  }
}
BENCHMARK_CAPTURE(winding_numbers, closed_few, 0, ExpectedQueries::Few);
BENCHMARK_CAPTURE(winding_numbers, closed_many, 0, ExpectedQueries::Many);
BENCHMARK_CAPTURE(winding_numbers, holes_few, 100, ExpectedQueries::Few);
BENCHMARK_CAPTURE(winding_numbers, holes_many, 100, ExpectedQueries::Many);

// A square of 2 n^2 faces, whose inner vertices are moved at random: in the plane by up to a third
// of a side, and out of it by up to a thousandth.
Soup uneven_square(Index n) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  Soup soup;
  for (Index i = 0; i <= n; ++i) {
    for (Index k = 0; k <= n; ++k) {
      const bool is_inside = i > 0 && i < n && k > 0 && k < n;
      const Vec3 move(share(random) / 3, share(random) / 3, share(random) / 1000);
      soup.positions.push_back(Vec3(i, k, 0) + (is_inside ? move : Vec3(0, 0, 0)));
    }
  }
  for (Index i = 0; i < n; ++i) {
    for (Index k = 0; k < n; ++k) {
      const Index a = i * (n + 1) + k;
      soup.triangles.push_back({a, a + n + 1, a + n + 2});
      soup.triangles.push_back({a, a + n + 2, a + 1});
    }
  }
  return soup;
}

// A face of the input that was cut into so many: how far is it from them?
void distance_of_cut_face(benchmark::State& state, Index n, DistanceQuestion question) {
  const SearchedSurface surface(uneven_square(n));
  const double end = n;
  const Corners face{Vec3(0, 0, 0), Vec3(end, 0, 0), Vec3(end, end, 0)};
  constexpr double kBound = 0.01;
  for (auto _ : state) {
    SurfaceDistance meter(surface.tree, surface.closest, kBound, question, 0.0);
    benchmark::DoNotOptimize(meter.measure(face));
  }
}
BENCHMARK_CAPTURE(distance_of_cut_face, how_far_100, 10, DistanceQuestion::HowFar)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(distance_of_cut_face, how_far_900, 30, DistanceQuestion::HowFar)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(distance_of_cut_face, is_within_900, 30, DistanceQuestion::IsWithin)
    ->Unit(benchmark::kMillisecond);

}  // namespace
