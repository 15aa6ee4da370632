#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>

namespace meshalyzer {

/// The members of the head of a line: those up to the path, which ends it. The key of a member of
/// an object in it consists of both names and a dot: `asked.version`.
class HeadMembers {
 public:
  struct Null {};
  struct Object {};
  /// The value of a member. An integer that does not fit into 64 bits with a sign is a double.
  using Value = std::variant<Null, Object, bool, std::int64_t, double, std::string>;

  /// Reads only the head of a line.
  /// @throws InvalidArgument  if it is not the beginning of such a line.
  explicit HeadMembers(std::string_view line);

  /// Returns a member, or null if it is missing.
  [[nodiscard]] const Value* find(const std::string& key) const;

  /// Returns a member of a type.
  /// @throws InvalidArgument  if it is missing or of another type.
  template <typename T>
  [[nodiscard]] const T& get(const std::string& key) const {
    const Value* value = find(key);
    if (value == nullptr || !std::holds_alternative<T>(*value)) {
      refuse(key);
    }
    return std::get<T>(*value);
  }

  /// Returns an integer that is not negative.
  [[nodiscard]] std::uint64_t count(const std::string& key) const;

  /// Returns the number of members of an object and of the objects in it.
  [[nodiscard]] std::size_t n_in(const std::string& key) const;

  /// Throws InvalidArgument, because the member is missing or wrong.
  [[noreturn]] static void refuse(const std::string& key);

 private:
  std::map<std::string, Value> members_;
};

}  // namespace meshalyzer
