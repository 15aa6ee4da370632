#include "meshalyzer/io/off_keyword.h"

namespace meshalyzer {
namespace {

bool take_prefix(std::string_view& word, std::string_view prefix) {
  if (word.substr(0, prefix.size()) != prefix) {
    return false;
  }
  word.remove_prefix(prefix.size());
  return true;
}

}  // namespace

bool is_off_keyword(std::string_view word) {
  take_prefix(word, "ST");
  take_prefix(word, "C");
  take_prefix(word, "N");
  take_prefix(word, "4");
  take_prefix(word, "n");
  return word == "OFF";
}

OffLayout parse_off_keyword(std::string_view keyword, const TextScanner& in) {
  OffLayout layout;
  layout.texture = take_prefix(keyword, "ST");
  layout.colour = take_prefix(keyword, "C");
  layout.normal = take_prefix(keyword, "N");
  if (keyword != "OFF") {
    in.fault("OFF in other than three dimensions is not read");
  }
  return layout;
}

bool is_binary_off(std::string_view content) {
  TextScanner in(content.substr(0, content.find('\n')));
  return in.next_record() && is_off_keyword(in.word()) && in.word() == "BINARY";
}

}  // namespace meshalyzer
