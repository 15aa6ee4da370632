#include "meshalyzer/repair/cut/internal/estimated_windings.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/triangle.h"
#include "meshalyzer/spatial/winding_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>

namespace meshalyzer {
namespace {

/// The number of pieces that are sampled of those with the same cells on both sides: fewer if there
/// are so many such patches that all samples together would be more than kSamples.
constexpr std::size_t kMostSamplesOfPatch = 64;
constexpr std::size_t kLeastSamplesOfPatch = 4;
constexpr std::size_t kSamples = 4096;
/// A winding number is whole if it is no farther than this from an integer. It comes as near as 1/4
/// beside a sheet that another one crosses.
constexpr double kNearWhole = 0.15;

/// The estimate beside one piece.
struct Sample {
  Index piece = kNoIndex;
  /// Twice the area that the sample represents.
  double area = 0.0;
  /// The winding number in front of the piece.
  double front = 0.0;
};

/// Pieces that have the same cells on both sides, by component and these cells.
using Patches = std::map<std::array<Index, 3>, std::vector<Sample>>;

Patches find_patches(const ArrangedSoup& a, std::span<const std::uint8_t> wanted) {
  Patches patches;
  for (Index piece = 0; piece < a.arrangement.pieces.size(); ++piece) {
    const Index component = a.cells.component_of[piece];
    if (wanted[component] == 0) continue;
    patches[{component, a.cells.front(piece), a.cells.behind(piece)}].push_back(
        {.piece = piece, .area = normal_of(a.arrangement.corners_of(piece)).norm()});
  }
  return patches;
}

/// Chooses pieces of a patch evenly, in the order of the pieces, and gives to each the same share
/// of the area of the patch.
void choose_from(const std::vector<Sample>& pieces, std::size_t most,
                 std::vector<Sample>& samples) {
  const std::size_t n = std::min(pieces.size(), most);
  double area = 0.0;
  for (const Sample& sample : pieces) area += sample.area;
  for (std::size_t i = 0; i < n; ++i) {
    Sample sample = pieces[i * pieces.size() / n];
    if (n < pieces.size()) sample.area = area / static_cast<double>(n);
    samples.push_back(sample);
  }
}

/// Selects pieces of each patch.
std::vector<Sample> choose_samples(const Patches& patches) {
  const std::size_t n_of_patch = std::clamp(kSamples / std::max<std::size_t>(1, patches.size()),
                                            kLeastSamplesOfPatch, kMostSamplesOfPatch);
  std::vector<Sample> samples;
  for (const auto& [sides, pieces] : patches) choose_from(pieces, n_of_patch, samples);
  return samples;
}

/// Selects pieces of the patches of each component together, whatever their patches.
std::vector<Sample> choose_few_samples(const Patches& patches) {
  std::vector<Sample> samples;
  std::vector<Sample> of_component;
  for (auto patch = patches.begin(); patch != patches.end();) {
    const Index component = patch->first[0];
    of_component.clear();
    for (; patch != patches.end() && patch->first[0] == component; ++patch) {
      of_component.insert(of_component.end(), patch->second.begin(), patch->second.end());
    }
    choose_from(of_component, kSamples, samples);
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

void estimate(const ArrangedSoup& a, const WindingNumbers& windings, std::vector<Sample>& samples) {
  parallel_chunks(samples.size(), 256, [&](Chunk chunk) {
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      Sample& sample = samples[i];
      // On the piece itself, the winding number is half-way between those on both sides.
      sample.front = windings.at(centroid_of(a.arrangement.corners_of(sample.piece))) -
                     0.5 * a.arrangement.multiplicity(sample.piece);
    }
  });
}

/// #components: 1 for those of which at least half of the area separates whole winding numbers.
std::vector<std::uint8_t> find_solids(const Cells& cells, std::span<const Sample> samples) {
  std::vector<double> whole(cells.n_components, 0.0);
  for (const Sample& sample : samples) {
    const bool is_whole = std::abs(sample.front - std::round(sample.front)) <= kNearWhole;
    whole[cells.component_of[sample.piece]] += is_whole ? sample.area : -sample.area;
  }
  std::vector<std::uint8_t> solids(whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) solids[i] = whole[i] > 0.0 ? 1 : 0;
  return solids;
}

/// Removes the patches of sheets if there are so many that sampling each would take long.
void drop_sheets(const ArrangedSoup& a, const WindingNumbers& windings, Patches& patches) {
  if (patches.size() <= kSamples) return;
  std::vector<Sample> samples = choose_few_samples(patches);
  estimate(a, windings, samples);
  const std::vector<std::uint8_t> solids = find_solids(a.cells, samples);
  std::erase_if(patches, [&](const auto& patch) { return solids[patch.first[0]] == 0; });
}

}  // namespace

EstimatedWindings estimate_windings(const ArrangedSoup& arranged,
                                    std::span<const std::uint8_t> wanted) {
  const Cells& cells = arranged.cells;
  EstimatedWindings result{.of_cell = std::vector<double>(cells.count, 0.0),
                           .bounds_solid = std::vector<std::uint8_t>(cells.n_components, 0)};
  Patches patches = find_patches(arranged, wanted);
  if (patches.empty()) return result;
  const WindingNumbers windings = windings_of(arranged.soup);
  drop_sheets(arranged, windings, patches);
  std::vector<Sample> samples = choose_samples(patches);
  estimate(arranged, windings, samples);
  std::vector<double> areas(cells.count, 0.0);
  for (const Sample& sample : samples) {
    const double behind = sample.front + arranged.arrangement.multiplicity(sample.piece);
    result.of_cell[cells.front(sample.piece)] += sample.area * sample.front;
    result.of_cell[cells.behind(sample.piece)] += sample.area * behind;
    areas[cells.front(sample.piece)] += sample.area;
    areas[cells.behind(sample.piece)] += sample.area;
  }
  for (std::size_t i = 0; i < cells.count; ++i) {
    if (areas[i] > 0.0) result.of_cell[i] /= areas[i];
  }
  result.bounds_solid = find_solids(cells, samples);
  return result;
}

}  // namespace meshalyzer
