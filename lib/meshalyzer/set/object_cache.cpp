#include "meshalyzer/set/object_cache.h"

#include "meshalyzer/base/require.h"

#include <algorithm>
#include <utility>

namespace meshalyzer {

ObjectCache::ObjectCache(std::size_t n_objects, std::uint64_t byte_limit, Load load)
    : byte_limit_(byte_limit), load_(std::move(load)), slots_(n_objects) {
  require_function("the loader of an object cache", load_);
}

std::shared_ptr<const SetObject> ObjectCache::get(std::size_t object) {
  std::unique_lock lock(mutex_);
  Slot& slot = slots_[object];
  changed_.wait(lock, [&] { return !slot.is_loading; });
  if (slot.object) {
    used_.splice(used_.begin(), used_, slot.use);
    return slot.object;
  }
  slot.is_loading = true;
  lock.unlock();
  std::shared_ptr<const SetObject> loaded;
  try {
    loaded = load_(object);
  } catch (...) {
    lock.lock();
    slot.is_loading = false;
    changed_.notify_all();
    throw;
  }
  lock.lock();
  slot.is_loading = false;
  ++n_loads_;
  keep(object, loaded);
  changed_.notify_all();
  return loaded;
}

void ObjectCache::add(std::size_t object, std::shared_ptr<const SetObject> made) {
  const std::lock_guard lock(mutex_);
  const Slot& slot = slots_[object];
  if (slot.object || slot.is_loading || bytes_ + made->bytes() > byte_limit_) return;
  keep(object, std::move(made));
}

void ObjectCache::keep(std::size_t object, std::shared_ptr<const SetObject> made) {
  Slot& slot = slots_[object];
  slot.bytes = made->bytes();
  slot.object = std::move(made);
  slot.use = used_.insert(used_.begin(), object);
  bytes_ += slot.bytes;
  peak_bytes_ = std::max(peak_bytes_, bytes_);
  forget_unused();
}

void ObjectCache::forget_unused() {
  for (auto place = used_.end(); bytes_ > byte_limit_ && place != used_.begin();) {
    --place;
    Slot& slot = slots_[*place];
    // Only this cache can make a new copy, and only under the lock.
    if (slot.object.use_count() == 1) {
      bytes_ -= slot.bytes;
      slot.object.reset();
      place = used_.erase(place);
    }
  }
}

std::size_t ObjectCache::n_loads() const {
  const std::lock_guard lock(mutex_);
  return n_loads_;
}

std::uint64_t ObjectCache::peak_bytes() const {
  const std::lock_guard lock(mutex_);
  return peak_bytes_;
}

}  // namespace meshalyzer
