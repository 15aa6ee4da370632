#include "meshalyzer/io/mesh_format.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/io/print_record.h"
#include "meshalyzer/io/references.h"
#include "meshalyzer/io/text_scanner.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace meshalyzer {
namespace {

/// The records in one part of the text. Lines count from 1 within the part; faces hold vertex ids.
struct Part {
  std::vector<Vec3> positions;
  std::vector<std::int32_t> vertex_ids;
  std::vector<std::uint32_t> vertex_lines;
  std::vector<Triangle> triangles;
  std::vector<std::int32_t> face_ids;
  std::vector<std::uint32_t> face_lines;
  std::vector<std::uint32_t> torn_lines;
  std::size_t n_line_ends = 0;
  /// The fault that ended the reading of the part, if any.
  std::optional<TextFault> fault;
};

bool begins_like_number(std::string_view word) {
  return word.find_first_of("0123456789+-.") == 0;
}

void parse_record(TextScanner& in, Part& part) {
  const auto line = static_cast<std::uint32_t>(in.line());
  const std::string_view keyword = in.word();
  if (keyword == "Vertex") {
    part.vertex_ids.push_back(static_cast<std::int32_t>(in.index(1)));
    part.positions.push_back(in.point());
    part.vertex_lines.push_back(line);
  } else if (keyword == "Face") {
    part.face_ids.push_back(static_cast<std::int32_t>(in.index(1)));
    const Index a = in.index(1);
    const Index b = in.index(1);
    const Index c = in.index(1);
    part.triangles.push_back({a, b, c});
    part.face_lines.push_back(line);
  } else if (begins_like_number(keyword)) {
    part.torn_lines.push_back(line);
    in.skip_record();
  } else {
    in.fault(in_quotes(keyword) + " is neither Vertex nor Face");
  }
  in.end_record();
}

Part parse_part(std::string_view text) {
  Part part;
  TextScanner in(text);
  try {
    while (in.next_record()) {
      parse_record(in, part);
    }
  } catch (const TextFault& fault) {
    part.fault = fault;
  }
  part.n_line_ends = in.line() - 1;
  return part;
}

/// Returns the offset of the first line that begins at `offset` or after it.
std::size_t line_begin_from(std::string_view text, std::size_t offset) {
  if (offset == 0 || offset >= text.size()) {
    return std::min(offset, text.size());
  }
  const std::size_t line_end = text.find('\n', offset - 1);
  return line_end == std::string_view::npos ? text.size() : line_end + 1;
}

std::vector<Part> parse_parts(std::string_view text, std::size_t bytes_per_part) {
  std::vector<Part> parts(n_chunks(text.size(), bytes_per_part));
  parallel_chunks(text.size(), bytes_per_part, [&](Chunk chunk) {
    const std::size_t begin = line_begin_from(text, chunk.begin);
    const std::size_t end = line_begin_from(text, chunk.end);
    parts[chunk.number] = parse_part(text.substr(begin, end - begin));
  });
  return parts;
}

/// Concatenates one list of all parts; each is freed as soon as it is copied, so that memory is not
/// doubled.
template <typename T>
std::vector<T> take(std::vector<Part>& parts, std::vector<T> Part::*list) {
  std::size_t n = 0;
  for (const Part& part : parts) {
    n += (part.*list).size();
  }
  std::vector<T> all;
  all.reserve(n);
  for (Part& part : parts) {
    const std::vector<T> taken = std::move(part.*list);
    all.insert(all.end(), taken.begin(), taken.end());
  }
  return all;
}

/// Converts line numbers to those of the file, and throws the fault of the first part that has one.
void number_lines(std::vector<Part>& parts) {
  std::size_t lines_before = 0;
  for (Part& part : parts) {
    if (part.fault) {
      throw TextFault(lines_before + part.fault->line(), part.fault->what());
    }
    for (auto* lines : {&part.vertex_lines, &part.face_lines, &part.torn_lines}) {
      for (std::uint32_t& line : *lines) {
        line += static_cast<std::uint32_t>(lines_before);
      }
    }
    lines_before += part.n_line_ends;
  }
}

Soup join(std::vector<Part> parts) {
  number_lines(parts);
  std::size_t n_records = 0;
  for (const Part& part : parts) n_records += part.positions.size() + part.triangles.size();
  Soup soup;
  parallel_invoke(n_records,
                  {
                      [&] { soup.positions = take(parts, &Part::positions); },
                      [&] { soup.triangles = take(parts, &Part::triangles); },
                      [&] { soup.vertex_ids = compact_ids(take(parts, &Part::vertex_ids)); },
                      [&] { soup.face_ids = compact_ids(take(parts, &Part::face_ids)); },
                      [&] { soup.vertex_lines = take(parts, &Part::vertex_lines); },
                      [&] { soup.face_lines = take(parts, &Part::face_lines); },
                      [&] { soup.torn_lines = take(parts, &Part::torn_lines); },
                  });
  return soup;
}

/// The ids to print, none of which may be below 1 in `.mesh`.
class PrintedIds {
 public:
  explicit PrintedIds(const Ids& ids)
      : ids_(ids), shift_(ids.named.empty() ? std::max(0, 1 - ids.first) : 0) {}
  [[nodiscard]] std::string of(std::size_t record) const {
    return std::to_string(ids_.of(static_cast<Index>(record)) + shift_);
  }

 private:
  const Ids& ids_;
  std::int64_t shift_;
};

}  // namespace

Soup parse_mesh_format(std::string_view text, const std::string& name,
                       const MeshFormatOptions& options) {
  Soup soup = name_fault(name, [&] { return join(parse_parts(text, options.bytes_per_part)); });
  if (soup.n_vertices() >= kNoIndex || soup.n_faces() >= kNoIndex) {
    throw IoError(name, {}, "more than " + std::to_string(kNoIndex - 1) + " records of a kind");
  }
  soup.format = Format::Mesh;
  resolve_ids(soup);
  return soup;
}

std::string print_mesh_format(const Soup& soup) {
  require_all_vertices(soup);
  require_unambiguous_ids(soup);
  const PrintedIds vertex_ids(soup.vertex_ids);
  const PrintedIds face_ids(soup.face_ids);
  std::string text;
  for (std::size_t v = 0; v < soup.n_vertices(); ++v) {
    print_record(text, "Vertex " + vertex_ids.of(v), soup.positions[v]);
  }
  for (std::size_t f = 0; f < soup.n_faces(); ++f) {
    text += "Face " + face_ids.of(f);
    for (const Index corner : soup.triangles[f]) {
      text += ' ' + vertex_ids.of(corner);
    }
    text += '\n';
  }
  return text;
}

}  // namespace meshalyzer
