#include "meshalyzer/arrangement/arrangement.h"

#include "meshalyzer/exact/exact_point.h"

#include <utility>

namespace meshalyzer {

ExactVertices::ExactVertices(std::vector<ExactPoint> made)
    : made_(std::make_shared<const std::vector<ExactPoint>>(std::move(made))) {}

const ExactPoint& ExactVertices::made(std::size_t i) const {
  return (*made_)[i];
}

int Arrangement::multiplicity(std::size_t piece) const {
  int sum = 0;
  for (const PieceSource& source : sources_of(piece)) sum += source.sign;
  return sum;
}

}  // namespace meshalyzer
