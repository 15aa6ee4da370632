#include "meshalyzer/io/rewrite/obj_records.h"

#include "meshalyzer/io/text_scanner.h"

#include <algorithm>
#include <array>

namespace meshalyzer {
namespace {

/// The keyword of statements that name vertices; see ObjNaming.
struct NamingKeyword {
  std::string_view word;
  std::size_t n_before;
  AttributeKind kind = AttributeKind::OtherStatements;
};

constexpr std::array<NamingKeyword, 8> kNamingKeywords = {{{"l", 1, AttributeKind::LinesAndPoints},
                                                           {"p", 1, AttributeKind::LinesAndPoints},
                                                           {"curv", 3},
                                                           {"surf", 5},
                                                           {"bsp", 1},
                                                           {"bzp", 1},
                                                           {"cdc", 1},
                                                           {"cdp", 1}}};
constexpr std::array<std::string_view, 6> kBodyKeywords = {"parm", "trim", "hole",
                                                           "scrv", "sp",   "end"};

class ObjRecordFinder {
 public:
  explicit ObjRecordFinder(std::string_view text)
      : text_(text), in_(text, Continuation::Backslash) {}

  ObjRecords find() {
    while (in_.next_record()) {
      const std::size_t begin = text_.size() - in_.remaining();
      note_statement(in_.word(), begin);
      in_.skip_record();
    }
    end_run();
    return std::move(records_);
  }

 private:
  void note_statement(std::string_view keyword, std::size_t begin) {
    if (keyword == "v") {
      records_.vertices.push_back(begin);
    } else if (keyword == "f" || keyword == "fo") {
      records_.faces.push_back(begin);
      note_triangles();
    } else if (keyword == "vt") {
      records_.texture_points.push_back(begin);
    } else if (keyword == "vn") {
      records_.normals.push_back(begin);
    } else if (keyword != "vp" && keyword != "l" && keyword != "p") {
      // Materials, groups and similar statements apply to the faces after them.
      end_run();
    }
    note_naming(keyword, begin);
    if (keyword == "g" || keyword == "o") {
      // In a name, # does not begin a comment.
      static_cast<void>(in_.rest_of_record());
    }
  }

  /// Notes statements that name vertices or surfaces, and the bodies of curves and surfaces.
  void note_naming(std::string_view keyword, std::size_t begin) {
    const bool continues_body = is_in_body_ && std::find(kBodyKeywords.begin(), kBodyKeywords.end(),
                                                         keyword) != kBodyKeywords.end();
    if (continues_body) records_.naming.back().body.push_back(begin);
    is_in_body_ = (continues_body && keyword != "end") || keyword == "curv" || keyword == "surf";
    if (keyword == "con") records_.connections.push_back(begin);
    for (const NamingKeyword& known : kNamingKeywords) {
      if (keyword == known.word) {
        records_.naming.push_back({begin, known.n_before, known.kind, {}});
      }
    }
  }

  void note_triangles() {
    std::size_t n_corners = 0;
    for (; !in_.at_record_end(); ++n_corners) {
      const bool is_relative = in_.word().find('-') != std::string_view::npos;
      records_.has_relative_faces = records_.has_relative_faces || is_relative;
    }
    records_.face_records.append(n_corners);
  }

  void end_run() {
    const std::size_t n = records_.faces.size();
    records_.face_records.run_ends.resize(n, static_cast<Index>(n - 1));
  }

  std::string_view text_;
  TextScanner in_;
  ObjRecords records_;
  bool is_in_body_ = false;
};

std::size_t count_before(const std::vector<std::size_t>& begins, std::size_t statement) {
  return static_cast<std::size_t>(std::lower_bound(begins.begin(), begins.end(), statement) -
                                  begins.begin());
}

}  // namespace

ObjCounts ObjRecords::counts_before(std::size_t statement) const {
  return {count_before(vertices, statement), count_before(texture_points, statement),
          count_before(normals, statement)};
}

ObjRecords find_obj_records(std::string_view text) {
  return ObjRecordFinder(text).find();
}

}  // namespace meshalyzer
