#include "meshalyzer/arrangement/arrange.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/self_intersection.h"
#include "support/effort.h"
#include "support/random_soups.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <tuple>

namespace meshalyzer {
namespace {

using Place = std::tuple<double, double, double>;

Place place(const Vec3& p) {
  return {p.x() + 0.0, p.y() + 0.0, p.z() + 0.0};
}

/// The content of an arrangement, independent of the numbering of its records.
struct Figures {
  std::multiset<Place> made;
  std::multiset<std::pair<Place, Place>> curves;
  std::multiset<std::size_t> pieces_a_face;
  std::multiset<int> multiplicities;

  friend bool operator==(const Figures&, const Figures&) = default;
};

/// @param moved_back  Where a point of the arrangement was before the mesh was moved.
Figures figures(const Soup& soup, const std::function<Vec3(const Vec3&)>& moved_back) {
  const Arrangement a = arrange(soup);
  const auto at = [&](Index v) { return place(moved_back(a.positions[v])); };
  Figures result;
  for (auto v = static_cast<Index>(a.n_input_vertices); v < a.positions.size(); ++v) {
    result.made.insert(at(v));
  }
  for (const auto& [u, v] : a.curves) {
    const Place p = at(u);
    const Place q = at(v);
    result.curves.insert({std::min(p, q), std::max(p, q)});
  }
  for (Index f = 0; f < soup.n_faces(); ++f) result.pieces_a_face.insert(a.pieces_of(f).size());
  // The lowest face orients a piece, so the sign is a matter of numbering.
  for (std::size_t i = 0; i < a.pieces.size(); ++i) {
    result.multiplicities.insert(std::abs(a.multiplicity(i)));
  }
  return result;
}

Figures figures(const Soup& soup) {
  return figures(soup, [](const Vec3& p) { return p; });
}

/// A soup where all kinds of contacts occur, with coordinates of few bits.
std::vector<Soup> soups() {
  std::vector<Soup> all;
  const Soup cubes = shapes::merged(shapes::merged(shapes::cube(2), shapes::cube(2, {1, 0, 0})),
                                    shapes::cube(1, {0.5, 0.5, 2}));
  all.push_back(cubes);
  all.push_back(shapes::merged(cubes, shapes::genus_block(1)));
  std::mt19937 random(20261122);
  for (int i = 0; i < 6; ++i) {
    Soup soup;
    for (int v = 0; v < 12; ++v) {
      soup.positions.emplace_back(below(random, 4), below(random, 4), below(random, i < 3 ? 4 : 2));
    }
    for (int f = 0; f < 12; ++f) {
      soup.triangles.push_back({below(random, 12), below(random, 12), below(random, 12)});
    }
    all.push_back(std::move(soup));
  }
  return all;
}

Soup moved(Soup soup, const std::function<Vec3(const Vec3&)>& move) {
  for (Vec3& p : soup.positions) p = move(p);
  return soup;
}

TEST(ArrangementLaws, NumberingDoesNotMatter) {
  for (const Soup& soup : soups()) {
    EXPECT_EQ(figures(shapes::renumbered_vertices(soup, 3)), figures(soup));
    // Points of one face may come out in another order, whose triangulations have as many pieces.
    EXPECT_EQ(figures(shapes::shuffled_faces(soup, 5)), figures(soup));
  }
}

TEST(ArrangementLaws, ExchangedAxesExchangeThemInTheArrangement) {
  const auto turn = [](const Vec3& p) { return Vec3(p.y(), p.z(), p.x()); };
  const auto back = [](const Vec3& p) { return Vec3(p.z(), p.x(), p.y()); };
  for (const Soup& soup : soups()) EXPECT_EQ(figures(moved(soup, turn), back), figures(soup));
}

TEST(ArrangementLaws, PowersOfTwoScaleEveryCoordinate) {
  for (const double scale : {0x1p-300, 0x1p-7, 0x1p+200}) {
    const auto grow = [&](const Vec3& p) { return Vec3(scale * p); };
    const auto back = [&](const Vec3& p) { return Vec3(p / scale); };
    for (const Soup& soup : soups()) EXPECT_EQ(figures(moved(soup, grow), back), figures(soup));
  }
}

TEST(ArrangementLaws, FarFromTheOriginTheSameIsCut) {
  // So far that the points made have only 13 bits behind the point, but all stay apart.
  const auto away = [](const Vec3& p) { return Vec3(p + Vec3(0x1p+39, -0x1p+39, 0x1p+38)); };
  for (const Soup& soup : soups()) {
    const Figures far = figures(moved(soup, away));
    const Figures near = figures(soup);
    EXPECT_EQ(far.made.size(), near.made.size());
    EXPECT_EQ(far.curves.size(), near.curves.size());
    EXPECT_EQ(far.pieces_a_face, near.pieces_a_face);
    EXPECT_EQ(far.multiplicities, near.multiplicities);
  }
}

TEST(ArrangementLaws, AnyNumberOfThreadsGivesTheSame) {
  const Soup soup = shapes::merged(
      shapes::icosphere(3), shapes::translated(shapes::torus(1, 0.5, 40, 20), {0.2, 0.1, 0}));
  const auto run = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    return arrange(soup);
  };
  const Arrangement one = run(1);
  EXPECT_GT(one.cut_faces.size(), 100U);
  for (const std::size_t threads : {2U, 7U}) {
    const Arrangement many = run(threads);
    EXPECT_EQ(many.positions, one.positions);
    EXPECT_EQ(many.pieces, one.pieces);
    EXPECT_EQ(many.sources, one.sources);
    EXPECT_EQ(many.curves, one.curves);
  }
}

/// How often the pieces cross each edge, those from its lower vertex to the higher counted
/// positive: only the edges where that is not zero.
std::map<std::pair<Index, Index>, int> boundary(const Arrangement& a) {
  std::map<std::pair<Index, Index>, int> sums;
  for (std::size_t i = 0; i < a.pieces.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index u = a.pieces[i][k];
      const Index v = a.pieces[i][(k + 1) % 3];
      sums[std::minmax(u, v)] += u < v ? a.multiplicity(i) : -a.multiplicity(i);
    }
  }
  std::erase_if(sums, [](const auto& item) { return item.second == 0; });
  return sums;
}

