#include "meshalyzer/repair/driver/deviation.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/parallel_sort.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/repair/driver/internal/changed_faces.h"
#include "meshalyzer/repair/driver/internal/convex_piece.h"
#include "meshalyzer/repair/driver/internal/covered_segments.h"
#include "meshalyzer/repair/driver/internal/face_cover.h"
#include "meshalyzer/repair/driver/internal/face_distance.h"
#include "meshalyzer/repair/driver/internal/removed_walls.h"
#include "meshalyzer/repair/driver/internal/searched_surface.h"
#include "meshalyzer/spatial/box_tree.h"
#include "meshalyzer/spatial/faces_near.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <mutex>
#include <optional>
#include <utility>

namespace meshalyzer {
namespace {

/// Faces that one task measures.
constexpr std::size_t kFacesPerChunk = 64;
/// Corners of the pieces of a cut face count as one within this fraction of the resolution.
constexpr double kMatchingShare = 1.0 / 16;

/// The faces of one mesh whose distance from the other is to be measured.
struct Side {
  const Soup& from;
  const Soup& to;
  std::vector<ChangedFace> faces;
  /// If it is not empty, a box for each face: its points outside of it are within the bound.
  std::vector<Box3> in_doubt;

  [[nodiscard]] Corners corners(std::size_t i) const { return corners_of(from, faces[i].face); }
  /// Returns what is to be measured of a face.
  [[nodiscard]] ConvexPiece part(std::size_t i) const {
    const ConvexPiece face(corners(i));
    return in_doubt.empty() ? face : face.part_in(in_doubt[i]);
  }
};

struct SideResult {
  double largest = 0.0;
  /// The largest distance of the faces that are not far.
  double largest_near = 0.0;
  /// Ascending.
  std::vector<Index> far;
};

/// The question that is answered about the distance between two surfaces.
struct DistanceQuery {
  double bound = 0.0;
  DistanceQuestion question = DistanceQuestion::HowFar;
  /// The largest distance that is known already: what is nearer need not be known.
  double known = 0.0;
  /// If it is given, the points outside of these boxes are known to be within the bound.
  const BoxTree* doubtful = nullptr;
  /// See DeviationMeter::Repaired.
  StopQuery wants_to_stop = {};

  [[nodiscard]] bool is_to_stop() const {
    return question == DistanceQuestion::IsWithin && wants_to_stop();
  }
  /// Returns the precision with which a distance must be known.
  [[nodiscard]] double near_enough() const {
    return question == DistanceQuestion::IsWithin ? bound : resolution();
  }
  [[nodiscard]] double resolution() const { return SurfaceDistance::kResolution * bound; }
};

/// Removes the faces of which `keep` is not true; it is called with their positions, ascending.
template <typename Keep>
void keep_faces(Side& side, const Keep& keep) {
  std::size_t n_kept = 0;
  for (std::size_t i = 0; i < side.faces.size(); ++i) {
    if (!keep(i)) continue;
    side.faces[n_kept] = side.faces[i];
    if (!side.in_doubt.empty()) side.in_doubt[n_kept] = side.in_doubt[i];
    ++n_kept;
  }
  side.faces.resize(n_kept);
  if (!side.in_doubt.empty()) side.in_doubt.resize(n_kept);
}

/// Removes the faces with a known distance, which is not negative, and returns the largest.
double drop_settled(const std::vector<double>& distances, Side& side) {
  keep_faces(side, [&](std::size_t i) { return distances[i] < 0.0; });
  double largest = 0.0;
  for (const double distance : distances) largest = std::max(largest, distance);
  return largest;
}

/// Removes the faces that are near enough to a single face of the other mesh, and returns the
/// largest of their distances.
double settle_near_faces(Side& side, const DistanceQuery& query) {
  std::vector<double> distances(side.faces.size(), -1.0);
  parallel_chunks(side.faces.size(), [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const ChangedFace& changed = side.faces[i];
      if (changed.other == kNoIndex) continue;
      const double distance =
          largest_distance(corners_of(side.from, changed.face), corners_of(side.to, changed.other));
      if (distance <= query.near_enough()) distances[i] = distance;
    }
  });
  return drop_settled(distances, side);
}

/// The parts that changed faces of the input became: faces of the new surface, and walls that were
/// removed. It only refers to them.
class PartsOfFaces {
 public:
  /// @param of_input  The faces of the input whose parts are asked for, ascending.
  PartsOfFaces(std::span<const ChangedFace> of_input, const TrackedMesh& tracked,
               std::span<const ChangedFace> of_repaired, std::span<const InteriorWall> walls)
      : tracked_(tracked), of_repaired_(of_repaired), walls_(walls) {
    const auto add = [&](Index origin, std::size_t part) {
      const auto at = std::lower_bound(
          of_input.begin(), of_input.end(), origin,
          [](const ChangedFace& changed, Index face) { return changed.face < face; });
      if (at == of_input.end() || at->face != origin) return;
      by_origin_.push_back(std::uint64_t{origin} << kBitsOfPart | part);
    };
    for (std::size_t i = 0; i < of_repaired.size(); ++i) {
      add(tracked.origin_of_face(of_repaired[i].face), i);
    }
    for (std::size_t i = 0; i < walls.size(); ++i) add(walls[i].face, of_repaired.size() + i);
    parallel_sort(by_origin_);
  }

