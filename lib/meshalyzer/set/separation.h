#pragma once

#include "meshalyzer/base/types.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace meshalyzer {

/// The options of the separation of objects, which select the points that count. Lengths are finite
/// and not negative.
struct SeparationOptions {
  /// Vertices with nothing closer than this are counted, not measured.
  std::optional<double> search_radius = std::nullopt;
  /// Excludes points whose direction is more than this number of degrees from the vertex normal, 0
  /// ... 90.
  std::optional<double> search_cone_degrees = std::nullopt;
  /// Includes the object's own surface, except faces with a vertex within this length along edges.
  std::optional<double> include_self = std::nullopt;

  friend bool operator==(const SeparationOptions&, const SeparationOptions&) = default;
};

/// The closest point of any other object for each vertex of one object, in columns of equal length.
struct ObjectSeparation {
  /// The ids of the vertices that faces use, in file order.
  std::vector<std::int64_t> vertices;
  /// The distances, negative if the vertex lies inside another object; NaN if no point was found.
  std::vector<double> distances;
  /// The object of the closest point; kNoIndex if none was found.
  std::vector<Index> objects;
  /// The id of its face; of several at the same distance, the first face of the first object.
  std::vector<std::int64_t> faces;
  std::vector<Vec3> points;
};

}  // namespace meshalyzer
