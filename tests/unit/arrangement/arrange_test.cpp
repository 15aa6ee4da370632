#include "meshalyzer/arrangement/arrange.h"

#include "meshalyzer/arrangement/clusters.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/mesh/build.h"
#include "meshalyzer/spatial/self_intersection.h"
#include "support/arrangement_oracle.h"
#include "support/effort.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

constexpr unsigned kSeed = 20261122;
using Random = std::mt19937;

Soup random_soup(std::size_t n_vertices, std::size_t n_faces,
                 const std::function<Vec3(Random&)>& point, Random& random) {
  Soup soup;
  for (std::size_t i = 0; i < n_vertices; ++i) soup.positions.push_back(point(random));
  std::uniform_int_distribution<Index> vertex(0, static_cast<Index>(n_vertices - 1));
  for (std::size_t i = 0; i < n_faces; ++i) {
    soup.triangles.push_back({vertex(random), vertex(random), vertex(random)});
  }
  return soup;
}

double lattice(Random& random, int n) {
  return std::uniform_int_distribution<>(0, n - 1)(random);
}

/// Soups of a few faces, where many of them meet, some of no area, some twice.
void expect_no_fault(std::size_t n_faces, const std::function<Vec3(Random&)>& point) {
  Random random(kSeed);
  for (std::size_t round = 0; round < 12; round += test::one_of()) {
    const Soup soup = random_soup(10, n_faces, point, random);
    const Arrangement arrangement = arrange(soup);
    ASSERT_EQ(test::arrangement_fault(soup, arrangement), "") << "round " << round;
  }
}

TEST(Arrange, RandomSoupsHaveNoFault) {
  const auto real = [](Random& r) { return std::uniform_real_distribution<>(-1, 1)(r); };
  expect_no_fault(10, [&](Random& r) { return Vec3(real(r), real(r), real(r)); });
}

TEST(Arrange, LatticesWhereNearlyAllIsCoplanarOrTouchingHaveNoFault) {
  expect_no_fault(10, [](Random& r) { return Vec3(lattice(r, 3), lattice(r, 3), lattice(r, 3)); });
  expect_no_fault(8, [](Random& r) { return Vec3(lattice(r, 4), lattice(r, 4), 0); });
  expect_no_fault(10, [](Random& r) { return Vec3(lattice(r, 3), lattice(r, 3), lattice(r, 2)); });
  expect_no_fault(12, [](Random& r) { return Vec3(lattice(r, 2), lattice(r, 2), lattice(r, 2)); });
  expect_no_fault(12, [](Random& r) { return Vec3(lattice(r, 5), lattice(r, 2), 0); });
}

TEST(Arrange, SoupsNearlyInOnePlaneHaveNoFault) {
  expect_no_fault(9, [](Random& r) {
    const double x = 0.1 * lattice(r, 4);
    const double y = 0.1 * lattice(r, 4);
    return Vec3(x, y, 0.3 * x + 0.7 * y);
  });
}

TEST(Arrange, SoupsOneUlpFromTouchingHaveNoFault) {
  expect_no_fault(7, [](Random& r) {
    const auto nudged = [&r](double x) { return r() % 3 == 0 ? std::nextafter(x, 9.0) : x; };
    return Vec3(nudged(lattice(r, 3)), nudged(lattice(r, 3)), nudged(lattice(r, 3)));
  });
}

TEST(Arrange, SoupsFarFromTheOriginHaveNoFault) {
  expect_no_fault(10, [](Random& r) {
    return Vec3(1e9 + lattice(r, 3), 1e9 - lattice(r, 3), 1e-3 * lattice(r, 3));
  });
}

TEST(Arrange, SoupsOfHugeAndTinyCoordinatesHaveNoFault) {
  for (const double scale : {1e300, 1e-290}) {
    expect_no_fault(8, [&](Random& r) {
      return Vec3(scale * lattice(r, 3), 0.3 * scale * lattice(r, 3), scale * lattice(r, 4));
    });
  }
}

TEST(Arrange, FacesThatMeetNothingStayAsTheyAre) {
  const Soup soup = shapes::torus(2, 0.5, 12, 8);
  const Arrangement arrangement = arrange(soup);
  EXPECT_EQ(arrangement.pieces, soup.triangles);
  EXPECT_EQ(arrangement.positions, soup.positions);
  EXPECT_TRUE(arrangement.cut_faces.empty());
  EXPECT_TRUE(arrangement.curves.empty());
}

