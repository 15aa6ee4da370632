#include "meshalyzer/repair/driver/internal/applied_operations.h"

#include "meshalyzer/base/sort_unique.h"
#include "meshalyzer/mesh/vertex_faces.h"

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
class OperationsByVertex {
 public:
  explicit OperationsByVertex(const std::vector<AppliedOperation>& operations) {
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

/// Keeps, of the operations near an element, the one that has most likely created it.
void keep_likeliest(const std::vector<AppliedOperation>& operations, CountedDefect kind,
                    std::vector<Index>& near) {
  if (near.empty()) return;
  const DefectCode code = code_of(kind);
  const auto likeliest = std::find_if(near.rbegin(), near.rend(), [&](Index op) {
    return operations[op].may_create.contains(code);
  });
  near = {likeliest == near.rend() ? near.back() : *likeliest};
}

/// Bans operations place by place. In a heap of faces each face is in hundreds of intersecting
/// pairs, so what is known of a face is kept.
class Banning {
 public:
  Banning(const std::vector<AppliedOperation>& operations, const Soup& input,
          BannedOperations& banned)
      : operations_(operations),
        by_vertex_(operations),
        input_(input),
        faces_at_(input),
        is_wholly_banned_(operations.size(), 0),
        banned_(banned) {}

  void ban_for(const WorsePlace& place, Responsible choice) {
    std::vector<KnownPart*> parts;
    std::vector<Index> responsible;
    for (const Triangle& corners : place.corners) {
      KnownPart& part = known_part(corners);
      parts.push_back(&part);
      const std::vector<Index> before = std::exchange(responsible, {});
      std::set_union(before.begin(), before.end(), part.operations.begin(), part.operations.end(),
                     std::back_inserter(responsible));
    }
    if (choice == Responsible::Last) keep_likeliest(operations_, place.kind, responsible);
    for (const Index op : responsible) {
      // Of a large operation only the part round the element is banned.
      bool is_any_part_near = false;
      for (KnownPart* part : parts) is_any_part_near = ban_near(op, *part) || is_any_part_near;
      if (!is_any_part_near) ban_whole(op);
    }
  }

 private:
  /// What is known of an edge, a vertex or a face.
  struct KnownPart {
    /// The operations that affect all its vertices, ascending.
    std::vector<Index> operations;
    /// Its vertices, and the faces at them, as elements of a site.
    OperationSite near;
    /// The operations that were banned near it, and whether their sites have a part there.
    std::map<Index, bool> is_banned_near;
  };

  KnownPart& known_part(const Triangle& corners) {
    const auto [found, is_new] = known_.try_emplace(corners);
    if (is_new) found->second = {by_vertex_.at(corners), site_round(corners), {}};
    return found->second;
  }

  [[nodiscard]] OperationSite site_round(const Triangle& corners) const {
    OperationSite site;
    for (const Index v : corners) {
      if (v >= input_.n_vertices()) continue;
      site.push_back(2 * std::uint64_t{v} + 1);
      for (const Index f : faces_at_.at(v)) site.push_back(2 * std::uint64_t{f});
    }
    sort_unique(site);
    return site;
  }

  /// Bans the part of an operation near an element, and tells whether there is one.
  bool ban_near(Index op, KnownPart& part) {
    const auto [found, is_new] = part.is_banned_near.try_emplace(op, false);
    if (!is_new) return found->second;
    OperationSite common;
    const OperationSite& site = operations_[op].site;
    std::set_intersection(site.begin(), site.end(), part.near.begin(), part.near.end(),
                          std::back_inserter(common));
    found->second = !common.empty();
    if (found->second) banned_.add(operations_[op].pass, common);
    return found->second;
  }

  void ban_whole(Index op) {
    if (std::exchange(is_wholly_banned_[op], 1) != 0) return;
    banned_.add(operations_[op].pass, operations_[op].site);
  }

  const std::vector<AppliedOperation>& operations_;
  OperationsByVertex by_vertex_;
  const Soup& input_;
  VertexFaces faces_at_;
  std::map<Triangle, KnownPart> known_;
  std::vector<std::uint8_t> is_wholly_banned_;
  BannedOperations& banned_;
};

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
                     const std::vector<WorsePlace>& places, Responsible choice, const Soup& input,
                     BannedOperations& banned) {
  Banning banning(operations, input, banned);
  for (const WorsePlace& place : places) banning.ban_for(place, choice);
}

}  // namespace meshalyzer
