#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>

namespace meshalyzer {

/// The one vector type of the library: positions and directions, in the file's own length unit.
using Vec3 = Eigen::Vector3d;

/// An axis-aligned box, which is empty when default-constructed (isEmpty()).
using Box3 = Eigen::AlignedBox3d;

/// The index of a record (vertex or face) in file order, from 0. It is not the file's id: see Ids.
using Index = std::uint32_t;

/// The index that means "no such record".
inline constexpr Index kNoIndex = 0xFFFFFFFFU;

/// Three vertex indices, in the order of the file.
using Triangle = std::array<Index, 3>;

/// The triangle that means "none": no corners, because the face was removed, or no normals.
inline constexpr Triangle kNoTriangle = {kNoIndex, kNoIndex, kNoIndex};

/// Tells whether all three corners name a record.
[[nodiscard]] constexpr bool has_all_corners(const Triangle& t) {
  return t[0] != kNoIndex && t[1] != kNoIndex && t[2] != kNoIndex;
}

}  // namespace meshalyzer
