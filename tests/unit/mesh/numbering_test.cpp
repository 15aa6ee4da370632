#include "meshalyzer/mesh/numbering.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

std::optional<Index> misnumbered(std::vector<std::int32_t> ids, Format format = Format::Mesh) {
  const std::size_t n = ids.size();
  return first_misnumbered({.first = 1, .named = std::move(ids)}, format, n);
}

TEST(FirstMisnumbered, IdsFromOneOnAreInOrder) {
  EXPECT_EQ(misnumbered({}), std::nullopt);
  EXPECT_EQ(misnumbered({1, 2, 3}), std::nullopt);
  EXPECT_EQ(first_misnumbered({}, Format::Mesh, 5), std::nullopt);
}

TEST(FirstMisnumbered, IsTheFirstThatIsNotItsNumber) {
  EXPECT_EQ(misnumbered({0, 1, 2}), Index{0});
  EXPECT_EQ(misnumbered({1, 2, 4, 3}), Index{2});
  EXPECT_EQ(misnumbered({1, 2, 2}), Index{2});
}

TEST(FirstMisnumbered, OtherFormatsHaveNoIdsOfTheirOwn) {
  EXPECT_EQ(misnumbered({7, 8}, Format::Obj), std::nullopt);
}

}  // namespace
}  // namespace meshalyzer
