#include "meshalyzer/io/attributes.h"

#include <algorithm>
#include <array>

namespace meshalyzer {
namespace {

struct KindNames {
  std::string_view one;
  std::string_view many;
  std::string_view key;
};

constexpr std::array<KindNames, 18> kKindNames = {{
    {"polygon", "polygons", "polygons"},
    {"normal", "normals", "normals"},
    {"texture coordinate", "texture coordinates", "texture_coordinates"},
    {"vertex colour", "vertex colours", "vertex_colours"},
    {"face colour", "face colours", "face_colours"},
    {"absent colour", "absent colours", "absent_colours"},
    {"material", "materials", "materials"},
    {"group", "groups", "groups"},
    {"smoothing group", "smoothing groups", "smoothing_groups"},
    {"reference", "references", "references"},
    {"vertex property", "vertex properties", "vertex_properties"},
    {"face property", "face properties", "face_properties"},
    {"attribute word", "attribute words", "attribute_words"},
    {"line or point", "lines and points", "lines_and_points"},
    {"other record", "other records", "other_records"},
    {"other statement", "other statements", "other_statements"},
    {"header", "headers", "headers"},
    {"comment", "comments", "comments"},
}};

const KindNames& names_of(AttributeKind kind) {
  return kKindNames[static_cast<std::size_t>(kind)];
}

}  // namespace

std::string attribute_text(const AttributeCount& count) {
  std::string text = std::to_string(count.count);
  text += ' ';
  text += count.count == 1 ? names_of(count.kind).one : names_of(count.kind).many;
  return text;
}

std::string_view attribute_key(AttributeKind kind) {
  return names_of(kind).key;
}

std::vector<AttributeCount> summed(std::vector<AttributeCount> counts) {
  std::stable_sort(
      counts.begin(), counts.end(),
      [](const AttributeCount& a, const AttributeCount& b) { return a.kind < b.kind; });
  std::vector<AttributeCount> sums;
  for (const AttributeCount& count : counts) {
    if (count.count == 0) {
      continue;
    }
    if (sums.empty() || sums.back().kind != count.kind) {
      sums.push_back({count.kind, 0});
    }
    sums.back().count += count.count;
  }
  return sums;
}

}  // namespace meshalyzer
