#include "meshalyzer/repair/guarantee/internal/boundary_loss.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/mesh/used_box.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
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
                           const FaceTree& tree, double limit)
    : mesh_(std::move(mesh)), pieces_(pieces), closest_(tree) {
  const std::vector<PieceSample> samples = sample_pieces(pieces_.corners, mesh_->spacing());
  std::vector<double> upper_bounds(samples.size(), std::numeric_limits<double>::infinity());
  parallel_chunks(samples.size(), kSamplesOfTask, [&](Chunk chunk) {
    Index hint = kNoIndex;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const auto found = closest_.find(
          {.point = samples[i].point, .within = limit, .hint = hint, .near_enough = limit});
      if (!found) continue;
      hint = found->slot;
      upper_bounds[i] = found->distance;
    }
  });
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (upper_bounds[i] <= limit) {
      near_.push_back({samples[i], upper_bounds[i]});
    } else {
      far_.push_back(samples[i]);
    }
  }
}

std::vector<BoundarySample> BoundaryLoss::beyond_limit() const {
  const std::vector<PieceSample> far = on_boundary(far_);
  const std::vector<double> distances = distances_of(far);
  std::vector<BoundarySample> lost;
  for (std::size_t i = 0; i < far.size(); ++i) {
    lost.push_back({far[i].point, pieces_.face_keys[far[i].piece], distances[i]});
  }
  return lost;
}

double BoundaryLoss::largest_within_limit(double least,
                                          const std::function<bool(const Vec3&)>& counts) const {
  std::vector<PieceSample> samples;
  for (const auto& [sample, upper_bound] : near_) {
    if (upper_bound > least) samples.push_back(sample);
  }
  const std::vector<double> distances = distances_of(samples);
  std::vector<std::size_t> farthest_first;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (distances[i] > least) farthest_first.push_back(i);
  }
  std::sort(farthest_first.begin(), farthest_first.end(),
            [&](std::size_t a, std::size_t b) { return distances[a] > distances[b]; });
  for (const std::size_t i : farthest_first) {
    if (is_on_boundary(samples[i]) && counts(samples[i].point)) return distances[i];
  }
  return least;
}

std::vector<PieceSample> BoundaryLoss::on_boundary(std::span<const PieceSample> samples) const {
  std::vector<std::uint8_t> is_on(samples.size());
  parallel_chunks(samples.size(), kSamplesOfTask, [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) is_on[i] = is_on_boundary(samples[i]);
  });
  std::vector<PieceSample> found;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (is_on[i] != 0) found.push_back(samples[i]);
  }
  return found;
}

std::vector<double> BoundaryLoss::distances_of(std::span<const PieceSample> samples) const {
  std::vector<double> distances(samples.size());
  parallel_chunks(samples.size(), kSamplesOfTask, [&](Chunk chunk) {
    Index hint = kNoIndex;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const auto found = closest_.find({.point = samples[i].point, .hint = hint});
      hint = found->slot;
      distances[i] = found->distance;
    }
  });
  return distances;
}

bool BoundaryLoss::is_on_boundary(const PieceSample& sample) const {
  return mesh_->boundary().is_at(sample.point, pieces_.corners[sample.piece]);
}

}  // namespace meshalyzer
