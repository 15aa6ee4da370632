#include "meshalyzer/io/rewrite/inria_records.h"

#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/text_scanner.h"

#include <cstddef>
#include <optional>
#include <utility>

namespace meshalyzer {
namespace {

class InriaRecordFinder {
 public:
  explicit InriaRecordFinder(std::string_view text) : text_(text), in_(text) {}

  InriaRecords find() {
    while (in_.next_record()) {
      const std::string_view keyword = in_.word();
      if (keyword == "End") {
        break;
      }
      read_section(keyword);
    }
    return std::move(records_);
  }

 private:
  void read_section(std::string_view keyword) {
    if (keyword == "MeshVersionFormatted" || keyword == "Dimension") {
      skip(1);
    } else if (const InriaStatement* statement = find_inria_statement(keyword)) {
      ++records_.n_statements;
      skip(statement->n_numbers);
      if (statement->n_numbers == 0) in_.skip_record();
    } else {
      read_records(keyword);
    }
  }

  void skip(std::size_t n) {
    for (std::size_t i = 0; i < n && in_.next_record(); ++i) {
      static_cast<void>(in_.word());
    }
  }

  void read_records(std::string_view keyword) {
    InriaRecords::Section& section = records_.sections.emplace_back();
    section.keyword = keyword;
    section.kind = find_inria_section(keyword);
    static_cast<void>(in_.next_record());
    section.count = in_.word();
    const std::size_t n_own = keyword == "Quadrilaterals" ? 5 : 4;
    const std::size_t n_numbers = section.kind == nullptr ? n_own : section.kind->numbers_a_record;
    const auto n = static_cast<std::size_t>(parse_integer(section.count).value_or(0));
    section.records.reserve(n);
    for (std::size_t i = 0; i < n && in_.next_record(); ++i) {
      const std::size_t begin = text_.size() - in_.remaining();
      skip(n_numbers);
      section.records.push_back(text_.substr(begin, text_.size() - in_.remaining() - begin));
    }
  }

  std::string_view text_;
  TextScanner in_;
  InriaRecords records_;
};

}  // namespace

InriaRecords find_inria_records(std::string_view text) {
  return InriaRecordFinder(text).find();
}

std::vector<std::string_view> inria_numbers(std::string_view record) {
  TextScanner in(record);
  std::vector<std::string_view> numbers;
  while (in.next_record()) {
    numbers.push_back(in.word());
  }
  return numbers;
}

}  // namespace meshalyzer
