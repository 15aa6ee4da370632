#include "meshalyzer/base/pooled_values.h"

#include "meshalyzer/base/descriptor.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/statistics_passes.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fcntl.h>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <unistd.h>
#include <vector>

namespace meshalyzer {
namespace {

/// Stores doubles in an unnamed file, which vanishes when it is closed, however the program ends.
class ScratchFile {
 public:
  /// Makes the file in the folder that the environment variable TMPDIR names, or else in /tmp.
  /// @throws IoError if no file can be made there.
  ScratchFile();

  [[nodiscard]] std::size_t size() const { return size_; }

  /// @throws IoError if that fails; the file then keeps its former content.
  void append(std::span<const double> values);

  /// Returns the `n` values from number `first` on, counted from 0; they must exist.
  /// @throws IoError if that fails.
  [[nodiscard]] std::vector<double> read(std::size_t first, std::size_t n) const;

 private:
  std::string folder_;
  Descriptor file_;
  std::size_t size_ = 0;
};

std::string temporary_folder() {
  const char* folder = std::getenv("TMPDIR");
  return folder != nullptr && *folder != '\0' ? folder : "/tmp";
}

Descriptor open_unnamed(const std::string& folder) {
  std::string path = folder + "/meshalyzer-XXXXXX";
  Descriptor file(::mkostemp(path.data(), O_CLOEXEC));
  if (!file.is_open()) {
    throw_errno(folder, "a temporary file cannot be made");
  }
  ::unlink(path.c_str());
  return file;
}

off_t place_of(std::size_t value) {
  return static_cast<off_t>(value * sizeof(double));
}

ScratchFile::ScratchFile() : folder_(temporary_folder()), file_(open_unnamed(folder_)) {}

void ScratchFile::append(std::span<const double> values) {
  // Seek to the end of the valid data: a failed write may have left some bytes after it.
  const std::string_view bytes(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  if (::lseek(file_.get(), place_of(size_), SEEK_SET) < 0 || !write_all(file_, bytes)) {
    throw_errno(folder_, "a temporary file cannot be written");
  }
  size_ += values.size();
}

std::vector<double> ScratchFile::read(std::size_t first, std::size_t n) const {
  std::vector<double> values(n);
  char* const bytes = reinterpret_cast<char*>(values.data());
  std::size_t done = 0;
  while (done < n * sizeof(double)) {
    const ssize_t got = ::pread(file_.get(), bytes + done, n * sizeof(double) - done,
                                place_of(first) + static_cast<off_t>(done));
    if (got > 0) {
      done += static_cast<std::size_t>(got);
    } else if (got == 0 || errno != EINTR) {
      errno = got == 0 ? EIO : errno;  // at the end: another process has truncated the file
      throw_errno(folder_, "a temporary file cannot be read");
    }
  }
  return values;
}

}  // namespace

struct PooledValues::State {
  /// The number of values that the buffer can hold. It is a multiple of kChunkLength, so that the
  /// sums do not depend on what was spilled to the file.
  std::size_t capacity = 0;
  std::size_t infinite = 0;
  std::optional<ScratchFile> file;
  /// The extent of the values in the file.
  ExtentPass spilled;
  /// The finite values that come after those in the file.
  std::vector<double> buffer;

  void spill() {
    if (!file) {
      file.emplace();
    }
    file->append(buffer);
    spilled.add(buffer);
    buffer.clear();
  }

  /// Calls `body` for all finite values, block by block, in order.
  template <typename Body>
  void for_each_block(Body&& body) const {
    constexpr std::size_t kBlockLength = 16 * kChunkLength;
    const std::size_t n_in_file = file ? file->size() : 0;
    for (std::size_t first = 0; first < n_in_file; first += kBlockLength) {
      const std::vector<double> block =
          file->read(first, std::min(kBlockLength, n_in_file - first));
      body(std::span<const double>(block));
    }
    body(std::span<const double>(buffer));
  }
};

namespace {

constexpr unsigned kKeyBits = 64;
constexpr unsigned kDigitBits = 16;
constexpr std::uint64_t kSignBit = std::uint64_t{1} << (kKeyBits - 1);

/// Maps a double to an integer key whose order is that of the values, with -0 before 0.
std::uint64_t key_of(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return (bits & kSignBit) != 0 ? ~bits : bits | kSignBit;
}

double value_of(std::uint64_t key) {
  return std::bit_cast<double>((key & kSignBit) != 0 ? key & ~kSignBit : ~key);
}

/// The values whose keys begin with certain bits, and the rank, from 0, of the value sought among
/// them.
struct Bucket {
  std::uint64_t prefix = 0;
  unsigned n_bits = 0;
  std::size_t size = 0;
  std::size_t rank = 0;

