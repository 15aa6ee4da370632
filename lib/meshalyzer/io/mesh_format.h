#pragma once

#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace meshalyzer {

/// The options for dividing a long text for parallel parsing.
struct MeshFormatOptions {
  /// The size of a part in bytes, up to the next line end. It does not change any result.
  std::size_t bytes_per_part = std::size_t{1} << 20U;
};

/// Reads the native `.mesh` format: lines `Vertex i x y z` and `Face j a b c` in any order.
///
/// A line that begins with a number is the remains of a torn record: it is no record, and listed in
/// Soup::torn_lines.
///
/// @param name  The name of the file in messages.
/// @throws IoError with the first faulty line of the text, whatever the number of threads and the
/// size of the parts.
/// @complexity O(bytes) time for contiguous ids, O(bytes) memory for any.
[[nodiscard]] Soup parse_mesh_format(std::string_view text, const std::string& name,
                                     const MeshFormatOptions& options = {});

/// Writes the soup's own ids; if they begin below 1, as those of OFF do, records are numbered from
/// 1.
/// @throws InvalidArgument if a face has a corner without a vertex, or one whose id belongs to an
///         earlier vertex.
[[nodiscard]] std::string print_mesh_format(const Soup& soup);

}  // namespace meshalyzer
