#include "meshalyzer/io/obj.h"

#include "meshalyzer/io/obj_corner.h"
#include "meshalyzer/io/print_record.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/io/text_scanner.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// The statements that do not concern the triangles: materials, lines, points, curves, free-form
/// surfaces, display.
constexpr std::array<std::string_view, 39> kSkippedKeywords = {
    "vt",       "vp",       "p",          "l",         "s",    "mg",    "usemtl", "mtllib",
    "usemap",   "maplib",   "shadow_obj", "trace_obj", "lod",  "bevel", "ctech",  "stech",
    "c_interp", "d_interp", "cstype",     "deg",       "bmat", "step",  "curv",   "curv2",
    "surf",     "parm",     "trim",       "hole",      "scrv", "sp",    "end",    "con",
    "call",     "csh",      "bsp",        "bzp",       "cdc",  "cdp",   "res"};

bool is_skipped(std::string_view word) {
  return std::find(kSkippedKeywords.begin(), kSkippedKeywords.end(), word) !=
         kSkippedKeywords.end();
}

/// Reads the statements of one file in order.
class ObjParser {
 public:
  explicit ObjParser(std::string_view text) : in_(text, Continuation::Backslash) {}

  Soup parse() {
    soup_.format = Format::Obj;
    while (in_.next_record()) {
      line_ = in_.line();
      parse_statement(in_.word());
      in_.end_record();
    }
    resolve_indices(soup_);
    resolve_normals();
    return std::move(soup_);
  }

 private:
  void parse_statement(std::string_view keyword) {
    if (keyword == "v") {
      parse_vertex();
    } else if (keyword == "f" || keyword == "fo") {
      parse_face();
    } else if (keyword == "vn") {
      soup_.normals.push_back(in_.point());
    } else if (keyword == "g" || keyword == "o") {
      soup_.groups.push_back({in_.rest_of_record(), static_cast<Index>(soup_.n_faces())});
    } else if (is_skipped(keyword)) {
      n_texture_points_ += keyword == "vt" ? 1 : 0;
      in_.skip_record();
    } else {
      in_.fault(in_quotes(keyword) + " is no keyword of OBJ");
    }
  }

  /// Reads a vertex: x y z, then nothing, a weight, a colour, or both.
  void parse_vertex() {
    soup_.positions.push_back(in_.point());
    soup_.vertex_lines.push_back(static_cast<std::uint32_t>(line_));
    std::size_t extra = 0;
    for (; !in_.at_record_end(); ++extra) {
      in_.skip_number();
    }
    if (extra == 2 || extra > 4) {
      in_.fault("a vertex of " + std::to_string(3 + extra) + " numbers, not 3, 4, 6 or 7");
    }
  }

  void parse_face() {
    corners_.clear();
    corner_normals_.clear();
    while (!in_.at_record_end()) {
      const ObjCorner corner = parse_obj_corner(in_.word(), counts(), in_);
      corners_.push_back(corner.vertex);
      corner_normals_.push_back(corner.normal);
    }
    if (corners_.empty()) {
      in_.fault("a face without corners");
    }
    append_corner_normals();
    append_polygon(soup_, corners_, line_);
  }

  /// Appends the normals of a face; it is called before the face is appended. Nothing is stored
  /// until a face has a normal; the faces before it have none.
  void append_corner_normals() {
    uses_normals_ = uses_normals_ || std::any_of(corner_normals_.begin(), corner_normals_.end(),
                                                 [](Index normal) { return normal != kNoIndex; });
    if (uses_normals_) {
      soup_.corner_normals.resize(soup_.n_faces(), kNoTriangle);
      append_fan(soup_.corner_normals, corner_normals_);
    }
  }

  [[nodiscard]] ObjCounts counts() const {
    return {soup_.n_vertices(), n_texture_points_, soup_.normals.size()};
  }

  void resolve_normals() {
    if (soup_.normals.empty()) {
      soup_.corner_normals.clear();
      return;
    }
    soup_.corner_normals.resize(soup_.n_faces(), kNoTriangle);
    for (Triangle& corners : soup_.corner_normals) {
      for (Index& normal : corners) {
        normal = normal < soup_.normals.size() ? normal : kNoIndex;
      }
    }
  }

  TextScanner in_;
  Soup soup_;
  /// The corners of the face being read.
  std::vector<Index> corners_;
  std::vector<Index> corner_normals_;
  std::size_t line_ = 0;
  std::size_t n_texture_points_ = 0;
  bool uses_normals_ = false;
};

void print_face(std::string& text, const Soup& soup, std::size_t face) {
  text += 'f';
  for (std::size_t k = 0; k < 3; ++k) {
    text += ' ' + std::to_string(std::uint64_t{soup.triangles[face][k]} + 1);
    if (!soup.corner_normals.empty() && soup.corner_normals[face][k] != kNoIndex) {
      text += "//" + std::to_string(std::uint64_t{soup.corner_normals[face][k]} + 1);
    }
  }
  text += '\n';
}

/// Returns a name on one line.
std::string one_line(std::string name) {
  std::replace(name.begin(), name.end(), '\n', ' ');
  return name;
}

}  // namespace

Soup parse_obj(std::string_view text, const std::string& name) {
  return name_fault(name, [&] { return ObjParser(text).parse(); });
}

std::string print_obj(const Soup& soup) {
  require_all_vertices(soup);
  std::string text;
  for (const Vec3& position : soup.positions) {
    print_record(text, "v", position);
  }
  for (const Vec3& normal : soup.normals) {
    print_record(text, "vn", normal);
  }
  auto group = soup.groups.begin();
  for (std::size_t f = 0; f <= soup.n_faces(); ++f) {
    for (; group != soup.groups.end() && group->first_face <= f; ++group) {
      text += "g " + one_line(group->name) + '\n';
    }
    if (f < soup.n_faces()) {
      print_face(text, soup, f);
    }
  }
  return text;
}

bool is_obj_keyword(std::string_view word) {
  constexpr std::array<std::string_view, 6> kRead = {"v", "vn", "f", "fo", "g", "o"};
  return is_skipped(word) || std::find(kRead.begin(), kRead.end(), word) != kRead.end();
}

}  // namespace meshalyzer
