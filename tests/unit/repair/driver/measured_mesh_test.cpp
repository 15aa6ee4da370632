#include "meshalyzer/repair/driver/internal/measured_mesh.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

TEST(MeasuredMesh, EditsThatStayAreMeasuredThoughTheRepairIsStopped) {
  const Soup plane = shapes::grid(6, 5);
  const Soup planes = shapes::merged(plane, shapes::translated(plane, {0, 0, 0.25}));
  PairLimits limits;
  limits.wants_to_stop = [] { return true; };
  MeasuredMesh mesh(planes, {}, 0.4, limits);
  Edits edits;
  const Index op = edits.begin_operation();
  for (Index face = 0; face < plane.n_faces(); ++face) edits.removed_faces.push_back({op, face});
  mesh.apply_unchecked(edits);
  EXPECT_NEAR(mesh.measure_deviation_but_for_lost(), 0.25, 1e-3 * 0.4);
}

}  // namespace
}  // namespace meshalyzer
