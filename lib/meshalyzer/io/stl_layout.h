#pragma once

#include <cstddef>

namespace meshalyzer {

// The layout of a binary STL file in bytes: a header, the count of facets, the facets.
inline constexpr std::size_t kStlHeaderBytes = 80;
inline constexpr std::size_t kStlFacetsOffset = 84;
inline constexpr std::size_t kStlFacetBytes = 50;
/// The offset of the attribute word in a facet, after its normal and its corners.
inline constexpr std::size_t kStlAttributeOffset = 48;

}  // namespace meshalyzer
