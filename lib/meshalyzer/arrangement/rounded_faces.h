#pragma once

#include "meshalyzer/base/types.h"

#include <cstdint>
#include <vector>

namespace meshalyzer {

/// The age of a face of a surface that is cut and rounded, in one or more rounds.
enum class FaceAge : std::uint8_t {
  /// The face is as it was before.
  Old,
  /// Cutting, rounding or an edit has made it, and what it intersects was searched for since.
  Searched,
  /// Cutting, rounding or an edit has made it since the last search.
  New,
};

/// The faces of a surface that was cut and rounded.
struct RoundedFaces {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  /// #triangles.
  std::vector<FaceAge> ages;
  /// #triangles: the number by which the caller knows the face that each is a part of.
  std::vector<Index> origins;
};

/// Edits faces so that, if they cross every edge equally often in both directions, they still do.
/// Numbers of faces stay as they are until finish().
class RoundedFaceEdits {
 public:
  /// @complexity O(#positions + #triangles).
  explicit RoundedFaceEdits(RoundedFaces& faces);

  /// Puts one vertex in the place of another, and removes the faces that have both.
  void collapse(Index vertex, Index into);

  /// Divides the faces at an edge so that the edge goes through a vertex, and removes those of
  /// which it is the third corner.
  void split_edge(Index a, Index b, Index through);

  /// Removed faces have no corners.
  [[nodiscard]] bool is_removed(Index face) const { return faces_.triangles[face][0] == kNoIndex; }

  /// Returns the faces that were made or changed and not yet taken, in the order of the edits.
  [[nodiscard]] std::vector<Index> take_changed();

  /// Leaves out the removed faces, and the new ones that have no area.
  void finish();

 private:
  void change(Index face);
  void add(const Triangle& t, Index like);
  [[nodiscard]] bool stays(Index face) const;

  RoundedFaces& faces_;
  /// #positions: the faces that have or had a vertex as a corner.
  std::vector<std::vector<Index>> faces_of_;
  std::vector<Index> changed_;
};

}  // namespace meshalyzer
