#pragma once

#include "meshalyzer/io/inria_sections.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The sections of a file that hold records.
struct InriaRecords {
  struct Section {
    std::string_view keyword;
    std::string_view count;
    /// The kind of the section; null for vertices and faces.
    const InriaSection* kind = nullptr;
    /// The records, each from its first number to its last.
    std::vector<std::string_view> records;
  };
  std::vector<Section> sections;
  /// The number of statements that have no records: see kInriaStatements.
  std::size_t n_statements = 0;
};

/// Finds the records of a text that parse_inria() reads.
[[nodiscard]] InriaRecords find_inria_records(std::string_view text);

/// Returns the numbers of a record, which may extend over several lines.
[[nodiscard]] std::vector<std::string_view> inria_numbers(std::string_view record);

}  // namespace meshalyzer