  /// @param face  One of the faces of the input.
  [[nodiscard]] std::vector<Corners> of(Index face) const {
    std::vector<Corners> parts;
    for (auto at = std::lower_bound(by_origin_.begin(), by_origin_.end(),
                                    std::uint64_t{face} << kBitsOfPart);
         at != by_origin_.end() && *at >> kBitsOfPart == face; ++at) {
      parts.push_back(corners(*at & kPartMask));
    }
    return parts;
  }

 private:
  static constexpr unsigned kBitsOfPart = 32;
  static constexpr std::uint64_t kPartMask = (std::uint64_t{1} << kBitsOfPart) - 1;

  [[nodiscard]] Corners corners(std::size_t part) const {
    if (part >= of_repaired_.size()) return walls_[part - of_repaired_.size()].corners;
    return corners_of(tracked_.soup, of_repaired_[part].face);
  }

  const TrackedMesh& tracked_;
  std::span<const ChangedFace> of_repaired_;
  std::span<const InteriorWall> walls_;
  /// For each part, the face that it is a part of, and its number, ascending.
  std::vector<std::uint64_t> by_origin_;
};

/// Removes the faces of the input that lie near enough to the pieces they were cut into, and
/// returns the largest of their distances.
double settle_cut_faces(Side& old_side, const PartsOfFaces& parts, const DistanceQuery& query) {
  std::vector<double> distances(old_side.faces.size(), -1.0);
  parallel_chunks(distances.size(), kFacesPerChunk, [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const Index face = old_side.faces[i].face;
      const Corners corners = corners_of(old_side.from, face);
      const std::vector<Corners> pieces = parts.of(face);
      // If vertices were moved a little after the cut, the pieces do not fit together exactly.
      for (const double slack : {0.0, kMatchingShare * query.resolution()}) {
        const auto distance = distance_from_parts(corners, pieces, slack);
        if (!distance || *distance > query.near_enough()) continue;
        distances[i] = *distance;
        break;
      }
    }
  });
  return drop_settled(distances, old_side);
}

/// So many faces are sampled for a distance to start from.
constexpr std::size_t kSampledFaces = 1024;

/// Returns the largest distance of a few points of some of the faces: what is nearer than this need
/// not be known of any face.
double largest_of_samples(const Side& side, const ClosestPoints& closest, double bound) {
  const std::size_t stride = side.faces.size() / kSampledFaces + 1;
  double largest = 0.0;
  for (std::size_t i = 0; i < side.faces.size(); i += stride) {
    const Corners t = corners_of(side.from, side.faces[i].face);
    double of_face = 0.0;
    for (const Vec3& point : {t[0], t[1], t[2], centroid_without_overflow(t)}) {
      const std::optional<SurfacePoint> found = closest.find({.point = point});
      of_face = std::max(of_face, found ? found->distance : bound);
    }
    // A face beyond the bound tells nothing of those that are not, which are measured, too.
    if (of_face <= bound) largest = std::max(largest, of_face);
  }
  return largest;
}

