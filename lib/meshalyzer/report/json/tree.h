#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

class JsonNode;

/// A parsed JSON text: all its values in one flat list.
///
/// A usual tree allocates memory for each list, which costs gigabytes if a mesh has millions of
/// offenders; this one takes 16 bytes per value.
class JsonTree {
 public:
  /// Parses a text.
  /// @throws InvalidArgument if the text is not one JSON value, or has 4 GiB or more.
  explicit JsonTree(std::string_view text);

  [[nodiscard]] JsonNode root() const;

 private:
  friend class JsonNode;
  friend class JsonElements;
  friend class JsonTreeBuilder;

  enum class Kind : std::uint8_t { Null, Truth, Integer, Real, Text, Array, Object };

  struct Value {
    Kind kind = Kind::Null;
    /// The number of entries of an array or object, including itself and everything in it; the
    /// number of bytes of a text.
    std::uint32_t size = 1;
    /// The integer, the bits of the real, the truth value, or the offset of the text in `texts_`.
    std::uint64_t content = 0;
  };

  [[nodiscard]] std::size_t end_of(std::size_t at) const;
  [[nodiscard]] std::string_view text_at(std::size_t at) const;
  /// Returns the path of a value for people: `integrity.vertex_numbering.ids[2]`.
  [[nodiscard]] std::string path_of(std::size_t at) const;

  /// The values in the order of the text; in an object each value follows its key.
  std::vector<Value> values_;
  /// All texts and keys, one after the other.
  std::string texts_;
};

class JsonElements;

/// A value in a JsonTree, which must outlive it. A function for another type than its own throws
/// InvalidArgument, which names the value.
class JsonNode {
 public:
  [[nodiscard]] bool is_null() const;
  [[nodiscard]] bool truth() const;
  [[nodiscard]] std::int64_t integer() const;
  /// Returns an integer that is not negative.
  [[nodiscard]] std::size_t count() const;
  /// Returns any number as the nearest double.
  [[nodiscard]] double real() const;
  [[nodiscard]] std::string_view text() const;
  /// Returns the members of an array.
  [[nodiscard]] JsonElements elements() const;

  /// Returns the value of a key of an object.
  [[nodiscard]] JsonNode member(std::string_view key) const;
  /// Returns the value of a key of an object, or nothing if it is missing.
  [[nodiscard]] std::optional<JsonNode> find(std::string_view key) const;

  /// Throws InvalidArgument with the path of this value, and what is wrong with it.
  [[noreturn]] void refuse(std::string_view what) const;

 private:
  friend class JsonTree;
  friend class JsonElements;

  JsonNode(const JsonTree& tree, std::size_t at) : tree_(&tree), at_(at) {}
  [[nodiscard]] const JsonTree::Value& value() const { return tree_->values_[at_]; }
  void require(JsonTree::Kind kind, std::string_view what) const;

  const JsonTree* tree_;
  std::size_t at_;
};

/// Iterates over the members of an array, each once.
class JsonElements {
 public:
  [[nodiscard]] bool at_end() const { return at_ == end_; }
  /// Returns the next member.
  /// @throws InvalidArgument if there is no further one.
  [[nodiscard]] JsonNode next();
  /// Checks that all members were read.
  /// @throws InvalidArgument if there is a further one.
  void expect_end() const;

 private:
  friend class JsonNode;

  explicit JsonElements(const JsonNode& array);

  JsonNode array_;
  std::size_t at_;
  std::size_t end_;
};

}  // namespace meshalyzer
