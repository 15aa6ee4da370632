#include "journal.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/report/json/mesh_reader.h"
#include "meshalyzer/set/set_run.h"

#include <algorithm>
#include <fcntl.h>
#include <iterator>
#include <ostream>
#include <unistd.h>

namespace meshalyzer {
namespace {

/// FNV-1a over 64 bits (Fowler, Noll and Vo), as text.
class Fingerprint {
 public:
  void add(std::string_view text) {
    for (const char c : text) {
      hash_ = (hash_ ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    }
    hash_ = (hash_ ^ 0xffU) * 0x100000001b3ULL;
  }

  [[nodiscard]] std::string text() const {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (int shift = 60; shift >= 0; shift -= 4) {
      text += kDigits[hash_ >> shift & 0xfU];
    }
    return text;
  }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

/// The number of the file that a line is of, if it is one of the subject's.
std::optional<Index> number_of(const LineHead& head, const JournalSubject& subject) {
  if (head.number < subject.paths.size() && subject.paths[head.number] == head.path) {
    return static_cast<Index>(head.number);
  }
  const auto found = std::find(subject.paths.begin(), subject.paths.end(), head.path);
  return found == subject.paths.end()
             ? std::nullopt
             : std::optional(static_cast<Index>(found - subject.paths.begin()));
}

/// Whether the bytes behind the last line feed can be what a kill left of a line. What is no
/// journal at all must not be taken for one, for it would be written over.
bool is_torn_line(std::string_view rest) {
  constexpr std::string_view kBegin = "{\"number\": ";
  const std::size_t length = std::min(rest.size(), kBegin.size());
  return rest.substr(0, length) == kBegin.substr(0, length);
}

}  // namespace

FileStamp readable_stamp_of(const std::string& path) {
  return access(path.c_str(), R_OK) == 0 ? stamp_of(path) : FileStamp{};
}

LineHead JournalSubject::head(LineHead::Kind kind, Index number) const {
  return {.kind = kind,
          .number = number,
          .of = paths.size(),
          .path = paths[number],
          .stamp = stamps[number],
          .asked = asked,
          .set = fingerprint};
}

JournalSubject make_subject(const std::vector<std::string>& paths, const std::string& asked) {
  JournalSubject subject;
  subject.paths = paths;
  subject.names = set_names(paths);
  subject.asked = asked;
  std::transform(paths.begin(), paths.end(), std::back_inserter(subject.stamps), readable_stamp_of);
  Fingerprint fingerprint;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    fingerprint.add(paths[i]);
    fingerprint.add(std::to_string(subject.stamps[i].bytes));
    fingerprint.add(std::to_string(subject.stamps[i].modified_ns));
  }
  subject.fingerprint = fingerprint.text();
  return subject;
}

void for_each_line(const FileContent& content, const std::string& file,
                   const std::function<void(std::string_view)>& use) {
  const std::string_view bytes = content.bytes();
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < bytes.size();) {
    const std::size_t end = bytes.find('\n', begin);
    ++number;
    if (end == std::string_view::npos) {
      if (!is_torn_line(bytes.substr(begin))) {
        throw IoError(file, {.line = number}, "not the beginning of a line of a journal");
      }
      return;
    }
    try {
      use(bytes.substr(begin, end - begin));
    } catch (const InvalidArgument& error) {
      throw IoError(file, {.line = number}, error.what());
    }
    begin = end + 1;
  }
}

void KnownLines::add(const std::string& file, const JournalSubject& subject) {
  files_.push_back({file, std::make_unique<FileContent>(file)});
  for_each_line(*files_.back().content, file,
                [&](std::string_view line) { add_line(line, subject); });
}

void KnownLines::add_line(std::string_view text, const JournalSubject& subject) {
  const LineHead head = read_head(text);
  const std::optional<Index> number = number_of(head, subject);
  if (!number || head.asked != subject.asked || head.stamp != subject.stamps[*number] ||
      (head.kind == LineHead::Kind::Between && head.set != subject.fingerprint)) {
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
  return line != nullptr ? std::optional(understood(*line, read_mesh_json)) : std::nullopt;
}

std::optional<std::string> KnownLines::trouble(Index number) const {
  const Line* line = find(LineHead::Kind::Unreadable, number);
  return line != nullptr ? std::optional(understood(*line, read_trouble)) : std::nullopt;
}

std::optional<ObjectFindings> KnownLines::findings(Index owner,
                                                   const JournalSubject& subject) const {
  const Line* line = find(LineHead::Kind::Between, owner);
  const auto read = [&](std::string_view text) { return read_between(text, subject.names); };
  return line != nullptr ? std::optional(understood(*line, read)) : std::nullopt;
}

bool KnownLines::has_file(Index number) const {
  return find(LineHead::Kind::Mesh, number) != nullptr ||
         find(LineHead::Kind::Unreadable, number) != nullptr;
}

bool KnownLines::has_findings(Index owner) const {
  return find(LineHead::Kind::Between, owner) != nullptr;
}

void KnownLines::write(const JournalSubject& subject,
                       const std::function<void(std::string_view)>& sink) const {
  for (const Line& line : lines_) {
    if (&line == find(line.kind, line.number)) {
      sink(anew(line, subject));
    }
  }
}

std::string KnownLines::anew(const Line& line, const JournalSubject& subject) const {
  const LineHead head = subject.head(line.kind, line.number);
  switch (line.kind) {
    case LineHead::Kind::Mesh:
      return mesh_line(head, *mesh(line.number), subject.offenders);
    case LineHead::Kind::Unreadable:
      return unreadable_line(head, *trouble(line.number));
    case LineHead::Kind::Between:
      break;
  }
  return between_line(head, *findings(line.number, subject), subject.names);
}

JournalWriter::JournalWriter(const std::string& file)
    : file_(file),
      descriptor_(open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {
  if (!descriptor_->is_open()) {
    throw_errno(file, "cannot be written");
  }
}

void JournalWriter::append(std::string_view line) {
  if (out_ != nullptr) {
    *out_ << line << std::flush;
  } else if (!write_all(*descriptor_, line)) {
    throw_errno(file_, "cannot be written");
  }
}

}  // namespace meshalyzer
