#include "meshalyzer/io/rewrite/ply_records.h"

#include "meshalyzer/base/bytes.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/rewrite/text_lines.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace meshalyzer {
namespace {

/// Calls `use` with a value of the C++ type that a type of PLY stands for.
template <typename Use>
auto with_type(PlyType type, Use use) {
  switch (type) {
    case PlyType::Int8:
      return use(std::int8_t{});
    case PlyType::UInt8:
      return use(std::uint8_t{});
    case PlyType::Int16:
      return use(std::int16_t{});
    case PlyType::UInt16:
      return use(std::uint16_t{});
    case PlyType::Int32:
      return use(std::int32_t{});
    case PlyType::UInt32:
      return use(std::uint32_t{});
    case PlyType::Float32:
      return use(float{});
    case PlyType::Float64:
      return use(double{});
  }
  return use(double{});
}

std::endian order_of(const PlyHeader& header) {
  return header.encoding == PlyEncoding::BigEndian ? std::endian::big : std::endian::little;
}

bool is_fixed(const PlyElement& element) {
  return std::none_of(element.properties.begin(), element.properties.end(),
                      [](const PlyProperty& p) { return p.list_size_type.has_value(); });
}

}  // namespace

PlyRecords::PlyRecords(std::string_view content, const PlyHeader& header)
    : content_(content), header_(header), begins_(header.elements.size()) {
  if (is_ascii()) {
    find_ascii_records();
  } else {
    find_binary_records();
  }
}

void PlyRecords::find_ascii_records() {
  TextScanner in(content_.substr(header_.n_bytes));
  for (std::size_t e = 0; e < begins_.size(); ++e) {
    // Records without properties take no bytes.
    const PlyElement& element = header_.elements[e];
    const std::size_t n = element.properties.empty() ? 0 : element.count;
    for (std::size_t i = 0; i < n && in.next_record(); ++i) {
      begins_[e].push_back(content_.size() - in.remaining());
      in.skip_record();
    }
  }
}

void PlyRecords::find_binary_records() {
  std::size_t at = header_.n_bytes;
  for (std::size_t e = 0; e < begins_.size(); ++e) {
    const PlyElement& element = header_.elements[e];
    std::size_t fixed_size = 0;
    for (const PlyProperty& property : element.properties) {
      fixed_size += size_of(property.type);
    }
    const std::size_t n = element.properties.empty() ? 0 : element.count;
    for (std::size_t i = 0; i < n; ++i) {
      begins_[e].push_back(at);
      at += is_fixed(element) ? fixed_size : read_binary(element, at).bytes.size();
    }
  }
}

PlyRecord PlyRecords::read(std::size_t element, std::size_t record) const {
  const std::size_t begin = begins_[element][record];
  if (!is_ascii()) {
    return read_binary(header_.elements[element], begin);
  }
  const std::vector<std::string_view> words = words_at(content_, begin, Continuation::None);
  PlyRecord result{span_of(words), {}};
  auto next = words.begin();
  for (const PlyProperty& property : header_.elements[element].properties) {
    PlyField& field = result.fields.emplace_back();
    std::size_t n = 1;
    if (property.list_size_type) {
      field.size = *next++;
      n = static_cast<std::size_t>(parse_integer(field.size).value_or(0));
    }
    field.items.assign(next, next + static_cast<std::ptrdiff_t>(n));
    next += static_cast<std::ptrdiff_t>(n);
  }
  return result;
}

PlyRecord PlyRecords::read_binary(const PlyElement& element, std::size_t begin) const {
  std::size_t at = begin;
  const auto take = [&](PlyType type) {
    const std::string_view taken = content_.substr(at, size_of(type));
    at += taken.size();
    return taken;
  };
  PlyRecord result;
  for (const PlyProperty& property : element.properties) {
    PlyField& field = result.fields.emplace_back();
    std::size_t n = 1;
    if (property.list_size_type) {
      field.size = take(*property.list_size_type);
      n = static_cast<std::size_t>(number(field.size, *property.list_size_type));
    }
    for (std::size_t i = 0; i < n; ++i) {
      field.items.push_back(take(property.type));
    }
  }
  result.bytes = content_.substr(begin, at - begin);
  return result;
}

double PlyRecords::number(std::string_view item, PlyType type) const {
  if (is_ascii()) {
    return parse_real(item).value_or(0.0);
  }
  return with_type(type, [&](auto sample) {
    return static_cast<double>(load<decltype(sample)>(item.data(), order_of(header_)));
  });
}

std::string PlyRecords::text(double number, PlyType type) const {
  if (is_ascii()) {
    return shortest(is_integer(type) ? std::round(number) : number);
  }
  return with_type(type, [&](auto sample) {
    using Number = decltype(sample);
    std::string bytes;
    append_little_endian(bytes,
                         static_cast<Number>(is_integer(type) ? std::round(number) : number));
    if (order_of(header_) == std::endian::big) {
      std::reverse(bytes.begin(), bytes.end());
    }
    return bytes;
  });
}

bool PlyRecords::fits(double number, PlyType type) const {
  if (!is_integer(type)) {
    return is_ascii() || type == PlyType::Float64 ||
           static_cast<double>(static_cast<float>(number)) == number;
  }
  return with_type(type, [&](auto sample) {
    using Limits = std::numeric_limits<decltype(sample)>;
    return number == std::round(number) && number >= static_cast<double>(Limits::lowest()) &&
           number <= static_cast<double>(Limits::max());
  });
}

std::vector<std::string_view> declaration_of(std::string_view content, const PlyElement& element,
                                             std::optional<std::string_view> property) {
  for (std::size_t begin = line_offset(content, element.line);;
       begin = content.find('\n', begin) + 1) {
    std::vector<std::string_view> words = words_at(content, begin, Continuation::None);
    const bool is_property = !words.empty() && words.front() == "property";
    if (!property || (is_property && words.back() == *property)) {
      return words;
    }
  }
}

std::size_t find_corner_list(const PlyElement& element) {
  const std::vector<PlyProperty>& all = element.properties;
  return static_cast<std::size_t>(std::find_if(all.begin(), all.end(), is_corner_list) -
                                  all.begin());
}

FaceRecords face_records_of(const PlyRecords& records, std::size_t element, std::size_t corners) {
  FaceRecords faces;
  for (std::size_t r = 0; r < records.begins(element).size(); ++r) {
    faces.append(records.read(element, r).fields[corners].items.size());
  }
  return faces;
}

std::size_t find_property(const PlyElement& element, std::string_view name) {
  return static_cast<std::size_t>(
      std::find_if(element.properties.begin(), element.properties.end(),
                   [&](const PlyProperty& p) { return p.name == name; }) -
      element.properties.begin());
}

}  // namespace meshalyzer
