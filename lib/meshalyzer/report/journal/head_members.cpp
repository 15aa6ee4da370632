#include "meshalyzer/report/journal/head_members.h"

#include "meshalyzer/base/error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Collects the members of a line until the first that does not belong to the head, and stops the
/// parser there. Its member functions have the names that nlohmann's parser calls.
class HeadParser {
 public:
  using Members = std::map<std::string, HeadMembers::Value>;

  bool null() { return add(HeadMembers::Null{}); }
  bool boolean(bool truth) { return add(truth); }
  bool number_integer(std::int64_t number) { return add(number); }
  bool number_unsigned(std::uint64_t number) {
    return std::in_range<std::int64_t>(number) ? add(static_cast<std::int64_t>(number))
                                               : add(static_cast<double>(number));
  }
  bool number_float(double number, const std::string&) { return add(number); }
  bool string(const std::string& text) { return add(text); }
  bool binary(const std::vector<std::uint8_t>&) { return false; }
  bool start_object(std::size_t) {
    if (!std::exchange(has_begun_, true)) {
      return true;
    }
    objects_.push_back(key_ + ".");
    return add(HeadMembers::Object{});
  }
  bool key(const std::string& name) {
    key_ = (objects_.empty() ? "" : objects_.back()) + name;
    is_whole_ = members_.contains("path") && key_ != "path_bytes";
    return !is_whole_;
  }
  bool end_object() {
    if (objects_.empty()) {
      return false;
    }
    objects_.pop_back();
    return true;
  }
  bool start_array(std::size_t) { return false; }
  bool end_array() { return false; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) {
    return false;
  }

  /// Tells whether the parser reached a member after the path.
  [[nodiscard]] bool is_whole() const { return is_whole_; }
  [[nodiscard]] Members take() { return std::move(members_); }

 private:
  /// Adds a member; returns false, which stops the parser, if it occurs twice.
  bool add(HeadMembers::Value value) { return members_.emplace(key_, std::move(value)).second; }

  Members members_;
  /// The common beginning of the keys in the objects that are open.
  std::vector<std::string> objects_;
  /// The key of the member whose value comes next.
  std::string key_;
  bool has_begun_ = false;
  bool is_whole_ = false;
};

}  // namespace

HeadMembers::HeadMembers(std::string_view line) {
  HeadParser parser;
  // The parser always returns false: it is stopped before the end, by us or by an error.
  static_cast<void>(nlohmann::json::sax_parse(line.begin(), line.end(), &parser));
  if (!parser.is_whole()) {
    throw InvalidArgument("not the beginning of a line of a journal");
  }
  members_ = parser.take();
}

const HeadMembers::Value* HeadMembers::find(const std::string& key) const {
  const auto found = members_.find(key);
  return found == members_.end() ? nullptr : &found->second;
}

std::uint64_t HeadMembers::count(const std::string& key) const {
  const std::int64_t number = get<std::int64_t>(key);
  if (number < 0) {
    refuse(key);
  }
  return static_cast<std::uint64_t>(number);
}

std::size_t HeadMembers::n_in(const std::string& key) const {
  return static_cast<std::size_t>(
      std::count_if(members_.begin(), members_.end(),
                    [&](const auto& member) { return member.first.starts_with(key + "."); }));
}

void HeadMembers::refuse(const std::string& key) {
  throw InvalidArgument("the head of the line: \"" + key + "\" is missing or wrong");
}

}  // namespace meshalyzer
