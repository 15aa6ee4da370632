#include "meshalyzer/report/json/tree.h"

#include "meshalyzer/base/error.h"

#include <nlohmann/json.hpp>

#include <bit>
#include <limits>

namespace meshalyzer {

/// Builds a tree from the events of the parser. Its member functions have the names that nlohmann's
/// parser calls.
class JsonTreeBuilder {
 public:
  explicit JsonTreeBuilder(JsonTree& tree) : tree_(tree) {}

  bool null() { return add(JsonTree::Kind::Null, 0); }
  bool boolean(bool truth) { return add(JsonTree::Kind::Truth, truth ? 1 : 0); }
  /// Adds an integer. The parser calls this only for negative integers: 0 here was written as -0, a
  /// real.
  bool number_integer(std::int64_t integer) {
    return integer == 0 ? add_real(-0.0)
                        : add(JsonTree::Kind::Integer, std::bit_cast<std::uint64_t>(integer));
  }
  bool number_unsigned(std::uint64_t integer) {
    constexpr auto kMax = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    return integer <= kMax ? add(JsonTree::Kind::Integer, integer)
                           : add_real(static_cast<double>(integer));
  }
  /// Adds a real, which is the nearest double in any locale: the parser inserts the locale's
  /// decimal point before it calls strtod, which rounds correctly.
  bool number_float(double real, const std::string& /*token*/) { return add_real(real); }
  bool string(const std::string& text) { return add_text(text); }
  bool binary(const std::vector<std::uint8_t>& /*never in text*/) { return false; }
  bool start_object(std::size_t /*unknown*/) { return begin(JsonTree::Kind::Object); }
  bool key(const std::string& name) { return add_text(name); }
  bool end_object() { return end(); }
  bool start_array(std::size_t /*unknown*/) { return begin(JsonTree::Kind::Array); }
  bool end_array() { return end(); }
  bool parse_error(std::size_t position, const std::string& /*token*/,
                   const nlohmann::detail::exception& /*error*/) {
    error_at_ = position;
    return false;
  }

  /// Returns the 1-based byte at which the text stops being JSON.
  [[nodiscard]] std::size_t error_at() const { return error_at_; }

 private:
  bool add(JsonTree::Kind kind, std::uint64_t content, std::size_t size = 1) {
    tree_.values_.push_back({kind, static_cast<std::uint32_t>(size), content});
    return true;
  }
  bool add_real(double real) {
    return add(JsonTree::Kind::Real, std::bit_cast<std::uint64_t>(real));
  }
  bool add_text(const std::string& text) {
    const std::size_t at = tree_.texts_.size();
    tree_.texts_ += text;
    return add(JsonTree::Kind::Text, at, text.size());
  }
  bool begin(JsonTree::Kind kind) {
    open_.push_back(tree_.values_.size());
    return add(kind, 0);
  }
  bool end() {
    JsonTree::Value& opened = tree_.values_[open_.back()];
    opened.size = static_cast<std::uint32_t>(tree_.values_.size() - open_.back());
    open_.pop_back();
    return true;
  }

  JsonTree& tree_;
  /// The arrays and objects that are not ended yet.
  std::vector<std::size_t> open_;
  std::size_t error_at_ = 0;
};

JsonTree::JsonTree(std::string_view text) {
  if (text.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw InvalidArgument("JSON of 4 GiB or more");
  }
  JsonTreeBuilder builder(*this);
  if (!nlohmann::json::sax_parse(text.begin(), text.end(), &builder)) {
    throw InvalidArgument("not JSON, or not all of it: byte " + std::to_string(builder.error_at()));
  }
}

JsonNode JsonTree::root() const {
  return {*this, 0};
}

std::size_t JsonTree::end_of(std::size_t at) const {
  const Value& value = values_[at];
  return at + (value.kind == Kind::Text ? 1 : value.size);
}

std::string_view JsonTree::text_at(std::size_t at) const {
  return std::string_view(texts_).substr(values_[at].content, values_[at].size);
}

std::string JsonTree::path_of(std::size_t at) const {
  std::string path;
  for (std::size_t parent = 0; parent != at;) {
    const bool is_object = values_[parent].kind == Kind::Object;
    const std::size_t step = is_object ? 1 : 0;  // to skip the key
    std::size_t index = 0;
    std::size_t child = parent + 1 + step;
    while (end_of(child) <= at) {
      child = end_of(child) + step;
      ++index;
    }
    if (is_object) {
      path += path.empty() ? "" : ".";
      path += text_at(child - 1);
    } else {
      path += '[' + std::to_string(index) + ']';
    }
    parent = child;
  }
  return path;
}

bool JsonNode::is_null() const {
  return value().kind == JsonTree::Kind::Null;
}

bool JsonNode::truth() const {
  require(JsonTree::Kind::Truth, "neither true nor false");
  return value().content != 0;
}

std::int64_t JsonNode::integer() const {
  require(JsonTree::Kind::Integer, "not an integer");
  return std::bit_cast<std::int64_t>(value().content);
}

std::size_t JsonNode::count() const {
  const std::int64_t number = integer();
  if (number < 0) {
    refuse("negative");
  }
  return static_cast<std::size_t>(number);
}

double JsonNode::real() const {
  if (value().kind == JsonTree::Kind::Integer) {
    return static_cast<double>(integer());
  }
  require(JsonTree::Kind::Real, "not a number");
  return std::bit_cast<double>(value().content);
}

std::string_view JsonNode::text() const {
  require(JsonTree::Kind::Text, "not a text");
  return tree_->text_at(at_);
}

JsonElements JsonNode::elements() const {
  require(JsonTree::Kind::Array, "not a list");
  return JsonElements(*this);
}

JsonNode JsonNode::member(std::string_view key) const {
  const std::optional<JsonNode> found = find(key);
  if (!found) {
    refuse("has no \"" + std::string(key) + '"');
  }
  return *found;
}

std::optional<JsonNode> JsonNode::find(std::string_view key) const {
  require(JsonTree::Kind::Object, "not an object");
  const std::size_t end = tree_->end_of(at_);
  for (std::size_t at = at_ + 1; at != end; at = tree_->end_of(at + 1)) {
    if (tree_->text_at(at) == key) {
      return JsonNode(*tree_, at + 1);
    }
  }
  return std::nullopt;
}

void JsonNode::refuse(std::string_view what) const {
  const std::string path = tree_->path_of(at_);
  throw InvalidArgument((path.empty() ? "the JSON value" : path) + ": " + std::string(what));
}

void JsonNode::require(JsonTree::Kind kind, std::string_view what) const {
  if (value().kind != kind) {
    refuse(what);
  }
}

JsonElements::JsonElements(const JsonNode& array)
    : array_(array), at_(array.at_ + 1), end_(array.tree_->end_of(array.at_)) {}

JsonNode JsonElements::next() {
  if (at_end()) {
    array_.refuse("too short a list");
  }
  const JsonNode element(*array_.tree_, at_);
  at_ = array_.tree_->end_of(at_);
  return element;
}

void JsonElements::expect_end() const {
  if (!at_end()) {
    array_.refuse("too long a list");
  }
}

}  // namespace meshalyzer
