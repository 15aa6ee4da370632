#pragma once

#include "meshalyzer/io/ply_header.h"
#include "meshalyzer/io/rewrite/face_plan.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The value of one property of a record, as views into the file.
struct PlyField {
  /// The number of items, if the property is a list.
  std::string_view size;
  std::vector<std::string_view> items;
};

/// One record of an element.
struct PlyRecord {
  /// The whole record, without its line end.
  std::string_view bytes;
  /// The fields, in the order of the properties.
  std::vector<PlyField> fields;
};

/// Finds and reads the records of a valid PLY file, and encodes numbers in the same way.
class PlyRecords {
 public:
  PlyRecords(std::string_view content, const PlyHeader& header);

  /// Returns the offsets of the records of an element.
  [[nodiscard]] const std::vector<std::size_t>& begins(std::size_t element) const {
    return begins_[element];
  }
  [[nodiscard]] PlyRecord read(std::size_t element, std::size_t record) const;

  /// Decodes a number of the file.
  [[nodiscard]] double number(std::string_view item, PlyType type) const;
  [[nodiscard]] std::string text(double number, PlyType type) const;

  /// Tells whether this type can hold a number without changing it.
  [[nodiscard]] bool fits(double number, PlyType type) const;

  [[nodiscard]] bool is_ascii() const { return header_.encoding == PlyEncoding::Ascii; }

 private:
  void find_ascii_records();
  void find_binary_records();
  [[nodiscard]] PlyRecord read_binary(const PlyElement& element, std::size_t begin) const;

  std::string_view content_;
  const PlyHeader& header_;
  /// The offsets of the records of each element.
  std::vector<std::vector<std::size_t>> begins_;
};

/// Returns the words of the line of the header that declares an element or, if one is given, a
/// property of it.
[[nodiscard]] std::vector<std::string_view> declaration_of(
    std::string_view content, const PlyElement& element,
    std::optional<std::string_view> property = std::nullopt);

/// Returns the index of the property that lists the corners of faces.
[[nodiscard]] std::size_t find_corner_list(const PlyElement& element);

/// Returns the records of an element of faces.
/// @param corners  The result of find_corner_list().
[[nodiscard]] FaceRecords face_records_of(const PlyRecords& records, std::size_t element,
                                          std::size_t corners);

/// Returns the index of the property with this name, or the number of properties if none has it.
[[nodiscard]] std::size_t find_property(const PlyElement& element, std::string_view name);

}  // namespace meshalyzer
