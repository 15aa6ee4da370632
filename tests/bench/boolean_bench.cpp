// Booleans side by side with CGAL's. That package is under the GPL, so it may be measured against,
// but never be linked to the library nor installed: this program is neither.

#include "big_meshes.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/boolean/combine_solids.h"

#include <benchmark/benchmark.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>
#include <string>
#include <vector>

namespace {

using namespace meshalyzer;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// A mesh, and a copy of it that was turned about an axis and moved.
std::vector<Soup> two_meshes(const char* kind, std::size_t faces) {
  std::vector<Soup> meshes{bench::big_mesh(kind, faces)};
  Soup other = meshes.front();
  Box3 box;
  for (const Vec3& p : other.positions) box.extend(p);
  const Vec3 centre = box.center();
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
  for (Vec3& p : other.positions) p = centre + turn * (p - centre);
  meshes.push_back(std::move(other));
  return meshes;
}

CgalMesh cgal_mesh(const Soup& soup) {
  CgalMesh mesh;
  for (const Vec3& p : soup.positions) mesh.add_vertex({p.x(), p.y(), p.z()});
  for (const Triangle& t : soup.triangles) {
    mesh.add_face(CgalMesh::Vertex_index(t[0]), CgalMesh::Vertex_index(t[1]),
                  CgalMesh::Vertex_index(t[2]));
  }
  return mesh;
}

void ours(benchmark::State& state, const std::vector<Soup>& meshes, std::size_t threads) {
  const ThreadLimit limit(threads);
  CombinedSolid solid;
  for (auto _ : state) {
    const Soup all = concatenate(meshes);
    solid = combine_solids(operands_of(all, meshes), union_rule());
  }
  state.counters["faces"] = static_cast<double>(solid.faces.size());
  state.counters["pairs"] = static_cast<double>(solid.n_pairs);
}

void cgal(benchmark::State& state, const std::vector<Soup>& meshes) {
  const CgalMesh a = cgal_mesh(meshes[0]);
  const CgalMesh b = cgal_mesh(meshes[1]);
  CgalMesh result;
  for (auto _ : state) {
    CgalMesh one = a;
    CgalMesh two = b;
    result.clear();
    if (!CGAL::Polygon_mesh_processing::corefine_and_compute_union(one, two, result)) {
      state.SkipWithError("no manifold result");
    }
  }
  state.counters["faces"] = static_cast<double>(result.number_of_faces());
}

void compare(const std::string& name, const std::vector<Soup>& meshes) {
  const auto add = [&](const std::string& side, auto run) {
    benchmark::RegisterBenchmark((name + "/" + side).c_str(), run)
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime()
        ->UseRealTime();
  };
  add("ours, 1 thread", [meshes](benchmark::State& state) { ours(state, meshes, 1); });
  add("ours, 2 threads", [meshes](benchmark::State& state) { ours(state, meshes, 2); });
  add("cgal", [meshes](benchmark::State& state) { cgal(state, meshes); });
}

}  // namespace

/// boolean_bench [--benchmark_...]: the union of a mesh and a turned copy of it.
int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  compare("wavy", two_meshes("wavy", 100000));
  benchmark::RunSpecifiedBenchmarks();
}
