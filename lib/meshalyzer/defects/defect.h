#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/spatial/intersecting_pair.h"

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// What can be wrong with a mesh (contract 5). Never renamed.
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

/// All codes, in the order of the enumeration, which is that of reports.
[[nodiscard]] const std::array<DefectCode, kDefectCodes>& all_defect_codes();

/// "disjoint", "foldover", "flat-facet", ...
[[nodiscard]] std::string_view defect_name(DefectCode code);

/// The code of a name; nothing where there is none of that name.
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

/// How bad a defect is.
enum class Severity : std::uint8_t {
  /// The mesh bounds no solid, or a program that trusts it may fail.
  Error,
  /// The mesh means what it should, but is not as neat as it could be.
  Warning,
};

/// "error", "warning".
[[nodiscard]] std::string_view severity_name(Severity severity);

/// One thing that is wrong with a mesh, and where. Records by index in the soup, each list
/// ascending unless its finder says otherwise; which of the lists are filled is told in
/// doc/defects.md, code by code.
struct Defect {
  DefectCode code = DefectCode::Corrupt;
  Severity severity = Severity::Error;
  std::vector<Index> vertices;
  /// By their two vertices, the smaller first (a border loop: in walking order).
  std::vector<std::array<Index, 2>> edges;
  std::vector<Index> faces;
  /// Where to look: at least one point, but for what has no place.
  std::vector<Vec3> positions;
  /// Self-intersection only.
  std::vector<IntersectingPair> pairs;
  /// What was measured, and what it should not be below, or above; the catalogue says which.
  std::optional<double> value;
  std::optional<double> limit;
  /// What no list can hold, such as the id of a vertex that does not exist; mostly empty.
  std::string detail;
  /// Whether meshfixer has a fix for it.
  bool fixable = true;
};

}  // namespace meshalyzer
