#pragma once

#include "meshalyzer/exact/predicates.h"

#include <memory>

namespace meshalyzer {

/// Adds up det(a, b, c) over triangles without any rounding: six times the volume that they
/// enclose.
class ExactVolume {
 public:
  ExactVolume();
  ~ExactVolume();
  ExactVolume(ExactVolume&&) noexcept;
  ExactVolume& operator=(ExactVolume&&) noexcept;

  void add(const Vec3& a, const Vec3& b, const Vec3& c);
  [[nodiscard]] Sign sign() const;
  /// Returns the volume, rounded only once it is known; infinite if too large for a double.
  [[nodiscard]] double value() const;

 private:
  struct Sum;
  std::unique_ptr<Sum> sum_;
};

}  // namespace meshalyzer
