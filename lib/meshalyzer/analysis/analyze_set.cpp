#include "meshalyzer/analysis/analyze.h"
#include "meshalyzer/base/sum.h"

namespace meshalyzer {

SetAnalysis analyze_set(std::span<const Analysis> meshes, std::size_t unreadable) {
  SetAnalysis set;
  set.meshes = meshes.size();
  set.unreadable = unreadable;
  CompensatedSum area;
  CompensatedSum volume;
  std::size_t without_volume = 0;
  for (const Analysis& mesh : meshes) {
    const Characteristics& c = mesh.characteristics;
    set.good += mesh.goodness && mesh.goodness->good ? 1 : 0;
    set.vertices += c.vertices;
    set.faces += c.faces;
    set.edges += c.edges;
    set.components += c.components;
    set.boundaries += c.boundaries;
    set.intersecting_pairs_within += c.intersecting_pairs;
    area.add(c.area);
    volume.add(c.volume.value.value_or(0.0));
    without_volume += c.volume.value ? 0 : 1;
  }
  set.area = area.value();
  if (without_volume < meshes.size()) {
    set.volume.value = volume.value();
  }
  if (without_volume != 0) {
    set.volume.reason = "meshes without a volume: " + std::to_string(without_volume);
  }
  return set;
}

}  // namespace meshalyzer
