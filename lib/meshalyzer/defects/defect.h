#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/spatial/intersecting_pair.h"

#include <array>
#include <bitset>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The kinds of faults that a mesh can have. doc/defects.md describes each; none is ever renamed.
enum class DefectCode : std::uint8_t {
  Disjoint,
  Foldover,
  FlatFacet,
  DegenerateFacet,
  Slit,
  SelfIntersection,
  NonManifold,
  VertexNormal,
  Corrupt,
  Hole,
  Flipped,
  Inward,
  DuplicateFacet,
  OrphanVertex,
  Numbering,
};

inline constexpr std::size_t kDefectCodes = 15;

/// Returns all codes in the order of the enumeration, which is also the order of reports.
[[nodiscard]] const std::array<DefectCode, kDefectCodes>& all_defect_codes();

/// Returns the name of a code in reports: "disjoint", "foldover", "flat-facet", ...
[[nodiscard]] std::string_view defect_name(DefectCode code);

/// Returns the code with the given name, or nothing if no code has it.
[[nodiscard]] std::optional<DefectCode> defect_code(std::string_view name);

/// A set of defect codes.
class DefectCodes {
 public:
  DefectCodes() = default;
  DefectCodes(std::initializer_list<DefectCode> codes) {
    for (const DefectCode code : codes) insert(code);
  }
  [[nodiscard]] static DefectCodes all() {
    DefectCodes codes;
    codes.bits_.set();
    return codes;
  }

  void insert(DefectCode code) { bits_.set(static_cast<std::size_t>(code)); }
  void erase(DefectCode code) { bits_.reset(static_cast<std::size_t>(code)); }
  [[nodiscard]] bool contains(DefectCode code) const {
    return bits_.test(static_cast<std::size_t>(code));
  }
  [[nodiscard]] bool empty() const { return bits_.none(); }
  friend bool operator==(const DefectCodes&, const DefectCodes&) = default;

 private:
  std::bitset<kDefectCodes> bits_;
};

/// The severity of a defect.
enum class Severity : std::uint8_t {
  /// The mesh bounds no solid, or a program that trusts it may fail.
  Error,
  /// The mesh means what it should, but is not as neat as it could be.
  Warning,
};

/// Returns "error" or "warning".
[[nodiscard]] std::string_view severity_name(Severity severity);

/// One fault of a mesh and where it is. The lists hold indices of records of the soup and are
/// ascending unless the finder says otherwise; doc/defects.md says which lists each code fills.
struct Defect {
  DefectCode code = DefectCode::Corrupt;
  Severity severity = Severity::Error;
  std::vector<Index> vertices;
  /// The edges, each by its two vertices: the smaller first, but those of a border loop in walking
  /// order.
  std::vector<std::array<Index, 2>> edges;
  std::vector<Index> faces;
  /// Points where the defect can be seen: at least one, unless it is nowhere in space.
  std::vector<Vec3> positions;
  /// The intersecting pairs of a self-intersection; empty for other defects.
  std::vector<IntersectingPair> pairs;
  /// The measured value, and the limit that it passes; CatalogueEntry::value says what they are.
  std::optional<double> value;
  std::optional<double> limit;
  /// The 1-based line of the file if no record stands for the defect; else nothing.
  std::optional<std::size_t> line = std::nullopt;
  /// Says what no list can hold, such as the id of a vertex that does not exist; mostly empty.
  std::string detail;
  /// Tells whether repair has a fix for the defect.
  bool fixable = true;
};

}  // namespace meshalyzer
