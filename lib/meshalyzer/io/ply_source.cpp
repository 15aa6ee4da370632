#include "meshalyzer/io/ply_source.h"

#include "meshalyzer/base/bytes.h"
#include "meshalyzer/base/error.h"

#include <algorithm>
#include <cmath>

namespace meshalyzer {
namespace {

std::string implausible_count(const PlyElement& element, std::size_t bytes) {
  return "a count of " + std::to_string(element.count) + " for element " + element.name +
         ", but only " + std::to_string(bytes) + " bytes follow";
}

bool is_plausible(const PlyElement& element, std::size_t bytes_each, std::size_t bytes) {
  return bytes_each == 0 ||
         element.count <= std::min<std::size_t>(bytes / bytes_each, kNoIndex - 1);
}

/// Returns the smallest number of bytes that a record can take, since its lists may be empty.
std::size_t least_bytes(const PlyElement& element) {
  std::size_t bytes = 0;
  for (const PlyProperty& property : element.properties) {
    bytes += size_of(property.list_size_type.value_or(property.type));
  }
  return bytes;
}

}  // namespace

void AsciiPlySource::check_count(const PlyElement& element) const {
  // Each number takes a digit and a blank or line end; the last line end may be missing.
  if (!is_plausible(element, 2 * element.properties.size(), in_.remaining() + 1)) {
    throw TextFault(element.line, implausible_count(element, in_.remaining()));
  }
}

Index AsciiPlySource::index_of_strip(PlyType type) {
  if (in_.peek() == "-1") {
    static_cast<void>(in_.word());
    return kNoIndex;
  }
  return index(type);
}

void AsciiPlySource::finish() {
  if (in_.next_record()) {
    in_.fault("more lines than the header counts");
  }
}

BinaryPlySource::BinaryPlySource(std::string_view content, const PlyHeader& header,
                                 const std::string& name)
    : content_(content),
      at_(header.n_bytes),
      order_(header.encoding == PlyEncoding::LittleEndian ? std::endian::little : std::endian::big),
      name_(name) {}

void BinaryPlySource::check_count(const PlyElement& element) const {
  const std::size_t remaining = content_.size() - at_;
  if (!is_plausible(element, least_bytes(element), remaining)) {
    fault(implausible_count(element, remaining));
  }
}

double BinaryPlySource::real(PlyType type) {
  const std::size_t offset = at_;
  const double value = number(type);
  if (!std::isfinite(value)) {
    fault_at(offset, "a number is not finite");
  }
  return value;
}

Index BinaryPlySource::index(PlyType type) {
  const std::size_t offset = at_;
  return checked_index(integer(type), offset);
}

Index BinaryPlySource::index_of_strip(PlyType type) {
  const std::size_t offset = at_;
  const std::int64_t value = integer(type);
  return value == -1 ? kNoIndex : checked_index(value, offset);
}

Index BinaryPlySource::checked_index(std::int64_t value, std::size_t offset) const {
  if (value < 0 || value > kLargestIndex) {
    fault_at(offset,
             "index " + std::to_string(value) + " is not in 0 to " + std::to_string(kLargestIndex));
  }
  return static_cast<Index>(value);
}

std::size_t BinaryPlySource::list_size(const PlyProperty& list) {
  const std::size_t offset = at_;
  const std::int64_t value = integer(*list.list_size_type);
  const std::size_t most = (content_.size() - at_) / size_of(list.type);
  if (value < 0 || static_cast<std::uint64_t>(value) > most) {
    fault_at(offset, "a list of " + std::to_string(value) + " items, but only " +
                         std::to_string(content_.size() - at_) + " bytes follow");
  }
  return static_cast<std::size_t>(value);
}

void BinaryPlySource::finish() {
  const std::string_view rest = content_.substr(at_);
  if (rest.find_first_not_of(" \t\r\n") != std::string_view::npos) {
    fault(std::to_string(rest.size()) + " bytes more than the header counts");
  }
}

void BinaryPlySource::fault_at(std::size_t offset, const std::string& what) const {
  throw IoError(name_, {.byte = offset}, what);
}

const char* BinaryPlySource::take(std::size_t n) {
  if (content_.size() - at_ < n) {
    fault("the file ends within a record");
  }
  const char* taken = content_.data() + at_;
  at_ += n;
  return taken;
}

std::int64_t BinaryPlySource::integer(PlyType type) {
  return static_cast<std::int64_t>(number(type));
}

double BinaryPlySource::number(PlyType type) {
  const char* at = take(size_of(type));
  switch (type) {
    case PlyType::Int8:
      return load<std::int8_t>(at, order_);
    case PlyType::UInt8:
      return load<std::uint8_t>(at, order_);
    case PlyType::Int16:
      return load<std::int16_t>(at, order_);
    case PlyType::UInt16:
      return load<std::uint16_t>(at, order_);
    case PlyType::Int32:
      return load<std::int32_t>(at, order_);
    case PlyType::UInt32:
      return load<std::uint32_t>(at, order_);
    case PlyType::Float32:
      return static_cast<double>(load<float>(at, order_));
    case PlyType::Float64:
      return load<double>(at, order_);
  }
  return 0.0;
}

}  // namespace meshalyzer