TEST(Arrange, EmptySoupGivesNothing) {
  const Arrangement arrangement = arrange(Soup{});
  EXPECT_TRUE(arrangement.pieces.empty());
  EXPECT_EQ(arrangement.pieces_of_faces.size(), 0U);
}

TEST(Arrange, FacesInNoComplexHaveNoPieces) {
  Soup soup = shapes::tetrahedron();
  soup.triangles.push_back({0, 0, 1});
  soup.triangles.push_back({0, kNoIndex, 1});
  const Arrangement arrangement = arrange(soup);
  EXPECT_EQ(arrangement.pieces.size(), 4U);
  EXPECT_TRUE(arrangement.pieces_of(4).empty());
  EXPECT_TRUE(arrangement.pieces_of(5).empty());
}

TEST(Arrange, TwoTrianglesThroughEachOtherAreCutAlongOneSegment) {
  // The second stands across the first along y = 1/4, and ends inside it.
  const Soup soup = shapes::make(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, -1}, {0.5, 0.25, -1}, {0.375, 0.25, 1}},
      {{0, 1, 2}, {3, 4, 5}});
  const Arrangement arrangement = arrange(soup);
  EXPECT_EQ(test::arrangement_fault(soup, arrangement), "");
  EXPECT_EQ(arrangement.positions.size(), 8U);
  ASSERT_EQ(arrangement.curves.size(), 1U);
  // By similar triangles, half of the base is left at half of the height.
  EXPECT_EQ(arrangement.positions[6], Vec3(0.3125, 0.25, 0));
  EXPECT_EQ(arrangement.positions[7], Vec3(0.4375, 0.25, 0));
  // Three corners and a segment inside: five triangles by Euler's formula; the other is cut off
  // its tip, and what is left is a quadrangle.
  EXPECT_EQ(arrangement.pieces_of(0).size(), 5U);
  EXPECT_EQ(arrangement.pieces_of(1).size(), 3U);
}

TEST(Arrange, FacesOfOppositeSidesCancelInOnePiece) {
  const Soup soup = shapes::make({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
  const Arrangement arrangement = arrange(soup);
  ASSERT_EQ(arrangement.pieces.size(), 1U);
  EXPECT_EQ(arrangement.multiplicity(0), 0);
  EXPECT_EQ(arrangement.sources_of(0)[0], (PieceSource{0, 1}));
  EXPECT_EQ(arrangement.sources_of(0)[1], (PieceSource{1, -1}));
}

/// Three triangles that contain the origin, one in each coordinate plane.
Soup three_planes() {
  return shapes::make({{-1, -1, 0},
                       {3, -1, 0},
                       {-1, 3, 0},
                       {0, -1, -1},
                       {0, 3, -1},
                       {0, -1, 3},
                       {-1, 0, -1},
                       {-1, 0, 3},
                       {3, 0, -1}},
                      {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}});
}

TEST(Arrange, ThreePlanesMeetInOneVertex) {
  const Soup soup = three_planes();
  const Arrangement arrangement = arrange(soup);
  EXPECT_EQ(test::arrangement_fault(soup, arrangement), "");
  std::size_t n_origins = 0;
  for (const Vec3& p : arrangement.positions) n_origins += p.isZero() ? 1 : 0;
  EXPECT_EQ(n_origins, 1U);
}

TEST(Arrange, VerticesAtOnePlaceBecomeOne) {
  // Two triangles that share an edge by place only: a seam that was never welded.
  const Soup soup = shapes::make(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}, {0, -1, 1}}, {{0, 1, 2}, {3, 4, 5}});
  const Arrangement arrangement = arrange(soup);
  EXPECT_EQ(arrangement.pieces, (std::vector<Triangle>{{2, 0, 1}, {0, 5, 1}}));
}

