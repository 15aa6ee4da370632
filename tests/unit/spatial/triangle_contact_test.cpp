#include "meshalyzer/spatial/triangle_contact.h"

#include "support/effort.h"
#include "support/exact_oracle.h"
#include "support/random_soups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>

namespace meshalyzer {
namespace {

using test::oracle_contact;

constexpr unsigned kContactSeed = 20261121;
using Random = std::mt19937;

std::string name_of(const std::optional<ContactKind>& kind) {
  return kind ? std::string(contact_name(*kind)) : "none";
}

/// A source of corners, and how many pairs to take from it.
struct Source {
  std::function<Vec3(Random&)> point;
  int pairs;
};

/// Fills two triangles whose first `common` corners are the same.
std::pair<Corners, Corners> random_pair(const Source& source, Common common, Random& random) {
  Corners p;
  Corners q;
  std::generate(p.begin(), p.end(), [&] { return source.point(random); });
  std::generate(q.begin(), q.end(), [&] { return source.point(random); });
  std::copy_n(p.begin(), static_cast<int>(common), q.begin());
  return {p, q};
}

void expect_agreement(const Source& source) {
  Random random(kContactSeed);
  for (const Common common : {Common::Nothing, Common::Vertex, Common::Edge}) {
    int contacts = 0;
    for (int i = 0; i < source.pairs / static_cast<int>(test::one_of()); ++i) {
      const auto [p, q] = random_pair(source, common, random);
      const auto expected = oracle_contact(p, q, common);
      contacts += expected.has_value() ? 1 : 0;
      ASSERT_EQ(name_of(find_contact(p, q, common)), name_of(expected))
          << "pair " << i << " common " << static_cast<int>(common) << " seed " << kContactSeed;
      ASSERT_EQ(name_of(find_contact(q, p, common)), name_of(expected)) << "exchanged, pair " << i;
    }
    EXPECT_GT(contacts, 0) << "the source never makes a contact: it tests nothing";
  }
}

TEST(FindContact, AgreesWithRationalsOnRandomTriangles) {
  const auto real = [](Random& r) { return std::uniform_real_distribution<>(-1, 1)(r); };
  // Coplanar neighbours do not occur here, so the source for a common edge flattens every third
  // pair.
  expect_agreement(
      {[&](Random& r) { return Vec3(real(r), real(r), r() % 3 == 0 ? 0.0 : real(r)); }, 3000});
}

TEST(FindContact, AgreesWithRationalsOnSmallLattices) {
  for (const int n : {2, 3, 4}) {
    expect_agreement(
        {[n](Random& r) { return Vec3(lattice(r, n), lattice(r, n), lattice(r, n)); }, 4000});
  }
}

TEST(FindContact, AgreesWithRationalsInOnePlane) {
  expect_agreement({[](Random& r) {
                      const double x = lattice(r, 5);
                      const double y = lattice(r, 5);
                      return Vec3(x, y, 2 * x - y);
                    },
                    4000});
}

TEST(FindContact, AgreesWithRationalsOnOneLine) {
  expect_agreement({[](Random& r) -> Vec3 { return Vec3(1, 2, 3) * lattice(r, 5); }, 2000});
}

TEST(FindContact, AgreesWithRationalsNearlyInOnePlane) {
  expect_agreement({[](Random& r) {
                      const double x = 0.1 * lattice(r, 5);
                      const double y = 0.1 * lattice(r, 5);
                      return Vec3(x, y, 0.3 * x + 0.7 * y);
                    },
                    4000});
}

TEST(FindContact, AgreesWithRationalsAtExtremeMagnitudes) {
  expect_agreement({[](Random& r) -> Vec3 {
                      const double scale = r() % 2 == 0 ? 1e-310 : 1e305;
                      return Vec3(lattice(r, 3), lattice(r, 3), lattice(r, 3)) * scale;
                    },
                    2000});
}

TEST(FindContact, AgreesWithRationalsOneUlpFromTouching) {
  expect_agreement({[](Random& r) {
                      const auto nudge = [&r](double x) {
                        const auto way = r() % 6;
                        return way > 1 ? x : std::nextafter(x, way == 0 ? -10.0 : 10.0);
                      };
                      return Vec3(nudge(lattice(r, 3)), nudge(lattice(r, 3)), nudge(lattice(r, 3)));
                    },
                    4000});
}

TEST(FindContact, SameThreeVerticesAreDuplicate) {
  const Corners t{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  EXPECT_EQ(find_contact(t, t, Common::All), ContactKind::Duplicate);
}

TEST(FindContact, EdgeThroughTheInsideIsCrossing) {
  const Corners floor{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
  const Corners wall{Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(9, 1, 1)};
  EXPECT_EQ(find_contact(floor, wall, Common::Nothing), ContactKind::Crossing);
}

TEST(FindContact, CornerOnTheInsideIsTouching) {
  const Corners floor{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
  const Corners needle{Vec3(1, 1, 0), Vec3(1, 1, 1), Vec3(2, 1, 1)};
  EXPECT_EQ(find_contact(floor, needle, Common::Nothing), ContactKind::Touching);
}

TEST(FindContact, CornerJustAboveTheInsideIsNone) {
  const Corners floor{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
  const Corners needle{Vec3(1, 1, 5e-324), Vec3(1, 1, 1), Vec3(2, 1, 1)};
  EXPECT_EQ(find_contact(floor, needle, Common::Nothing), std::nullopt);
}

TEST(FindContact, FlatNeighboursOfAnEdgeAreNone) {
  const Corners p{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  const Corners q{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, -1, 0)};
  EXPECT_EQ(find_contact(p, q, Common::Edge), std::nullopt);
}

TEST(FindContact, FaceFoldedBackOnItsNeighbourIsFoldOver) {
  const Corners p{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  const Corners q{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 2, 0)};
  EXPECT_EQ(find_contact(p, q, Common::Edge), ContactKind::FoldOver);
}

TEST(FindContact, ZeroAreaFaceThroughTheInsideIsCrossing) {
  const Corners floor{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
  const Corners needle{Vec3(1, 1, -1), Vec3(1, 1, 0), Vec3(1, 1, 1)};
  EXPECT_EQ(find_contact(floor, needle, Common::Nothing), ContactKind::Crossing);
}

TEST(AreClearlyApart, NeverContradictsTheExactAnswer) {
  Random random(kContactSeed);
  const Source source{[](Random& r) { return Vec3(lattice(r, 3), lattice(r, 3), lattice(r, 3)); },
                      20000};
  int apart = 0;
  for (int i = 0; i < source.pairs; ++i) {
    const auto common = static_cast<Common>(i % 3);
    const auto [p, q] = random_pair(source, common, random);
    if (are_clearly_apart(p, q, common)) {
      ++apart;
      ASSERT_EQ(oracle_contact(p, q, common), std::nullopt) << "pair " << i;
    }
  }
  EXPECT_GT(apart, source.pairs / 10);
}

}  // namespace
}  // namespace meshalyzer
