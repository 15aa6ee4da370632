#pragma once

#include "meshalyzer/base/stop_query.h"
#include "meshalyzer/prepared/prepared_mesh.h"
#include "meshalyzer/repair/edits/edits.h"
#include "meshalyzer/repair/edits/tracked_mesh.h"
#include "meshalyzer/spatial/triangle_contact.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace meshalyzer {

struct ChangedFace;
struct ChangedFaces;
enum class DistanceQuestion;

/// The faces with a point that is farther than a bound from the other surface, or may be: its
/// distance is within a thousandth of the bound, or the face lies over thousands of others.
struct FarFaces {
  /// Faces of the input, by index, ascending.
  std::vector<Index> of_input;
  /// Faces of the tracked mesh, ascending.
  std::vector<Index> of_repaired;

  [[nodiscard]] bool empty() const { return of_input.empty() && of_repaired.empty(); }
};

/// The latest step of a repair that was within the bound before.
struct SurfaceStep {
  /// #F of the tracked mesh: non-zero for each face that the step has added or changed.
  std::vector<std::uint8_t> is_new;
  /// The triangles of the surface before that are no longer part of it.
  std::vector<Corners> gone;
};

/// Measures how far repaired surfaces are from the input that they were made of.
///
/// Construction is cheap, and the tree over the input is built by the first measurement of so many
/// faces that it pays. It is safe to ask from several threads.
class DeviationMeter {
 public:
  /// @param input  Must outlive this, unchanged.
  explicit DeviationMeter(const Soup& input);
  ~DeviationMeter();
  DeviationMeter(const DeviationMeter&) = delete;
  DeviationMeter& operator=(const DeviationMeter&) = delete;

  /// Adds the hole patches of a tracked mesh to the surface that new faces may not leave, because
  /// what is made of a patch and of the old surface together lies on both. Patches that were added
  /// before stay.
  ///
  /// @complexity O(#F); the next measure() looks at the input anew.
  void include_patches(const TrackedMesh& tracked);

  /// A repaired mesh to be measured. It only refers to its data.
  struct Repaired {
    const TrackedMesh& tracked;
    /// The tracked mesh, prepared: its tree is built if very many faces are to be measured.
    const PreparedMesh& mesh;
    /// A finite length, at least 0.
    double bound = 0.0;
    /// The walls of the input that were removed: the input may be near to them instead of the new
    /// surface.
    std::span<const InteriorWall> walls = {};
    /// Faces of the input that do not count, by index, ascending: those that are lost on purpose.
    /// Faces of zero area on their edges do not count either.
    std::span<const Index> lost = {};
    /// Tells find_far() what may have changed since the surface was last found to be within the
    /// bound; null if it never was.
    const SurfaceStep* step = nullptr;
    /// Once it says yes, find_far() takes the faces that are not measured yet for far.
    StopQuery wants_to_stop = {};
  };

  /// The faces that are farther than a bound from the other surface, and the distance of the rest.
  struct Result {
    /// An upper bound, except for rounding, of the largest distance of a point of either surface
    /// from the other, without hole patches; infinite if there is no other surface. If no face is
    /// far, it exceeds the true value by at most a thousandth of the bound, except at faces that
    /// lie over a thousand others or more; it never exceeds the bound there.
    double largest = 0.0;
    FarFaces far;
  };

  /// Only faces that differ between the two meshes are measured: a face is the same if its corners
  /// are where the corners of the face that it was made of are, in any order. Faces of zero area
  /// count as the segment or point that they are. Faces that are in no complex do not count.
  ///
  /// The result is the same for any number of threads.
  ///
  /// @complexity   O(#F), and O(log #F) for each changed face. If faces moved by less than a
  /// thousandth of the bound only, no other face is visited.
  [[nodiscard]] Result measure(const Repaired& repaired) const;

  /// Finds the faces that measure() would find to be far, in a part of the time. If the latest step
  /// is known, only faces that it may have taken beyond the bound are measured.
  [[nodiscard]] FarFaces find_far(const Repaired& repaired) const;

  /// Measures parts of the input separately: the distance of their faces from the new surface, and
  /// the distance of the faces made of them from the input.
  ///
  /// @param part_of  #faces of the input: the part of each face, or kNoIndex.
  /// @return         #parts: the value of Result::largest for each.
  [[nodiscard]] std::vector<double> measure_parts(const Repaired& repaired,
                                                  std::span<const Index> part_of,
                                                  std::size_t n_parts) const;

 private:
  struct Surface;
  /// Returns the faces that differ between the two meshes, without those of the input that are
  /// walls, lost on purpose, or not affected by the latest step.
  [[nodiscard]] ChangedFaces find_measured_faces(const Repaired& repaired) const;
  /// Removes the faces of the input that the latest step has left as near as they were.
  void drop_unaffected(const Repaired& repaired, std::vector<ChangedFace>& of_input) const;
  /// @param own_walls  The walls that were parts of the changed faces; others may be near them too.
  /// @param question   If it is IsWithin, Result::largest is meaningless.
  [[nodiscard]] Result measure_changes(ChangedFaces changes, const Repaired& repaired,
                                       std::span<const InteriorWall> own_walls,
                                       DistanceQuestion question) const;

  const Soup& input_;
  std::unique_ptr<Surface> surface_;
  /// Indexed by face key - number of the input's faces: non-zero for patches that are included.
  std::vector<std::uint8_t> is_included_;
};

}  // namespace meshalyzer
