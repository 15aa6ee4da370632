#include "meshalyzer/io/rewrite/off_records.h"

#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/text_scanner.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

namespace meshalyzer {
namespace {

class OffRecordFinder {
 public:
  OffRecordFinder(std::string_view text, std::size_t n_vertices)
      : text_(text), in_(text), n_vertices_(n_vertices) {}

  OffRecords find() {
    static_cast<void>(in_.next_record());
    if (is_off_keyword(in_.peek())) {
      records_.layout = parse_off_keyword(in_.peek(), in_);
      static_cast<void>(in_.word());
      static_cast<void>(in_.next_record());
    }
    records_.n_vertices = in_.word();
    records_.n_faces = in_.word();
    in_.skip_record();
    while (in_.next_record()) {
      note_record();
    }
    return std::move(records_);
  }

 private:
  void note_record() {
    const std::size_t begin = text_.size() - in_.remaining();
    if (records_.vertices.size() < n_vertices_) {
      records_.vertices.push_back(begin);
    } else {
      records_.faces.push_back(begin);
      records_.face_records.append(static_cast<std::size_t>(in_.integer()));
    }
    in_.skip_record();
  }

  std::string_view text_;
  TextScanner in_;
  std::size_t n_vertices_;
  OffRecords records_;
};

}  // namespace

OffRecords find_off_records(std::string_view text, std::size_t n_vertices) {
  return OffRecordFinder(text, n_vertices).find();
}

bool is_byte_colour(std::span<const std::string_view> colour) {
  bool is_above_1 = false;
  for (const std::string_view word : colour) {
    const std::optional<std::int64_t> number = parse_integer(word);
    if (!number) return false;
    is_above_1 = is_above_1 || *number > 1;
  }
  return is_above_1;
}

std::string off_intensity(double intensity) {
  const std::string text = shortest(intensity);
  const bool is_whole = text.find_first_not_of("-0123456789") == std::string::npos;
  return is_whole ? text + ".0" : text;
}

}  // namespace meshalyzer
