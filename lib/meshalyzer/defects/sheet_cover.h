#pragma once

#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/spatial/closest_point.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {

// Private to the defects module: whether one part of a surface lies on another.

/// A sheet of faces, and those that it may lie on. Only refers.
struct SheetQuery {
  /// Mesh faces.
  std::span<const Index> faces;
  /// Numbers of the patches it may lie on, ascending; its own is none of them.
  std::span<const Index> under;
};

/// Tells whether a sheet lies on other patches of a mesh: whether each of its points is within a
/// tolerance of a face of theirs whose normal is opposed to that of the point's face.
///
/// It never says so of one that does not. Distance from a face is a convex function, so a convex
/// piece lies on a face where its corners do: each face of the sheet is cut along the sides of the
/// faces below it until every piece lies on one of these.
class SheetCover {
 public:
  /// @param patch_of_face  #mesh faces; kNoIndex for those that nothing may lie on.
  /// @complexity           O(#F).
  SheetCover(const PreparedMesh& mesh, std::span<const Index> patch_of_face, double tolerance);

  /// @return     An upper bound of the distance of the sheet from what it lies on; nothing where it
  /// does not lie there, or is so much finer cut below that it was not found out.
  /// @complexity O(#faces + pieces log #F); stops at the first piece that is too far.
  [[nodiscard]] std::optional<double> measure(const SheetQuery& query);

 private:
  using Polygon = std::vector<Vec3>;

  [[nodiscard]] bool lies_below(Index face, const SheetQuery& query, const Vec3& normal) const;
  [[nodiscard]] std::optional<Corners> find_below(const Polygon& piece, const SheetQuery& query,
                                                  const Vec3& normal);
  [[nodiscard]] std::optional<double> measure_face(Index face, const SheetQuery& query);
  [[nodiscard]] std::optional<double> gap(const Polygon& piece, const Corners& below) const;

  const TriMesh& mesh_;
  ClosestPoints closest_;
  std::span<const Index> patch_of_face_;
  double tolerance_;
  /// #mesh faces: non-zero for those that are not to be found.
  std::vector<std::uint8_t> excluded_;
  /// Those that are excluded for the face at hand only.
  std::vector<Index> passed_over_;
};

}  // namespace meshalyzer