TEST(Arrange, VertexOfATriangleThatIsNotCutIsTheOneThatStays) {
  // Vertices 2 and 6 are at one place. The face 2 6 9, of no area, is cut, and names both; of the
  // triangles there only 0 6 3 meets nothing.
  const Soup soup =
      shapes::make({{1, 1, 0},
                    {1, 0, 0},
                    {1, 0, 1},
                    {1, 1, 1},
                    {0, 1, 1},
                    {1, 0, 0},
                    {1, 0, 1},
                    {1, 1, 0},
                    {0, 1, 1},
                    {0, 1, 0}},
                   {{5, 6, 8}, {6, 2, 5}, {5, 1, 9}, {2, 6, 9}, {7, 0, 6}, {0, 6, 3}, {0, 7, 3}});
  const Arrangement arrangement = arrange(soup);
  EXPECT_EQ(test::arrangement_fault(soup, arrangement), "");
  ASSERT_EQ(arrangement.pieces_of(5).size(), 1U);
  EXPECT_EQ(arrangement.pieces[arrangement.pieces_of(5)[0]], (Triangle{0, 6, 3}));
}

TEST(Arrange, FacesOfNoAreaBetweenUnitedVerticesGo) {
  // Vertices 2, 4 and 7 are at one place, and faces that meet there unite them: nothing is left of
  // two faces of no area on the edge 9 2, nor of one at the place.
  const Soup soup = shapes::make({{1, 0, 0},
                                  {1, 0, 0},
                                  {1, 0, 1},
                                  {0, 1, 1},
                                  {1, 0, 1},
                                  {0, 1, 0},
                                  {0, 1, 0},
                                  {1, 0, 1},
                                  {0, 1, 0},
                                  {0, 1, 1}},
                                 {{4, 9, 2}, {7, 9, 2}, {9, 0, 6}, {1, 4, 7}});
  const Arrangement arrangement = arrange(soup);
  EXPECT_EQ(test::arrangement_fault(soup, arrangement), "");
  EXPECT_EQ(arrangement.pieces, (std::vector<Triangle>{{6, 9, 0}}));
}

TEST(Arrange, FaceOfNoAreaGoesWhereItsNeighboursComeToFit) {
  // Vertex 3 lies in the middle of the edge 0 1 of the first face. The face 0 3 1, of no area, led
  // from that edge to those of the two faces below, which touch it.
  const Soup soup = shapes::make({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 0}, {1, -1, 0}},
                                 {{0, 1, 2}, {0, 3, 1}, {0, 4, 3}, {3, 4, 1}});
  const Arrangement arrangement = arrange(soup);
  EXPECT_EQ(test::arrangement_fault(soup, arrangement), "");
  EXPECT_EQ(arrangement.pieces_of(0).size(), 2U);
  EXPECT_TRUE(arrangement.pieces_of(1).empty());
}

TEST(Arrange, FaceOfNoAreaCutsAnotherAsTheSegmentThatItIs) {
  const Soup soup = shapes::make(
      {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {1.5, 1, 0}, {2, 1, 0}}, {{0, 1, 2}, {3, 4, 5}});
  const Arrangement arrangement = arrange(soup);
  EXPECT_EQ(test::arrangement_fault(soup, arrangement), "");
  EXPECT_EQ(arrangement.curves, (std::vector<std::array<Index, 2>>{{3, 4}, {4, 5}}));
  EXPECT_TRUE(arrangement.pieces_of(1).empty());
}

TEST(Arrange, ManySegmentsInOneFaceHaveNoFault) {
  // 20 upright triangles through one: a star of segments that nearly all cross.
  Soup soup = shapes::make({{-9, -9, 0}, {9, -9, 0}, {0, 18, 0}}, {{0, 1, 2}});
  Random random(kSeed);
  std::uniform_real_distribution<> real(-1, 1);
  for (int i = 0; i < 20; ++i) {
    const auto first = static_cast<Index>(soup.n_vertices());
    const double angle = 3.14159 * real(random);
    const Vec3 along(std::cos(angle), std::sin(angle), 0.1 * real(random));
    const Vec3 middle(0.3 * real(random), 0.3 * real(random), 0);
    soup.positions.insert(soup.positions.end(),
                          {middle + along, middle - along, Vec3(middle + Vec3(0, 0, 1e-3))});
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_EQ(test::arrangement_fault(soup, arrange(soup)), "");
}

/// Copies of two triangles through each other, each with vertices of its own.
Soup copies_of_crossing_triangles(int n) {
  Soup soup;
  for (int i = 0; i < n; ++i) {
    soup = shapes::merged(
        soup, shapes::make({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 2, -1}, {1.5, 1, 3}},
                           {{0, 1, 2}, {3, 4, 5}}));
  }
  return soup;
}

