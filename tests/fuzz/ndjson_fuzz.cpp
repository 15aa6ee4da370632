#include "changed_line.h"
#include "check_parser.h"
#include "meshalyzer/report/journal/line.h"

#include <limits>
#include <vector>

namespace {

using namespace meshalyzer;

const std::vector<std::string> kNames{"a.mesh", "b\xE9.mesh", "c \"c\".off"};

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Request full_request() {
  Request request;
  request.mesh.goodness = GoodnessThresholds{2.5, 10, kInfinity};
  request.mesh.curvature = VertexArea::OneRing;
  request.is_set = true;
  request.between.separation = SeparationOptions{.search_radius = 0.1};
  request.between.statistics = false;
  return request;
}

/// Something in every list, and what JSON cannot say.
std::string good_line() {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  ObjectFindings findings;
  findings.owner = 1;
  findings.intersections = SetIntersections{
      .pairs = {{0, 3, 1, 17, ContactKind::Crossing}, {1, -5, 2, 6, ContactKind::Touching}},
      .contained = {{2, 1}},
      .partly_contained = {{1, 0}}};
  findings.separation =
      ObjectSeparation{.vertices = {20, -30, 40},
                       .distances = {-0.125, kNaN, kInfinity},
                       .objects = {2, kNoIndex, 0},
                       .faces = {6, 0, 7},
                       .points = {{1, 0.1, -0.0}, Vec3::Zero(), {kInfinity, 1e-300, 5}}};
  const LineHead head{.kind = LineHead::Kind::Between,
                      .number = 1,
                      .of = 3,
                      .path = "b\xE9.mesh",
                      .stamp = {12, -34},
                      .request = full_request(),
                      .set = "ab12"};
  return between_line(head, findings, kNames);
}

/// Any text is either refused by an InvalidArgument or makes a head and findings that a line of
/// them keeps.
void check(std::string_view text) {
  LineHead head;
  ObjectFindings findings;
  try {
    head = read_head(text);
    findings = read_between(text, kNames);
  } catch (const InvalidArgument&) {
    return;
  }
  const std::string line = between_line(head, findings, kNames);
  if (read_head(line) != head || between_line(head, read_between(line, kNames), kNames) != line) {
    std::abort();
  }
}

}  // namespace

/// The bytes are tried as a line, and then as changes to a good one.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string good = good_line();
  check(as_text(data, size));
  check(changed_line(good, data, size));
  return 0;
}
