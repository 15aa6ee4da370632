#include "meshalyzer/repair/guarantee/internal/boundary_loss.h"

#include "meshalyzer/prepared/prepared_mesh.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

namespace meshalyzer {
namespace {

FacePieces all_faces(const TrackedMesh& mesh) {
  FacePieces pieces;
  for (Index face = 0; face < mesh.soup.n_faces(); ++face) {
    pieces.corners.push_back(corners_of(mesh.soup, face));
    pieces.face_keys.push_back(mesh.face_keys[face]);
  }
  return pieces;
}

/// A cube of side 2, with a smaller one inside, replaced by the lower half of the larger one.
class HalfOfACubeIsLost : public ::testing::Test {
 protected:
  static Soup lower_half() {
    Soup half = shapes::cube(2);
    for (Vec3& p : half.positions) p.z() /= 2;
    return half;
  }
  static bool any(const Vec3& /*point*/) { return true; }

  TrackedMesh mesh_ =
      track_mesh(shapes::merged(shapes::cube(2), shapes::cube(0.5, {0.75, 0.75, 1.25})));
  FacePieces pieces_ = all_faces(mesh_);
  PreparedMesh half_{lower_half()};
  std::shared_ptr<const ReplacedMesh> replaced_ = std::make_shared<ReplacedMesh>(mesh_, 1e-3);

  /// What is lost, up to a limit and beyond.
  [[nodiscard]] BoundaryLoss loss(double limit) const {
    return {replaced_, pieces_, half_.tree(), limit};
  }
};

TEST_F(HalfOfACubeIsLost, FarSamplesLieOnTheBoundaryAndKnowTheirFaces) {
  const std::vector<BoundarySample> far = loss(0.5).beyond_limit();
  ASSERT_FALSE(far.empty());
  for (const BoundarySample& sample : far) {
    EXPECT_NEAR(sample.distance, sample.point.z() - 1.0, 1e-12);
    EXPECT_GT(sample.distance, 0.5);
    // The faces of the inner cube are walls inside the solid.
    ASSERT_LT(sample.face_key, 12U);
    const Corners face = corners_of(mesh_.soup, sample.face_key);
    const Vec3 normal = (face[1] - face[0]).cross(face[2] - face[0]).normalized();
    EXPECT_NEAR(normal.dot(sample.point - face[0]), 0.0, 1e-12);
  }
  EXPECT_TRUE(loss(1.0).beyond_limit().empty());
}

TEST_F(HalfOfACubeIsLost, LargestDistanceIsThatOfTheTop) {
  EXPECT_NEAR(loss(2.0).largest_within_limit(0.0, any), 1.0, 1e-12);
  // There are samples up to any limit, no farther apart than the spacing.
  EXPECT_LE(loss(0.7).largest_within_limit(0.0, any), 0.7);
  EXPECT_NEAR(loss(0.7).largest_within_limit(0.0, any), 0.7, replaced_->spacing());
  EXPECT_EQ(loss(2.0).largest_within_limit(1.5, any), 1.5);
  const auto is_below = [](const Vec3& point) { return point.z() < 1.25; };
  EXPECT_NEAR(loss(2.0).largest_within_limit(0.0, is_below), 0.25, replaced_->spacing());
}

TEST_F(HalfOfACubeIsLost, MeshIsKnownByItsShapeAndItsKeys) {
  EXPECT_TRUE(replaced_->is(mesh_));
  TrackedMesh other = mesh_;
  std::swap(other.face_keys.front(), other.face_keys.back());
  EXPECT_FALSE(replaced_->is(other));
  other = mesh_;
  other.soup.positions.front().x() += 1;
  EXPECT_FALSE(replaced_->is(other));
}

}  // namespace
}  // namespace meshalyzer
