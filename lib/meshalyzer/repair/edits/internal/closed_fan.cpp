#include "meshalyzer/repair/edits/internal/closed_fan.h"

#include "meshalyzer/base/triangle_vertices.h"

#include <algorithm>
#include <cstddef>

namespace meshalyzer {
namespace {

/// A face with a vertex, by its other corners, which follow the vertex in this order.
struct FaceOfFan {
  Index next = kNoIndex;
  Index last = kNoIndex;
  Index face = kNoIndex;
};

}  // namespace

std::optional<std::vector<Index>> closed_fan(std::span<const Triangle> faces, Index vertex) {
  std::vector<FaceOfFan> fan;
  for (Index face = 0; face < faces.size(); ++face) {
    if (!has_corner(faces[face], vertex)) continue;
    const Triangle t = with_first(faces[face], vertex);
    fan.push_back({t[1], t[2], face});
  }
  if (fan.size() < 3) return std::nullopt;
  const auto is_before = [](const FaceOfFan& a, const FaceOfFan& b) { return a.next < b.next; };
  std::sort(fan.begin(), fan.end(), is_before);
  std::vector<Index> order;
  Index at = fan.front().next;
  do {
    const auto found = std::lower_bound(fan.begin(), fan.end(), FaceOfFan{.next = at}, is_before);
    if (found == fan.end() || found->next != at) return std::nullopt;
    order.push_back(found->face);
    at = found->last;
  } while (at != fan.front().next && order.size() < fan.size());
  if (at != fan.front().next || order.size() != fan.size()) return std::nullopt;
  return order;
}

}  // namespace meshalyzer
