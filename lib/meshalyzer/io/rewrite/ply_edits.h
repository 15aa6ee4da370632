#pragma once

#include "meshalyzer/io/rewrite/ply_records.h"
#include "meshalyzer/io/rewrite/text_lines.h"

#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The fields of a record to be written, each in the encoding of the file.
using PlyFields = std::vector<std::string>;

/// Appends the field of a record, with its length if it is a list.
void append_field(const PlyField& field, PlyFields& fields);

/// Tells whether numbers of this type have no mean because they are identifiers: whole numbers
/// wider than a byte. Bytes are colours.
[[nodiscard]] bool has_no_mean(PlyType type);

/// Edits of the content of a PLY file. Records of text are lines.
class PlyEdits : public LineEdits {
 public:
  PlyEdits(std::string_view content, bool is_ascii) : LineEdits(content), is_ascii_(is_ascii) {}

  /// @param bytes  The new records, as joined() makes them; empty to drop the record.
  void replace_record(std::string_view record, std::string bytes);
  void insert_records_behind(std::string_view record, std::string bytes);
  /// Returns a record with these fields.
  [[nodiscard]] std::string joined(const PlyFields& fields) const;

 private:
  bool is_ascii_;
};

}  // namespace meshalyzer
