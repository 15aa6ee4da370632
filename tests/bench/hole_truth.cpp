#include "support/curved_shapes.h"
#include "support/punched_holes.h"

#include <array>
#include <fmt/core.h>
#include <string_view>

// Punches holes into surfaces, fills them, and prints how far the patches are from what was there,
// in percent of the diameter of the hole: mean and largest, by the pass as it chooses, by the patch
// of least area, and by the other shapes.
namespace meshalyzer::bench {
namespace {

constexpr std::size_t kLevel = 3;
constexpr std::array kRadii{0.25, 0.4, 0.6};
constexpr std::array kFillings{test::Filling::Auto, test::Filling::LeastArea, test::Filling::Linear,
                               test::Filling::Smooth};

/// The vertex that is farthest from all borders the shapes have: the first near (1, 0, 0) on a
/// round one, and near the middle of the others.
Index vertex_to_punch(const Soup& soup) {
  Box3 box;
  for (const Vec3& p : soup.positions) box.extend(p);
  const Vec3 wanted(box.max().x(), 0.0, 0.0);
  const bool is_graph = box.max().x() < 1.1 && box.diagonal().z() < 1.5;
  Index nearest = 0;
  double least = -1.0;
  for (Index v = 0; v < soup.n_vertices(); ++v) {
    const double distance = (soup.positions[v] - (is_graph ? Vec3(0.2, 0.1, 0.0) : wanted)).norm();
    if (least < 0.0 || distance < least) nearest = v;
    if (nearest == v) least = distance;
  }
  return nearest;
}

void print_row(shapes::Surface surface, shapes::Meshing meshing, double radius) {
  const Soup soup = shapes::curved_shape(surface, meshing, kLevel).soup;
  const test::PunchedMesh punched = test::punch(soup, vertex_to_punch(soup), radius);
  fmt::print("| {} | {} | {} |", shapes::surface_name(surface), shapes::meshing_name(meshing),
             punched.lost.n_faces());
  for (const test::Filling filling : kFillings) {
    const test::FillError error = test::fill_error(punched, filling);
    fmt::print(" {:.2f} {:.2f} ({}) |", 100.0 * error.mean, 100.0 * error.largest, error.n_faces);
  }
  fmt::print("\n");
}

void run() {
  fmt::print("| surface | meshing | faces lost | auto | least area | linear | smooth |\n");
  fmt::print("|---|---|---|---|---|---|---|\n");
  for (const shapes::Surface surface : shapes::kSurfaces) {
    for (const shapes::Meshing meshing : shapes::kMeshings) {
      for (const double radius : kRadii) print_row(surface, meshing, radius);
    }
  }
}

}  // namespace
}  // namespace meshalyzer::bench

int main() {
  meshalyzer::bench::run();
}
