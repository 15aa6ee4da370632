#include "meshalyzer/base/disjoint_sets.h"
#include "meshalyzer/repair/passes.h"
#include "meshalyzer/repair/rules/internal/fixed_vertices.h"
#include "meshalyzer/repair/split/internal/copy_vertices.h"
#include "meshalyzer/repair/split/internal/incident_faces.h"
#include "meshalyzer/topology/manifold.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Leaves fans at an edge with more than two faces apart: pinched vertices have none.
std::vector<Index> join_none(std::span<const Spoke> edge) {
  return std::vector<Index>(edge.size(), kNoIndex);
}

}  // namespace

PassResult split_vertices(const PassInput& input) {
  PassResult result;
  std::vector<Index> pinched;
  for (const Index v : find_pinched_vertices(input.mesh.cut())) {
    if (!may_be_copied(input, v)) {
      result.refused.push_back(
          {.code = DefectCode::NonManifold,
           .vertex = v,
           .reason = "the border of a face of the body would get more vertices"});
    } else {
      pinched.push_back(v);
    }
  }
  if (pinched.empty()) return result;

  const Soup& soup = input.mesh.soup();
  const IncidentFaces incident(input.mesh.cut(), std::move(pinched));
  std::vector<Index> fans;
  for (std::size_t entry = 0; entry < incident.size(); ++entry) {
    std::vector<Index> at_vertex = find_fans_at(soup, incident, entry, join_none);
    if (are_too_many_fans(at_vertex)) {
      std::fill(at_vertex.begin(), at_vertex.end(), 0);
      result.refused.push_back({.code = DefectCode::NonManifold,
                                .vertex = incident.vertex(entry),
                                .reason = "so many fans of faces meet there that all their copies "
                                          "of the vertex would touch"});
    }
    fans.insert(fans.end(), at_vertex.begin(), at_vertex.end());
  }
  result.edits = copy_vertices(soup, incident, fans, DisjointSets(incident.size()));
  return result;
}

}  // namespace meshalyzer
