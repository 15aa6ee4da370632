#pragma once

#include "meshalyzer/analysis/analysis.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

namespace meshalyzer {

/// The description of a list of offenders, for all outputs.
struct OffenderListInfo {
  /// The key in JSON, on which programs may rely.
  std::string_view key;
  /// The name of the list in texts, and of each element in it.
  std::string_view label;
  std::string_view element = {};
  /// The words before the measured value of an element in texts, if it has one.
  std::string_view quantity = {};
  std::string_view unit = {};
};

/// A row of a table of lists of offenders.
template <typename List>
struct OffenderListRow {
  OffenderListInfo info;
  List Offenders::*member;
  /// The ids of the records, for a list of indices.
  Ids Analysis::*ids = nullptr;
};
template <typename List>
OffenderListRow(OffenderListInfo, List Offenders::*) -> OffenderListRow<List>;
template <typename List>
OffenderListRow(OffenderListInfo, List Offenders::*, Ids Analysis::*) -> OffenderListRow<List>;

inline constexpr std::tuple kTornLineLists{
    OffenderListRow{{"torn_lines", "torn lines", "torn line"}, &Offenders::torn_lines},
};

/// The lists of faults of the file's records.
inline constexpr std::tuple kRecordLists{
    OffenderListRow{{"orphan_vertices", "orphan vertices", "orphan vertex"},
                    &Offenders::orphan_vertices,
                    &Analysis::vertex_ids},
    OffenderListRow{{"missing_vertices", "missing vertices", "missing vertex"},
                    &Offenders::missing_vertices},
    OffenderListRow{
        {"faces_with_missing_vertices", "faces with missing vertices", "face with missing vertex"},
        &Offenders::faces_with_missing_vertices,
        &Analysis::face_ids},
    OffenderListRow{{"degenerate_faces", "degenerate faces", "degenerate face"},
                    &Offenders::degenerate_faces,
                    &Analysis::face_ids},
    OffenderListRow{
        {"duplicate_vertex_indices", "duplicate vertex indices", "duplicate vertex index"},
        &Offenders::duplicate_vertex_records,
        &Analysis::vertex_ids},
    OffenderListRow{{"duplicate_face_indices", "duplicate face indices", "duplicate face index"},
                    &Offenders::duplicate_face_records,
                    &Analysis::face_ids},
};

inline constexpr std::tuple kNumberingBreaks{
    OffenderListRow{{"vertex_numbering", "vertex numbering"}, &Offenders::vertex_numbering},
    OffenderListRow{{"face_numbering", "face numbering"}, &Offenders::face_numbering},
};

/// The lists of elements that decide the attributes.
inline constexpr std::tuple kAttributeLists{
    OffenderListRow{{"border_edges", "border edges", "border edge"}, &Offenders::border_edges},
    OffenderListRow{{"non_manifold_edges", "non-manifold edges", "non-manifold edge"},
                    &Offenders::non_manifold_edges},
    OffenderListRow{{"non_manifold_vertices", "non-manifold vertices", "non-manifold vertex"},
                    &Offenders::non_manifold_vertices,
                    &Analysis::vertex_ids},
    OffenderListRow{{"pinched_vertices", "pinched vertices", "pinched vertex"},
                    &Offenders::pinched_vertices,
                    &Analysis::vertex_ids},
    OffenderListRow{{"flipped_edges", "flipped edges", "flipped edge"}, &Offenders::flipped_edges},
};

/// The lists that Scope::AttributesOnly does not fill in.
inline constexpr std::tuple kMeasuredLists{
    OffenderListRow{
        {"indistinguishable_vertices", "indistinguishable vertices", "indistinguishable vertex"},
        &Offenders::indistinguishable_vertices,
        &Analysis::vertex_ids},
    OffenderListRow{
        {"indistinguishable_edges", "indistinguishable edges", "indistinguishable edge"},
        &Offenders::indistinguishable_edges},
    OffenderListRow{{"zero_area_faces", "zero-area faces", "zero-area face"},
                    &Offenders::zero_area_faces,
                    &Analysis::face_ids},
    OffenderListRow{{"duplicate_faces", "duplicate faces", "duplicate face"},
                    &Offenders::duplicate_faces,
                    &Analysis::face_ids},
    OffenderListRow{{"intersecting_pairs", "intersecting pairs", "intersecting faces"},
                    &Offenders::intersecting_pairs},
};

/// The lists of elements beyond a requested threshold; these are reported even if offenders are
/// not.
inline constexpr std::tuple kRequestedLists{
    OffenderListRow{{"short_edges", "short edges", "short edge", "length "},
                    &Offenders::short_edges},
    OffenderListRow{{"long_edges", "long edges", "long edge", "length "}, &Offenders::long_edges},
    OffenderListRow{{"small_angles", "small edge angles", "small edge angle", "", " degrees"},
                    &Offenders::small_angles},
    OffenderListRow{{"large_angles", "large edge angles", "large edge angle", "", " degrees"},
                    &Offenders::large_angles},
    OffenderListRow{{"large_aspect_ratios", "large aspect ratios", "large aspect ratio of face"},
                    &Offenders::large_aspect_ratios},
};

/// Tells whether a list of kRequestedLists was asked for.
[[nodiscard]] constexpr bool has_asked_lists(const Offenders& all) {
  return std::apply([&](const auto&... row) { return ((all.*row.member).has_value() || ...); },
                    kRequestedLists);
}

}  // namespace meshalyzer
