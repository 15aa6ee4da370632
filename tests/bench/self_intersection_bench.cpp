// Self-intersection side by side with CGAL's. That package is under the GPL, so it may be measured
// against, but never be linked to the library nor installed: this program is neither.

#include "big_meshes.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/self_intersection.h"

#include <benchmark/benchmark.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace meshalyzer;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using CgalFace = CgalMesh::Face_index;

/// A mesh to search: a file, or a kind of big_mesh().
struct Input {
  const char* name;
  std::size_t faces = 0;
};

Soup soup_of(const Input& input) {
  return input.faces == 0 ? read_mesh(input.name) : bench::big_mesh(input.name, input.faces);
}

void per_face(benchmark::State& state, std::size_t faces, std::size_t pairs) {
  state.counters["s_per_face"] =
      benchmark::Counter(static_cast<double>(faces), benchmark::Counter::kIsIterationInvariantRate |
                                                         benchmark::Counter::kInvert);
  state.counters["faces"] = static_cast<double>(faces);
  state.counters["pairs"] = static_cast<double>(pairs);
}

/// The tree and the search, one thread.
void ours(benchmark::State& state, const Input& input) {
  const ThreadLimit one(1);
  const CutMesh cut = build(soup_of(input));
  std::size_t pairs = 0;
  for (auto _ : state) {
    const FaceTree tree(cut);
    pairs = find_self_intersections(cut, tree).size();
  }
  per_face(state, cut.mesh.n_faces(), pairs);
}

void cgal(benchmark::State& state, const Input& input) {
  const Soup soup = soup_of(input);
  CgalMesh mesh;
  for (const Vec3& p : soup.positions) {
    mesh.add_vertex({p.x(), p.y(), p.z()});
  }
  for (const Triangle& t : soup.triangles) {
    mesh.add_face(CgalMesh::Vertex_index(t[0]), CgalMesh::Vertex_index(t[1]),
                  CgalMesh::Vertex_index(t[2]));
  }
  std::size_t pairs = 0;
  for (auto _ : state) {
    std::vector<std::pair<CgalFace, CgalFace>> found;
    CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(
        mesh, std::back_inserter(found));
    pairs = found.size();
  }
  per_face(state, mesh.number_of_faces(), pairs);
}

void compare(const std::string& name, const Input& input) {
  const auto add = [&](const std::string& side, auto run) {
    benchmark::RegisterBenchmark((name + "/" + side).c_str(), run, input)
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime();
  };
  add("ours", ours);
  add("cgal", cgal);
}

}  // namespace

/// self_intersection_bench [--benchmark_...] [FILE...]: the generated meshes, and then the files.
int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  compare("small", {"wavy", 2000});
  compare("scan", {"wavy", 86000});
  compare("subdivided", {"subdivided", 1400000});
  compare("crossing", {"crossing", 1040000});
  compare("cad", {"cad", 77000});
  compare("slivers", {"beam", 20000});
  for (int i = 1; i < argc; ++i) {
    compare(argv[i], {argv[i]});
  }
  benchmark::RunSpecifiedBenchmarks();
}
