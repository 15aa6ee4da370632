#include "meshalyzer/io/rewrite/ply_edits.h"

#include <utility>

namespace meshalyzer {

void append_field(const PlyField& field, PlyFields& fields) {
  if (!field.size.empty()) fields.emplace_back(field.size);
  fields.insert(fields.end(), field.items.begin(), field.items.end());
}

bool has_no_mean(PlyType type) {
  return is_integer(type) && size_of(type) > 1;
}

void PlyEdits::replace_record(std::string_view record, std::string bytes) {
  if (is_ascii_) {
    replace_lines(record, std::move(bytes));
  } else {
    replace(offset_of(record), offset_of(record) + record.size(), std::move(bytes));
  }
}

void PlyEdits::insert_records_behind(std::string_view record, std::string bytes) {
  if (is_ascii_) {
    insert_lines_behind(record, std::move(bytes));
  } else {
    insert(offset_of(record) + record.size(), std::move(bytes));
  }
}

std::string PlyEdits::joined(const PlyFields& fields) const {
  std::string record;
  for (const std::string& field : fields) {
    record += record.empty() || !is_ascii_ ? "" : " ";
    record += field;
  }
  return is_ascii_ ? record + line_end() : record;
}

}  // namespace meshalyzer
