#include "meshalyzer/mesh/build.h"
#include "meshalyzer/mesh/validate.h"
#include "meshalyzer/repair/fix_defects.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// On so few points nearly all faces meet each other: more of them only take longer.
constexpr std::size_t kMaxFaces = 24;
constexpr std::size_t kMaxFacesToCut = 12;
constexpr std::size_t kMaxBytes = 96;
/// A repair is done after the first run, but for meshes where a patch of a hole, part of the
/// surface the next time, lets more be done.
constexpr std::size_t kMaxRuns = 5;

/// Gives one byte after the other, zeros when all have been taken.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  [[nodiscard]] unsigned next() { return at_ < size_ ? data_[at_++] : 0U; }
  [[nodiscard]] bool next_bit() { return next() % 2U != 0; }
  [[nodiscard]] std::size_t left() const { return size_ - at_; }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t at_ = 0;
};

RepairOptions read_options(Bytes& bytes) {
  RepairOptions options;
  options.borders = bytes.next_bit() ? Borders::Intended : Borders::Holes;
  options.contact = bytes.next_bit() ? Contact::Keep : Contact::Part;
  options.groups = bytes.next_bit() ? Groups::Faces : Groups::Names;
  options.fill.shape = bytes.next_bit() ? FillShape::Smooth : FillShape::Auto;
  options.fill.sheets = bytes.next_bit() ? FillSheets::Yes : FillSheets::No;
  constexpr std::array<double, 6> kDeviations{0.001, 0.0, 1e-12, 0.05, 0.5, 10.0};
  options.max_deviation.value = kDeviations[bytes.next() % kDeviations.size()];
  if (!bytes.next_bit()) options.fixes.erase(DefectCode::SelfIntersection);
  const unsigned left_out = bytes.next();
  if (left_out < kDefectCodes) options.fixes.erase(all_defect_codes()[left_out]);
  if (bytes.next_bit()) options.fixes.insert(DefectCode::Numbering);
  return options;
}

/// On a lattice of 4 x 4 x 4 points, some of them a little off it: a byte a vertex.
Vec3 read_position(Bytes& bytes, double scale) {
  constexpr std::array<double, 4> kOffsets{0.0, 0.0, 1e-10, 0.25};
  const unsigned code = bytes.next();
  Vec3 position(code % 4U, code / 4U % 4U, code / 16U % 4U);
  position.x() += kOffsets[code / 64U];
  return scale * position;
}

/// Few points and many faces, so that nearly everything coincides; one corner value stands for a
/// missing vertex.
Soup read_soup(Bytes& bytes, std::size_t max_faces) {
  constexpr std::array<double, 4> kScales{1.0, 1e-3, 1e-310, 1e305};
  constexpr std::array<Format, 3> kFormats{Format::Mesh, Format::Obj, Format::Ply};
  Soup soup;
  const double scale = kScales[bytes.next() % kScales.size()];
  soup.format = kFormats[bytes.next() % kFormats.size()];
  const unsigned n_vertices = 1U + bytes.next() % 24U;
  for (unsigned i = 0; i < n_vertices; ++i) {
    soup.positions.push_back(read_position(bytes, scale));
  }
  while (bytes.left() >= 3 && soup.n_faces() < max_faces) {
    const auto face = static_cast<Index>(soup.n_faces());
    Triangle triangle{};
    for (std::uint8_t corner = 0; corner < 3; ++corner) {
      const unsigned value = bytes.next() % (n_vertices + 1U);
      triangle[corner] = value == n_vertices ? kNoIndex : value;
      if (value == n_vertices) soup.missing.push_back({face, corner, 1000});
    }
    if (face % 16 == 5) soup.groups.push_back({"group", face});
    soup.triangles.push_back(triangle);
  }
  if (soup.format == Format::Ply) {
    for (const Vec3& p : soup.positions) soup.normals.push_back(Vec3(1, 1, 1) - p / scale);
    soup.corner_normals = soup.triangles;
  }
  return soup;
}

/// Tells whether each face that is not there any more is in the log.
bool names_all_that_went(const Soup& input, const RepairResult& result) {
  std::vector<std::uint8_t> is_known(input.n_faces(), 0);
  const auto know = [&](const std::vector<Index>& keys) {
    for (const Index key : keys) {
      if (key < is_known.size()) is_known[key] = 1;
    }
  };
  know(result.meshes.front().tracked.face_keys);
  for (const LoggedOperation& operation : result.log.operations) know(operation.removed_faces);
  return std::all_of(is_known.begin(), is_known.end(), [](auto known) { return known != 0; });
}

void check(const Soup& input, const RepairResult& result) {
  const Soup& soup = result.meshes.front().tracked.soup;
  const auto is_finite = [](const Vec3& p) { return p.allFinite(); };
  if (!validate(build(soup), soup).empty() || !(result.deviation <= result.max_deviation) ||
      !std::all_of(soup.positions.begin(), soup.positions.end(), is_finite) ||
      !names_all_that_went(input, result)) {
    __builtin_trap();
  }
}

}  // namespace
}  // namespace meshalyzer

/// Options and a small mesh. However broken it is, repairing it must end, keep the deviation, give
/// a mesh that the independent checker finds no fault with, and come to an end when repeated.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace meshalyzer;
  // Longer ones say nothing more, and the meshes that other targets begin with are such.
  if (size > kMaxBytes) return 0;
  Bytes bytes(data, size);
  const RepairOptions options = read_options(bytes);
  const bool cuts = options.fixes.contains(DefectCode::SelfIntersection);
  Soup soup = read_soup(bytes, cuts ? kMaxFacesToCut : kMaxFaces);
  for (std::size_t run = 0; run < kMaxRuns; ++run) {
    RepairResult result = fix_defects(soup, options);
    check(soup, result);
    // Where nearly all faces cross, cutting finds more to do in what it has made, run after run.
    if (result.log.operations.empty() || cuts) return 0;
    soup = std::move(result.meshes.front().tracked.soup);
  }
  __builtin_trap();
}
