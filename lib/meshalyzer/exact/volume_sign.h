#pragma once

#include "meshalyzer/exact/predicates.h"

#include <memory>

namespace meshalyzer {

/// Adds up det(a, b, c) over triangles without any rounding, for the sign of the volume they
/// enclose.
class ExactVolume {
 public:
  ExactVolume();
  ~ExactVolume();
  ExactVolume(ExactVolume&&) noexcept;
  ExactVolume& operator=(ExactVolume&&) noexcept;

  void add(const Vec3& a, const Vec3& b, const Vec3& c);
  [[nodiscard]] Sign sign() const;

 private:
  struct Sum;
  std::unique_ptr<Sum> sum_;
};

}  // namespace meshalyzer
