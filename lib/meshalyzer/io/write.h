#pragma once

#include "meshalyzer/mesh/soup.h"

#include <string>

namespace meshalyzer {

/// The encoding to write if a format has several.
enum class Encoding { Text, Binary };

/// Writes a soup to a file; the format is that of the name's ending, `.mesh` the native one, and a
/// name ending in .gz gives a gzipped file.
///
/// Every double reads back to the last bit, except from the 32-bit floats of binary STL. The file
/// is written beside the target, flushed and renamed, so that a failure leaves the old file as it
/// was.
///
/// @throws IoError if the file cannot be written; InvalidArgument if the soup contradicts itself,
/// the ending is of no known format, the format has no such encoding (Binary: STL and PLY only), or
/// a face has a corner without a vertex or, in a `.mesh` file, a vertex whose id belongs to an
/// earlier one.
void write_mesh(const Soup& soup, const std::string& path, Encoding encoding = Encoding::Text);

/// Returns the bytes that write_mesh() would write.
[[nodiscard]] std::string print_mesh(const Soup& soup, Format format,
                                     Encoding encoding = Encoding::Text);

}  // namespace meshalyzer
