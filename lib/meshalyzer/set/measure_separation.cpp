#include "meshalyzer/set/measure_separation.h"

#include "meshalyzer/base/box.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/geometry/vertex_normals.h"
#include "meshalyzer/set/box_distance.h"
#include "meshalyzer/set/edge_neighbourhood.h"
#include "meshalyzer/set/nearby_objects.h"
#include "meshalyzer/set/require_options.h"
#include "meshalyzer/spatial/closest_point.h"
#include "meshalyzer/spatial/mutual_intersection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>

namespace meshalyzer {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// The number of vertices in one task. They follow each other on the surface, so that the answer of
/// one is a good first guess for the next.
constexpr std::size_t kVerticesPerChunk = 256;
/// The number of vertices that are excluded together where another object is far from all of them:
/// as many as still lie close together.
constexpr std::size_t kVerticesPerPatch = 16;
/// The largest number of tasks that search an object's own surface.
constexpr std::size_t kSelfChunks = 64;

/// The best answer for one vertex so far.
struct Best {
  double distance = kInfinity;
  Vec3 point = Vec3::Zero();
  Index object = kNoIndex;
  std::int64_t face = 0;
};

/// Tells whether something in a box may be as near as a distance or nearer, with a tolerance for
/// rounding.
///
/// The tolerance is sufficient: the error of closest_on_triangle() may be larger for faces that
/// reach far beyond their closest point, but not if that is as near as their box.
bool may_undercut(double distance_of_box, double distance) {
  constexpr double kGrant = 1.0 - 1e-12;
  return !(distance_of_box * kGrant > distance);
}

/// Tells whether something in a box may be as near to a point as a distance or nearer, with the
/// same tolerance.
///
/// It compares squares, which is much faster. Where they underflow, it accepts the box; where that
/// of the box overflows, so does the other, or it is smaller.
bool may_undercut(const Box3& box, const Vec3& point, double distance) {
  constexpr double kGrant = 1.0 - 1e-11;
  const Vec3 gap = (box.min() - point).cwiseMax(point - box.max()).cwiseMax(Vec3::Zero());
  return distance >= 0.0 &&
         !(gap.squaredNorm() * kGrant > distance * distance + std::numeric_limits<double>::min());
}

/// Tells whether a box may intersect a cone with its apex at `apex`: false only if it lies behind
/// the apex, or its bounding sphere beside the cone.
bool may_hold(const Box3& box, const Vec3& apex, const Cone& cone) {
  constexpr double kGrant = 1e-9;
  const Vec3 to_middle = middle_of(box) - apex;
  const Vec3 half = half_widths_of(box);
  const double ahead = to_middle.dot(cone.axis) + half.dot(cone.axis.cwiseAbs());
  const double length = to_middle.stableNorm();
  const double radius = half.stableNorm();
  if (ahead < -kGrant * (length + radius)) {
    return false;
  }
  const double angle = std::acos(std::clamp(to_middle.dot(cone.axis) / length, -1.0, 1.0));
  const double reach = std::acos(cone.cos_half_angle) + std::asin(std::min(1.0, radius / length));
  // The comparison is written so that a NaN from an overflow above accepts the box.
  return radius >= length || !(angle > reach + kGrant);
}

class Separator {
 public:
  Separator(Index number, const SetScene& scene, const SeparationOptions& options)
      : number_(number),
        scene_(scene),
        options_(options),
        object_(scene.objects.get(number)),
        vertices_(object_->used_vertices()),
        best_(vertices_.size()),
        is_inside_(vertices_.size(), 0),
        open_(vertices_.size()) {
    std::iota(open_.begin(), open_.end(), std::size_t{0});
    if (options.search_radius) {
      for (Best& best : best_) {
        best.distance = *options.search_radius;
      }
    }
    if (options.search_cone_degrees) {
      normals_ = vertex_normals(object_->cut());
      leave_out_vertices_without_normal();
    }
  }

  [[nodiscard]] ObjectSeparation measure() {
    if (options_.include_self) {
      look_at_self();
    }
    NearbyObjects others(number_, scene_.boxes, scene_.tree);
    for (double reach = 0.0; !open_.empty() && !others.all_given(); reach = next_reach(reach)) {
      look_at_all(others.within(reach));
      close_those_nearer_than(others.given_up_to());
    }
    return in_file_order();
  }

