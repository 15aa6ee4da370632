#pragma once

#include "meshalyzer/base/corners.h"
#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/spatial/closest_point.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace meshalyzer {

/// A sheet of faces, and the patches that it may lie on. The caller keeps the data.
struct SheetQuery {
  /// The mesh faces of the sheet.
  std::span<const Index> faces;
  /// The numbers of the patches that it may lie on, ascending; its own is not among them.
  std::span<const Index> under;
  /// The mesh faces of these patches, ascending, if they are few; else nothing, and those near the
  /// sheet are searched for.
  std::optional<std::span<const Index>> faces_under;
};

/// Decides whether a sheet lies on other patches of a mesh: each of its points must be within a
/// tolerance of a face of theirs whose normal is opposed to that of the point's face.
///
/// A positive answer is always right. The distance from a face is a convex function, so a convex
/// piece lies on a face if its corners do: each face of the sheet is cut along the sides of the
/// faces below it until every piece lies on one of these.
class SheetCover {
 public:
  /// @param patch_of_face  #mesh faces: the patch of each, kNoIndex if no sheet may lie on it.
  /// @param wants_to_stop  Called for each face; once it returns true, no sheet lies on patches. It
  ///                       must outlive this.
  /// @complexity           O(#F).
  SheetCover(const PreparedMesh& mesh, std::span<const Index> patch_of_face, double tolerance,
             const StopQuery& wants_to_stop);

  /// Returns the distance of a sheet from the patches.
  ///
  /// @return     An upper bound of the distance; nothing if the sheet does not lie on the patches,
  ///             or if these are so fine that the search was given up.
  /// @complexity O(#faces + pieces log #F); stops at the first piece that is too far.
  [[nodiscard]] std::optional<double> measure(const SheetQuery& query);

 private:
  using Polygon = std::vector<Vec3>;

  /// A face of a patch below, by corners.
  using Below = std::optional<Corners>;

  [[nodiscard]] bool has_opposed_normal(Index face, const Vec3& normal) const;
  [[nodiscard]] Below find_below(const Polygon& piece, const SheetQuery& query, const Vec3& normal);
  [[nodiscard]] Below find_below_among(std::span<const Index> faces, const Vec3& point,
                                       const Vec3& normal);
  [[nodiscard]] Below find_below_in_mesh(const SheetQuery& query, const Vec3& point,
                                         const Vec3& normal);
  [[nodiscard]] std::optional<double> measure_face(Index face, const SheetQuery& query);
  [[nodiscard]] std::optional<double> gap(const Polygon& piece, const Corners& below) const;

  const TriMesh& mesh_;
  ClosestPoints closest_;
  std::span<const Index> patch_of_face_;
  double tolerance_;
  /// #mesh faces: non-zero for those of the sheet that is measured.
  std::vector<std::uint8_t> excluded_;
  std::size_t n_left_to_examine_;
  const StopQuery& wants_to_stop_;
};

}  // namespace meshalyzer