  /// Returns the leading bits of a key, as many as the prefix has.
  [[nodiscard]] std::uint64_t head(std::uint64_t key) const {
    return n_bits == 0 ? 0 : key >> (kKeyBits - n_bits);
  }
};

/// Returns the part of a bucket, one digit further, that holds the value sought.
template <typename ForEachBlock>
Bucket narrowed(const Bucket& bucket, const ForEachBlock& for_each_block) {
  std::vector<std::size_t> counts(std::size_t{1} << kDigitBits);
  const unsigned shift = kKeyBits - kDigitBits - bucket.n_bits;
  for_each_block([&](std::span<const double> block) {
    for (const double value : block) {
      const std::uint64_t key = key_of(value);
      if (bucket.head(key) == bucket.prefix) {
        ++counts[(key >> shift) % counts.size()];
      }
    }
  });
  std::size_t digit = 0;
  std::size_t rank = bucket.rank;
  for (; rank >= counts[digit]; ++digit) {
    rank -= counts[digit];
  }
  return {(bucket.prefix << kDigitBits) | digit, bucket.n_bits + kDigitBits, counts[digit], rank};
}

struct Neighbours {
  double value = 0.0;
  double next = 0.0;
};

/// Returns the value sought in a bucket and the next larger one, which may lie beyond the bucket
/// and is infinite when the value is the last.
template <typename ForEachBlock>
Neighbours value_and_next(const Bucket& bucket, const ForEachBlock& for_each_block) {
  const bool are_all_equal = bucket.n_bits == kKeyBits;
  std::vector<double> members;
  members.reserve(are_all_equal ? 0 : bucket.size);
  double beyond = std::numeric_limits<double>::infinity();
  for_each_block([&](std::span<const double> block) {
    for (const double value : block) {
      const std::uint64_t head = bucket.head(key_of(value));
      if (head > bucket.prefix) {
        beyond = std::min(beyond, value);
      } else if (head == bucket.prefix && !are_all_equal) {
        members.push_back(value);
      }
    }
  });
  const bool is_next_inside = bucket.rank + 1 < bucket.size;
  if (are_all_equal) {
    const double value = value_of(bucket.prefix);
    return {value, is_next_inside ? value : beyond};
  }
  const auto found = members.begin() + static_cast<std::ptrdiff_t>(bucket.rank);
  std::nth_element(members.begin(), found, members.end());
  return {*found, is_next_inside ? *std::min_element(found + 1, members.end()) : beyond};
}

/// Selects by the digits of the keys until the remaining values fit into memory.
/// @param capacity  The number of values that may be held at a time.
template <typename ForEachBlock>
double median_of(std::size_t count, std::size_t capacity, const ForEachBlock& for_each_block) {
  Bucket bucket{.size = count, .rank = lower_middle(count)};
  while (bucket.size > capacity && bucket.n_bits < kKeyBits) {
    bucket = narrowed(bucket, for_each_block);
  }
  const Neighbours middle = value_and_next(bucket, for_each_block);
  return median_of_middle(middle.value, count % 2 == 1 ? middle.value : middle.next);
}

}  // namespace

PooledValues::PooledValues(std::size_t buffer_bytes) : state_(std::make_unique<State>()) {
  const std::size_t n_whole = buffer_bytes / sizeof(double) / kChunkLength;
  state_->capacity = std::max<std::size_t>(1, n_whole) * kChunkLength;
}

PooledValues::~PooledValues() = default;
PooledValues::PooledValues(PooledValues&& other) noexcept = default;
PooledValues& PooledValues::operator=(PooledValues&& other) noexcept = default;

void PooledValues::append(std::span<const double> values) {
  for (const double value : values) {
    if (!std::isfinite(value)) {
      ++state_->infinite;
      continue;
    }
    if (state_->buffer.size() == state_->capacity) {
      state_->spill();
    }
    state_->buffer.push_back(value);
  }
}

Statistics PooledValues::summarize() const {
  const auto for_each_block = [&](const auto& body) { state_->for_each_block(body); };
  ExtentPass extent = state_->spilled;
  extent.add(state_->buffer);
  Statistics result;
  if (extent.count() != 0) {
    SpreadPass spread(extent);
    for_each_block([&](std::span<const double> block) { spread.add(block); });
    result = spread.statistics();
    result.median = median_of(extent.count(), state_->capacity, for_each_block);
  }
  result.infinite = state_->infinite;
  return result;
}

}  // namespace meshalyzer
