#include "meshalyzer/checks/check_mesh.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/checks/profile.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace meshalyzer {
namespace {

CheckCriteria solid() {
  return find_profile("solid")->criteria;
}

FileFindings check_solid(const Soup& soup) {
  return check_mesh(soup, "it", solid());
}

/// Faces with random corners in the unit cube: more than a quarter of all pairs intersect.
Soup random_faces(std::size_t n) {
  std::mt19937 random(20261122);
  std::uniform_real_distribution<double> coordinate(0.0, 1.0);
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  for (Index f = 0; f < n; ++f) {
    triangles.push_back({3 * f, 3 * f + 1, 3 * f + 2});
    for (int k = 0; k < 3; ++k) {
      positions.emplace_back(coordinate(random), coordinate(random), coordinate(random));
    }
  }
  return shapes::make(std::move(positions), std::move(triangles));
}

TEST(CheckMesh, GoodMeshHasNoFindings) {
  const FileFindings file = check_solid(shapes::cube());
  EXPECT_TRUE(file.is_good());
  EXPECT_TRUE(file.findings.empty());
  EXPECT_EQ(file.path, "it");
  EXPECT_EQ(file.vertices, 8U);
  EXPECT_EQ(file.faces, 12U);
}

TEST(CheckMesh, FindingNamesElementsLineAndMeans) {
  Soup soup = shapes::two_tetrahedra_sharing_vertex();
  soup.vertex_lines.resize(soup.n_vertices());
  for (Index v = 0; v < soup.n_vertices(); ++v) soup.vertex_lines[v] = 100 + v;
  const FileFindings file = check_solid(soup);
  ASSERT_EQ(file.findings.size(), 1U);
  const Finding& finding = file.findings[0];
  EXPECT_EQ(finding.code, "non-manifold");
  EXPECT_EQ(finding.severity, Severity::Error);
  EXPECT_EQ(finding.message, "vertex 1 joins 2 fans of faces");
  EXPECT_EQ(finding.fix, "meshfixer splits it");
  EXPECT_EQ(finding.line, 100U);
  EXPECT_EQ(finding.vertices, (std::vector<std::int64_t>{1}));
}

TEST(CheckMesh, ErrorsComeBeforeWarnings) {
  Soup soup = shapes::open_cube();
  soup.positions.emplace_back(5.0, 5.0, 5.0);
  const FileFindings file = check_solid(soup);
  ASSERT_EQ(file.counts.size(), 2U);
  EXPECT_EQ(file.counts[0].code, "hole");
  EXPECT_EQ(file.counts[1].code, "orphan-vertex");
  EXPECT_EQ(file.counts[1].severity, Severity::Warning);
}

TEST(CheckMesh, ListsNoMoreOfACodeThanAskedForAndCountsAll) {
  Soup soup = shapes::cube();
  for (int i = 0; i < 7; ++i) soup.positions.emplace_back(5.0, 5.0, i);
  CheckCriteria criteria = solid();
  criteria.max_listed = 2;
  const FileFindings cut = check_mesh(soup, "it", criteria);
  EXPECT_EQ(cut.findings.size(), 2U);
  ASSERT_EQ(cut.counts.size(), 1U);
  EXPECT_EQ(cut.counts[0].count, 7U);
  EXPECT_EQ(cut.counts[0].fixable, 7U);
  EXPECT_FALSE(cut.counts[0].is_at_least);
  criteria.max_listed = 0;
  EXPECT_EQ(check_mesh(soup, "it", criteria).findings.size(), 7U);
}

TEST(CheckMesh, MeshWithoutFacesIsNotGood) {
  const FileFindings file = check_solid(shapes::make({Vec3::Zero()}, {}));
  ASSERT_FALSE(file.findings.empty());
  EXPECT_EQ(file.findings[0].code, "min-faces");
  EXPECT_EQ(file.findings[0].message, "number of faces 0, below 1");
}

TEST(CheckMesh, SearchForPairsEndsEarlyAndSaysSo) {
  CheckCriteria criteria = solid();
  criteria.max_pairs = 1000;
  const FileFindings file = check_mesh(random_faces(2000), "it", criteria);
  const auto found =
      std::find_if(file.counts.begin(), file.counts.end(),
                   [](const FindingCount& count) { return count.code == "self-intersection"; });
  ASSERT_NE(found, file.counts.end());
  EXPECT_TRUE(found->is_at_least);
}

/// Returns the first self-intersection that a check finds.
Finding first_self_intersection(const Soup& soup, const CheckCriteria& criteria) {
  const std::vector<Finding> findings = check_mesh(soup, "it", criteria).findings;
  const auto found = std::find_if(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.code == "self-intersection";
  });
  return found == findings.end() ? Finding() : *found;
}

TEST(CheckMesh, SelfIntersectionIsOfAtLeastTheFacesAndPairsThatWereFound) {
  CheckCriteria criteria = solid();
  const Soup soup = random_faces(60);
  const Finding whole = first_self_intersection(soup, criteria);
  EXPECT_FALSE(whole.is_at_least);
  EXPECT_EQ(whole.message.find("at least"), std::string::npos);
  // More than a quarter of the 60 * 59 / 2 = 1770 pairs of faces intersect, so more than 300.
  criteria.max_pairs = 300;
  const Finding cut = first_self_intersection(soup, criteria);
  EXPECT_TRUE(cut.is_at_least);
  EXPECT_EQ(cut.value, 300.0);
  EXPECT_EQ(cut.message.substr(0, 9), "at least ");
  EXPECT_NE(cut.message.find(" faces from face "), std::string::npos);
  EXPECT_NE(cut.message.find(" intersect in at least 300 pairs"), std::string::npos);
}

TEST(CheckMesh, CountsInSentencesHaveTheirDigitsInGroups) {
  CheckCriteria criteria = solid();
  criteria.max_pairs = 12345;
  const Finding cut = first_self_intersection(random_faces(2000), criteria);
  EXPECT_NE(cut.message.find(" intersect in at least 12,345 pairs"), std::string::npos);
  EXPECT_NE(cut.message.find(" on intersect"), std::string::npos);
}

TEST(CheckMesh, FindingsDoNotDependOnThreads) {
  CheckCriteria criteria = solid();
  criteria.max_pairs = 1000;
  const Soup soup = random_faces(2000);
  const auto messages_with = [&](std::size_t n_threads) {
    const ThreadLimit limit(n_threads);
    std::string messages;
    for (const Finding& finding : check_mesh(soup, "it", criteria).findings) {
      messages += finding.message + '\n';
    }
    return messages;
  };
  EXPECT_EQ(messages_with(1), messages_with(4));
}

TEST(CheckMesh, PositionThatIsNotFiniteIsCorruptAndHeldToNoLimit) {
  Soup soup = shapes::cube();
  soup.positions[1].z() = std::numeric_limits<double>::quiet_NaN();
  CheckCriteria criteria = solid();
  criteria.limits[LimitKind::MinCornerAngle] = 10.0;
  const FileFindings found = check_mesh(soup, "cube", criteria);
  ASSERT_EQ(found.counts.size(), 1U);
  EXPECT_EQ(found.counts[0].code, "corrupt");
}

}  // namespace
}  // namespace meshalyzer