TEST(Arrange, CopiesOfFacesAreCutAsOneOfEach) {
  const std::size_t n_pieces = arrange(copies_of_crossing_triangles(1)).pieces.size();
  const Soup copies = copies_of_crossing_triangles(12);
  const Arrangement arrangement = arrange(copies);
  EXPECT_EQ(test::arrangement_fault(copies, arrangement), "");
  EXPECT_EQ(arrangement.pieces.size(), n_pieces);
  for (std::size_t piece = 0; piece < n_pieces; ++piece) {
    EXPECT_EQ(arrangement.multiplicity(piece), 12) << piece;
  }
}

TEST(Clusters, KeepEachSegmentOnce) {
  const Soup copies = copies_of_crossing_triangles(12);
  const CutMesh cut = build(copies);
  const std::vector<IntersectingPair> pairs = find_self_intersections(cut, FaceTree(cut));
  const std::vector<FaceSimplex> simplices = simplices_of(copies, pairs);
  FaceContacts contacts;
  std::vector<PointName> names;
  for (Index v = 0; v < copies.n_vertices(); ++v) names.push_back(vertex_name(v));
  for (const IntersectingPair& pair : pairs) {
    find_face_contact(copies, simplices[pair.face_a], simplices[pair.face_b], contacts);
  }
  for (const ContactPoint& point : contacts.points) names.push_back(point.point);
  sort_unique(names);
  const NamedPoints points(copies, std::move(names));
  const std::vector<FaceCluster> clusters = make_clusters(simplices, pairs, contacts, points);
  ASSERT_EQ(clusters.size(), 2U);
  for (const FaceCluster& cluster : clusters) {
    EXPECT_EQ(cluster.faces.size(), 12U);
    // Three edges, and the segment along which the triangles meet.
    EXPECT_EQ(cluster.segments.size(), 4U);
  }
}

TEST(Arrange, CuttingEndsSoonAfterItIsToStop) {
  const Soup soup = shapes::merged(shapes::uv_sphere(20, 40),
                                   shapes::translated(shapes::uv_sphere(20, 40), {0.1, 0.2, 0.3}));
  const CutMesh cut = build(soup);
  const std::vector<IntersectingPair> pairs = find_self_intersections(cut, FaceTree(cut));
  const std::size_t most_items = std::max(pairs.size(), simplices_of(soup, pairs).size());
  std::atomic<std::size_t> n_asked = 0;
  const auto stopped_after = [&](std::size_t n_allowed) {
    n_asked = 0;
    return arrange_within(soup, pairs,
                          {.wants_to_stop = [&, n_allowed] { return ++n_asked > n_allowed; }});
  };
  const ThreadLimit one(1);
  ASSERT_TRUE(stopped_after(pairs.size()));
  const std::size_t n_in_all = n_asked;
  // For every 64 pairs and clusters.
  EXPECT_GE(n_in_all, pairs.size() / 64);
  for (std::size_t n_allowed = 0; n_allowed < n_in_all; ++n_allowed) {
    EXPECT_FALSE(stopped_after(n_allowed)) << n_allowed;
    // A loop that has begun asks once more for each of its tasks, and no other loop begins.
    EXPECT_LE(n_asked, n_allowed + n_chunks(most_items, 64) + 1) << n_allowed;
  }
}

TEST(Arrange, WindingNumbersStay) {
  const Soup soup = shapes::merged(
      shapes::merged(shapes::uv_sphere(3, 4), shapes::translated(shapes::cube(), {0.1, 0.2, 0.3})),
      shapes::translated(shapes::torus(1, 0.4, 4, 3), {0.3, 0, 0.2}));
  const Arrangement arrangement = arrange(soup);
  EXPECT_EQ(test::arrangement_fault(soup, arrangement), "");
  EXPECT_EQ(test::winding_fault(soup, arrangement, 1000 / test::one_of()), "");
}

/// Three triangles inside each of which the two segments cross in which the others meet it. Of
/// different size, they have no point on two edges.
Soup three_crossings() {
  Soup soup = three_planes();
  for (std::size_t v = 3; v < 9; ++v) soup.positions[v] *= v < 6 ? 1.25 : 1.5;
  return soup;
}

