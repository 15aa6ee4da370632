#include "meshalyzer/mesh/numbering.h"

#include <cstdint>

namespace meshalyzer {

std::optional<Index> first_misnumbered(const Ids& ids, Format format, std::size_t n) {
  if (format != Format::Mesh) return std::nullopt;
  for (Index record = 0; record < n; ++record) {
    if (ids.of(record) != std::int64_t{record} + 1) return record;
  }
  return std::nullopt;
}

}  // namespace meshalyzer
