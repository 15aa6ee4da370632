#include "meshalyzer/spatial/mutual_intersection.h"

#include "meshalyzer/spatial/align_faces.h"
#include "meshalyzer/spatial/box_meetings.h"
#include "meshalyzer/spatial/pair_collector.h"
#include "meshalyzer/spatial/triangle_contact.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace meshalyzer {
namespace {

using Next = BoxMeetings::Next;

/// The number of pairs that a task keeps before it passes them on; there may be very many tasks.
constexpr std::size_t kPairsKept = 256;

/// Faces with corners at common places touch at least there. Further contact is found faster if
/// these corners are aligned: otherwise their signs, which are all zero, would need exact
/// arithmetic.
std::optional<ContactKind> find_kind(const Corners& p, const Corners& q) {
  const AlignedFaces<Vec3> pair =
      align_faces(p, q, [](const Vec3& a, const Vec3& b) { return a == b; });
  switch (static_cast<Common>(pair.n_common)) {
    case Common::Nothing:
      return find_contact(p, q, Common::Nothing);
    case Common::Vertex:
      return find_contact(pair.p, pair.q, Common::Vertex).value_or(ContactKind::Touching);
    case Common::Edge:
      // A fold-over of faces that share an edge only by place is reported as an overlap.
      return find_contact(pair.p, pair.q, Common::Edge) ? find_contact(p, q, Common::Nothing)
                                                        : ContactKind::Touching;
    case Common::All:
      return ContactKind::Duplicate;
  }
  return std::nullopt;
}

bool share_point(const Corners& p, const Corners& q) {
  return std::find_first_of(p.begin(), p.end(), q.begin(), q.end()) != p.end() ||
         find_contact(p, q, Common::Nothing).has_value();
}

}  // namespace

std::vector<IntersectingPair> find_intersections(const CutMesh& a, const FaceTree& tree_a,
                                                 const CutMesh& b, const FaceTree& tree_b) {
  return count_intersections(a, tree_a, b, tree_b, PairLimits()).listed;
}

FoundPairs count_intersections(const CutMesh& a, const FaceTree& tree_a, const CutMesh& b,
                               const FaceTree& tree_b, const PairLimits& limits) {
  const BoxMeetings meetings(tree_a, tree_b);
  PairCollector collector(limits.max_listed);
  std::vector<PairBuffer> buffers(meetings.n_chunks(), PairBuffer(collector, kPairsKept));
  const Next end = meetings.run([&](std::size_t chunk, std::size_t f, std::size_t g) {
    if (const auto kind = find_kind(tree_a.corners(f), tree_b.corners(g))) {
      buffers[chunk].push({.face_a = a.side.faces[tree_a.mesh_face(f)],
                           .face_b = b.side.faces[tree_b.mesh_face(g)],
                           .kind = *kind});
    }
    return limits.wants_to_stop() ? Next::Stop : Next::GoOn;
  });
  for (PairBuffer& buffer : buffers) buffer.flush();
  FoundPairs found = collector.take();
  found.is_complete = end == Next::GoOn;
  return found;
}

bool do_intersect(const FaceTree& a, const FaceTree& b) {
  const auto meet = [&](std::size_t, std::size_t f, std::size_t g) {
    return share_point(a.corners(f), b.corners(g)) ? Next::Stop : Next::GoOn;
  };
  return BoxMeetings(a, b).run(meet) == Next::Stop;
}

}  // namespace meshalyzer
