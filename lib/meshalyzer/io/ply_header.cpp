#include "meshalyzer/io/ply_header.h"

#include "meshalyzer/io/text_scanner.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace meshalyzer {
namespace {

constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypeNames = {{
    {"char", PlyType::Int8},
    {"int8", PlyType::Int8},
    {"uchar", PlyType::UInt8},
    {"uint8", PlyType::UInt8},
    {"short", PlyType::Int16},
    {"int16", PlyType::Int16},
    {"ushort", PlyType::UInt16},
    {"uint16", PlyType::UInt16},
    {"int", PlyType::Int32},
    {"int32", PlyType::Int32},
    {"uint", PlyType::UInt32},
    {"uint32", PlyType::UInt32},
    {"float", PlyType::Float32},
    {"float32", PlyType::Float32},
    {"double", PlyType::Float64},
    {"float64", PlyType::Float64},
}};

template <typename Named>
bool has_name(const std::vector<Named>& list, std::string_view name) {
  return std::any_of(list.begin(), list.end(),
                     [&](const Named& item) { return item.name == name; });
}

/// Reads the lines of one header in order. Each is scanned by itself, so that the content after the
/// header, which may be binary, is never read.
class HeaderParser {
 public:
  explicit HeaderParser(std::string_view content) : content_(content) {}

  PlyHeader parse() {
    if (next_line().word() != "ply") {
      throw TextFault(1, "the keyword ply does not stand first");
    }
    parse_format();
    for (;;) {
      TextScanner line = next_line();
      const std::string_view keyword = line.word();
      if (keyword == "end_header") {
        line.end_record();
        break;
      }
      parse_statement(keyword, line);
    }
    check_elements();
    return std::move(header_);
  }

 private:
  TextScanner next_line() {
    ++header_.n_lines;
    if (header_.n_bytes >= content_.size()) {
      throw TextFault(header_.n_lines, "the file ends before end_header");
    }
    const std::size_t begin = header_.n_bytes;
    const std::size_t end = std::min(content_.find('\n', begin), content_.size());
    header_.n_bytes = std::min(end + 1, content_.size());
    return {content_.substr(begin, end - begin), header_.n_lines};
  }

  void parse_format() {
    constexpr std::array<std::pair<std::string_view, PlyEncoding>, 3> kEncodings = {{
        {"ascii", PlyEncoding::Ascii},
        {"binary_little_endian", PlyEncoding::LittleEndian},
        {"binary_big_endian", PlyEncoding::BigEndian},
    }};
    TextScanner line = next_line();
    std::string_view keyword = line.word();
    while (keyword == "comment" || keyword == "obj_info") {
      line = next_line();
      keyword = line.word();
    }
    const std::string_view encoding = line.word();
    const auto* const found =
        std::find_if(kEncodings.begin(), kEncodings.end(),
                     [&](const auto& known) { return known.first == encoding; });
    if (keyword != "format" || found == kEncodings.end() || line.word() != "1.0") {
      line.fault("no line 'format ascii|binary_little_endian|binary_big_endian 1.0'");
    }
    line.end_record();
    header_.encoding = found->second;
  }

  void parse_statement(std::string_view keyword, TextScanner& line) {
    if (keyword == "comment" || keyword == "obj_info" || keyword.empty()) {
      return;
    }
    if (keyword == "element") {
      parse_element(line);
    } else if (keyword == "property") {
      parse_property(line);
    } else {
      line.fault(in_quotes(keyword) + " is no keyword of a PLY header");
    }
    line.end_record();
  }

  void parse_element(TextScanner& line) {
    PlyElement element;
    element.name = line.word();
    element.line = line.line();
    if (element.name.empty() || has_name(header_.elements, element.name)) {
      line.fault("element " + in_quotes(element.name) + " has no name or is declared twice");
    }
    const std::int64_t count = line.integer();
    if (count < 0) {
      line.fault("a count of " + std::to_string(count) + " elements");
    }
    element.count = static_cast<std::size_t>(count);
    header_.elements.push_back(std::move(element));
  }

  void parse_property(TextScanner& line) {
    if (header_.elements.empty()) {
      line.fault("a property before the first element");
    }
    PlyProperty property;
    std::string_view type = line.word();
    if (type == "list") {
      property.list_size_type = type_of(line.word(), line);
      if (!is_integer(*property.list_size_type)) {
        line.fault("the size of a list is no integer");
      }
      type = line.word();
    }
    property.type = type_of(type, line);
    property.name = line.word();
    PlyElement& element = header_.elements.back();
    if (property.name.empty() || has_name(element.properties, property.name)) {
      line.fault("property " + in_quotes(property.name) + " has no name or is declared twice");
    }
    if (has_corners(element) && is_corner_list(property) && !is_integer(property.type)) {
      line.fault("the vertex indices of faces are no integers");
    }
    element.properties.push_back(std::move(property));
  }

  static PlyType type_of(std::string_view name, const TextScanner& line) {
    const auto* const found = std::find_if(kTypeNames.begin(), kTypeNames.end(),
                                           [&](const auto& known) { return known.first == name; });
    if (found == kTypeNames.end()) {
      line.fault(in_quotes(name) + " is no type of PLY");
    }
    return found->second;
  }

  void check_elements() const {
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") {
        for (const std::string_view axis : {"x", "y", "z"}) {
          const auto is_axis = [&](const PlyProperty& p) {
            return p.name == axis && !p.list_size_type;
          };
          require_one(element, is_axis, "number " + std::string(axis));
        }
      } else if (has_corners(element)) {
        require_one(element, is_corner_list, "list vertex_indices or vertex_index");
      }
    }
  }

  template <typename Predicate>
  static void require_one(const PlyElement& element, Predicate wanted, const std::string& what) {
    if (std::count_if(element.properties.begin(), element.properties.end(), wanted) != 1) {
      throw TextFault(element.line, "element " + element.name + " needs one property " + what);
    }
  }

  std::string_view content_;
  PlyHeader header_;
};

}  // namespace

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::Int8:
    case PlyType::UInt8:
      return 1;
    case PlyType::Int16:
    case PlyType::UInt16:
      return 2;
    case PlyType::Int32:
    case PlyType::UInt32:
    case PlyType::Float32:
      return 4;
    case PlyType::Float64:
      return 8;
  }
  return 0;
}

bool has_corners(const PlyElement& element) {
  return element.name == "face" || element.name == "tristrips";
}

bool is_corner_list(const PlyProperty& property) {
  return property.list_size_type &&
         (property.name == "vertex_indices" || property.name == "vertex_index");
}

PlyHeader parse_ply_header(std::string_view content) {
  return HeaderParser(content).parse();
}

}  // namespace meshalyzer
