#include "meshalyzer/repair/cut/internal/estimated_windings.h"

#include "meshalyzer/base/parallel.h"
#include "meshalyzer/base/stop_query.h"
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
/// are so many such patches that all samples together would be more than kSamples. If there are
/// more patches than that, a patch is left out if both of its cells have samples beside other ones.
constexpr std::size_t kMostSamplesOfPatch = 64;
constexpr std::size_t kLeastSamplesOfPatch = 4;
constexpr std::size_t kSamples = 4096;
/// A component of many pieces is clearly a sheet if less than this share of a few samples separates
/// whole winding numbers, where half is needed: that is four standard deviations.
constexpr std::size_t kFewSamples = 64;
constexpr std::size_t kManyPieces = 4 * kFewSamples;
constexpr double kClearlySheet = 0.25;
constexpr double kHalf = 0.5;
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

double total_area(const std::vector<Sample>& pieces) {
  double area = 0.0;
  for (const Sample& piece : pieces) area += piece.area;
  return area;
}

/// Chooses pieces of a patch evenly, in the order of the pieces, and gives to each the same share
/// of the area of the patch.
void choose_from(const std::vector<Sample>& pieces, std::size_t most,
                 std::vector<Sample>& samples) {
  const std::size_t n = std::min(pieces.size(), most);
  const double area = total_area(pieces);
  for (std::size_t i = 0; i < n; ++i) {
    Sample sample = pieces[i * pieces.size() / n];
    if (n < pieces.size()) sample.area = area / static_cast<double>(n);
    samples.push_back(sample);
  }
}

/// Selects pieces of each patch with a cell that has no sample yet, the largest patch first.
std::vector<Sample> choose_for_each_cell(const Patches& patches, std::size_t n_cells) {
  struct Measured {
    double area = 0.0;
    const Patches::value_type* patch = nullptr;
  };
  std::vector<Measured> by_area;
  by_area.reserve(patches.size());
  for (const auto& patch : patches) by_area.push_back({total_area(patch.second), &patch});
  std::stable_sort(by_area.begin(), by_area.end(),
                   [](const Measured& a, const Measured& b) { return a.area > b.area; });
  std::vector<std::uint8_t> has_sample(n_cells, 0);
  std::vector<Sample> samples;
  for (const auto& [area, patch] : by_area) {
    const auto& [component, front, behind] = patch->first;
    if (has_sample[front] != 0 && has_sample[behind] != 0) continue;
    has_sample[front] = has_sample[behind] = 1;
    choose_from(patch->second, kLeastSamplesOfPatch, samples);
  }
  return samples;
}

/// Selects pieces of each patch.
std::vector<Sample> choose_samples(const Patches& patches, std::size_t n_cells) {
  if (patches.size() > kSamples) return choose_for_each_cell(patches, n_cells);
  const std::size_t n_of_patch = std::clamp(kSamples / std::max<std::size_t>(1, patches.size()),
                                            kLeastSamplesOfPatch, kMostSamplesOfPatch);
  std::vector<Sample> samples;
  for (const auto& [sides, pieces] : patches) choose_from(pieces, n_of_patch, samples);
  return samples;
}

/// Chooses pieces at equal steps through the area, in the order of the pieces.
void choose_by_area(const std::vector<Sample>& pieces, std::size_t most,
                    std::vector<Sample>& samples) {
  double step = 0.0;
  for (const Sample& sample : pieces) step += sample.area / static_cast<double>(most);
  if (!(step > 0.0)) return;
  double reached = 0.0;
  double next = step / 2;
  for (Sample sample : pieces) {
    reached += sample.area;
    sample.area = 0.0;
    for (; next < reached; next += step) sample.area += step;
    if (sample.area > 0.0) samples.push_back(sample);
  }
}

