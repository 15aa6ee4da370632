#include "meshalyzer/io/text_scanner.h"

#include "meshalyzer/base/numbers.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

namespace meshalyzer {
namespace {

bool is_printable(char c) {
  return c >= ' ' && c <= '~';
}

/// Tells whether a token is an integer that is only too long for 64 bits.
bool is_all_digits(std::string_view token) {
  if (!token.empty() && (token.front() == '-' || token.front() == '+')) {
    token.remove_prefix(1);
  }
  return !token.empty() && token.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kMaxBytes = 40;
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string result = "\"";
  for (const char c : text.substr(0, kMaxBytes)) {
    if (is_printable(c)) {
      result += c;
    } else {
      const auto byte = static_cast<unsigned char>(c);
      result += {'\\', 'x', kHex[byte / 16], kHex[byte % 16]};
    }
  }
  return result + (text.size() > kMaxBytes ? "...\"" : "\"");
}

void TextScanner::require_record(std::string_view what) {
  if (!next_record()) {
    fault("the file ends before " + std::string(what));
  }
}

std::string TextScanner::rest_of_record() {
  std::string rest;
  while (!at_record_end()) {
    const char* begin = at_;
    while (at_ != end_ && *at_ != '\n' && !is_blank(*at_) && !is_continuation(at_)) {
      ++at_;
    }
    rest += rest.empty() ? "" : " ";
    rest.append(begin, at_);
  }
  // A name that ends with a backslash could not be written back: it would join the next line.
  while (!rest.empty() && (rest.back() == '\\' || rest.back() == ' ')) {
    rest.pop_back();
  }
  return rest;
}

void TextScanner::skip_record() {
  while (!at_record_end()) {
    while (!ends_token(at_)) {
      ++at_;
    }
  }
}

void TextScanner::skip_number() {
  const std::string_view token = word();
  if (token.empty()) {
    fault("the line ends where a number should stand");
  }
  if (!parse_real(token)) {
    fault(in_quotes(token) + " is not a number");
  }
}

std::size_t TextScanner::count(std::size_t bytes_each, std::string_view what) {
  const std::int64_t value = integer();
  if (value < 0) {
    fault("a count of " + std::to_string(value) + " " + std::string(what));
  }
  // The last record may lack its line end.
  const std::size_t most = std::min<std::size_t>((remaining() + 1) / bytes_each, kNoIndex - 1);
  if (static_cast<std::uint64_t>(value) > most) {
    fault("a count of " + std::to_string(value) + " " + std::string(what) + ", but only " +
          std::to_string(remaining()) + " bytes follow");
  }
  return static_cast<std::size_t>(value);
}

bool TextScanner::is_continuation(const char* at) const {
  if (continuation_ == Continuation::None || *at != '\\') {
    return false;
  }
  const std::ptrdiff_t left = end_ - at - 1;
  return left == 0 || at[1] == '\n' || (at[1] == '\r' && (left == 1 || at[2] == '\n'));
}

void TextScanner::skip_continuation() {
  while (at_ != end_ && is_continuation(at_)) {
    at_ = std::find(at_, end_, '\n');
    if (at_ != end_) {
      ++at_;
      ++line_;
    }
    at_ = std::find_if_not(at_, end_, is_blank);
  }
}

void TextScanner::skip_comment() {
  ++n_comments_;
  const void* newline = std::memchr(at_, '\n', remaining());
  at_ = newline == nullptr ? end_ : static_cast<const char*>(newline);
}

double TextScanner::unusual_real() {
  const std::string_view token = word();
  if (token.empty()) {
    fault("the line ends where a number should stand");
  }
  const std::optional<double> value = parse_real(token);
  if (!value) {
    fault(in_quotes(token) + " is not a number");
  }
  if (!std::isfinite(*value)) {
    fault(in_quotes(token) + " is not a finite number");
  }
  return *value;
}

std::int64_t TextScanner::unusual_integer() {
  const std::string_view token = word();
  if (token.empty()) {
    fault("the line ends where an integer should stand");
  }
  const std::optional<std::int64_t> value = parse_integer(token);
  if (!value) {
    fault(in_quotes(token) + (is_all_digits(token) ? " is too large" : " is not an integer"));
  }
  return *value;
}

void TextScanner::fault_surplus() {
  fault(in_quotes(word()) + " stands where the line should end");
}

void TextScanner::fault_index(std::int64_t value, std::int64_t first) const {
  fault("index " + std::to_string(value) +
        (value < first ? ": indices count from " + std::to_string(first)
                       : " is beyond " + std::to_string(kLargestIndex)));
}

}  // namespace meshalyzer
