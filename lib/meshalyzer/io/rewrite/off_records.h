#pragma once

#include "meshalyzer/io/off_keyword.h"
#include "meshalyzer/io/rewrite/face_plan.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The positions of the records of an OFF file.
struct OffRecords {
  std::string_view n_vertices;
  std::string_view n_faces;
  std::vector<std::size_t> vertices;
  std::vector<std::size_t> faces;
  FaceRecords face_records;
  /// What each vertex must have.
  OffLayout layout;
};

/// Finds the records of a text that parse_off() reads.
///
/// @complexity O(bytes) time.
[[nodiscard]] OffRecords find_off_records(std::string_view text, std::size_t n_vertices);

/// Tells whether the numbers of a colour can only be bytes: all are whole, and one is above 1.
/// Colours of whole numbers up to 1 are bytes if another colour of the file is; else they are
/// intensities, since many programs write 1.0 as 1.
[[nodiscard]] bool is_byte_colour(std::span<const std::string_view> colour);

/// Returns an intensity as text with a point, so that no reader takes it for a byte.
[[nodiscard]] std::string off_intensity(double intensity);

}  // namespace meshalyzer
