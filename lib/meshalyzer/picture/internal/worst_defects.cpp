#include "meshalyzer/picture/internal/worst_defects.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/mesh/edge_key.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace meshalyzer {
namespace {

/// The rank of a value by severity: the lower, the worse.
using Rank = std::uint8_t;
constexpr Rank kNoDefect = 2 * kDefectCodes;

Rank rank_of(DefectCode code) {
  const bool is_error = catalogue_entry(code).severity == Severity::Error;
  return static_cast<Rank>(static_cast<std::size_t>(code) + (is_error ? 0 : kDefectCodes));
}

double value_of(Rank rank) {
  return rank == kNoDefect ? 0.0 : static_cast<double>(1 + rank % kDefectCodes);
}

Rank rank_of_value(double value) {
  return value == 0.0 ? kNoDefect : rank_of(static_cast<DefectCode>(value - 1.0));
}

/// Finds the worst defect that lists each element.
class ListedElements {
 public:
  ListedElements(const Soup& soup, const DefectReport& report)
      : vertices_(soup.n_vertices(), kNoDefect),
        faces_(soup.n_faces(), kNoDefect),
        has_edge_(soup.n_vertices(), 0) {
    for (const Defect& defect : report.defects) {
      add(defect);
    }
    std::sort(edges_.begin(), edges_.end());
  }

  /// Returns the worst rank of a face, its vertices and its edges.
  [[nodiscard]] Rank at(std::size_t face, const Triangle& corners) const {
    Rank worst = faces_[face];
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = corners[k];
      if (v != kNoIndex) {
        worst = std::min({worst, vertices_[v], at_edge(v, corners[(k + 1) % 3])});
      }
    }
    return worst;
  }

 private:
  struct Edge {
    /// Both ends of the edge in one number, the lower in front.
    std::uint64_t ends;
    Rank rank;

    friend bool operator<(const Edge& a, const Edge& b) {
      return a.ends != b.ends ? a.ends < b.ends : a.rank < b.rank;
    }
  };

  void add(const Defect& defect) {
    const Rank rank = rank_of(defect.code);
    for (const Index v : defect.vertices) {
      vertices_[v] = std::min(vertices_[v], rank);
    }
    for (const Index f : defect.faces) {
      faces_[f] = std::min(faces_[f], rank);
    }
    for (const auto& [a, b] : defect.edges) {
      edges_.push_back({edge_key(a, b), rank});
      has_edge_[a] = 1;
      has_edge_[b] = 1;
    }
  }

  /// @param b  The other end; if it is kNoIndex, no edge is found.
  [[nodiscard]] Rank at_edge(Index a, Index b) const {
    if (has_edge_[a] == 0) {
      return kNoDefect;
    }
    const auto found = std::lower_bound(edges_.begin(), edges_.end(), Edge{edge_key(a, b), 0});
    return found != edges_.end() && found->ends == edge_key(a, b) ? found->rank : kNoDefect;
  }

  std::vector<Rank> vertices_;
  std::vector<Rank> faces_;
  /// #V: 1 for ends of listed edges.
  std::vector<std::uint8_t> has_edge_;
  /// The listed edges, sorted.
  std::vector<Edge> edges_;
};

}  // namespace

std::vector<double> worst_defects(const Soup& soup, const DefectReport& report) {
  const ListedElements listed(soup, report);
  std::vector<double> values(soup.n_faces());
  parallel_chunks(values.size(), [&](Chunk chunk) {
    for (std::size_t f = chunk.begin; f < chunk.end; ++f) {
      values[f] = value_of(listed.at(f, soup.triangles[f]));
    }
  });
  return values;
}

bool names_component(const Defect& defect) {
  return is_whole_component(defect.code) && !defect.faces.empty();
}

std::vector<double> spread_over_components(std::vector<double> values, const DefectReport& report,
                                           const CutMesh& cut, const Components& components) {
  std::vector<double> of_component(components.count, 0.0);
  for (const Defect& defect : report.defects) {
    if (names_component(defect)) {
      double& value = of_component[components.of_face[cut.side.mesh_face(defect.faces.front())]];
      value = worse_defect(value, value_of(rank_of(defect.code)));
    }
  }
  for (std::size_t f = 0; f < components.of_face.size(); ++f) {
    double& value = values[cut.side.faces[f]];
    value = worse_defect(value, of_component[components.of_face[f]]);
  }
  return values;
}

double worse_defect(double a, double b) {
  return rank_of_value(b) < rank_of_value(a) ? b : a;
}

}  // namespace meshalyzer
