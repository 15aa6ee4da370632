#include "meshalyzer/io/inria.h"

#include "meshalyzer/base/numbers.h"
#include "meshalyzer/io/inria_sections.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/io/text_scanner.h"

#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// Reads the sections of one file in order; line ends have no meaning.
class InriaParser {
 public:
  explicit InriaParser(std::string_view text) : in_(text) {}

  Soup parse() {
    soup_.format = Format::Inria;
    parse_header();
    while (in_.next_record()) {
      const std::string_view keyword = in_.word();
      if (keyword == "End") {
        break;
      }
      parse_section(keyword);
    }
    resolve_indices(soup_);
    return std::move(soup_);
  }

 private:
  void parse_header() {
    in_.require_record("its keyword MeshVersionFormatted");
    if (in_.word() != "MeshVersionFormatted") {
      in_.fault("the keyword MeshVersionFormatted does not stand first");
    }
    in_.require_record("its version");
    static_cast<void>(in_.integer());
  }

  void parse_section(std::string_view keyword) {
    if (keyword == "Dimension") {
      parse_dimension();
    } else if (keyword == "Vertices") {
      parse_vertices();
    } else if (keyword == "Triangles") {
      parse_faces(3);
    } else if (keyword == "Quadrilaterals") {
      parse_faces(4);
    } else if (const InriaStatement* statement = find_inria_statement(keyword)) {
      skip_numbers(statement->n_numbers);
      if (statement->n_numbers == 0) in_.skip_record();
    } else {
      skip_section(keyword);
    }
  }

  void parse_dimension() {
    in_.require_record("its dimension");
    if (in_.integer() != 3) {
      in_.fault("only meshes of dimension 3 are read");
    }
  }

  void parse_vertices() {
    if (has_vertices_) {
      in_.fault("a second section Vertices");
    }
    has_vertices_ = true;
    const std::size_t n = begin_records(4, "vertices");
    for (std::size_t i = 0; i < n; ++i) {
      in_.require_record("vertex " + std::to_string(i + 1) + " of " + std::to_string(n));
      soup_.vertex_lines.push_back(static_cast<std::uint32_t>(in_.line()));
      Vec3 position;
      for (double& coordinate : position) {
        in_.require_record("a coordinate");
        coordinate = in_.real();
      }
      soup_.positions.push_back(position);
      parse_attribute();
    }
  }

  void parse_faces(std::size_t n_corners) {
    const std::size_t n = begin_records(n_corners + 1, "faces");
    for (std::size_t i = 0; i < n; ++i) {
      in_.require_record("face " + std::to_string(i + 1) + " of " + std::to_string(n));
      const std::size_t line = in_.line();
      corners_.clear();
      for (std::size_t k = 0; k < n_corners; ++k) {
        in_.require_record("a corner");
        corners_.push_back(in_.index(1) - 1);
      }
      append_polygon(soup_, corners_, line);
      parse_attribute();
    }
  }

  /// Reads the reference of a record, a number without meaning for the mesh.
  void parse_attribute() {
    in_.require_record("a reference");
    static_cast<void>(in_.integer());
  }

  void skip_section(std::string_view keyword) {
    const InriaSection* section = find_inria_section(keyword);
    if (section == nullptr) {
      in_.fault(in_quotes(keyword) + " is no keyword of INRIA's format");
    }
    skip_numbers(begin_records(section->numbers_a_record, keyword) * section->numbers_a_record);
  }

  /// Reads the number of records. Each number of a record takes at least a digit and a blank, so
  /// that a count beyond the length of the file is rejected.
  std::size_t begin_records(std::size_t numbers_a_record, std::string_view what) {
    in_.require_record("the count of " + std::string(what));
    return in_.count(2 * numbers_a_record, what);
  }

  void skip_numbers(std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
      in_.require_record("a number");
      in_.skip_number();
    }
  }

  TextScanner in_;
  Soup soup_;
  bool has_vertices_ = false;
  /// The corners of the face being read.
  std::vector<Index> corners_;
};

}  // namespace

Soup parse_inria(std::string_view text, const std::string& name) {
  return name_fault(name, [&] { return InriaParser(text).parse(); });
}

std::string print_inria(const Soup& soup) {
  require_all_vertices(soup);
  std::string text = "MeshVersionFormatted 2\nDimension 3\n";
  text += "Vertices\n" + std::to_string(soup.n_vertices()) + '\n';
  for (const Vec3& position : soup.positions) {
    for (const double coordinate : position) {
      append_shortest(text, coordinate);
      text += ' ';
    }
    text += "0\n";
  }
  text += "Triangles\n" + std::to_string(soup.n_faces()) + '\n';
  for (const Triangle& t : soup.triangles) {
    for (const Index corner : t) {
      text += std::to_string(std::uint64_t{corner} + 1) + ' ';
    }
    text += "0\n";
  }
  return text + "End\n";
}

}  // namespace meshalyzer