/// The 27 ways in which an interval of length 1, 2 or 3 can lie to [3, 6], on a grid.
std::pair<double, double> interval(std::size_t i) {
  const auto low = static_cast<double>(i % 9);
  return {low, low + static_cast<double>(1 + i / 9)};
}

TEST(ArrangementLaws, TwoBoxesInAllIntegerRelationsBecomeOneComplexWithoutBoundary) {
  // All slopes are quotients of 1, 2 and 3: on this grid, whatever they make are whole numbers.
  constexpr double kGrid = 5040;
  constexpr std::size_t kShare = 37;
  std::size_t n_cut = 0;
  for (std::size_t i = 0; i < 27 * 27 * 27; i += kShare * test::one_of()) {
    const auto [x0, x1] = interval(i % 27);
    const auto [y0, y1] = interval(i / 27 % 27);
    const auto [z0, z1] = interval(i / 27 / 27);
    const Soup soup =
        shapes::merged(shapes::box(kGrid * Vec3(3, 3, 3), kGrid * Vec3(6, 6, 6)),
                       shapes::box(kGrid * Vec3(x0, y0, z0), kGrid * Vec3(x1, y1, z1)));
    const Arrangement a = arrange(soup);
    n_cut += a.cut_faces.empty() ? 0 : 1;
    ASSERT_TRUE(boundary(a).empty()) << i;
    for (const Vec3& p : a.positions) ASSERT_EQ(p, Vec3(p.array().round())) << i;
    const CutMesh cut = build(shapes::make(a.positions, a.pieces));
    ASSERT_TRUE(find_self_intersections(cut, FaceTree(cut)).empty()) << i;
  }
  EXPECT_GT(n_cut, 0U);
}

TEST(ArrangementLaws, ArrangementOfAnArrangementChangesNothing) {
  const Soup soup = shapes::merged(shapes::cube(4), shapes::cube(4, {2, 2, 2}));
  const Arrangement once = arrange(soup);
  const Arrangement twice = arrange(shapes::make(once.positions, once.pieces));
  EXPECT_EQ(twice.pieces, once.pieces);
  EXPECT_TRUE(twice.cut_faces.empty());
}

TEST(ArrangementLaws, UnionWithItselfCoversEveryPieceTwice) {
  const Soup sphere = shapes::icosphere(2);
  const Arrangement a = arrange(
      shapes::merged(sphere, shapes::renumbered_vertices(shapes::shuffled_faces(sphere, 1), 2)));
  EXPECT_EQ(a.pieces.size(), sphere.n_faces());
  for (std::size_t i = 0; i < a.pieces.size(); ++i) EXPECT_EQ(a.multiplicity(i), 2);
}

}  // namespace
}  // namespace meshalyzer