 private:
  [[nodiscard]] const Vec3& point(std::size_t i) const {
    return object_->tree().point(vertices_[i]);
  }

  /// Excludes the vertices without a normal, for which there is no cone.
  void leave_out_vertices_without_normal() {
    for (std::size_t i = 0; i < best_.size(); ++i) {
      if (normals_[vertices_[i]].isZero(0.0)) {
        best_[i].distance = -kInfinity;
      }
    }
  }

  [[nodiscard]] bool is_in_reach(const Box3& box, std::size_t i) const {
    return may_undercut(box, point(i), best_[i].distance) &&
           (normals_.empty() || may_hold(box, point(i), cone(i)));
  }

  [[nodiscard]] bool is_in_reach(const Box3& box) const {
    return std::any_of(open_.begin(), open_.end(),
                       [&](std::size_t i) { return is_in_reach(box, i); });
  }

  /// Closes the vertices whose closest point is nearer than all objects to come, which are at this
  /// distance or farther.
  void close_those_nearer_than(double distance) {
    std::erase_if(open_, [&](std::size_t i) { return !may_undercut(distance, best_[i].distance); });
  }

  /// Returns the next search radius: the largest distance found so far, or an increasing one while
  /// some vertex has no closest point yet.
  [[nodiscard]] double next_reach(double reach) const {
    constexpr double kGrant = 1.0 + 1e-8;
    double farthest = 0.0;
    for (const std::size_t i : open_) {
      farthest = std::max(farthest, best_[i].distance);
    }
    const bool is_found = farthest > 0.0 && farthest < kInfinity;
    const double enough = is_found ? farthest * kGrant : object_->box().diagonal().stableNorm();
    return std::max({enough, 2 * reach, std::numeric_limits<double>::denorm_min()});
  }

  void look_at_all(const std::vector<NearbyObjects::Candidate>& candidates) {
    for (const NearbyObjects::Candidate& next : candidates) {
      close_those_nearer_than(next.distance);
      if (is_in_reach(scene_.boxes[next.object])) {
        const std::shared_ptr<const SetObject> other = scene_.objects.get(next.object);
        look_at(next.object, *other);
        mark_inside(*other);
      }
    }
  }

  [[nodiscard]] Cone cone(std::size_t i) const {
    const double radians = *options_.search_cone_degrees * std::numbers::pi / 180.0;
    return {normals_[vertices_[i]], std::cos(radians)};
  }

  [[nodiscard]] ClosestQuery query(std::size_t i) const {
    ClosestQuery query{.point = point(i), .within = best_[i].distance};
    if (options_.search_cone_degrees) {
      query.cone = cone(i);
    }
    return query;
  }

  void look_at(Index number, const SetObject& other) {
    parallel_chunks(open_.size(), kVerticesPerChunk, [&](Chunk chunk) {
      Index hint = kNoIndex;
      for (std::size_t k = chunk.begin; k < chunk.end; k += kVerticesPerPatch) {
        const std::size_t n = std::min(kVerticesPerPatch, chunk.end - k);
        const auto patch = std::span(open_).subspan(k, n);
        if (!may_be_near(other, patch)) continue;
        for (const std::size_t i : patch) {
          if (is_in_reach(other.box(), i)) {
            ClosestQuery closest_query = query(i);
            closest_query.hint = hint;
            hint = take(i, number, other, closest_query);
          }
        }
      }
    });
  }

  /// Tells whether another object may be as near to any of some vertices as the best so far.
  [[nodiscard]] bool may_be_near(const SetObject& other, std::span<const std::size_t> patch) const {
    Box3 box;
    double farthest = -kInfinity;
    for (const std::size_t i : patch) {
      box.extend(point(i));
      farthest = std::max(farthest, best_[i].distance);
    }
    return farthest >= 0.0 && other.closest().may_be_within(box, farthest);
  }

  void look_at_self() {
    const FaceTree& tree = object_->tree();
    const ItemsByGroup slots = slots_by_vertex(tree, object_->cut().side.n_file_vertices);
    // There are few chunks, because each begins with a table of all vertices.
    const std::size_t length = std::max(kVerticesPerChunk, vertices_.size() / kSelfChunks + 1);
    parallel_chunks(vertices_.size(), length, [&](Chunk chunk) {
      EdgeNeighbourhood neighbourhood(tree, slots);
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        ClosestQuery closest_query = query(i);
        closest_query.excluded = neighbourhood.mark_within(vertices_[i], *options_.include_self);
        (void)take(i, number_, *object_, closest_query);
      }
    });
  }

