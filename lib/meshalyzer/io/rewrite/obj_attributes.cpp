#include "meshalyzer/io/rewrite/obj_attributes.h"

#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/rewrite/text_lines.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace meshalyzer {
namespace {

std::string text_of(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) {
    text += ' ';
    append_shortest(text, number);
  }
  return text;
}

}  // namespace

ObjAttributes::ObjAttributes(const EditedMesh& mesh, std::string_view text,
                             const ObjRecords& records)
    : mesh_(mesh),
      text_(text),
      records_(records),
      has_none_(records.texture_points.empty() && mesh.soup.corner_normals.empty()),
      blender_(mesh, records.face_records, [this](Index a, Index b) {
        return source_corner(a).texture_point == source_corner(b).texture_point;
      }) {}

Index ObjAttributes::NewRecords::insert(std::string value) {
  const auto [entry, is_new] = numbers.emplace(value, static_cast<Index>(values.size()));
  if (is_new) {
    values.push_back(std::move(value));
  }
  return entry->second;
}

ObjCorner ObjAttributes::corner(FanCorner corner) {
  ObjCorner named;
  named.vertex = mesh_.soup.triangles[corner.triangle][corner.corner];
  if (has_none_) return named;
  const Blend blend = blender_.blend(corner);
  if (blend.is_empty()) {
    named.normal = normal(corner, kNoIndex);
    return named;
  }
  named.texture_point = texture_point(blend);
  named.normal = normal(corner, source_corner(blend.main_item()).normal);
  return named;
}

Index ObjAttributes::normal(FanCorner corner, Index named) {
  if (mesh_.soup.corner_normals.empty()) {
    return kNoIndex;
  }
  const Index wanted = mesh_.soup.corner_normals[corner.triangle][corner.corner];
  if (wanted == kNoIndex) {
    return kNoIndex;
  }
  const Vec3& value = mesh_.soup.normals[wanted];
  const std::vector<Vec3>& old = mesh_.source.normals;
  const Index vertex = mesh_.soup.triangles[corner.triangle][corner.corner];
  for (const Index candidate : {named, wanted, mesh_.vertices[vertex].record}) {
    if (candidate < old.size() && old[candidate] == value) {
      return candidate;
    }
  }
  return static_cast<Index>(old.size()) +
         normals_.insert(text_of({value.x(), value.y(), value.z()}));
}

Index ObjAttributes::texture_point(const Blend& blend) {
  const auto is_known = [&](Index item) {
    return item == kNoIndex || source_corner(item).texture_point < records_.texture_points.size();
  };
  if (!std::all_of(blend.items.begin(), blend.items.end(), is_known)) {
    return kNoIndex;
  }
  const auto named = [&](Index item) { return source_corner(item).texture_point; };
  const Index first = named(blend.items[0]);
  if (std::all_of(blend.items.begin(), blend.items.end(),
                  [&](Index item) { return item == kNoIndex || named(item) == first; })) {
    return first;
  }
  std::vector<double> mean = texture_numbers(first);
  for (std::size_t i = 0; i < mean.size(); ++i) {
    mean[i] = blend.mean([&](Index item) {
      const std::vector<double>& numbers = texture_numbers(named(item));
      return i < numbers.size() ? numbers[i] : 0.0;
    });
  }
  return static_cast<Index>(records_.texture_points.size()) + texture_points_.insert(text_of(mean));
}

const std::vector<double>& ObjAttributes::texture_numbers(Index texture_point) {
  const auto [entry, is_new] = texture_numbers_.try_emplace(texture_point);
  std::vector<double>& numbers = entry->second;
  if (!is_new) return numbers;
  const std::vector<std::string_view> words =
      words_at(text_, records_.texture_points[texture_point], Continuation::Backslash);
  for (std::size_t i = 1; i < words.size(); ++i) {
    numbers.push_back(parse_real(words[i]).value_or(0.0));
  }
  return numbers;
}

ObjCorner ObjAttributes::source_corner(Index number) {
  const FanCorner corner = corner_of_number(number);
  const Index record = records_.face_records.record_of(corner.triangle);
  return source_corners(record)[local_corner(records_.face_records, record, corner)];
}

const std::vector<ObjCorner>& ObjAttributes::source_corners(Index record) {
  if (record == latest_record_) {
    return latest_corners_;
  }
  latest_record_ = record;
  latest_corners_.clear();
  const std::size_t begin = records_.faces[record];
  const ObjCounts counts = records_.counts_before(begin);
  const std::vector<std::string_view> words = words_at(text_, begin, Continuation::Backslash);
  const TextScanner no_scanner(text_);
  for (std::size_t i = 1; i < words.size(); ++i) {
    latest_corners_.push_back(parse_obj_corner(words[i], counts, no_scanner));
  }
  // A triangle with fewer corners repeats its last one.
  latest_corners_.resize(std::max<std::size_t>(latest_corners_.size(), 3), latest_corners_.back());
  return latest_corners_;
}

}  // namespace meshalyzer
