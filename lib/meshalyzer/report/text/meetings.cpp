#include "meshalyzer/report/text/meetings.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iterator>
#include <span>
#include <vector>

namespace meshalyzer {
namespace {

constexpr std::array kKinds{ContactKind::Duplicate, ContactKind::Unwelded,
                            ContactKind::FoldOver,  ContactKind::CoplanarOverlap,
                            ContactKind::Crossing,  ContactKind::Touching};

/// The pairs of faces of two meshes.
using Meeting = std::span<const SetPair>;

bool are_of_same_meshes(const SetPair& a, const SetPair& b) {
  return a.mesh_a == b.mesh_a && a.mesh_b == b.mesh_b;
}

std::vector<Meeting> meetings_of(const std::vector<SetPair>& pairs) {
  std::vector<Meeting> meetings;
  for (auto first = pairs.begin(); first != pairs.end();) {
    const auto last = std::find_if_not(
        first, pairs.end(), [&](const SetPair& pair) { return are_of_same_meshes(*first, pair); });
    meetings.emplace_back(first, last);
    first = last;
  }
  return meetings;
}

std::size_t count_of(Meeting pairs, ContactKind kind) {
  return static_cast<std::size_t>(std::count_if(
      pairs.begin(), pairs.end(), [&](const SetPair& pair) { return pair.kind == kind; }));
}

void append_pairs(std::string& text, const SetAnalysis& set) {
  for (const SetPair& pair : set.intersections->pairs) {
    fmt::format_to(std::back_inserter(text), "{} face {}, {} face {}: {}\n", set.names[pair.mesh_a],
                   pair.face_a, set.names[pair.mesh_b], pair.face_b, contact_name(pair.kind));
  }
}

}  // namespace

TextTable meetings_table(const SetAnalysis& set) {
  TextTable table{2, {{"mesh", "and mesh", "pairs"}}};
  if (!set.intersections) {
    return table;
  }
  // A column for each kind that occurs.
  std::vector<ContactKind> kinds;
  std::copy_if(kKinds.begin(), kKinds.end(), std::back_inserter(kinds),
               [&](ContactKind kind) { return count_of(set.intersections->pairs, kind) > 0; });
  for (const ContactKind kind : kinds) {
    table.rows.front().emplace_back(contact_name(kind));
  }
  for (const Meeting& pairs : meetings_of(set.intersections->pairs)) {
    std::vector<std::string>& row = table.rows.emplace_back();
    row = {set.names[pairs.front().mesh_a], set.names[pairs.front().mesh_b],
           std::to_string(pairs.size())};
    for (const ContactKind kind : kinds) {
      row.push_back(std::to_string(count_of(pairs, kind)));
    }
  }
  return table;
}

void append_meeting_counts(LineSink& lines, const SetAnalysis& set) {
  if (!set.intersections) {
    return;
  }
  const SetIntersections& found = *set.intersections;
  lines.line("intersecting pairs between meshes", found.pairs.size());
  lines.line("pairs of meshes that intersect", meetings_of(found.pairs).size());
  lines.line("contained meshes", found.contained.size());
  lines.line("partly contained meshes", found.partly_contained.size());
  for (const ContainedMesh& mesh : found.contained) {
    lines.line("contained mesh", set.names[mesh.inner] + " inside " + set.names[mesh.outer]);
  }
  for (const ContainedMesh& mesh : found.partly_contained) {
    lines.line("partly contained mesh",
               "components of " + set.names[mesh.inner] + " inside " + set.names[mesh.outer]);
  }
}

void append_meetings(TextLines& lines, const SetAnalysis& set, OffenderStyle style) {
  if (!set.intersections) {
    return;
  }
  lines.heading("INTERSECTIONS BETWEEN MESHES");
  append_meeting_counts(lines, set);
  const std::vector<SetPair>& pairs = set.intersections->pairs;
  if (pairs.empty()) {
    return;
  }
  lines.line("pairs of meshes that intersect, one a row", "all");
  append_table(lines.text(), meetings_table(set));
  if (style != OffenderStyle::None) {
    lines.line("offending intersecting pairs between meshes", pairs.size());
    append_pairs(lines.text(), set);
  }
}

}  // namespace meshalyzer
