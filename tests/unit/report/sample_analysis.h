#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/analysis/goodness.h"

#include <memory>
#include <utility>

namespace meshalyzer {

/// A made-up analysis of two triangles (10 20 30) and (20 10 40), faces 7 and 9, with something in
/// every list.
///
/// The ids are far from the record indices, so that a report that mixes them up is seen.
inline Analysis sample_analysis() {
  Analysis analysis;
  analysis.path = "sample.mesh";
  analysis.vertex_ids.named = {10, 20, 30, 40};
  analysis.face_ids.named = {7, 9};
  Soup soup;
  soup.positions = {{0.1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  soup.triangles = {{0, 1, 2}, {1, 0, 3}};
  analysis.soup = std::make_shared<const Soup>(std::move(soup));
  analysis.offenders.border_edges = {{{0, 2}, {1, 2}}, {0, 1, 2}, {0, 0}, {}};
  analysis.offenders.non_manifold_edges = {{{0, 1}}, {0, 2}, {0, 1}, {}};
  analysis.offenders.non_manifold_vertices = {3};
  analysis.offenders.intersecting_pairs = {{0, 1, ContactKind::Crossing}};
  analysis.offenders.missing_vertices = {99};
  analysis.offenders.orphan_vertices = {2, 3};
  analysis.offenders.degenerate_faces = {1};
  analysis.offenders.vertex_numbering = NumberingBreak{{10, 20, 30}, 0};
  analysis.fitness = judge_fitness(analysis);
  return analysis;
}

}  // namespace meshalyzer
