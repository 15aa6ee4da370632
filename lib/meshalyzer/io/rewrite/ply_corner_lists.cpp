#include "meshalyzer/io/rewrite/ply_corner_lists.h"

#include "meshalyzer/io/ply_names.h"

#include <algorithm>

namespace meshalyzer {

PlyCornerLists::PlyCornerLists(const EditedMesh& mesh, const PlyRecords& records,
                               const PlyFaces& faces, const FaceRecords& face_records)
    : records_(records),
      faces_(faces),
      face_records_(face_records),
      blender_(mesh, face_records, [this](Index a, Index b) { return has_same_numbers(a, b); }) {}

bool PlyCornerLists::has_list(const PlyRecord& record, std::size_t property) const {
  return is_one_of(faces_.element.properties[property].name, kPlyCornerTexture) &&
         record.fields[property].items.size() == 2 * record.fields[faces_.corners].items.size();
}

std::array<std::string, 2> PlyCornerLists::numbers(const Blend& blend, std::size_t property) const {
  const PlyType type = faces_.element.properties[property].type;
  std::array<std::string, 2> texts;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto single = blend.is_single() ? items_of(blend.items[0], property) : std::nullopt;
    const auto number = [&](Index corner) {
      const auto items = items_of(corner, property);
      return items ? records_.number((*items)[i], type) : 0.0;
    };
    texts[i] = single ? std::string((*single)[i]) : records_.text(blend.mean(number), type);
  }
  return texts;
}

std::optional<std::array<std::string_view, 2>> PlyCornerLists::items_of(
    Index corner, std::size_t property) const {
  const FanCorner place = corner_of_number(corner);
  const Index record = face_records_.record_of(place.triangle);
  const PlyRecord read = records_.read(faces_.number, record);
  if (!has_list(read, property)) {
    return std::nullopt;
  }
  const std::vector<std::string_view>& items = read.fields[property].items;
  // A triangle with fewer corners repeats its last one.
  const std::size_t local =
      std::min(local_corner(face_records_, record, place), items.size() / 2 - 1);
  return std::array<std::string_view, 2>{items[2 * local], items[2 * local + 1]};
}

bool PlyCornerLists::has_same_numbers(Index a, Index b) const {
  for (std::size_t p = 0; p < faces_.element.properties.size(); ++p) {
    if (is_one_of(faces_.element.properties[p].name, kPlyCornerTexture) &&
        items_of(a, p) != items_of(b, p)) {
      return false;
    }
  }
  return true;
}

}  // namespace meshalyzer