/// Selects pieces of each component with at least some number of pieces, whatever their patches.
std::vector<Sample> choose_of_components(const Patches& patches, std::size_t most,
                                         std::size_t least_pieces) {
  std::vector<Sample> samples;
  std::vector<Sample> of_component;
  for (auto patch = patches.begin(); patch != patches.end();) {
    const Index component = patch->first[0];
    of_component.clear();
    for (; patch != patches.end() && patch->first[0] == component; ++patch) {
      of_component.insert(of_component.end(), patch->second.begin(), patch->second.end());
    }
    if (of_component.size() >= least_pieces) choose_by_area(of_component, most, samples);
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

/// The area of a component that samples represent, and of the samples that separate whole winding
/// numbers.
struct Separation {
  double area = 0.0;
  double whole = 0.0;
};

/// #components.
std::vector<Separation> measure_separation(const Cells& cells, std::span<const Sample> samples) {
  std::vector<Separation> found(cells.n_components);
  for (const Sample& sample : samples) {
    const bool is_whole = std::abs(sample.front - std::round(sample.front)) <= kNearWhole;
    Separation& component = found[cells.component_of[sample.piece]];
    component.area += sample.area;
    if (is_whole) component.whole += sample.area;
  }
  return found;
}

/// Computes winding numbers beside pieces.
class Estimator {
 public:
  Estimator(const ArrangedSoup& arranged, const StopQuery& wants_to_stop)
      : a_(arranged), windings_(windings_of(arranged.soup)), wants_to_stop_(wants_to_stop) {}

  /// Sets the winding numbers of samples; all are 0 that are reached once it is to stop.
  void estimate(std::vector<Sample>& samples) const {
    parallel_chunks(samples.size(), 256, [&](Chunk chunk) {
      if (wants_to_stop_()) return;
      // Two samples at once take little more time than one; successive ones are mostly near.
      for (std::size_t i = chunk.begin; i < chunk.end; i += 2) {
        Sample& first = samples[i];
        Sample& second = samples[std::min(i + 1, chunk.end - 1)];
        const auto [of_first, of_second] = windings_.at_both(place_of(first), place_of(second));
        first.front = of_first - half_step(first);
        second.front = of_second - half_step(second);
      }
    });
  }

  /// Removes the patches of components that are clearly sheets, by a few samples; then those of
  /// all sheets, if there are so many patches that sampling each would take long.
  void drop_sheets(Patches& patches) const {
    drop_sheets(choose_of_components(patches, kFewSamples, kManyPieces), kClearlySheet, patches);
    if (patches.size() <= kSamples) return;
    drop_sheets(choose_of_components(patches, kSamples, 0), kHalf, patches);
  }

 private:
  [[nodiscard]] Vec3 place_of(const Sample& sample) const {
    return centroid_of(a_.arrangement.corners_of(sample.piece));
  }

  /// On the piece itself, the winding number is half-way between those on both sides.
  [[nodiscard]] double half_step(const Sample& sample) const {
    return 0.5 * a_.arrangement.multiplicity(sample.piece);
  }

  /// Removes the patches of components of which less than a share of the samples separates whole
  /// winding numbers.
  void drop_sheets(std::vector<Sample> samples, double share, Patches& patches) const {
    estimate(samples);
    const std::vector<Separation> found = measure_separation(a_.cells, samples);
    std::erase_if(patches, [&](const auto& patch) {
      return found[patch.first[0]].whole < share * found[patch.first[0]].area;
    });
  }

  const ArrangedSoup& a_;
  WindingNumbers windings_;
  const StopQuery& wants_to_stop_;
};

}  // namespace

EstimatedWindings estimate_windings(const ArrangedSoup& arranged,
                                    std::span<const std::uint8_t> wanted,
                                    const StopQuery& wants_to_stop) {
  const Cells& cells = arranged.cells;
  EstimatedWindings result{.of_cell = std::vector<double>(cells.count, 0.0),
                           .bounds_solid = std::vector<std::uint8_t>(cells.n_components, 0)};
  Patches patches = find_patches(arranged, wanted);
  if (patches.empty()) return result;
  const Estimator estimator(arranged, wants_to_stop);
  estimator.drop_sheets(patches);
  std::vector<Sample> samples = choose_samples(patches, cells.count);
  estimator.estimate(samples);
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
  const std::vector<Separation> separation = measure_separation(cells, samples);
  for (std::size_t i = 0; i < separation.size(); ++i) {
    result.bounds_solid[i] = separation[i].whole > kHalf * separation[i].area ? 1 : 0;
  }
  return result;
}

}  // namespace meshalyzer
