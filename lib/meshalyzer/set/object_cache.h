#pragma once

#include "meshalyzer/set/set_object.h"

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <vector>

namespace meshalyzer {

/// Returns how much of the memory limit of a run is for objects that are kept. The rest is for
/// files that are being read and built.
[[nodiscard]] constexpr std::uint64_t memory_for_objects(std::uint64_t memory_limit) {
  return memory_limit / 8 * 5;
}

/// Loads the objects of a set on request and keeps them as long as memory allows; the least
/// recently used ones are dropped first, and loaded again on request.
///
/// Several threads may call at a time.
class ObjectCache {
 public:
  using Load = std::function<std::unique_ptr<const SetObject>(std::size_t object)>;

  /// @param byte_limit  The limit for the memory of kept objects, except those in use.
  /// @param load        Loads an object; called for one object by one thread at a time. Its
  ///     exceptions pass through get().
  /// @throws InvalidArgument  if `load` is null.
  ObjectCache(std::size_t n_objects, std::uint64_t byte_limit, Load load);

  /// Adds an object that need not be loaded any more, unless it would exceed the limit, or is
  /// there.
  void add(std::size_t object, std::shared_ptr<const SetObject> made);

  /// Returns the object, which stays valid as long as the pointer is held.
  [[nodiscard]] std::shared_ptr<const SetObject> get(std::size_t object);

  /// Returns the number of times that an object was loaded.
  [[nodiscard]] std::size_t n_loads() const;
  /// Returns the largest number of bytes held at a time.
  [[nodiscard]] std::uint64_t peak_bytes() const;

 private:
  struct Slot {
    std::shared_ptr<const SetObject> object;
    std::uint64_t bytes = 0;
    bool is_loading = false;
    /// The position of `object` in used_, if it is loaded.
    std::list<std::size_t>::iterator use;
  };

  void keep(std::size_t object, std::shared_ptr<const SetObject> made);
  void forget_unused();

  std::uint64_t byte_limit_;
  Load load_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Slot> slots_;
  /// The loaded objects, the most recently used first.
  std::list<std::size_t> used_;
  std::uint64_t bytes_ = 0;
  std::uint64_t peak_bytes_ = 0;
  std::size_t n_loads_ = 0;
};

}  // namespace meshalyzer