TEST(Arrange, NothingIsReturnedBeyondTheMaximumNumberOfPieces) {
  const auto two_cubes = [](const Vec3& by) {
    return shapes::merged(shapes::cube(), shapes::translated(shapes::cube(), by));
  };
  // The last two have four overlapping walls each, whose pieces are of both.
  for (const Soup& soup :
       {three_crossings(), two_cubes({0.1, 0.2, 0.3}), two_cubes({0.5, 0.5, 0})}) {
    const CutMesh cut = build(soup);
    const std::vector<IntersectingPair> pairs = find_self_intersections(cut, FaceTree(cut));
    const std::vector<Triangle> pieces = arrange(soup, pairs).pieces;
    EXPECT_EQ(arrange_within(soup, pairs, {.max_pieces = pieces.size()})->pieces, pieces);
    // None of the maxima below is enough, whether it is noticed before the faces are cut or after.
    for (std::size_t max = 0; max < pieces.size(); ++max) {
      EXPECT_FALSE(arrange_within(soup, pairs, {.max_pieces = max})) << max;
    }
  }
}

TEST(Arrange, NothingIsReturnedBeyondTheMaximumNumberOfCrossings) {
  const Soup soup = three_crossings();
  const CutMesh cut = build(soup);
  const std::vector<IntersectingPair> pairs = find_self_intersections(cut, FaceTree(cut));
  const std::optional<Arrangement> cut_whole = arrange_within(soup, pairs, {.max_crossings = 3});
  ASSERT_TRUE(cut_whole);
  EXPECT_EQ(cut_whole->pieces, arrange(soup).pieces);
  for (std::size_t max = 0; max < 3; ++max) {
    EXPECT_FALSE(arrange_within(soup, pairs, {.max_crossings = max})) << max;
  }
}

TEST(Arrange, NothingIsReturnedBeyondTheMaximumMemoryForDigits) {
  const auto cubes_and_far_face = [](double distance) {
    Soup soup =
        shapes::merged(shapes::cube(), shapes::translated(shapes::cube(), {0.125, 0.25, 0.375}));
    return shapes::merged(
        std::move(soup),
        shapes::make({{distance, 0.5, 0.5}, {-distance, 0.5, 0.25}, {0.3, distance, 0.625}},
                     {{0, 1, 2}}));
  };
  for (const auto& [distance, needs_digits] : {std::pair(8.0, false), std::pair(1e150, true)}) {
    const Soup soup = cubes_and_far_face(distance);
    const CutMesh cut = build(soup);
    const std::vector<IntersectingPair> pairs = find_self_intersections(cut, FaceTree(cut));
    EXPECT_EQ(arrange_within(soup, pairs, {.max_digit_bytes = 1000}).has_value(), !needs_digits);
    EXPECT_TRUE(arrange_within(soup, pairs, {.max_digit_bytes = 1'000'000}));
  }
}

TEST(Arrange, SoupsWithFewPiecesForTheirNodesAreNotRefused) {
  // Faces that overlap in a plane have the fewest pieces, beside the nodes of all of them.
  Random random(kSeed);
  for (int round = 0; round < 100; ++round) {
    const auto point = [&](Random& r) {
      return Vec3(lattice(r, 4), lattice(r, 3), round % 2 == 0 ? 0.0 : lattice(r, 2));
    };
    const Soup soup = random_soup(9, 6, point, random);
    const CutMesh cut = build(soup);
    const std::vector<IntersectingPair> pairs = find_self_intersections(cut, FaceTree(cut));
    const Arrangement all = arrange(soup, pairs);
    const std::size_t n_nodes = all.positions.size() - soup.n_vertices();
    EXPECT_TRUE(arrange_within(soup, pairs, {.max_pieces = std::max(all.pieces.size(), n_nodes)}))
        << round;
  }
}

TEST(Arrange, PairsOfFacesInNoComplexAreRefused) {
  const Soup soup = shapes::tetrahedron();
  const std::vector<IntersectingPair> pairs{{0, 9, ContactKind::Crossing}};
  EXPECT_THROW((void)arrange(soup, pairs), InvalidArgument);
}

}  // namespace
}  // namespace meshalyzer
