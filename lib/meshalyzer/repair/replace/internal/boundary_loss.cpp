#include "meshalyzer/repair/replace/internal/boundary_loss.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/mesh/used_box.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace meshalyzer {
namespace {

/// The distance between samples, as a share of the diagonal.
constexpr double kSampleSpacing = 1.0 / 128.0;
/// So many samples are worth a task.
constexpr std::size_t kSamplesOfTask = 256;

}  // namespace

ReplacedMesh::ReplacedMesh(const TrackedMesh& mesh, double reach)
    : face_keys_(mesh.face_keys), reach_(reach) {
  soup_.positions = mesh.soup.positions;
  soup_.triangles = mesh.soup.triangles;
}

bool ReplacedMesh::is(const TrackedMesh& mesh) const {
  return soup_.positions == mesh.soup.positions && soup_.triangles == mesh.soup.triangles &&
         face_keys_ == mesh.face_keys;
}

double ReplacedMesh::spacing() const {
  return kSampleSpacing * used_box(soup_).diagonal().norm();
}

const SolidBoundary& ReplacedMesh::boundary() const {
  return boundary_.get([&] { return SolidBoundary(soup_, reach_); });
}

BoundaryLoss::BoundaryLoss(std::shared_ptr<const ReplacedMesh> mesh, const FacePieces& pieces,
                           const FaceTree& tree, double near_enough)
    : mesh_(std::move(mesh)), pieces_(pieces), closest_(tree), near_enough_(near_enough) {
  for (const PieceSample& sample : sample_pieces(pieces_.corners, mesh_->spacing())) {
    samples_.push_back({.sample = sample});
  }
  measure(samples_, near_enough_);
}

void BoundaryLoss::measure(std::vector<Measured>& samples, double near_enough) const {
  parallel_chunks(samples.size(), kSamplesOfTask, [&](Chunk chunk) {
    Index hint = kNoIndex;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const auto found = closest_.find(
          {.point = samples[i].sample.point, .hint = hint, .near_enough = near_enough});
      hint = found->slot;
      samples[i].distance = found->distance;
    }
  });
}

std::vector<BoundaryLoss::Measured> BoundaryLoss::samples_beyond(double distance) const {
  const auto is_nearer = [&](const Measured& measured) { return measured.distance <= distance; };
  std::vector<Measured> beyond;
  std::remove_copy_if(samples_.begin(), samples_.end(), std::back_inserter(beyond), is_nearer);
  if (distance < near_enough_) {
    measure(beyond, distance);
    std::erase_if(beyond, is_nearer);
  }
  return beyond;
}

std::vector<BoundarySample> BoundaryLoss::farther_than(double distance) const {
  const std::vector<Measured> far = samples_beyond(distance);
  std::vector<std::uint8_t> is_on(far.size());
  parallel_chunks(far.size(), kSamplesOfTask, [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) is_on[i] = is_on_boundary(far[i].sample);
  });
  std::vector<BoundarySample> lost;
  for (std::size_t i = 0; i < far.size(); ++i) {
    if (is_on[i] == 0) continue;
    const PieceSample& sample = far[i].sample;
    lost.push_back({sample.point, pieces_.face_keys[sample.piece], far[i].distance});
  }
  return lost;
}

double BoundaryLoss::largest_between(double low, double high,
                                     const std::function<bool(const Vec3&)>& counts) const {
  std::vector<Measured> between = samples_beyond(low);
  std::erase_if(between, [&](const Measured& measured) { return measured.distance > high; });
  std::sort(between.begin(), between.end(),
            [](const Measured& a, const Measured& b) { return a.distance > b.distance; });
  const auto first = std::find_if(between.begin(), between.end(), [&](const Measured& measured) {
    return is_on_boundary(measured.sample) && counts(measured.sample.point);
  });
  return first == between.end() ? low : first->distance;
}

bool BoundaryLoss::is_on_boundary(const PieceSample& sample) const {
  return mesh_->boundary().is_at(sample.point, pieces_.corners[sample.piece]);
}

}  // namespace meshalyzer
