#include "meshalyzer/repair/cut/internal/estimated_windings.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/spatial/winding_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>

namespace meshalyzer {
namespace {

/// So many pieces are looked at of those that have the same cells on both sides: fewer where there
/// are so many such patches that all samples together would be more than kSamples.
constexpr std::size_t kMostSamplesOfPatch = 64;
constexpr std::size_t kLeastSamplesOfPatch = 4;
constexpr std::size_t kSamples = 4096;
/// A winding number is whole where it is no farther than this from one. Beside a sheet that another
/// one crosses it comes as near as 1/4.
constexpr double kNearWhole = 0.15;

/// What is estimated beside one piece.
struct Sample {
  Index piece = kNoIndex;
  double area = 0.0;
  /// The winding number in front of the piece.
  double front = 0.0;
};

double area_of(const Arrangement& arrangement, Index piece) {
  const Triangle& t = arrangement.pieces[piece];
  const Vec3& p = arrangement.positions[t[0]];
  return (arrangement.positions[t[1]] - p).cross(arrangement.positions[t[2]] - p).norm();
}

/// Chooses pieces of each patch evenly, in the order of the pieces, and gives to each the same
/// share of the area of the patch.
std::vector<Sample> choose_samples(const ArrangedSoup& a, std::span<const std::uint8_t> wanted) {
  std::map<std::array<Index, 3>, std::vector<Sample>> patches;
  for (Index piece = 0; piece < a.arrangement.pieces.size(); ++piece) {
    const Index component = a.cells.component_of[piece];
    if (wanted[component] == 0) continue;
    patches[{component, a.cells.front(piece), a.cells.behind(piece)}].push_back(
        {.piece = piece, .area = area_of(a.arrangement, piece)});
  }
  const std::size_t n_of_patch = std::clamp(kSamples / std::max<std::size_t>(1, patches.size()),
                                            kLeastSamplesOfPatch, kMostSamplesOfPatch);
  std::vector<Sample> samples;
  for (const auto& [sides, pieces] : patches) {
    const std::size_t n = std::min(pieces.size(), n_of_patch);
    double area = 0.0;
    for (const Sample& sample : pieces) area += sample.area;
    for (std::size_t i = 0; i < n; ++i) {
      Sample sample = pieces[i * pieces.size() / n];
      if (n < pieces.size()) sample.area = area / static_cast<double>(n);
      samples.push_back(sample);
    }
  }
  return samples;
}

WindingNumbers windings_of(const Soup& soup) {
  std::vector<Corners> triangles;
  triangles.reserve(soup.n_faces());
  for (Index face = 0; face < soup.n_faces(); ++face) {
    triangles.push_back(corners_of(soup, face));
  }
  return WindingNumbers(std::move(triangles));
}

void estimate(const ArrangedSoup& a, std::vector<Sample>& samples) {
  const WindingNumbers windings = windings_of(a.soup);
  parallel_chunks(samples.size(), 256, [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      Sample& sample = samples[i];
      const Triangle& t = a.arrangement.pieces[sample.piece];
      const Vec3& p = a.arrangement.positions[t[0]];
      const Vec3& q = a.arrangement.positions[t[1]];
      const Vec3& r = a.arrangement.positions[t[2]];
      // On the piece itself it is half-way between those on both sides.
      sample.front =
          windings.at((p + q + r) / 3.0) - 0.5 * a.arrangement.multiplicity(sample.piece);
    }
  });
}

}  // namespace

EstimatedWindings estimate_windings(const ArrangedSoup& arranged,
                                    std::span<const std::uint8_t> wanted) {
  const Cells& cells = arranged.cells;
  EstimatedWindings result{.of_cell = std::vector<double>(cells.count, 0.0),
                           .bounds_solid = std::vector<std::uint8_t>(cells.n_components, 0)};
  std::vector<Sample> samples = choose_samples(arranged, wanted);
  if (samples.empty()) return result;
  estimate(arranged, samples);
  std::vector<double> areas(cells.count, 0.0);
  std::vector<double> whole(cells.n_components, 0.0);
  for (const Sample& sample : samples) {
    const double behind = sample.front + arranged.arrangement.multiplicity(sample.piece);
    result.of_cell[cells.front(sample.piece)] += sample.area * sample.front;
    result.of_cell[cells.behind(sample.piece)] += sample.area * behind;
    areas[cells.front(sample.piece)] += sample.area;
    areas[cells.behind(sample.piece)] += sample.area;
    const bool is_whole = std::abs(sample.front - std::round(sample.front)) <= kNearWhole;
    whole[cells.component_of[sample.piece]] += is_whole ? sample.area : -sample.area;
  }
  for (std::size_t i = 0; i < cells.count; ++i) {
    if (areas[i] > 0.0) result.of_cell[i] /= areas[i];
  }
  for (std::size_t i = 0; i < whole.size(); ++i) result.bounds_solid[i] = whole[i] > 0.0 ? 1 : 0;
  return result;
}

}  // namespace meshalyzer
