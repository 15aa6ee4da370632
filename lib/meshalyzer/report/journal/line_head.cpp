#include "meshalyzer/base/error.h"
#include "meshalyzer/report/journal/line.h"
#include "meshalyzer/report/journal/line_kind.h"
#include "meshalyzer/report/utf8.h"

#include <nlohmann/json.hpp>

#include <map>
#include <utility>

namespace meshalyzer {
namespace {

/// Takes the members of an object until the first that is none of the head, and stops the parser
/// there. Its member functions have the names that nlohmann's parser calls.
class HeadMembers {
 public:
  bool null() { return false; }
  bool boolean(bool) { return false; }
  bool number_integer(std::int64_t number) { return integers_.emplace(key_, number).second; }
  bool number_unsigned(std::uint64_t number) {
    return std::in_range<std::int64_t>(number) && number_integer(static_cast<std::int64_t>(number));
  }
  bool number_float(double, const std::string&) { return false; }
  bool string(const std::string& text) { return texts_.emplace(key_, text).second; }
  bool binary(const std::vector<std::uint8_t>&) { return false; }
  bool start_object(std::size_t) { return !std::exchange(has_begun_, true); }
  bool key(const std::string& name) {
    key_ = name;
    is_whole_ = texts_.contains("path") && name != "path_bytes";
    return !is_whole_;
  }
  bool end_object() { return false; }
  bool start_array(std::size_t) { return false; }
  bool end_array() { return false; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) {
    return false;
  }

  /// Whether the parser came to a member behind the path.
  [[nodiscard]] bool is_whole() const { return is_whole_; }
  [[nodiscard]] std::int64_t integer(const char* name) const { return get(integers_, name); }
  [[nodiscard]] std::uint64_t count(const char* name) const {
    const std::int64_t number = integer(name);
    return number >= 0 ? static_cast<std::uint64_t>(number) : refuse(name);
  }
  [[nodiscard]] const std::string& text(const char* name) const { return get(texts_, name); }
  [[nodiscard]] bool has_text(const char* name) const { return texts_.contains(name); }
  [[noreturn]] static std::uint64_t refuse(const char* name) {
    throw InvalidArgument(std::string("the head of the line: \"") + name +
                          "\" is missing or wrong");
  }

 private:
  template <typename T>
  static const T& get(const std::map<std::string, T>& members, const char* name) {
    const auto found = members.find(name);
    if (found == members.end()) {
      refuse(name);
    }
    return found->second;
  }

  std::map<std::string, std::int64_t> integers_;
  std::map<std::string, std::string> texts_;
  /// Of the member whose value comes next.
  std::string key_;
  bool has_begun_ = false;
  bool is_whole_ = false;
};

LineHead::Kind kind_of(const HeadMembers& members) {
  for (const LineHead::Kind kind : kLineKinds) {
    if (members.text("kind") == kind_name(kind)) {
      return kind;
    }
  }
  HeadMembers::refuse("kind");
}

std::string path_of(const HeadMembers& members) {
  if (!members.has_text("path_bytes")) {
    return members.text("path");
  }
  std::optional<std::string> bytes = utf8_to_latin1(members.text("path_bytes"));
  if (!bytes) {
    HeadMembers::refuse("path_bytes");
  }
  return *std::move(bytes);
}

}  // namespace

LineHead read_head(std::string_view line) {
  HeadMembers members;
  // False always: it is stopped before the end, by us or by what is wrong.
  static_cast<void>(nlohmann::json::sax_parse(line.begin(), line.end(), &members));
  if (!members.is_whole()) {
    throw InvalidArgument("not the beginning of a line of a journal");
  }
  return {.kind = kind_of(members),
          .number = members.count("number"),
          .of = members.count("of"),
          .path = path_of(members),
          .stamp = {members.count("bytes"), members.integer("modified")},
          .asked = members.text("asked"),
          .set = members.text("set")};
}

}  // namespace meshalyzer
