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
/// mesh. Distances are measured first, because it takes longer to tell whether a sample lies on the
/// boundary: only those samples are asked about that may decide something.
class BoundaryLoss {
 public:
  /// @param pieces       The pieces of the mesh that may be lost; they must outlive this.
  /// @param tree         The tree over the faces of the surface; it must outlive this.
  /// @param near_enough  Smaller distances are measured only if somebody asks for them: where most
  ///                     samples are that near, it takes much longer.
  BoundaryLoss(std::shared_ptr<const ReplacedMesh> mesh, const FacePieces& pieces,
               const FaceTree& tree, double near_enough);

  /// Returns the samples on the boundary that are farther away than a distance.
  [[nodiscard]] std::vector<BoundarySample> farther_than(double distance) const;

  /// Returns the largest distance, between two limits, of a sample on the boundary that counts; the
  /// lower limit if there is none.
  [[nodiscard]] double largest_between(double low, double high,
                                       const std::function<bool(const Vec3&)>& counts) const;

 private:
  struct Measured {
    PieceSample sample;
    /// The distance, or an upper bound of it that was near enough.
    double distance = 0.0;
  };

  /// Measures how far samples are, where that is more than is near enough.
  void measure(std::vector<Measured>& samples, double near_enough) const;
  /// Returns the samples that are farther away than a distance, on the boundary or not.
  [[nodiscard]] std::vector<Measured> samples_beyond(double distance) const;
  [[nodiscard]] bool is_on_boundary(const PieceSample& sample) const;

  std::shared_ptr<const ReplacedMesh> mesh_;
  const FacePieces& pieces_;
  ClosestPoints closest_;
  double near_enough_;
  std::vector<Measured> samples_;
};

}  // namespace meshalyzer
