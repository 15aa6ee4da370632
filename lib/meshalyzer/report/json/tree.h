#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

class JsonNode;

/// A JSON text that was read: all its values in one flat list.
///
/// A usual tree allocates for each list, which costs gigabytes where a mesh has millions of
/// offenders; this one takes 16 bytes a value.
class JsonTree {
 public:
  /// @throws InvalidArgument where the text is not one JSON value, or has 4 GiB or more.
  explicit JsonTree(std::string_view text);

  [[nodiscard]] JsonNode root() const;

 private:
  friend class JsonNode;
  friend class JsonElements;
  friend class JsonTreeBuilder;

  enum class Kind : std::uint8_t { Null, Truth, Integer, Real, Text, Array, Object };

  struct Value {
    Kind kind = Kind::Null;
    /// The number of places that an array or object takes, its own and those of all that is in it;
    /// of a text the number of its bytes.
    std::uint32_t size = 1;
    /// The integer, the bits of the real, the truth, or where the text begins in `texts_`.
    std::uint64_t content = 0;
  };

  [[nodiscard]] std::size_t end_of(std::size_t at) const;
  [[nodiscard]] std::string_view text_at(std::size_t at) const;
  /// How a person finds a value: `integrity.vertex_numbering.ids[2]`.
  [[nodiscard]] std::string path_of(std::size_t at) const;

  /// The values in the order of the text; in an object each value follows its key.
  std::vector<Value> values_;
  /// All texts and keys, one after the other.
  std::string texts_;
};

class JsonElements;

/// A value in a JsonTree, which must outlive it. What is asked of it must be of its kind: else
/// InvalidArgument is thrown, saying which value is what it should not be.
class JsonNode {
 public:
  [[nodiscard]] bool is_null() const;
  [[nodiscard]] bool truth() const;
  [[nodiscard]] std::int64_t integer() const;
  /// Returns an integer that is not negative.
  [[nodiscard]] std::size_t count() const;
  /// Any number; the nearest double.
  [[nodiscard]] double real() const;
  [[nodiscard]] std::string_view text() const;
  /// Returns the members of an array.
  [[nodiscard]] JsonElements elements() const;

  /// Returns the value of a key of an object.
  [[nodiscard]] JsonNode member(std::string_view key) const;
  /// Returns the same, where the key may be missing.
  [[nodiscard]] std::optional<JsonNode> find(std::string_view key) const;

  /// Throws InvalidArgument: the place of this value, and what is wrong with it.
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

/// Goes through the members of an array, each once.
class JsonElements {
 public:
  [[nodiscard]] bool at_end() const { return at_ == end_; }
  /// @throws InvalidArgument where there is no further one.
  [[nodiscard]] JsonNode next();
  /// @throws InvalidArgument where there is a further one.
  void expect_end() const;

 private:
  friend class JsonNode;

  explicit JsonElements(const JsonNode& array);

  JsonNode array_;
  std::size_t at_;
  std::size_t end_;
};

}  // namespace meshalyzer