/// Measures all remaining faces of a side.
SideResult measure_side(const Side& side, const FaceTree& tree, const ClosestPoints& closest,
                        const DistanceQuery& query) {
  std::vector<FaceDistance> distances(side.faces.size());
  // The faces of one task tell each other how far they are, those of several need samples.
  double known = query.known;
  if (query.question == DistanceQuestion::HowFar && side.faces.size() > kFacesPerChunk) {
    known = std::max(known, largest_of_samples(side, closest, query.bound));
  }
  parallel_chunks(side.faces.size(), kFacesPerChunk, [&](Chunk chunk) {
    SurfaceDistance meter(tree, closest, query.bound, query.question, known);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      if (query.is_to_stop()) {
        distances[i].is_far = true;
        continue;
      }
      distances[i] = query.doubtful == nullptr
                         ? meter.measure(side.corners(i))
                         : meter.measure(side.corners(i), side.part(i), *query.doubtful);
    }
  });
  SideResult result;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    result.largest = std::max(result.largest, distances[i].largest);
    if (distances[i].is_far) {
      result.far.push_back(side.faces[i].face);
    } else {
      result.largest_near = std::max(result.largest_near, distances[i].largest);
    }
  }
  return result;
}

/// Finds the part of each face that is in doubt if only what lies in some boxes is, and removes
/// faces without such a part.
void find_parts_in_doubt(Side& side, std::span<const Box3> boxes, const BoxTree& tree) {
  side.in_doubt.resize(side.faces.size());
  std::vector<std::uint8_t> is_in_doubt(side.faces.size(), 0);
  parallel_chunks(side.faces.size(), kFacesPerChunk, [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      for (const Index box : tree.meeting(box_of(side.corners(i)))) {
        side.in_doubt[i].extend(boxes[box]);
      }
      is_in_doubt[i] = side.in_doubt[i].isEmpty() || side.part(i).empty() ? 0 : 1;
    }
  });
  keep_faces(side, [&](std::size_t i) { return is_in_doubt[i] != 0; });
}

/// Returns boxes round what a step has removed, within the bound of it.
std::vector<Box3> boxes_near_gone(const SurfaceStep& step, double bound) {
  std::vector<Box3> boxes(step.gone.size());
  std::transform(step.gone.begin(), step.gone.end(), boxes.begin(),
                 [](const Corners& triangle) { return box_of(triangle); });
  return boxes_within(std::move(boxes), bound);
}

/// Returns boxes round what is to be measured, within the bound of it.
std::vector<Box3> boxes_near_parts(const Side& side, double bound) {
  std::vector<Box3> boxes(side.faces.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) boxes[i] = side.part(i).box();
  return boxes_within(std::move(boxes), bound);
}

/// A tree over the whole of the other surface is worth its time if there is more than one face to
/// measure for so many of its faces.
constexpr std::size_t kFacesPerMeasured = 16;

/// Measures the remaining faces of a side: if they are few, from those faces of the other surface
/// alone that may be within the bound, which takes no tree over the whole of it.
///
/// @param other          The other surface.
/// @param measure_whole  Measures them from the whole of it: called if they are many, or if a
///                       distance beyond the bound is to be known.
template <typename MeasureWhole>
SideResult measure_rest(const Side& side, const Soup& other, const DistanceQuery& query,
                        const MeasureWhole& measure_whole) {
  if (side.faces.size() * kFacesPerMeasured >= other.n_faces()) return measure_whole();
  const SearchedSurface near(part_near(other, boxes_near_parts(side, query.bound)));
  SideResult result = measure_side(side, near.tree, near.closest, query);
  const bool is_known = query.question == DistanceQuestion::IsWithin || result.far.empty();
  return is_known ? result : measure_whole();
}

