#include "meshalyzer/io/gzip.h"

#include "meshalyzer/base/error.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <new>
#include <zlib.h>

namespace meshalyzer {
namespace {

/// The largest piece for zlib, which counts bytes in 32 bits.
constexpr std::size_t kMostAtOnce = std::size_t{1} << 30U;
constexpr std::size_t kPieceBytes = std::size_t{1} << 16U;
/// The window bits for zlib: the largest window, and a gzip header.
constexpr int kGzipWindow = 15 + 16;

std::atomic<std::uint64_t> unpack_ratio{kDefaultUnpackRatio};

/// Returns the bytes in the type that zlib expects; it does not write to its input.
Bytef* bytes_of(const char* at) {
  return reinterpret_cast<Bytef*>(const_cast<char*>(at));
}

/// Unpacks the members of one file in order.
class GzipReader {
 public:
  using Take = std::function<void(std::string_view)>;

  GzipReader(std::string_view content, const std::string& name) : content_(content), name_(name) {
    if (inflateInit2(&stream_, kGzipWindow) != Z_OK) {
      throw std::bad_alloc();
    }
  }
  ~GzipReader() { inflateEnd(&stream_); }
  GzipReader(const GzipReader&) = delete;
  GzipReader& operator=(const GzipReader&) = delete;

  /// @param take  Receives the unpacked bytes piece by piece.
  void read(const Take& take) {
    for (;;) {
      read_member(take);
      const std::string_view rest = content_.substr(offset());
      if (rest.find_first_not_of('\0') == std::string_view::npos) {
        return;  // padding
      }
      if (!is_gzip(rest)) {
        fault(std::to_string(rest.size()) + " bytes behind the end of the gzipped data");
      }
      static_cast<void>(inflateReset(&stream_));
    }
  }

  [[noreturn]] void fault(const std::string& what) const {
    throw IoError(name_, {.byte = offset()}, what);
  }

 private:
  void read_member(const Take& take) {
    for (int status = Z_OK; status != Z_STREAM_END;) {
      feed();
      stream_.next_out = piece_->data();
      stream_.avail_out = static_cast<uInt>(piece_->size());
      status = inflate(&stream_, Z_NO_FLUSH);
      if (status == Z_MEM_ERROR) {
        throw std::bad_alloc();
      }
      if (status != Z_OK && status != Z_STREAM_END) {
        fault(std::string("the gzipped data are damaged") +
              (stream_.msg == nullptr ? "" : std::string(": ") + stream_.msg));
      }
      take({reinterpret_cast<const char*>(piece_->data()), piece_->size() - stream_.avail_out});
    }
  }

  void feed() {
    if (stream_.avail_in != 0) {
      return;
    }
    const std::size_t n = std::min(content_.size() - fed_, kMostAtOnce);
    if (n == 0) {
      fault("the gzipped data end too soon");
    }
    stream_.next_in = bytes_of(content_.data() + fed_);
    stream_.avail_in = static_cast<uInt>(n);
    fed_ += n;
  }

  [[nodiscard]] std::size_t offset() const { return fed_ - stream_.avail_in; }

  std::string_view content_;
  const std::string& name_;
  std::unique_ptr<std::array<Bytef, kPieceBytes>> piece_ =
      std::make_unique<std::array<Bytef, kPieceBytes>>();
  z_stream stream_{};
  std::size_t fed_ = 0;
};

/// Returns the unpacked size of the content.
std::size_t unpacked_size(std::string_view content, const std::string& name) {
  const std::uint64_t ratio = unpack_ratio;
  std::size_t size = 0;
  GzipReader reader(content, name);
  reader.read([&](std::string_view piece) {
    size += piece.size();
    if (size != 0 && (size - 1) / ratio >= content.size()) {
      reader.fault("the gzipped data take more than " + std::to_string(ratio) +
                   " times their size: --max-unpack-ratio N allows more");
    }
  });
  return size;
}

}  // namespace

UnpackLimit::UnpackLimit(std::uint64_t ratio) {
  unpack_ratio = std::max<std::uint64_t>(1, ratio);
}

UnpackLimit::~UnpackLimit() {
  unpack_ratio = kDefaultUnpackRatio;
}

bool is_gzip(std::string_view content) {
  // The magic number, and the only compression method.
  return content.substr(0, 3) == "\x1f\x8b\x08";
}

std::string unpack_gzip(std::string_view content, const std::string& name) {
  std::string unpacked;
  unpacked.reserve(unpacked_size(content, name));
  GzipReader(content, name).read([&](std::string_view piece) { unpacked += piece; });
  return unpacked;
}

std::string pack_gzip(std::string_view content) {
  constexpr int kMemoryLevel = 8;
  z_stream stream{};
  if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzipWindow, kMemoryLevel,
                   Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::bad_alloc();
  }
  std::string packed;
  std::array<char, kPieceBytes> piece;
  for (int status = Z_OK; status != Z_STREAM_END;) {
    if (stream.avail_in == 0) {
      const std::string_view next = content.substr(0, kMostAtOnce);
      content.remove_prefix(next.size());
      stream.next_in = bytes_of(next.data());
      stream.avail_in = static_cast<uInt>(next.size());
    }
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    status = deflate(&stream, content.empty() ? Z_FINISH : Z_NO_FLUSH);
    packed.append(piece.data(), piece.size() - stream.avail_out);
  }
  deflateEnd(&stream);
  return packed;
}

}  // namespace meshalyzer
