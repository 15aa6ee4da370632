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

/// Loads the objects of a set when they are asked for and keeps them as long as memory allows:
/// those not used for longest are forgotten first, and loaded again when asked for again.
///
/// Any number of threads may ask.
class ObjectCache {
 public:
  using Load = std::function<std::unique_ptr<const SetObject>(std::size_t object)>;

  /// @param byte_limit  What is kept stays below this, but for the objects that somebody holds.
  /// @param load        Called for one object by one thread at a time; what it throws, get()
  /// throws.
  ObjectCache(std::size_t n_objects, std::uint64_t byte_limit, Load load);

  /// Returns the object, which stays valid as long as the pointer is held.
  [[nodiscard]] std::shared_ptr<const SetObject> get(std::size_t object);

  /// How often an object was loaded.
  [[nodiscard]] std::size_t n_loads() const;
  /// Returns the most bytes that were held at a time.
  [[nodiscard]] std::uint64_t peak_bytes() const;

 private:
  struct Slot {
    std::shared_ptr<const SetObject> object;
    std::uint64_t bytes = 0;
    bool is_loading = false;
    /// The place of `object` in used_, where it is loaded.
    std::list<std::size_t>::iterator use;
  };

  void keep(std::size_t object, std::shared_ptr<const SetObject> loaded);
  void forget_unused();

  std::uint64_t byte_limit_;
  Load load_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Slot> slots_;
  /// The objects that are there, the one used last first.
  std::list<std::size_t> used_;
  std::uint64_t bytes_ = 0;
  std::uint64_t peak_bytes_ = 0;
  std::size_t n_loads_ = 0;
};

}  // namespace meshalyzer
