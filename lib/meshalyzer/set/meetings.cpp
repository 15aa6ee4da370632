#include "meshalyzer/set/meetings.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace meshalyzer {
namespace {

bool comes_before(const MeshMeeting& a, const MeshMeeting& b) {
  return std::tie(a.mesh_a, a.mesh_b) < std::tie(b.mesh_a, b.mesh_b);
}

/// Merges the meetings of the same two meshes; the result is ascending.
std::vector<MeshMeeting> merged(std::vector<MeshMeeting> meetings) {
  std::sort(meetings.begin(), meetings.end(), comes_before);
  std::vector<MeshMeeting> one_each;
  for (const MeshMeeting& meeting : meetings) {
    if (one_each.empty() || comes_before(one_each.back(), meeting)) {
      one_each.push_back(meeting);
    } else {
      one_each.back().pairs.add(meeting.pairs);
    }
  }
  return one_each;
}

/// Appends the meetings of some pairs; pairs of the same meshes mostly follow each other.
void append_meetings(std::span<const SetPair> pairs, std::vector<MeshMeeting>& meetings) {
  for (const SetPair& pair : pairs) {
    if (meetings.empty() || meetings.back().mesh_a != pair.mesh_a ||
        meetings.back().mesh_b != pair.mesh_b) {
      meetings.push_back({pair.mesh_a, pair.mesh_b, {}});
    }
    meetings.back().pairs.add(pair.kind, 1);
  }
}

auto order_of(const SetPair& pair) {
  return std::tuple(pair.mesh_a, pair.mesh_b, pair.face_a, pair.face_b);
}

}  // namespace

std::vector<MeshMeeting> meetings_of(const SetIntersections& found) {
  std::vector<MeshMeeting> meetings(found.unlisted);
  append_meetings(found.pairs, meetings);
  return merged(std::move(meetings));
}

SetIntersections in_order(SetIntersections found, std::size_t max_list) {
  std::sort(found.pairs.begin(), found.pairs.end(),
            [](const SetPair& a, const SetPair& b) { return order_of(a) < order_of(b); });
  if (max_list != 0 && found.pairs.size() > max_list) {
    append_meetings(std::span(found.pairs).subspan(max_list), found.unlisted);
    found.pairs.resize(max_list);
  }
  found.unlisted = merged(std::move(found.unlisted));
  std::sort(found.contained.begin(), found.contained.end());
  std::sort(found.partly_contained.begin(), found.partly_contained.end());
  return found;
}

void append_intersections(const SetIntersections& more, std::size_t max_list,
                          SetIntersections& all) {
  const auto append = [](auto& to, const auto& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  append(all.pairs, more.pairs);
  append(all.unlisted, more.unlisted);
  append(all.contained, more.contained);
  append(all.partly_contained, more.partly_contained);
  all.is_search_stopped = all.is_search_stopped || more.is_search_stopped;
  // The list is cut now and then, so that memory grows with its final length.
  if (max_list != 0 && all.pairs.size() / 2 >= max_list) all = in_order(std::move(all), max_list);
}

}  // namespace meshalyzer
