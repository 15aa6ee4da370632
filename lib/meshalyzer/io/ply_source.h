#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/io/ply_header.h"
#include "meshalyzer/io/text_scanner.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace meshalyzer {

/// The numbers of an ASCII PLY file after its header, with one line for each record. Errors are
/// TextFaults.
class AsciiPlySource {
 public:
  AsciiPlySource(std::string_view content, const PlyHeader& header)
      : in_(content.substr(header.n_bytes), header.n_lines + 1) {}

  /// Rejects a count that the rest of the file cannot hold.
  void check_count(const PlyElement& element) const;

  void begin_record(const PlyElement& element) { in_.require_record("the last " + element.name); }
  void end_record() { in_.end_record(); }
  /// Returns the 1-based line of the record.
  [[nodiscard]] std::size_t line() const { return in_.line(); }

  /// Returns a finite number.
  [[nodiscard]] double real(PlyType /*type*/) { return in_.real(); }
  /// Returns a vertex index.
  [[nodiscard]] Index index(PlyType /*type*/) { return in_.index(0); }
  /// Returns a vertex index, or kNoIndex for the -1 that ends a strip.
  [[nodiscard]] Index index_of_strip(PlyType type);
  [[nodiscard]] std::size_t list_size(const PlyProperty& /*list*/) {
    return in_.count(2, "list items");
  }
  void skip(PlyType /*type*/) { in_.skip_number(); }

  /// Throws if anything is left.
  void finish();

  [[noreturn]] void fault(const std::string& what) const { in_.fault(what); }

 private:
  TextScanner in_;
};

/// The numbers of a binary PLY file after its header. Errors are IoErrors with the byte offset.
class BinaryPlySource {
 public:
  BinaryPlySource(std::string_view content, const PlyHeader& header, const std::string& name);

  void check_count(const PlyElement& element) const;

  void begin_record(const PlyElement& /*element*/) {}
  void end_record() {}
  /// Returns 0, because binary records have no line.
  [[nodiscard]] static std::size_t line() { return 0; }

  [[nodiscard]] double real(PlyType type);
  [[nodiscard]] Index index(PlyType type);
  [[nodiscard]] Index index_of_strip(PlyType type);
  [[nodiscard]] std::size_t list_size(const PlyProperty& list);
  void skip(PlyType type) { static_cast<void>(take(size_of(type))); }

  void finish();

  [[noreturn]] void fault(const std::string& what) const { fault_at(at_, what); }

 private:
  [[noreturn]] void fault_at(std::size_t offset, const std::string& what) const;
  /// Returns the next bytes; throws if the file ends within them.
  const char* take(std::size_t n);
  /// Returns the next number of any type; all are exact as doubles.
  double number(PlyType type);
  /// Returns the next number, of an integer type.
  std::int64_t integer(PlyType type);
  /// Returns the vertex index that was read at an offset; throws if it is none.
  [[nodiscard]] Index checked_index(std::int64_t value, std::size_t offset) const;

  std::string_view content_;
  std::size_t at_;
  std::endian order_;
  const std::string& name_;
};

}  // namespace meshalyzer
