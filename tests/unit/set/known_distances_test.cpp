#include "meshalyzer/set/measure_separation.h"
#include "meshalyzer/set/object_meeting.h"
#include "object_scene.h"
#include "support/closed_form_sets.h"
#include "support/packed_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace meshalyzer::test {
namespace {

constexpr double kTolerance = 1e-12;

std::vector<ObjectSeparation> measure_all(const PackedSet& set) {
  ObjectScene scene(set.objects);
  std::vector<ObjectSeparation> all;
  for (Index object = 0; object < set.objects.size(); ++object) {
    all.push_back(scene.measure(object));
  }
  return all;
}

/// Every distance that is known of the set; vertices are numbered from 1 and all used.
void expect_distances(const PackedSet& set, const std::vector<ObjectSeparation>& measured) {
  EXPECT_FALSE(set.distances.empty());
  for (const KnownDistance& known : set.distances) {
    SCOPED_TRACE("object " + std::to_string(known.object) + " vertex " +
                 std::to_string(known.vertex));
    ASSERT_EQ(measured[known.object].vertices[known.vertex], known.vertex + 1);
    const double distance = measured[known.object].distances[known.vertex];
    const double grant = kTolerance * std::max(1.0, std::abs(known.distance));
    EXPECT_GE(distance, known.distance - grant);
    EXPECT_LE(distance, known.distance + set.slack + grant);
  }
}

std::vector<KnownPair> find_pairs(const PackedSet& set) {
  std::vector<KnownPair> pairs;
  for (Index a = 0; a < set.objects.size(); ++a) {
    for (Index b = a + 1; b < set.objects.size(); ++b) {
      const ObjectMeeting meeting =
          find_meeting(SetObject(set.objects[a]), SetObject(set.objects[b]));
      const bool crosses =
          std::any_of(meeting.pairs.begin(), meeting.pairs.end(),
                      [](const auto& pair) { return pair.kind == ContactKind::Crossing; });
      if (!meeting.pairs.empty()) {
        pairs.push_back({a, b, crosses ? Relation::Crossing : Relation::Touching});
      } else if (meeting.first_in_second == Inclusion::Wholly) {
        pairs.push_back({a, b, Relation::Contained});
      } else if (meeting.second_in_first == Inclusion::Wholly) {
        pairs.push_back({b, a, Relation::Contained});
      }
    }
  }
  return pairs;
}

void expect_pairs(const PackedSet& set) {
  std::vector<KnownPair> expected = set.pairs;
  std::vector<KnownPair> found = find_pairs(set);
  const auto before = [](const KnownPair& p, const KnownPair& q) {
    return std::pair(p.a, p.b) < std::pair(q.a, q.b);
  };
  std::sort(expected.begin(), expected.end(), before);
  std::sort(found.begin(), found.end(), before);
  EXPECT_EQ(found, expected);
}

void expect_known(const PackedSet& set) {
  expect_pairs(set);
  expect_distances(set, measure_all(set));
}

TEST(KnownDistances, OfFlatSetsAreAsTheFormulaSays) {
  for (const double length : {0.25, 1.0, 3.0}) {
    SCOPED_TRACE(length);
    expect_known(parallel_plates(length));
    expect_known(box_in_box(length));
    expect_known(three_deep(length));
    expect_known(object_in_cavity(length));
    expect_known(rod_in_square_tube(length));
  }
  expect_known(touching_boxes());
  expect_known(crossing_boxes());
}

TEST(KnownDistances, OfRoundSetsAreAsTheFormulaSays) {
  expect_known(rod_in_round_tube({}));
  expect_known(rod_in_round_tube({.n_sides = 5, .rod_radius = 0.5, .bore_radius = 0.6}));
  // Apart, crossing, and one in the other.
  expect_known(two_spheres({}));
  expect_known(two_spheres({.radius_a = 1.0, .radius_b = 1.5, .distance = 2.0}));
  expect_known(two_spheres({.radius_a = 1.0, .radius_b = 4.0, .distance = 1.5}));
}

TEST(KnownDistances, WithoutRoundingInTheSetThereIsNoneInTheAnswer) {
  for (const PackedSet& set : {parallel_plates(0.5), box_in_box(2.0), touching_boxes()}) {
    const std::vector<ObjectSeparation> measured = measure_all(set);
    for (const KnownDistance& known : set.distances) {
      EXPECT_EQ(measured[known.object].distances[known.vertex], known.distance);
    }
  }
}

/// Between objects that are apart nothing is nearer than the gap.
void expect_gap(const PackedSet& set, const std::vector<ObjectSeparation>& measured) {
  std::vector<std::uint8_t> has_pair(set.objects.size(), 0);
  for (const KnownPair& pair : set.pairs) {
    has_pair[pair.a] = has_pair[pair.b] = 1;
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t object = 0; object < measured.size(); ++object) {
    for (const double distance : measured[object].distances) {
      nearest = has_pair[object] != 0 ? nearest : std::min(nearest, distance);
    }
  }
  EXPECT_GE(nearest, set.gap * (1 - kTolerance));
  EXPECT_LE(nearest, 2 * set.gap);
}

const PackOptions kPack{.n_objects = 40,
                        .faces_per_object = 160,
                        .gap = 0.125,
                        .n_crossing = 3,
                        .n_touching = 2,
                        .n_contained = 2};

TEST(KnownDistances, OfPackedTubesAreAsTheyWerePacked) {
  const PackedSet set = pack_tubes(kPack);
  expect_pairs(set);
  const std::vector<ObjectSeparation> measured = measure_all(set);
  expect_distances(set, measured);
  expect_gap(set, measured);
}

TEST(KnownDistances, OfPackedBlobsAreAsTheyWerePacked) {
  const PackedSet set = pack_blobs(kPack);
  expect_pairs(set);
  const std::vector<ObjectSeparation> measured = measure_all(set);
  expect_distances(set, measured);
  expect_gap(set, measured);
}

}  // namespace
}  // namespace meshalyzer::test
