#include "meshalyzer/base/control_group.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace meshalyzer {
namespace {

/// Control groups as the system shows them, with the limits that a test sets.
class Groups {
 public:
  void set(const std::string& file, const std::string& content) const {
    const std::filesystem::path path = folder_.file(file);
    std::filesystem::create_directories(path.parent_path());
    write_bytes(path.string(), content);
  }
  [[nodiscard]] std::optional<std::uint64_t> memory_of(const std::string& own_groups) const {
    write_bytes(folder_.file("own"), own_groups);
    return control_group_memory({.own_groups = folder_.file("own"), .root = folder_.path()});
  }

 private:
  TemporaryFolder folder_;
};

TEST(ControlGroupMemory, WithoutGroupsThereIsNoLimit) {
  const TemporaryFolder folder;
  EXPECT_EQ(control_group_memory({.own_groups = folder.file("none"), .root = folder.path()}),
            std::nullopt);
  EXPECT_EQ(Groups().memory_of("0::/\n"), std::nullopt);
}

TEST(ControlGroupMemory, ReadsTheLimitOfTheOwnGroup) {
  const Groups groups;
  groups.set("job/memory.max", "1000000\n");
  groups.set("other/memory.max", "5\n");
  EXPECT_EQ(groups.memory_of("0::/job\n"), 1000000U);
}

TEST(ControlGroupMemory, ALimitOfAGroupAroundHoldsToo) {
  const Groups groups;
  groups.set("slice/job/memory.max", "3000\n");
  groups.set("slice/memory.max", "2000\n");
  groups.set("memory.max", "4000\n");
  EXPECT_EQ(groups.memory_of("0::/slice/job\n"), 2000U);
}

TEST(ControlGroupMemory, TheWordMaxSetsNoLimit) {
  const Groups groups;
  groups.set("job/memory.max", "max\n");
  EXPECT_EQ(groups.memory_of("0::/job\n"), std::nullopt);
}

TEST(ControlGroupMemory, InsideAContainerTheRootHasTheLimit) {
  const Groups groups;
  groups.set("memory.max", "7000\n");
  EXPECT_EQ(groups.memory_of("0::/as/the/host/sees/it\n"), 7000U);
}

TEST(ControlGroupMemory, VersionOneHasAHierarchyForMemory) {
  const Groups groups;
  groups.set("memory/docker/a:b/memory.limit_in_bytes", "9000\n");
  groups.set("cpu/docker/a:b/memory.limit_in_bytes", "1\n");
  EXPECT_EQ(groups.memory_of("5:cpu,cpuacct:/docker/a:b\n4:memory:/docker/a:b\n0::/\n"), 9000U);
  EXPECT_EQ(groups.memory_of("4:hugetlb,memory,pids:/docker/a:b\n"), 9000U);
}

TEST(ControlGroupMemory, AHierarchyThatOnlySoundsLikeMemorySetsNoLimit) {
  const Groups groups;
  groups.set("memory/job/memory.limit_in_bytes", "1\n");
  EXPECT_EQ(groups.memory_of("3:name=memory:/job\n"), std::nullopt);
}

TEST(ControlGroupMemory, TheSmallerOfBothVersionsHolds) {
  const Groups groups;
  groups.set("memory/memory.limit_in_bytes", "9223372036854771712\n");
  groups.set("memory.max", "800\n");
  EXPECT_EQ(groups.memory_of("4:memory:/\n0::/\n"), 800U);
}

TEST(ControlGroupMemory, LinesThatMeanNothingSetNoLimit) {
  const Groups groups;
  groups.set("job/memory.max", "lots\n");
  EXPECT_EQ(groups.memory_of("\nnonsense\n4:memory\n0::/job\n"), std::nullopt);
}

}  // namespace
}  // namespace meshalyzer
