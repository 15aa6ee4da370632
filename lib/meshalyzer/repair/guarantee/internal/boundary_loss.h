#pragma once

#include "meshalyzer/base/lazy.h"
#include "meshalyzer/contour/boundary_samples.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"
#include "meshalyzer/spatial/closest_point.h"

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace meshalyzer {

/// Pieces of the faces of a mesh.
struct FacePieces {
  std::vector<Corners> corners;
  /// #pieces: the key of the face that each is a part of.
  std::vector<Index> face_keys;
};

/// A mesh that is replaced, and the boundary of the solid that it represents, which is prepared
/// once somebody asks for it.
class ReplacedMesh {
 public:
  /// @param reach  See SolidBoundary.
  ReplacedMesh(const TrackedMesh& mesh, double reach);

  /// Tells whether a mesh has the same positions, faces and keys.
  [[nodiscard]] bool is(const TrackedMesh& mesh) const;

  /// Returns the distance between samples.
  [[nodiscard]] double spacing() const;

  [[nodiscard]] const SolidBoundary& boundary() const;

 private:
  /// Positions and faces alone.
  Soup soup_;
  std::vector<Index> face_keys_;
  double reach_;
  mutable Lazy<SolidBoundary> boundary_;
};

/// A sample of what bounds the solid that a mesh represents.
struct BoundarySample {
  Vec3 point;
  /// The key of the face that it lies on.
  Index face_key = kNoIndex;
  /// The distance from the surface that has replaced the mesh.
  double distance = 0.0;
};

/// How far the boundary of the solid that a mesh represents is from a surface that has replaced the
/// mesh, up to a limit and beyond. Only what may decide something is measured: first whether
/// samples are within the limit, then whether they lie on the boundary, which takes longer, and
/// only for those that do how far they are.
class BoundaryLoss {
 public:
  /// @param pieces  The pieces of the mesh that may be lost; they must outlive this.
  /// @param tree    The tree over the faces of the surface; it must outlive this.
  /// @param limit   The distance that matters.
  BoundaryLoss(std::shared_ptr<const ReplacedMesh> mesh, const FacePieces& pieces,
               const FaceTree& tree, double limit);

  /// Returns the samples on the boundary that are farther away than the limit.
  [[nodiscard]] std::vector<BoundarySample> beyond_limit() const;

  /// Returns the largest distance, larger than `least` and at most the limit, of a sample on the
  /// boundary that counts; `least` if there is none.
  [[nodiscard]] double largest_within_limit(double least,
                                            const std::function<bool(const Vec3&)>& counts) const;

 private:
  struct NearSample {
    PieceSample sample;
    /// The distance from some face of the surface.
    double upper_bound = 0.0;
  };

  /// Returns those of some samples that lie on the boundary.
  [[nodiscard]] std::vector<PieceSample> on_boundary(std::span<const PieceSample> samples) const;
  /// #samples: how far each is.
  [[nodiscard]] std::vector<double> distances_of(std::span<const PieceSample> samples) const;
  [[nodiscard]] bool is_on_boundary(const PieceSample& sample) const;

  std::shared_ptr<const ReplacedMesh> mesh_;
  const FacePieces& pieces_;
  ClosestPoints closest_;
  /// The samples within the limit, and the others.
  std::vector<NearSample> near_;
  std::vector<PieceSample> far_;
};

}  // namespace meshalyzer
