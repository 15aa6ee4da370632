#include "meshalyzer/repair/driver/internal/applied_operations.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

constexpr std::array<std::string_view, 2> kPasses{"first", "second"};
/// The number of squares along each side of a grid, of two faces each.
constexpr Index kWidth = 12;
constexpr Index kFaces = 2 * kWidth * kWidth;

bool has_corner(const Triangle& t, Index v) {
  return std::find(t.begin(), t.end(), v) != t.end();
}

/// Returns an operation that affects some faces in a row, and whose site is every other of them.
AppliedOperation operation_on(const Soup& soup, std::size_t number, Index first, Index n_faces) {
  AppliedOperation operation{
      .pass = kPasses[number % kPasses.size()], .may_create = {}, .site = {}, .vertices = {}};
  if (number % 3 == 0) operation.may_create.insert(DefectCode::SelfIntersection);
  std::set<Index> vertices;
  for (Index f = first; f < std::min(first + n_faces, kFaces); ++f) {
    if (f % 2 == 0) operation.site.push_back(2 * std::uint64_t{f});
    vertices.insert(soup.triangles[f].begin(), soup.triangles[f].end());
  }
  operation.vertices.assign(vertices.begin(), vertices.end());
  return operation;
}

std::vector<AppliedOperation> make_operations(const Soup& soup, std::mt19937& random) {
  std::vector<AppliedOperation> operations;
  std::uniform_int_distribution<Index> first(0, kFaces - 1);
  for (std::size_t i = 0; i < 12; ++i) {
    const Index begin = first(random);
    operations.push_back(operation_on(soup, i, begin, 1 + first(random) / 4));
  }
  return operations;
}

bool affects(const AppliedOperation& operation, const Triangle& corners) {
  return std::all_of(corners.begin(), corners.end(), [&](Index v) {
    return std::binary_search(operation.vertices.begin(), operation.vertices.end(), v);
  });
}

/// Tells whether an element of a site is a vertex of a pair of faces or a face that has one.
bool is_near(const Soup& soup, const WorsePlace& place, std::uint64_t element) {
  return std::any_of(place.corners.begin(), place.corners.end(), [&](const Triangle& corners) {
    return std::any_of(corners.begin(), corners.end(), [&](Index v) {
      if (element % 2 == 1) return element / 2 == v;
      return has_corner(soup.triangles[element / 2], v);
    });
  });
}

using Bans = std::set<std::pair<std::string_view, std::uint64_t>>;

/// Bans operations by the definition, place by place.
Bans ban_by_definition(const Soup& soup, const std::vector<AppliedOperation>& operations,
                       const std::vector<WorsePlace>& places, Responsible choice) {
  Bans bans;
  for (const WorsePlace& place : places) {
    std::vector<const AppliedOperation*> responsible;
    for (const AppliedOperation& operation : operations) {
      if (affects(operation, place.corners[0]) || affects(operation, place.corners[1])) {
        responsible.push_back(&operation);
      }
    }
    if (choice == Responsible::Last && !responsible.empty()) {
      const AppliedOperation* chosen = responsible.back();
      for (const AppliedOperation* operation : responsible) {
        if (operation->may_create.contains(DefectCode::SelfIntersection)) chosen = operation;
      }
      responsible = {chosen};
    }
    for (const AppliedOperation* operation : responsible) {
      Bans near;
      Bans all;
      for (const std::uint64_t element : operation->site) {
        all.insert({operation->pass, element});
        if (is_near(soup, place, element)) near.insert({operation->pass, element});
      }
      bans.merge(near.empty() ? all : near);
    }
  }
  return bans;
}

TEST(BannedOperations, AreThoseOfTheDefinition) {
  const Soup soup = shapes::grid(kWidth, kWidth);
  std::mt19937 random(7);
  std::uniform_int_distribution<Index> any(0, kFaces - 1);
  std::size_t n_bans = 0;
  for (int run = 0; run < 200; ++run) {
    const std::vector<AppliedOperation> operations = make_operations(soup, random);
    std::vector<WorsePlace> places;
    for (int i = 0; i < 1 + run % 20; ++i) {
      places.push_back({CountedDefect::IntersectingPairs,
                        {soup.triangles[any(random)], soup.triangles[any(random)]}});
    }
    for (const Responsible choice : {Responsible::Last, Responsible::All}) {
      const Bans expected = ban_by_definition(soup, operations, places, choice);
      BannedOperations banned;
      ban_responsible(operations, places, choice, soup, banned);
      EXPECT_EQ(banned.size(), expected.size());
      for (const auto& [pass, element] : expected) EXPECT_TRUE(banned.contains(pass, {element}));
      n_bans += expected.size();
    }
  }
  EXPECT_GT(n_bans, 1000U);
}

TEST(BannedOperations, AreWholeWhereNoPartIsNearThePlace) {
  const Soup soup = shapes::grid(kWidth, kWidth);
  // The operation has changed faces far from those that it affects.
  const std::vector<AppliedOperation> operations{
      {.pass = "first", .may_create = {}, .site = {200, 220, 240}, .vertices = {0, 1, 14}}};
  BannedOperations banned;
  ban_responsible(operations, {{CountedDefect::ZeroAreaFaces, {Triangle{0, 1, 14}, kNoTriangle}}},
                  Responsible::All, soup, banned);
  EXPECT_EQ(banned.size(), 3U);
}

}  // namespace
}  // namespace meshalyzer
