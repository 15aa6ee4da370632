#include "meshalyzer/checks/profile.h"

#include "meshalyzer/base/nearest_name.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vector>

namespace meshalyzer {
namespace {

/// Returns the defects that no mesh may have, whatever its purpose.
DefectCodes without_faults() {
  return {DefectCode::Corrupt,         DefectCode::NonManifold, DefectCode::Flipped,
          DefectCode::DegenerateFacet, DefectCode::FlatFacet,   DefectCode::DuplicateFacet};
}

DefectCodes with(DefectCodes codes, std::initializer_list<DefectCode> more) {
  for (const DefectCode code : more) codes.insert(code);
  return codes;
}

Limits some_faces() {
  Limits limits;
  limits[LimitKind::MinFaces] = 1;
  return limits;
}

/// Zero area and zero length are decided exactly, like everything else that makes a mesh good.
CheckCriteria solid() {
  return {.codes = with(without_faults(),
                        {DefectCode::SelfIntersection, DefectCode::Slit, DefectCode::Hole,
                         DefectCode::Inward, DefectCode::OrphanVertex, DefectCode::Numbering}),
          .tolerances = {.degeneracy = 0.0},
          .limits = some_faces()};
}

CheckCriteria print() {
  return {.codes = with(without_faults(),
                        {DefectCode::SelfIntersection, DefectCode::Slit, DefectCode::Hole,
                         DefectCode::Inward, DefectCode::Foldover, DefectCode::VertexNormal}),
          .tolerances = {},
          .limits = some_faces()};
}

CheckCriteria simulation() {
  CheckCriteria criteria = print();
  criteria.codes.insert(DefectCode::OrphanVertex);
  criteria.limits[LimitKind::MinCornerAngle] = 5.0;
  criteria.limits[LimitKind::MaxAspectRatio] = 20.0;
  criteria.limits[LimitKind::MinEdgeAngle] = 5.0;
  return criteria;
}

CheckCriteria sheet() {
  CheckCriteria criteria = solid();
  criteria.codes.erase(DefectCode::Hole);
  criteria.codes.erase(DefectCode::Inward);
  return criteria;
}

CheckCriteria exchange() {
  return {.codes = with(without_faults(), {DefectCode::VertexNormal, DefectCode::OrphanVertex,
                                           DefectCode::Numbering}),
          .tolerances = {},
          .limits = some_faces()};
}

const std::array<CheckProfile, 5>& profiles() {
  static const std::array<CheckProfile, 5> table{
      {{"solid",
        "closed, manifold and outward, nothing intersecting or degenerate, no unused or "
        "misnumbered records: good in the sense of reports",
        solid()},
       {"print",
        "a solid that slicers take: no folds and no nearly degenerate faces either; unused "
        "records and numbering do not matter",
        print()},
       {"simulation",
        "a print mesh without unused vertices, with angles of faces of at least 5 degrees, "
        "aspect ratios up to 20, angles at edges of at least 5 degrees",
        simulation()},
       {"sheet", "a solid, but borders are allowed: terrain, cloth, scans", sheet()},
       {"exchange",
        "records that other programs read in the same way; borders and intersections do not "
        "matter",
        exchange()}}};
  return table;
}

}  // namespace

std::span<const CheckProfile> check_profiles() {
  return profiles();
}

const CheckProfile* find_profile(std::string_view name) {
  const auto* const found =
      std::find_if(profiles().begin(), profiles().end(),
                   [&](const CheckProfile& profile) { return profile.name == name; });
  return found == profiles().end() ? nullptr : found;
}

std::string why_no_profile(std::string_view name) {
  if (find_profile(name) != nullptr) return "";
  std::vector<std::string_view> names;
  for (const CheckProfile& profile : check_profiles()) names.push_back(profile.name);
  const std::string meant = did_you_mean(name, names);
  return fmt::format("no profile is called '{}'{}", name,
                     meant.empty() ? fmt::format("; there are {}", fmt::join(names, ", ")) : meant);
}

}  // namespace meshalyzer
