#pragma once

#include "meshalyzer/analysis/analysis.h"
#include "meshalyzer/set/object_findings.h"
#include "meshalyzer/set/set_analysis.h"
#include "meshalyzer/set/set_options.h"

#include <ios>
#include <sstream>
#include <string>
#include <vector>

/// Returns a text of all figures of a set, every number to the last bit, for comparisons.
namespace meshalyzer::test {

class Describer {
 public:
  template <typename... Items>
  Describer& line(const Items&... items) {
    text_ << std::hexfloat;
    ((text_ << items << ' '), ...);
    text_ << '\n';
    return *this;
  }

  Describer& add(const std::string& name, const Statistics& s) {
    line(name, s.count, s.infinite, s.min, s.max, s.mean, s.median, s.variance, s.total);
    for (std::size_t i = 0; i < Histogram::kBins; ++i) {
      line(s.histogram.edges[i], s.histogram.counts[i], s.histogram.edges[i + 1]);
    }
    return *this;
  }

  template <typename T>
  Describer& add(const std::string& name, const std::optional<T>& value) {
    return value ? line(name, *value) : line(name, "nothing");
  }

  Describer& add(const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
      line(text);
    }
    return *this;
  }

  Describer& add(const SetIntersections& found) {
    for (const SetPair& pair : found.pairs) {
      line(pair.mesh_a, pair.face_a, pair.mesh_b, pair.face_b, contact_name(pair.kind));
    }
    for (const ContainedMesh& mesh : found.contained) {
      line(mesh.inner, "in", mesh.outer);
    }
    for (const ContainedMesh& mesh : found.partly_contained) {
      line(mesh.inner, "partly in", mesh.outer);
    }
    return *this;
  }

  [[nodiscard]] std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
};

[[nodiscard]] inline std::string described(const ObjectFindings& findings) {
  Describer text;
  text.line("owner", findings.owner);
  if (findings.intersections) {
    text.line("intersections").add(*findings.intersections);
  }
  if (findings.separation) {
    const ObjectSeparation& s = *findings.separation;
    for (std::size_t i = 0; i < s.vertices.size(); ++i) {
      text.line(s.vertices[i], s.distances[i], s.objects[i], s.faces[i], s.points[i].x(),
                s.points[i].y(), s.points[i].z());
    }
  }
  return text.text();
}

/// Prints one figure of each part, not all of it.
[[nodiscard]] inline std::string described(const Analysis& mesh) {
  const Characteristics& c = mesh.characteristics;
  Describer text;
  text.line(mesh.path, c.vertices, c.faces, c.edges, c.intersecting_pairs, c.area);
  text.add("volume", c.volume.value).add("edge angle", c.edge_angle);
  for (const auto& verdict : {mesh.goodness, mesh.fitness}) {
    text.line("verdict", verdict ? (verdict->good ? "good" : "not good") : "none");
    text.add(verdict ? verdict->reasons : std::vector<std::string>());
  }
  return text.text();
}

inline void describe(const SetSeparation& separation, Describer& text) {
  text.line("separation", separation.without_closest, separation.inside, separation.is_forced);
  for (const MeshSeparation& mesh : separation.meshes) {
    text.line(mesh.mesh, mesh.without_closest, mesh.inside).add("distance", mesh.distance);
  }
  text.add("all", separation.all);
}

[[nodiscard]] inline std::string described(const SetAnalysis& set) {
  Describer text;
  text.add(set.names).line(set.meshes, set.unreadable, set.vertices, set.faces, set.edges);
  text.line(set.components, set.boundaries, set.is_measured, set.intersecting_pairs_within);
  text.line(set.area).add("volume", set.volume.value).line(set.volume.reason);
  text.add("good", set.good);
  for (const UnfitMesh& mesh : set.not_good) {
    text.line("not good", mesh.mesh).add(mesh.reasons);
  }
  if (set.statistics) {
    text.add("valence", set.statistics->vertex_valence).add("area", set.statistics->face_area);
    text.add("aspect", set.statistics->aspect_ratio).add("length", set.statistics->edge_length);
    text.add("angle", set.statistics->edge_angle);
  }
  if (set.intersections) {
    text.line("intersections").add(*set.intersections);
  }
  if (set.separation) {
    describe(*set.separation, text);
  }
  text.line("no separation:", set.separation_reason);
  return text.text();
}

/// Prints everything, with room for all of it.
inline SetOptions asking_all() {
  SetOptions options;
  options.request.between.intersections = true;
  options.request.between.separation.emplace();
  options.memory_limit = std::uint64_t{1} << 40;
  return options;
}

}  // namespace meshalyzer::test