  /// Queries an object, and keeps its point if it is closer, or as close and on an object of lower
  /// number.
  /// @return A good guess for the next vertex.
  Index take(std::size_t i, Index number, const SetObject& other,
             const ClosestQuery& closest_query) {
    const std::optional<SurfacePoint> found = other.closest().find(closest_query);
    if (!found) {
      return kNoIndex;
    }
    Best& best = best_[i];
    if (found->distance < best.distance || number < best.object) {
      const FaceHandle face(static_cast<int>(found->mesh_face));
      best = {found->distance, found->point, number,
              other.face_ids().of(other.cut().side.face(face))};
    }
    return found->slot;
  }

  void mark_inside(const SetObject& other) {
    if (!other.is_solid() || !object_->box().intersects(other.box())) {
      return;
    }
    if (do_intersect(object_->tree(), other.tree())) {
      mark_vertices_inside(other);
    } else {
      mark_components_inside(other);
    }
  }

  void mark_vertices_inside(const SetObject& other) {
    parallel_chunks(vertices_.size(), kVerticesPerChunk, [&](Chunk chunk) {
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        if (other.side_of(point(i)) == Side::Inside) {
          is_inside_[i] = 1;
        }
      }
    });
  }

  /// Marks the components that are inside the other object. If the surfaces do not meet, one vertex
  /// decides for its whole component.
  void mark_components_inside(const SetObject& other) {
    const Components& components = object_->components();
    std::vector<std::uint8_t> is_inside(components.count, 0);
    for (std::size_t c = 0; c < components.count; ++c) {
      const Vec3& any = object_->tree().point(object_->component_vertices()[c]);
      if (other.box().contains(object_->component_boxes()[c]) &&
          other.side_of(any) == Side::Inside) {
        is_inside[c] = 1;
      }
    }
    if (std::find(is_inside.begin(), is_inside.end(), 1) != is_inside.end()) {
      mark_vertices_of(is_inside);
    }
  }

  void mark_vertices_of(const std::vector<std::uint8_t>& marked_components) {
    const FaceTree& tree = object_->tree();
    std::vector<std::uint8_t> is_marked(object_->cut().side.n_file_vertices, 0);
    for (std::size_t slot = 0; slot < tree.n_faces(); ++slot) {
      if (marked_components[object_->components().of_face[tree.mesh_face(slot)]] != 0) {
        for (const Index v : tree.triangle(slot)) {
          is_marked[v] = 1;
        }
      }
    }
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      is_inside_[i] |= is_marked[vertices_[i]];
    }
  }

  [[nodiscard]] ObjectSeparation in_file_order() const {
    std::vector<std::size_t> order(vertices_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return vertices_[a] < vertices_[b]; });
    ObjectSeparation result;
    for (const std::size_t i : order) {
      const Best& best = best_[i];
      const bool is_found = best.object != kNoIndex;
      result.vertices.push_back(object_->vertex_ids().of(vertices_[i]));
      result.distances.push_back(!is_found            ? std::numeric_limits<double>::quiet_NaN()
                                 : is_inside_[i] != 0 ? -best.distance
                                                      : best.distance);
      result.objects.push_back(best.object);
      result.faces.push_back(best.face);
      result.points.push_back(best.point);
    }
    return result;
  }

  Index number_;
  const SetScene& scene_;
  const SeparationOptions& options_;
  std::shared_ptr<const SetObject> object_;
  /// The vertices in the order of the tree; the next three columns are in this order too.
  std::vector<Index> vertices_;
  std::vector<Best> best_;
  std::vector<std::uint8_t> is_inside_;
  /// The positions of the vertices to which a farther object may still be closest, ascending.
  std::vector<std::size_t> open_;
  /// The normal of each file vertex; empty without a cone.
  std::vector<Vec3> normals_;
};

}  // namespace

ObjectSeparation measure_separation(Index object, const SetScene& scene,
                                    const SeparationOptions& options) {
  require_valid(options);
  return Separator(object, scene, options).measure();
}

}  // namespace meshalyzer
