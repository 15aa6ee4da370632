#pragma once

#include "meshalyzer/mesh/side_table.h"
#include "meshalyzer/mesh/soup.h"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace meshalyzer {

/// Lists, for each of some vertices of a file, the faces of the complex that use it. The list has
/// one entry for each vertex.
class IncidentFaces {
 public:
  /// @param vertices  File vertices, ascending, each once.
  /// @complexity      O(log #copies + n log n) a vertex of n faces.
  IncidentFaces(const CutMesh& cut, std::vector<Index> vertices);

  [[nodiscard]] std::size_t size() const { return vertices_.size(); }
  [[nodiscard]] Index vertex(std::size_t entry) const { return vertices_[entry]; }
  /// Returns the faces of an entry by index in the file, in ascending order.
  [[nodiscard]] std::span<const Index> faces(std::size_t entry) const {
    return std::span(faces_).subspan(begin_[entry], begin_[entry + 1] - begin_[entry]);
  }

  /// Returns the entry of one of the vertices.
  [[nodiscard]] std::size_t entry_of(Index vertex) const;
  /// Returns where the faces of an entry begin in the list of those of all entries.
  [[nodiscard]] std::size_t begin(std::size_t entry) const { return begin_[entry]; }
  /// Returns the place of a face within its entry.
  [[nodiscard]] std::size_t place(std::size_t entry, Index face) const;
  /// Returns how many faces all entries have, each counted once for every entry it is in.
  [[nodiscard]] std::size_t n_places() const { return faces_.size(); }

 private:
  std::vector<Index> vertices_;
  std::vector<std::size_t> begin_{0};
  std::vector<Index> faces_;
};

/// A side of a face that ends at the vertex of an entry.
struct Spoke {
  /// The vertex at its other end.
  Index other = 0;
  /// The face's place in the entry.
  Index place = 0;
};

/// Lists the sides of an entry's faces that end at its vertex, two for each face, ascending by
/// their other ends, then by face. Spokes with the same other end are an edge of the complex.
[[nodiscard]] std::vector<Spoke> find_spokes(const Soup& soup, const IncidentFaces& incident,
                                             std::size_t entry);

/// Decides how faces are joined across an edge with more than two. It is called with the spokes of
/// the edge, and returns for each the number of the spoke that it is joined to, or kNoIndex.
using JoinWideEdge = std::function<std::vector<Index>(std::span<const Spoke>)>;

/// Finds the fans at a vertex: faces joined through edges with two faces, whatever their
/// orientations, and through edges with more as `join` decides.
///
/// @return  The fan of each face of the entry, numbered from 0 in order of their lowest faces.
[[nodiscard]] std::vector<Index> find_fans_at(const Soup& soup, const IncidentFaces& incident,
                                              std::size_t entry, const JoinWideEdge& join);

}  // namespace meshalyzer
