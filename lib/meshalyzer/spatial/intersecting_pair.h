#pragma once

#include "meshalyzer/base/types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <string_view>

namespace meshalyzer {

/// The kind of contact of two intersecting faces ("Intersecting faces" in doc/definitions.md). If
/// several kinds apply, the first in this order counts.
enum class ContactKind : std::uint8_t {
  /// The faces have the same three vertices: by id within one mesh, by place across two.
  Duplicate,
  /// The contact disappears when vertices at identical positions count as one: a seam that was
  /// never welded.
  Unwelded,
  /// The faces share an edge by id, lie in one plane, and overlap: they are folded back by 180
  /// degrees.
  FoldOver,
  /// The faces lie in one plane and share an area.
  CoplanarOverlap,
  /// A point inside one face (not on its border) is inside the other, and the planes differ.
  Crossing,
  /// The faces share only points of the border of one or both.
  Touching,
};

/// Returns "duplicate", "unwelded", "fold-over", "coplanar-overlap", "crossing" or "touching".
[[nodiscard]] std::string_view contact_name(ContactKind kind);

/// All kinds, in their order.
inline constexpr std::array kContactKinds{ContactKind::Duplicate, ContactKind::Unwelded,
                                          ContactKind::FoldOver,  ContactKind::CoplanarOverlap,
                                          ContactKind::Crossing,  ContactKind::Touching};

/// Two intersecting faces, by index of their records: of one file, face_a < face_b, or of two
/// files, face_a of the first and face_b of the second.
struct IntersectingPair {
  Index face_a = 0;
  Index face_b = 0;
  ContactKind kind = ContactKind::Touching;

  friend bool operator==(const IntersectingPair&, const IntersectingPair&) = default;
};

/// The number of pairs of each kind of contact.
class ContactCounts {
 public:
  [[nodiscard]] std::size_t of(ContactKind kind) const {
    return counts_[static_cast<std::size_t>(kind)];
  }
  [[nodiscard]] std::size_t total() const {
    return std::accumulate(counts_.begin(), counts_.end(), std::size_t{0});
  }

  void add(ContactKind kind, std::size_t n) { counts_[static_cast<std::size_t>(kind)] += n; }
  void add(std::span<const IntersectingPair> pairs) {
    for (const IntersectingPair& pair : pairs) add(pair.kind, 1);
  }
  void add(const ContactCounts& other) {
    for (const ContactKind kind : kContactKinds) add(kind, other.of(kind));
  }

  friend bool operator==(const ContactCounts&, const ContactCounts&) = default;

 private:
  std::array<std::size_t, kContactKinds.size()> counts_{};
};

}  // namespace meshalyzer
