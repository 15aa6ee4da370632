#include "meshalyzer/repair/driver/internal/applied_operations.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

namespace meshalyzer {
namespace {

/// Returns the code of the defects that a pass must be allowed to create for such an element.
DefectCode code_of(CountedDefect kind) {
  switch (kind) {
    case CountedDefect::NonManifoldEdges:
    case CountedDefect::NonManifoldVertices:
    case CountedDefect::PinchedVertices:
      return DefectCode::NonManifold;
    case CountedDefect::IntersectingPairs:
      return DefectCode::SelfIntersection;
    case CountedDefect::FlippedEdges:
      return DefectCode::Flipped;
    case CountedDefect::BorderEdges:
    case CountedDefect::SlitEdges:
      return DefectCode::Hole;
    case CountedDefect::DuplicateFaces:
      return DefectCode::DuplicateFacet;
    case CountedDefect::ZeroAreaFaces:
      return DefectCode::FlatFacet;
  }
  return DefectCode::Hole;
}

/// Finds the operations that affect a place.
class Suspects {
 public:
  explicit Suspects(const std::vector<AppliedOperation>& operations) {
    for (std::size_t op = 0; op < operations.size(); ++op) {
      for (const Index v : operations[op].vertices) at_vertex_[v].push_back(static_cast<Index>(op));
    }
  }

  /// Returns the operations that affect all vertices of an edge, a vertex or a face, in order.
  [[nodiscard]] std::vector<Index> at(const Triangle& corners) const {
    std::optional<std::vector<Index>> common;
    for (const Index v : corners) {
      if (v == kNoIndex) continue;
      const auto found = at_vertex_.find(v);
      if (found == at_vertex_.end()) return {};
      if (!common) {
        common = found->second;
        continue;
      }
      std::vector<Index> both;
      std::set_intersection(common->begin(), common->end(), found->second.begin(),
                            found->second.end(), std::back_inserter(both));
      common = std::move(both);
    }
    return common.value_or(std::vector<Index>());
  }

 private:
  std::map<Index, std::vector<Index>> at_vertex_;
};

/// Returns the operations that affect an element: for a pair of faces, either of them.
std::vector<Index> suspects_of(const WorsePlace& element, const Suspects& suspects) {
  std::vector<Index> found;
  for (const Triangle& corners : element.corners) {
    const std::vector<Index> more = suspects.at(corners);
    std::vector<Index> both;
    std::set_union(found.begin(), found.end(), more.begin(), more.end(), std::back_inserter(both));
    found = std::move(both);
  }
  return found;
}

/// Keeps the operation that has most likely created an element.
void keep_likeliest(const std::vector<AppliedOperation>& operations, CountedDefect kind,
                    std::vector<Index>& suspects) {
  if (suspects.empty()) return;
  const DefectCode code = code_of(kind);
  const auto likeliest = std::find_if(suspects.rbegin(), suspects.rend(), [&](Index op) {
    return operations[op].may_create.contains(code);
  });
  suspects = {likeliest == suspects.rend() ? suspects.back() : *likeliest};
}

/// Returns the faces, as elements of a site, that have a corner of an element.
std::set<std::uint64_t> site_of(const WorsePlace& element, const Soup& input,
                                const std::vector<std::vector<Index>>& faces_at) {
  std::set<std::uint64_t> site;
  for (const Triangle& corners : element.corners) {
    for (const Index v : corners) {
      if (v >= input.n_vertices()) continue;
      site.insert(2 * std::uint64_t{v} + 1);
      for (const Index f : faces_at[v]) site.insert(2 * std::uint64_t{f});
    }
  }
  return site;
}

std::vector<std::vector<Index>> faces_at_vertices(const Soup& soup) {
  std::vector<std::vector<Index>> faces_at(soup.n_vertices());
  for (Index f = 0; f < soup.n_faces(); ++f) {
    for (const Index v : soup.triangles[f]) {
      if (v != kNoIndex) faces_at[v].push_back(f);
    }
  }
  return faces_at;
}

}  // namespace

void BannedOperations::add(std::string_view pass, const OperationSite& site) {
  sites_[pass].insert(site.begin(), site.end());
}

void BannedOperations::add(std::string_view pass) {
  passes_.insert(pass);
}

bool BannedOperations::contains(std::string_view pass, const OperationSite& site) const {
  if (passes_.contains(pass)) return true;
  const auto found = sites_.find(pass);
  return found != sites_.end() && std::any_of(site.begin(), site.end(), [&](std::uint64_t element) {
           return found->second.contains(element);
         });
}

std::size_t BannedOperations::size() const {
  return std::accumulate(sites_.begin(), sites_.end(), passes_.size(),
                         [](std::size_t n, const auto& site) { return n + site.second.size(); });
}

void ban_responsible(const std::vector<AppliedOperation>& operations,
                     const std::vector<WorsePlace>& places, Blame blame, const Soup& input,
                     BannedOperations& banned) {
  const Suspects suspects(operations);
  const std::vector<std::vector<Index>> faces_at = faces_at_vertices(input);
  for (const WorsePlace& place : places) {
    std::vector<Index> responsible = suspects_of(place, suspects);
    if (blame == Blame::Last) keep_likeliest(operations, place.kind, responsible);
    const std::set<std::uint64_t> near = site_of(place, input, faces_at);
    for (const Index op : responsible) {
      // Of a large operation only the part round the element is banned.
      OperationSite part;
      const OperationSite& site = operations[op].site;
      std::set_intersection(site.begin(), site.end(), near.begin(), near.end(),
                            std::back_inserter(part));
      banned.add(operations[op].pass, part.empty() ? site : part);
    }
  }
}

}  // namespace meshalyzer
