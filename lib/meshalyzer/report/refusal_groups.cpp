#include "meshalyzer/report/refusal_groups.h"

#include "meshalyzer/base/sort_unique.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

namespace meshalyzer {
namespace {

using Final = std::optional<KeyIds::Final>;

/// Collects refusals in groups.
class RefusalCollector {
 public:
  void add(const LoggedRefusal& refusal, const Final& vertex, const Final& face) {
    const Final& element = vertex ? vertex : face;
    std::optional<std::size_t> mesh;
    if (element) mesh = element->mesh;
    const std::size_t number = number_of(refusal, mesh);
    if (!places_.emplace(number, refusal.vertex, refusal.face).second) return;
    RefusalGroup& group = groups_[number];
    ++group.places;
    if (vertex) {
      group.vertices.push_back(vertex->id);
    } else if (face) {
      group.faces.push_back(face->id);
    }
  }

  [[nodiscard]] std::vector<RefusalGroup> take() {
    for (RefusalGroup& group : groups_) {
      sort_unique(group.vertices);
      sort_unique(group.faces);
    }
    return std::move(groups_);
  }

 private:
  using Key =
      std::tuple<std::optional<std::size_t>, std::string_view, DefectCode, std::string_view>;

  std::size_t number_of(const LoggedRefusal& refusal, std::optional<std::size_t> mesh) {
    const Key key{mesh, refusal.pass, refusal.code, refusal.reason};
    const auto [found, is_new] = numbers_.emplace(key, groups_.size());
    if (is_new) groups_.push_back({.first = &refusal, .mesh = mesh});
    return found->second;
  }

  std::vector<RefusalGroup> groups_;
  std::map<Key, std::size_t> numbers_;
  /// The group, vertex and face of all added refusals.
  std::set<std::tuple<std::size_t, Index, Index>> places_;
};

}  // namespace

std::vector<RefusalGroup> group_refusals(const RepairReport& report, const KeyIds& ids) {
  RefusalCollector groups;
  for (const LoggedRefusal& refusal : report.result.log.refusals) {
    groups.add(refusal, ids.final_vertex(refusal.vertex), ids.final_face(refusal.face));
  }
  return groups.take();
}

}  // namespace meshalyzer
