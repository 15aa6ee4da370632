#include "meshalyzer/exact/exact_volume.h"

#include <CGAL/Mpzf.h>

namespace meshalyzer {

using Exact = CGAL::Mpzf;

struct ExactVolume::Sum {
  Exact value = Exact(0);
};

ExactVolume::ExactVolume() : sum_(std::make_unique<Sum>()) {}
ExactVolume::~ExactVolume() = default;
ExactVolume::ExactVolume(ExactVolume&&) noexcept = default;
ExactVolume& ExactVolume::operator=(ExactVolume&&) noexcept = default;

void ExactVolume::add(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Exact bx(b.x());
  const Exact by(b.y());
  const Exact bz(b.z());
  const Exact cx(c.x());
  const Exact cy(c.y());
  const Exact cz(c.z());
  const Exact determinant = Exact(a.x()) * (by * cz - bz * cy) +
                            Exact(a.y()) * (bz * cx - bx * cz) + Exact(a.z()) * (bx * cy - by * cx);
  sum_->value = sum_->value + determinant;
}

Sign ExactVolume::sign() const {
  return static_cast<Sign>(sum_->value.sign());
}

double ExactVolume::value() const {
  return CGAL::to_double(sum_->value) / 6;
}

}  // namespace meshalyzer
