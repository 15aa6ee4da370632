#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/mesh/soup.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// A part of a face that is removed without being missed, because it is proved that it separates no
/// inside from no outside, that it has no area, or that it also exists as a part of another face:
/// the deviation does not count it as lost.
struct InteriorWall {
  Corners corners;
  /// The face of the mesh in question that it is a part of; kNoIndex if it is a part of none.
  Index face = kNoIndex;
};

/// The changes of a mesh that a pass proposes: a list of operations, each a local change that is
/// made as a whole or not at all.
///
/// Operations of one list must be independent: no two change the same face, or move or replace the
/// same vertex, and if some of them are left out, the rest is still a valid proposal. All indices
/// refer to the soup before the edits; `op` is the number of the operation, from 0.
struct Edits {
  struct MovedVertex {
    Index op;
    Index vertex;
    Vec3 to;
  };
  /// The position of an added vertex. Vertex i of these is named n_vertices + i by the faces of
  /// this list.
  struct AddedVertex {
    Index op;
    Vec3 position;
    /// The vertex at whose position it is, or was; kNoIndex for a new one.
    Index copy_of = kNoIndex;
  };
  /// A vertex record to be dropped that no face uses. A vertex that loses its last face is dropped
  /// anyway and is not listed here.
  struct RemovedVertex {
    Index op;
    Index vertex;
  };
  struct RemovedFace {
    Index op;
    Index face;
  };
  /// The new corners of a face that keeps its id and its place in the file. Corners that stay the
  /// same vertex keep their normal, even at another position; others get that of the corner at
  /// their place, or else of the one they replace.
  struct ChangedFace {
    Index op;
    Index face;
    Triangle corners;
    /// Tells whether the normals of its corners are turned over. A vertex with one normal gets the
    /// opposite one if this is told of all of its faces but those of hole patches.
    bool turns_normals = false;
  };
  struct AddedFace {
    Index op;
    Triangle corners;
    /// A face of the soup that the new face is modelled on: the new face joins its group, and
    /// unless fills_hole is set counts as made of it and takes its normals, interpolated at other
    /// corners, and turned over where it faces the other way.
    Index prototype;
    /// Tells whether it fills a hole, so that it replaces nothing of the old surface.
    bool fills_hole = false;
  };
  /// A normal for the corners of faces at a vertex that have a certain one of the soup; where each
  /// vertex has one, that is the vertex's.
  struct ChangedNormal {
    Index op;
    Index vertex;
    Index replaced;
    Vec3 normal;
  };
  /// The id of a record; used only if the format names ids.
  struct ChangedId {
    Index op;
    Index record;
    std::int32_t id;
  };

  /// A vertex where a sheet was cut, which may end there; named as the faces of this list do it.
  struct SheetCut {
    Index op;
    Index vertex;
  };
  /// The wall counts as removed once the operation is applied.
  struct RemovedWall {
    Index op;
    InteriorWall wall;
  };

  std::size_t n_operations = 0;
  std::vector<MovedVertex> moved_vertices;
  std::vector<AddedVertex> added_vertices;
  std::vector<RemovedVertex> removed_vertices;
  std::vector<RemovedFace> removed_faces;
  std::vector<ChangedFace> changed_faces;
  std::vector<AddedFace> added_faces;
  std::vector<ChangedNormal> changed_normals;
  std::vector<ChangedId> changed_vertex_ids;
  std::vector<ChangedId> changed_face_ids;
  std::vector<SheetCut> sheet_cuts;
  std::vector<RemovedWall> interior_walls;

  [[nodiscard]] bool empty() const { return n_operations == 0; }
  /// Returns the position of a vertex, numbered as by the faces of this list, before any moves.
  ///
  /// @param soup  The soup before the edits.
  [[nodiscard]] const Vec3& position_of(const Soup& soup, Index vertex) const {
    return vertex < soup.n_vertices() ? soup.positions[vertex]
                                      : added_vertices[vertex - soup.n_vertices()].position;
  }

  /// Begins the next operation, and returns its number.
  [[nodiscard]] Index begin_operation() { return static_cast<Index>(n_operations++); }
};

/// Returns #operations: non-zero for each that would place a vertex where coordinates are too large
/// for doubles, which no file can say.
///
/// @complexity O(edits).
[[nodiscard]] std::vector<std::uint8_t> which_overflow(const Edits& edits);

}  // namespace meshalyzer
