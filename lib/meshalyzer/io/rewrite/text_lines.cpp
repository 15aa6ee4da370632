#include "meshalyzer/io/rewrite/text_lines.h"

#include "meshalyzer/base/numbers.h"

#include <algorithm>
#include <utility>

namespace meshalyzer {

std::vector<std::string_view> words_at(std::string_view text, std::size_t begin,
                                       Continuation continuation) {
  TextScanner in(text.substr(begin), continuation);
  std::vector<std::string_view> words;
  while (!in.at_record_end()) {
    words.push_back(in.word());
  }
  return words;
}

std::size_t line_offset(std::string_view text, std::size_t line) {
  std::size_t begin = 0;
  for (std::size_t l = 1; l < line; ++l) {
    begin = text.find('\n', begin) + 1;
  }
  return begin;
}

std::string_view span_of(const std::vector<std::string_view>& words) {
  const char* const begin = words.front().data();
  const char* const end = words.back().data() + words.back().size();
  return {begin, static_cast<std::size_t>(end - begin)};
}

LineEdits::LineEdits(std::string_view text) : ByteEdits(text) {
  const std::size_t first_end = text.find('\n');
  const bool has_return =
      first_end != std::string_view::npos && first_end != 0 && text[first_end - 1] == '\r';
  line_end_ = has_return ? "\r\n" : "\n";
}

void LineEdits::replace_lines(std::string_view record, std::string lines) {
  const std::size_t begin = offset_of(record);
  const std::size_t next = next_line(begin + record.size());
  const std::string_view rest =
      source().substr(begin + record.size(), next - begin - record.size());
  if (rest.find('#') != std::string_view::npos) {
    if (lines.empty()) {
      note_loss(AttributeKind::Comments, rest);
    } else {
      lines.insert(lines.find(line_end_), rest.substr(0, rest.find_last_not_of("\r\n") + 1));
    }
  }
  replace(line_begin(begin), next, std::move(lines));
}

bool LineEdits::is_continued(std::size_t next) const {
  std::string_view line = source().substr(0, next - 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line.ends_with('\\');
}

void LineEdits::insert_lines_behind(std::string_view record, std::string lines) {
  if (lines.empty()) {
    return;
  }
  std::size_t at = next_line(offset_of(record) + record.size());
  // A backslash at the end of a line joins the next line to the record.
  while (at < source().size() && is_continued(at)) at = next_line(at);
  if (at == source().size() && source().back() != '\n') {
    lines.insert(0, line_end_);
    if (source().back() == '\\') lines.insert(0, line_end_);
  } else if (at == source().size() && is_continued(at)) {
    lines.insert(0, line_end_);
  }
  insert(at, std::move(lines));
}

void LineEdits::replace_numbers(std::span<const std::string_view> words,
                                std::span<const double> before, std::span<const double> now) {
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i] != before[i]) replace(words[i], shortest(now[i]));
  }
}

void LineEdits::replace_integer(std::string_view part, std::int64_t number) {
  if (parse_integer(part) != number) {
    replace(part, std::to_string(number));
  }
}

void LineEdits::note_lost_comments(std::string_view part) {
  for (std::size_t mark = part.find('#'); mark != std::string_view::npos;
       mark = part.find('#', std::min(part.find('\n', mark), part.size()))) {
    note_loss(AttributeKind::Comments, part.substr(mark));
  }
}

void LineEdits::erase_with_lines(std::string_view part) {
  note_lost_comments(part);
  constexpr std::string_view kBlanks = " \t\r";
  std::size_t begin = offset_of(part);
  std::size_t end = begin + part.size();
  const std::size_t before = source().substr(0, begin).find_last_not_of(kBlanks);
  const std::size_t behind = source().find_first_not_of(kBlanks, end);
  const bool is_first = before == std::string_view::npos || source()[before] == '\n';
  if (is_first && behind != std::string_view::npos && source()[behind] == '\n') {
    begin = before == std::string_view::npos ? 0 : before + 1;
    end = behind + 1;
  }
  erase(begin, end);
}

std::size_t LineEdits::line_begin(std::size_t offset) const {
  const std::size_t previous = source().substr(0, offset).rfind('\n');
  return previous == std::string_view::npos ? 0 : previous + 1;
}

std::size_t LineEdits::next_line(std::size_t offset) const {
  const std::size_t end = source().find('\n', offset);
  return std::min(end, source().size() - 1) + 1;
}

}  // namespace meshalyzer
