#include "plain_counts.h"

#include "meshalyzer/exact/predicates.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

using Edge = std::pair<Index, Index>;

/// A face at an edge, and the end of the edge that it begins at.
struct Side {
  Index face;
  Index from;
};

using Sides = std::map<Edge, std::vector<Side>>;

bool counts(const Triangle& t) {
  return t[0] != kNoIndex && t[1] != kNoIndex && t[2] != kNoIndex && t[0] != t[1] && t[1] != t[2] &&
         t[2] != t[0];
}

Sides sides_of(const Soup& soup) {
  Sides sides;
  for (Index f = 0; f < soup.n_faces(); ++f) {
    const Triangle& t = soup.triangles[f];
    if (!counts(t)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      sides[std::minmax({t[k], t[(k + 1) % 3]})].push_back({f, t[k]});
    }
  }
  return sides;
}

/// Counts the groups of faces round a vertex that two-face edges join, by spreading from face to
/// face.
std::size_t count_fans(const std::set<Index>& faces,
                       const std::vector<const std::vector<Side>*>& edges) {
  std::set<Index> left = faces;
  std::size_t n = 0;
  while (!left.empty()) {
    ++n;
    std::vector<Index> front{*left.begin()};
    left.erase(left.begin());
    while (!front.empty()) {
      const Index f = front.back();
      front.pop_back();
      for (const auto* edge : edges) {
        if (edge->size() != 2) continue;
        for (std::size_t i = 0; i < 2; ++i) {
          const Index other = (*edge)[1 - i].face;
          if ((*edge)[i].face == f && left.erase(other) != 0) front.push_back(other);
        }
      }
    }
  }
  return n;
}

std::size_t count_pinched(const Sides& sides, const std::set<Index>& ends) {
  std::map<Index, std::set<Index>> faces;
  std::map<Index, std::vector<const std::vector<Side>*>> edges;
  for (const auto& [edge, around] : sides) {
    for (const Index v : {edge.first, edge.second}) {
      edges[v].push_back(&around);
      for (const Side& side : around) faces[v].insert(side.face);
    }
  }
  return static_cast<std::size_t>(std::count_if(faces.begin(), faces.end(), [&](const auto& at) {
    return !ends.contains(at.first) && count_fans(at.second, edges.at(at.first)) > 1;
  }));
}

}  // namespace

PlainCounts count_plainly(const Soup& soup) {
  const Sides sides = sides_of(soup);
  PlainCounts n;
  std::set<Index> ends;
  for (const auto& [edge, around] : sides) {
    n["border edges"] += around.size() == 1 ? 1 : 0;
    n["flipped edges"] += around.size() == 2 && around[0].from == around[1].from ? 1 : 0;
    if (around.size() <= 2) continue;
    ++n["non-manifold edges"];
    ends.insert({edge.first, edge.second});
  }
  n["pinched vertices"] = count_pinched(sides, ends);
  n["non-manifold vertices"] = ends.size() + n["pinched vertices"];
  std::set<Triangle> seen;
  for (Triangle t : soup.triangles) {
    if (!counts(t)) continue;
    const auto& p = soup.positions;
    n["zero-area faces"] += are_collinear(p[t[0]], p[t[1]], p[t[2]]) ? 1 : 0;
    std::sort(t.begin(), t.end());
    n["duplicate faces"] += seen.insert(t).second ? 0 : 1;
  }
  return n;
}

}  // namespace meshalyzer
