#include <iostream>
#include <meshalyzer/analysis/analyze.h>
#include <meshalyzer/io/read.h>
#include <meshalyzer/mesh/build.h>
#include <meshalyzer/repair/fix_defects.h>
#include <string_view>

namespace {

constexpr std::string_view kTetrahedron =
    "Vertex 1 0 0 0\nVertex 2 1 0 0\nVertex 3 0 1 0\nVertex 4 0 0 1\n"
    "Face 1 1 3 2\nFace 2 1 2 4\nFace 3 2 3 4\nFace 4 3 1 4\n";

}  // namespace

int main() {
  const meshalyzer::Soup soup = meshalyzer::parse_mesh(kTetrahedron, "tetrahedron.mesh");
  const meshalyzer::CutMesh cut = meshalyzer::build(soup);
  const meshalyzer::Analysis analysis = meshalyzer::analyze(soup, "tetrahedron.mesh");
  std::cout << cut.mesh.n_vertices() << " vertices, " << cut.mesh.n_faces() << " faces, "
            << (analysis.attributes.closed.value.value_or(false) ? "closed" : "not closed") << '\n';
  return meshalyzer::fix_defects(soup).log.steps.empty() ? 0 : 1;
}
