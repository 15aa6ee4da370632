#include "meshalyzer/report/journal/known_lines.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/io/file.h"
#include "meshalyzer/report/journal/for_each_line.h"
#include "meshalyzer/report/json/mesh.h"

#include <algorithm>

namespace meshalyzer {
namespace {

/// Returns the number of the file of a line, if it is one of the subject's.
std::optional<Index> number_in(const LineHead& head, const std::vector<std::string>& paths) {
  if (head.number < paths.size() && paths[head.number] == head.path) {
    return static_cast<Index>(head.number);
  }
  const auto found = std::find(paths.begin(), paths.end(), head.path);
  return found == paths.end() ? std::nullopt
                              : std::optional(static_cast<Index>(found - paths.begin()));
}

}  // namespace

KnownLines::KnownLines(const JournalSubject& subject, Missing missing)
    : subject_(subject), missing_(missing) {}
KnownLines::~KnownLines() = default;

void KnownLines::add(const std::string& file) {
  files_.push_back({file, std::make_unique<FileContent>(file)});
  for_each_line(files_.back().content->bytes(), file,
                [&](std::string_view line) { add_line(line); });
}

void KnownLines::add_line(std::string_view text) {
  const LineHead head = read_head(text);
  const std::optional<Index> number = number_in(head, subject_.files.paths);
  if (!number || head.request != subject_.request || head.stamp != subject_.files.stamps[*number] ||
      (head.kind == LineHead::Kind::Between && head.set != subject_.files.fingerprint)) {
    return;
  }
  places_[{head.kind, *number}] = lines_.size();
  lines_.push_back({head.kind, *number, text, files_.size() - 1});
}

const KnownLines::Line* KnownLines::find(LineHead::Kind kind, Index number) const {
  const auto found = places_.find({kind, number});
  return found == places_.end() ? nullptr : &lines_[found->second];
}

std::string KnownLines::place_of(const Line& line) const {
  const std::string_view bytes = files_[line.file].content->bytes();
  const auto before = bytes.substr(0, static_cast<std::size_t>(line.text.data() - bytes.data()));
  const auto n_before = std::count(before.begin(), before.end(), '\n');
  return files_[line.file].name + ":" + std::to_string(n_before + 1);
}

template <typename Read>
auto KnownLines::understood(const Line& line, const Read& read) const {
  try {
    return read(line.text);
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(place_of(line) + ": " + error.what());
  }
}

std::optional<Analysis> KnownLines::mesh(Index number) const {
  const Line* line = find(LineHead::Kind::Mesh, number);
  return line != nullptr ? std::optional(understood(*line, read_mesh_members)) : std::nullopt;
}

std::optional<std::string> KnownLines::error(Index number) const {
  const Line* line = find(LineHead::Kind::Unreadable, number);
  return line != nullptr ? std::optional(understood(*line, read_unreadable)) : std::nullopt;
}

std::optional<ObjectFindings> KnownLines::findings(Index owner) const {
  const Line* line = find(LineHead::Kind::Between, owner);
  if (line != nullptr) {
    return understood(
        *line, [&](std::string_view text) { return read_between(text, subject_.files.names); });
  }
  if (missing_ == Missing::Refuse) {
    throw IoError(subject_.files.paths[owner], {},
                  "no line tells what is between this mesh and the others: is a part missing?");
  }
  return std::nullopt;
}

bool KnownLines::has_file(Index number) const {
  return find(LineHead::Kind::Mesh, number) != nullptr ||
         find(LineHead::Kind::Unreadable, number) != nullptr;
}

bool KnownLines::has_findings(Index owner) const {
  return find(LineHead::Kind::Between, owner) != nullptr;
}

void KnownLines::write(const std::function<void(std::string_view)>& sink) const {
  for (const Line& line : lines_) {
    if (&line == find(line.kind, line.number)) {
      sink(anew(line));
    }
  }
}

std::string KnownLines::anew(const Line& line) const {
  const LineHead head = subject_.head(line.kind, line.number);
  switch (line.kind) {
    case LineHead::Kind::Mesh:
      return mesh_line(head, *mesh(line.number), subject_.offenders());
    case LineHead::Kind::Unreadable:
      return unreadable_line(head, *error(line.number));
    case LineHead::Kind::Between:
      break;
  }
  return between_line(head, *findings(line.number), subject_.files.names);
}

}  // namespace meshalyzer
