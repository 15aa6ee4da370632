#include "meshalyzer/repair/driver/internal/remembered_pass.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

/// Asks a remembered pass that proposes one operation.
class RememberedPass : public testing::Test {
 protected:
  void ask(const PassFunction& pass, std::size_t mesh_number,
           OperationSize size = OperationSize::Normal, const StopQuery& wants_to_stop = {}) {
    const PassResult answer = pass({.original = soup_,
                                    .tracked = tracked_,
                                    .mesh = mesh_,
                                    .tolerances = tolerances_,
                                    .limits = limits_,
                                    .operation_size = size,
                                    .wants_to_stop = wants_to_stop,
                                    .mesh_number = mesh_number});
    EXPECT_EQ(answer.edits.n_operations, 1U);
  }

  std::size_t n_runs_ = 0;
  RepairLimits limits_;
  PassFunction pass_ = remembered_pass([this](const PassInput&) {
    ++n_runs_;
    PassResult result;
    static_cast<void>(result.edits.begin_operation());
    return result;
  });

 private:
  Soup soup_ = shapes::cube();
  TrackedMesh tracked_ = track_mesh(soup_);
  PreparedMesh mesh_{soup_};
  Tolerances tolerances_;
};

TEST_F(RememberedPass, AnswersTwiceForTheSameMesh) {
  const PassFunction copy = pass_;
  ask(pass_, 1);
  ask(copy, 1);
  EXPECT_EQ(n_runs_, 1U);
}

TEST_F(RememberedPass, ForgetsWhatItHasAnsweredTwice) {
  for (int i = 0; i < 3; ++i) ask(pass_, 1);
  EXPECT_EQ(n_runs_, 2U);
}

TEST_F(RememberedPass, ComputesAnewForAnotherMesh) {
  ask(pass_, 1);
  ask(pass_, 2);
  EXPECT_EQ(n_runs_, 2U);
}

TEST_F(RememberedPass, ComputesAnewForOtherFixedVertices) {
  limits_.fixed_vertices = {1, 1, 1};
  ask(pass_, 1);
  limits_.fixed_vertices = {1, 0, 0};
  ask(pass_, 1);
  EXPECT_EQ(n_runs_, 2U);
}

TEST_F(RememberedPass, ComputesAnewForAMeshWithoutNumber) {
  ask(pass_, 0);
  ask(pass_, 0);
  EXPECT_EQ(n_runs_, 2U);
}

TEST_F(RememberedPass, ComputesAnewForSmallerOperations) {
  ask(pass_, 1);
  ask(pass_, 1, OperationSize::Smallest);
  EXPECT_EQ(n_runs_, 2U);
}

TEST_F(RememberedPass, RemembersNothingOfAPassThatWasStopped) {
  ask(pass_, 1, OperationSize::Normal, [] { return true; });
  ask(pass_, 1);
  EXPECT_EQ(n_runs_, 2U);
}

}  // namespace
}  // namespace meshalyzer
