#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>

namespace meshalyzer {

/// The members of the head of a line: those up to the path, which ends it. A member of an object in
/// it has a key of both, with a dot between: `asked.version`.
class HeadMembers {
 public:
  struct Null {};
  struct Object {};
  /// An integer that 64 bits with a sign do not hold is a double.
  using Value = std::variant<Null, Object, bool, std::int64_t, double, std::string>;

  /// Reads no more of a line than its head.
  /// @throws InvalidArgument  Not the beginning of such a line.
  explicit HeadMembers(std::string_view line);

  /// Null where it is not there.
  [[nodiscard]] const Value* find(const std::string& key) const;

  /// @throws InvalidArgument  Not there, or of another kind.
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

  /// Returns how many members there are in an object, and in objects in it.
  [[nodiscard]] std::size_t n_in(const std::string& key) const;

  /// Throws InvalidArgument: the member is missing or wrong.
  [[noreturn]] static void refuse(const std::string& key);

 private:
  std::map<std::string, Value> members_;
};

}  // namespace meshalyzer
