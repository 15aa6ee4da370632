#include "meshalyzer/base/enum_table.h"

#include <gtest/gtest.h>

namespace meshalyzer {
namespace {

enum class Size { Small, Large };

struct Row {
  int length;
  Size size;
};

TEST(IsInEnumOrder, EachRowIsThatOfItsEnumerator) {
  EXPECT_TRUE(is_in_enum_order(std::array{Row{1, Size::Small}, Row{9, Size::Large}}, &Row::size));
  EXPECT_FALSE(is_in_enum_order(std::array{Row{9, Size::Large}, Row{1, Size::Small}}, &Row::size));
  EXPECT_FALSE(is_in_enum_order(std::array{Row{1, Size::Small}, Row{2, Size::Small}}, &Row::size));
}

}  // namespace
}  // namespace meshalyzer
