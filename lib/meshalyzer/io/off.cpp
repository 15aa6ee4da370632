#include "meshalyzer/io/off.h"

#include "meshalyzer/io/binary_off.h"
#include "meshalyzer/io/off_keyword.h"
#include "meshalyzer/io/print_record.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/io/text_scanner.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Reads the lines of one file in order.
class OffParser {
 public:
  explicit OffParser(std::string_view text) : in_(text) {}

  Soup parse() {
    soup_.format = Format::Off;
    soup_.vertex_ids.first = 0;
    soup_.face_ids.first = 0;
    parse_header();
    for (std::size_t i = 0; i < n_vertices_; ++i) {
      in_.require_record("vertex " + std::to_string(i) + " of " + std::to_string(n_vertices_));
      parse_vertex();
      in_.end_record();
    }
    for (std::size_t i = 0; i < n_faces_; ++i) {
      in_.require_record("face " + std::to_string(i) + " of " + std::to_string(n_faces_));
      parse_face();
      in_.end_record();
    }
    if (in_.next_record()) {
      in_.fault("more lines than the " + std::to_string(n_vertices_) + " vertices and " +
                std::to_string(n_faces_) + " faces counted");
    }
    resolve_indices(soup_);
    use_vertex_normals(soup_);
    return std::move(soup_);
  }

 private:
  void parse_header() {
    in_.require_record("its keyword OFF");
    const std::string_view keyword = in_.peek();
    if (is_off_keyword(keyword)) {
      static_cast<void>(in_.word());
      layout_ = parse_off_keyword(keyword, in_);
    } else if (keyword.find_first_not_of("0123456789") != std::string_view::npos) {
      in_.fault(in_quotes(keyword) + " is not the keyword OFF");
    }
    in_.require_record("its counts");
    constexpr std::size_t kShortestVertex = std::string_view("0 0 0\n").size();
    constexpr std::size_t kShortestFace = std::string_view("1 0\n").size();
    n_vertices_ = in_.count(kShortestVertex, "vertices");
    n_faces_ = in_.count(kShortestFace, "faces");
    if (!in_.at_record_end()) {
      static_cast<void>(in_.integer());  // the number of edges, which is rarely right
    }
    in_.end_record();
  }

  void parse_vertex() {
    soup_.vertex_lines.push_back(static_cast<std::uint32_t>(in_.line()));
    soup_.positions.push_back(in_.point());
    if (layout_.normal) {
      soup_.normals.push_back(in_.point());
    }
    std::size_t extra = 0;
    for (; !in_.at_record_end(); ++extra) {
      in_.skip_number();
    }
    const std::size_t texture = layout_.texture ? 2 : 0;
    const bool has_colour = extra == texture + 3 || extra == texture + 4;
    if (!has_colour && (layout_.colour || extra != texture)) {
      in_.fault("a vertex of " + std::to_string(extra) + " numbers beyond its position" +
                (layout_.normal ? " and normal" : ""));
    }
  }

  void parse_face() {
    const std::size_t line = in_.line();
    const std::size_t n_corners = in_.count(2, "corners");
    if (n_corners == 0) {
      in_.fault("a face without corners");
    }
    corners_.clear();
    for (std::size_t i = 0; i < n_corners; ++i) {
      corners_.push_back(in_.index(0));
    }
    append_polygon(soup_, corners_, line);
    std::size_t n_colour = 0;
    for (; !in_.at_record_end(); ++n_colour) {
      in_.skip_number();
    }
    if (n_colour == 2 || n_colour > 4) {
      in_.fault(std::to_string(n_colour) + " numbers after the corners, which is no colour");
    }
  }

  TextScanner in_;
  Soup soup_;
  OffLayout layout_;
  std::size_t n_vertices_ = 0;
  std::size_t n_faces_ = 0;
  /// The corners of the face being read.
  std::vector<Index> corners_;
};

}  // namespace

Soup parse_off(std::string_view content, const std::string& name) {
  return name_fault(name, [&] {
    return is_binary_off(content) ? parse_binary_off(content, name).soup
                                  : OffParser(content).parse();
  });
}

std::string print_off(const Soup& soup) {
  require_all_vertices(soup);
  std::string text = has_vertex_normals(soup) ? "NOFF\n" : "OFF\n";
  text += std::to_string(soup.n_vertices()) + ' ' + std::to_string(soup.n_faces()) + " 0\n";
  print_vertices_and_triangles(text, soup);
  return text;
}

}  // namespace meshalyzer
