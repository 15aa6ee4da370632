#pragma once

#include "meshalyzer/base/types.h"
#include "meshalyzer/spatial/triangle_contact.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace meshalyzer {

/// How many points are asked for, compared with the number of triangles.
enum class ExpectedQueries : std::uint8_t { Few, Many };

/// How much is approximated. For a surface that goes round once the error of Fine is below 0.01,
/// and that of Coarse, which takes about half the time, below 0.03.
enum class WindingAccuracy : std::uint8_t { Fine, Coarse };

/// The generalised winding numbers of a set of triangles, which say how often it goes round a
/// point: 1 inside a closed outward surface, 0 outside, a value in between if the surface is open
/// (Jacobson et al. 2013, "Robust inside-outside segmentation using generalized winding numbers").
///
/// Triangles far from the point are approximated together by three terms of an expansion (Barill et
/// al. 2018, "Fast winding numbers for soups and clouds"). Where many points are expected and the
/// boundary is short, the crossings of a ray with the surface, closed by other triangles, are
/// counted instead, and the winding number of the others is subtracted, which is several times as
/// fast. The numbers serve for estimates and votes, never for exact decisions. Reversing all
/// triangles by exchanging their last two corners negates all answers, to the last bit.
class WindingNumbers {
 public:
  /// @complexity O(n log n); more than twice as much where many queries are expected.
  explicit WindingNumbers(std::vector<Corners> triangles,
                          ExpectedQueries expected = ExpectedQueries::Few,
                          WindingAccuracy accuracy = WindingAccuracy::Fine);
  ~WindingNumbers();
  WindingNumbers(WindingNumbers&&) noexcept;
  WindingNumbers(const WindingNumbers&) = delete;
  WindingNumbers& operator=(const WindingNumbers&) = delete;

  /// Returns the winding number at a point; several threads may call it at a time. A point on
  /// triangles, or within 1e-12 of the size or within rounding of them, gets the mean of their two
  /// sides; on their edges a value in between.
  ///
  /// @complexity O(log n) on average.
  [[nodiscard]] double at(const Vec3& point) const;

  /// Returns the winding numbers at two points, such as those on both sides of a face; if they are
  /// near each other, both cost little more than one.
  [[nodiscard]] std::array<double, 2> at_both(const Vec3& first, const Vec3& second) const;

 private:
  struct Prepared;
  std::unique_ptr<const Prepared> prepared_;
};

}  // namespace meshalyzer
