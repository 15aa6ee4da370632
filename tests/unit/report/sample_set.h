#pragma once

#include "meshalyzer/set/object_findings.h"
#include "meshalyzer/set/set_analysis.h"

#include <limits>
#include <vector>

namespace meshalyzer {

/// A made-up set of four meshes, one of them unreadable, with something in every list.
inline SetAnalysis sample_set() {
  SetAnalysis set;
  set.names = {"a.mesh", "b.mesh", "c.off", "torn.mesh"};
  set.meshes = 3;
  set.unreadable = 1;
  set.good = 2;
  set.not_good = {{1, {"not closed", "2 orphan vertices"}}, {3, {"cannot be read: torn"}}};
  set.vertices = 10;
  set.faces = 11;
  set.edges = 12;
  set.components = 13;
  set.boundaries = 14;
  set.intersecting_pairs_within = 15;
  set.area = 2.5;
  set.volume = {.value = 1.5, .reason = "meshes without a volume: 1"};
  std::vector<double> areas{1, 2, 3};
  set.statistics.emplace();
  set.statistics->face_area = summarize(areas);
  set.intersections = SetIntersections{
      .pairs = {{0, 3, 1, 17, ContactKind::Crossing},
                {0, 3, 1, 18, ContactKind::Touching},
                {0, 4, 1, 17, ContactKind::Crossing},
                {0, 4, 2, 6, ContactKind::Touching},
                {1, 5, 2, 6, ContactKind::CoplanarOverlap}},
      .contained = {{2, 0}},
      .partly_contained = {{0, 2}, {1, 2}},
  };
  std::vector<double> all{-1, 2, 2, 3, 5};
  std::vector<double> of_first{-1, 2, 2};
  std::vector<double> of_second{3, 5};
  set.separation = SetSeparation{
      .options = {},
      .meshes = {{0, summarize(of_first), 0, 1}, {1, summarize(of_second), 4, 0}, {2, {}, 6, 0}},
      .all = summarize(all),
      .without_closest = 10,
      .inside = 1,
  };
  return set;
}

/// Returns the findings of b.mesh of sample_set().
inline ObjectFindings sample_findings() {
  ObjectFindings findings;
  findings.owner = 1;
  findings.intersections = SetIntersections{
      .pairs = {{0, 3, 1, 17, ContactKind::Crossing}, {1, -5, 2, 6, ContactKind::Unwelded}},
      .contained = {{2, 1}},
      .partly_contained = {{1, 0}, {2, 0}},
  };
  findings.separation = ObjectSeparation{
      .vertices = {20, -30},
      .distances = {-0.125, std::numeric_limits<double>::quiet_NaN()},
      .objects = {2, kNoIndex},
      .faces = {6, 0},
      .points = {{1, 0.1, -0.0}, Vec3::Zero()},
  };
  return findings;
}

}  // namespace meshalyzer
