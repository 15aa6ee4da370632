#pragma once

#include "meshalyzer/base/corners.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace meshalyzer {

/// A part of a face that goes and is not missed, because it is proved that it separates no inside
/// from no outside, it has no area, or it is there as a part of another face: the deviation does
/// not count it as lost.
struct InteriorWall {
  Corners corners;
  /// The face that it is a part of, of the mesh in question; kNoIndex: of none that there is.
  Index face = kNoIndex;
};

/// Changes of a mesh, as a pass proposes them: a list of operations, each a local change that is
/// made as a whole or not at all.
///
/// Operations of one list must be independent: no two change the same face, or move or replace the
/// same vertex, and what is left when any of them are taken out is still what the pass wants. All
/// refers to the soup as it is before; `op` is the number of the operation, from 0.
struct Edits {
  struct MovedVertex {
    Index op;
    Index vertex;
    Vec3 to;
  };
  /// Added vertex i is named n_vertices + i by the faces of this list.
  struct AddedVertex {
    Index op;
    Vec3 position;
    /// Vertex at whose place it is, or was; kNoIndex: a new one.
    Index copy_of = kNoIndex;
  };
  /// A vertex record to be dropped that no face uses. A vertex that loses its last face is dropped
  /// anyway, without being listed here.
  struct RemovedVertex {
    Index op;
    Index vertex;
  };
  struct RemovedFace {
    Index op;
    Index face;
  };
  /// New corners for a face that keeps its id and its place in the file. Corners that stay the same
  /// vertex keep their normal, wherever they stand now; others that of the corner they replace.
  struct ChangedFace {
    Index op;
    Index face;
    Triangle corners;
  };
  struct AddedFace {
    Index op;
    Triangle corners;
    /// A face of the soup that the new face is modelled on: the new face joins its group, takes its
    /// normals at common corners, and counts as made of it unless fills_hole is set.
    Index like;
    /// Tells whether it fills a hole: nothing of the old surface was there.
    bool fills_hole = false;
  };
  /// A normal for all corners of faces at a vertex that have one.
  struct ChangedNormal {
    Index op;
    Index vertex;
    Vec3 normal;
  };
  /// An id for a record; only where the format names them.
  struct ChangedId {
    Index op;
    Index record;
    std::int32_t id;
  };

  /// The wall counts as no longer there when the operation is made.
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
  std::vector<RemovedWall> interior_walls;

  [[nodiscard]] bool empty() const { return n_operations == 0; }
  /// Begins the next operation, and gives its number.
  [[nodiscard]] Index begin_operation() { return static_cast<Index>(n_operations++); }
};

}  // namespace meshalyzer
