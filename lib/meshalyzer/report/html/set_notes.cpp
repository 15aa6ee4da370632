#include "meshalyzer/report/html/set_notes.h"

#include "meshalyzer/report/text/short_list.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

namespace meshalyzer {
namespace {

/// The meshes related to each mesh.
using Others = std::vector<std::vector<Index>>;

Others meeting(const SetAnalysis& set) {
  Others others(set.names.size());
  for (const MeshMeeting& meeting : meetings_of(*set.intersections)) {
    others[meeting.mesh_a].push_back(meeting.mesh_b);
    others[meeting.mesh_b].push_back(meeting.mesh_a);
  }
  return others;
}

Others outer_meshes(const SetAnalysis& set, const std::vector<ContainedMesh>& contained) {
  Others others(set.names.size());
  for (const ContainedMesh& mesh : contained) others[mesh.inner].push_back(mesh.outer);
  return others;
}

std::string note(std::string_view words, std::vector<Index>& others, const SetAnalysis& set) {
  std::sort(others.begin(), others.end());
  const std::size_t n = n_shown(others.size(), ListLength::Short);
  std::string text(words);
  for (std::size_t i = 0; i < n; ++i) {
    text += i == 0 ? " " : ", ";
    text += set.names[others[i]];
  }
  append_rest(text, others.size(), ListLength::Short);
  return text;
}

}  // namespace

std::vector<std::vector<std::string>> set_notes(const SetAnalysis& set) {
  std::vector<std::vector<std::string>> notes(set.names.size());
  if (!set.intersections) return notes;
  const auto append = [&](std::string_view words, Others others) {
    for (std::size_t mesh = 0; mesh < others.size(); ++mesh) {
      if (!others[mesh].empty()) notes[mesh].push_back(note(words, others[mesh], set));
    }
  };
  append("intersects", meeting(set));
  append("inside", outer_meshes(set, set.intersections->contained));
  append("partly inside", outer_meshes(set, set.intersections->partly_contained));
  return notes;
}

}  // namespace meshalyzer
