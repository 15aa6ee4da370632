#include "meshalyzer/report/text/meetings.h"

#include "meshalyzer/base/control_characters.h"
#include "meshalyzer/report/text/offenders.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <vector>

namespace meshalyzer {
namespace {

/// Returns the number of all pairs of faces, by kind.
ContactCounts count_all(const std::vector<MeshMeeting>& meetings) {
  ContactCounts counts;
  for (const MeshMeeting& meeting : meetings) counts.add(meeting.pairs);
  return counts;
}

void append_pairs(std::string& text, const SetAnalysis& set) {
  for (const SetPair& pair : set.intersections->pairs) {
    fmt::format_to(std::back_inserter(text), "{} face {}, {} face {}: {}\n",
                   without_controls(set.names[pair.mesh_a]), pair.face_a,
                   without_controls(set.names[pair.mesh_b]), pair.face_b, contact_name(pair.kind));
  }
}

}  // namespace

TextTable meetings_table(const SetAnalysis& set) {
  TextTable table{2, {{"mesh", "and mesh", "pairs"}}};
  if (!set.intersections) {
    return table;
  }
  if (set.intersections->is_search_stopped) {
    table.rows.front().back() += kAtLeastTitle;
  }
  // There is a column for each kind that occurs.
  const std::vector<MeshMeeting> meetings = meetings_of(*set.intersections);
  const ContactCounts all = count_all(meetings);
  std::vector<ContactKind> kinds;
  std::copy_if(kContactKinds.begin(), kContactKinds.end(), std::back_inserter(kinds),
               [&](ContactKind kind) { return all.of(kind) > 0; });
  for (const ContactKind kind : kinds) {
    table.rows.front().emplace_back(contact_name(kind));
  }
  for (const MeshMeeting& meeting : meetings) {
    std::vector<std::string>& row = table.rows.emplace_back();
    row = {set.names[meeting.mesh_a], set.names[meeting.mesh_b],
           std::to_string(meeting.pairs.total())};
    for (const ContactKind kind : kinds) {
      row.push_back(std::to_string(meeting.pairs.of(kind)));
    }
  }
  return table;
}

void append_meeting_counts(LineSink& lines, const SetAnalysis& set) {
  if (!set.intersections) {
    return;
  }
  const SetIntersections& found = *set.intersections;
  if (found.is_search_stopped) {
    lines.line("intersecting pairs between meshes",
               fmt::format("at least {} (the search ended at its time limit)", found.n_pairs()));
  } else {
    lines.line("intersecting pairs between meshes", found.n_pairs());
  }
  lines.count("pairs of meshes that intersect", meetings_of(found).size(), found.is_search_stopped);
  lines.count("contained meshes", found.contained.size(), found.is_search_stopped);
  lines.count("partly contained meshes", found.partly_contained.size(), found.is_search_stopped);
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
  const SetIntersections& found = *set.intersections;
  if (found.n_pairs() == 0) {
    return;
  }
  lines.line("mended by",
             "meshfixer --subtract-in-order (makes solids disjoint) or --union (makes them one)");
  lines.line("pairs of meshes that intersect, one a row",
             found.is_search_stopped ? "those found within the time limit" : "all");
  append_table(lines.text(), meetings_table(set));
  if (style != OffenderStyle::None) {
    lines.line("offending intersecting pairs between meshes",
               list_head(found.n_pairs(), found.pairs.size(), found.is_search_stopped));
    append_pairs(lines.text(), set);
  }
}

}  // namespace meshalyzer