/// The part of the new surface, and of the walls, that is near what is to be measured. A wall may
/// be a part of another face than the one that it is near to: an edge may have been flipped before.
Soup surface_with_walls(const Side& old_side, std::span<const InteriorWall> walls, double bound) {
  const std::vector<Box3> boxes = boxes_near_parts(old_side, bound);
  Soup soup = part_near(old_side.to, boxes);
  const BoxTree near(boxes);
  for (const InteriorWall& wall : walls) {
    if (!near.meets_any(box_of(wall.corners))) continue;
    const auto first = static_cast<Index>(soup.n_vertices());
    soup.positions.insert(soup.positions.end(), wall.corners.begin(), wall.corners.end());
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

/// Measures the far faces of the input again, with walls as part of the new surface. There are
/// often so many walls that only what is farther than the rest is worth measuring.
SideResult measure_with_walls(Side& old_side, const SideResult& without,
                              std::span<const InteriorWall> walls, DistanceQuery query) {
  keep_faces(old_side, [&](std::size_t i) {
    return std::binary_search(without.far.begin(), without.far.end(), old_side.faces[i].face);
  });
  query.known = without.largest_near;
  const SearchedSurface surface(surface_with_walls(old_side, walls, query.bound));
  SideResult result = measure_side(old_side, surface.tree, surface.closest, query);
  result.largest = std::max(result.largest, without.largest_near);
  return result;
}

/// Measures the remaining faces of the input.
SideResult measure_old_side(Side& old_side, const DeviationMeter::Repaired& repaired,
                            const DistanceQuery& query) {
  if (query.doubtful != nullptr && !repaired.walls.empty()) {
    // Most of what a step has taken beyond the bound of the surface is near to walls.
    const SearchedSurface near(surface_with_walls(old_side, repaired.walls, query.bound));
    return measure_side(old_side, near.tree, near.closest, query);
  }
  SideResult result = measure_rest(old_side, repaired.tracked.soup, query, [&] {
    const FaceTree& tree = repaired.mesh.tree();
    return measure_side(old_side, tree, ClosestPoints(tree), query);
  });
  if (result.far.empty() || repaired.walls.empty()) return result;
  return measure_with_walls(old_side, result, repaired.walls, query);
}

}  // namespace

struct DeviationMeter::Surface {
  [[nodiscard]] const Soup& soup(const Soup& input) const {
    return with_patches ? *with_patches : input;
  }
  /// Builds the surface at the first call.
  const SearchedSurface& built(const Soup& input) {
    std::call_once(is_built, [&] { searched.emplace(soup(input)); });
    return *searched;
  }

  /// The input's faces, then the patches; empty if there are none.
  std::optional<Soup> with_patches;
  std::once_flag is_built;
  std::optional<SearchedSurface> searched;
};

DeviationMeter::DeviationMeter(const Soup& input)
    : input_(input), surface_(std::make_unique<Surface>()) {}

void DeviationMeter::include_patches(const TrackedMesh& tracked) {
  auto surface = std::make_unique<Surface>();
  surface->with_patches = std::move(surface_->with_patches);
  if (!surface->with_patches) {
    surface->with_patches.emplace();
    surface->with_patches->positions = input_.positions;
    surface->with_patches->triangles = input_.triangles;
  }
  Soup& soup = *surface->with_patches;
  is_included_.resize(tracked.face_origins.size(), 0);
  for (Index face = 0; face < tracked.soup.n_faces(); ++face) {
    const bool is_patch = tracked.origin_of_face(face) == kNoIndex;
    if (!is_patch || !is_in_complex(tracked.soup.triangles[face])) continue;
    std::uint8_t& is_included = is_included_[tracked.face_keys[face] - tracked.n_input_faces];
    if (std::exchange(is_included, 1) != 0) continue;
    const auto first = static_cast<Index>(soup.n_vertices());
    for (const Vec3& corner : corners_of(tracked.soup, face)) soup.positions.push_back(corner);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  surface_ = std::move(surface);
}

DeviationMeter::~DeviationMeter() = default;

DeviationMeter::Result DeviationMeter::measure(const Repaired& repaired) const {
  return measure_changes(find_measured_faces(repaired), repaired, repaired.walls,
                         DistanceQuestion::HowFar);
}

FarFaces DeviationMeter::find_far(const Repaired& repaired) const {
  return measure_changes(find_measured_faces(repaired), repaired, repaired.walls,
                         DistanceQuestion::IsWithin)
      .far;
}

void DeviationMeter::drop_unaffected(const Repaired& repaired,
                                     std::vector<ChangedFace>& of_input) const {
  const std::vector<Index> affected =
      find_faces_near(input_, boxes_near_gone(*repaired.step, repaired.bound));
  std::erase_if(of_input, [&](const ChangedFace& changed) {
    return !std::binary_search(affected.begin(), affected.end(), changed.face);
  });
}

ChangedFaces DeviationMeter::find_measured_faces(const Repaired& repaired) const {
  ChangedFaces changed = find_changed_faces(input_, repaired.tracked);
  // What leaves few faces comes first: there may be very many walls to look for.
  if (repaired.step != nullptr) drop_unaffected(repaired, changed.of_input);
  drop_walls(input_, repaired.walls, changed.of_input);
  drop_covered_segments(input_, changed.of_input);
  // What lies on a lost face is lost with it, so these go last.
  std::erase_if(changed.of_input, [&](const ChangedFace& face) {
    return std::binary_search(repaired.lost.begin(), repaired.lost.end(), face.face);
  });
  return changed;
}

std::vector<double> DeviationMeter::measure_parts(const Repaired& repaired,
                                                  std::span<const Index> part_of,
                                                  std::size_t n_parts) const {
  const ChangedFaces all = find_measured_faces(repaired);
  std::vector<ChangedFaces> parts(n_parts);
  for (const ChangedFace& changed : all.of_input) {
    const Index part = part_of[changed.face];
    if (part != kNoIndex) parts[part].of_input.push_back(changed);
  }
  for (const ChangedFace& changed : all.of_repaired) {
    const Index part = part_of[repaired.tracked.origin_of_face(changed.face)];
    if (part != kNoIndex) parts[part].of_repaired.push_back(changed);
  }
  std::vector<std::vector<InteriorWall>> walls(n_parts);
  for (const InteriorWall& wall : repaired.walls) {
    const Index part = wall.face == kNoIndex ? kNoIndex : part_of[wall.face];
    if (part != kNoIndex) walls[part].push_back(wall);
  }
  std::vector<double> distances(n_parts);
  for (std::size_t i = 0; i < n_parts; ++i) {
    distances[i] =
        measure_changes(std::move(parts[i]), repaired, walls[i], DistanceQuestion::HowFar).largest;
  }
  return distances;
}

DeviationMeter::Result DeviationMeter::measure_changes(ChangedFaces changes,
                                                       const Repaired& repaired,
                                                       std::span<const InteriorWall> own_walls,
                                                       DistanceQuestion question) const {
  const TrackedMesh& tracked = repaired.tracked;
  const DistanceQuery query{
      .bound = repaired.bound, .question = question, .wants_to_stop = repaired.wants_to_stop};
  Side old_side{input_, tracked.soup, std::move(changes.of_input), {}};
  Side new_side{tracked.soup, input_, std::move(changes.of_repaired), {}};
  // What is near to a point of the input lies within the bound of it. So the point stays near
  // unless the step has removed something there.
  DistanceQuery old_query = query;
  std::optional<BoxTree> near_gone;
  if (repaired.step != nullptr) {
    const std::vector<Box3> boxes = boxes_near_gone(*repaired.step, repaired.bound);
    near_gone.emplace(boxes);
    find_parts_in_doubt(old_side, boxes, *near_gone);
    old_query.doubtful = &*near_gone;
  }
  Result result;
  result.largest = settle_near_faces(old_side, query);
  if (!old_side.faces.empty()) {
    const PartsOfFaces parts(old_side.faces, tracked, new_side.faces, own_walls);
    result.largest = std::max(result.largest, settle_cut_faces(old_side, parts, query));
  }
  if (repaired.step != nullptr) {
    // The input has not changed, so that the faces that are not new are as near to it as before.
    std::erase_if(new_side.faces, [&](const ChangedFace& changed) {
      return repaired.step->is_new[changed.face] == 0;
    });
  }
  result.largest = std::max(result.largest, settle_near_faces(new_side, query));
  if (!old_side.faces.empty()) {
    SideResult old_result = measure_old_side(old_side, repaired, old_query);
    result.largest = std::max(result.largest, old_result.largest);
    result.far.of_input = std::move(old_result.far);
  }
  if (!new_side.faces.empty()) {
    SideResult new_result = measure_rest(new_side, surface_->soup(input_), query, [&] {
      const SearchedSurface& input = surface_->built(input_);
      return measure_side(new_side, input.tree, input.closest, query);
    });
    result.largest = std::max(result.largest, new_result.largest);
    result.far.of_repaired = std::move(new_result.far);
  }
  return result;
}

}  // namespace meshalyzer
