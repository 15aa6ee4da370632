#pragma once

#include "meshalyzer/base/descriptor.h"
#include "meshalyzer/io/file.h"
#include "meshalyzer/report/journal/line.h"
#include "meshalyzer/report/json/report.h"
#include "meshalyzer/set/file_stamp.h"
#include "meshalyzer/set/object_findings.h"

#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meshalyzer {

/// The stamp of a file as a journal keeps it: all 0 also where the file may not be read, since
/// leave to do so changes neither its size nor its time.
[[nodiscard]] FileStamp readable_stamp_of(const std::string& path);

/// The files of a run and what is asked of them, as the lines of a journal say it.
struct JournalSubject {
  std::vector<std::string> paths;
  /// What the meshes are called in the report.
  std::vector<std::string> names;
  std::vector<FileStamp> stamps;
  /// "VERSION set OPTIONS" or "VERSION files OPTIONS": the program's version, as another one may
  /// find otherwise, whether the files are a set, and Options::asked_text.
  std::string asked;
  /// Of all paths and stamps: where one differs, what was found between the files does not hold.
  std::string fingerprint;
  JsonOffenders offenders = JsonOffenders::Omit;

  [[nodiscard]] LineHead head(LineHead::Kind kind, Index number) const;
};

/// The subject of files as they are now.
[[nodiscard]] JournalSubject make_subject(const std::vector<std::string>& paths,
                                          const std::string& asked);

/// The lines of earlier runs that still hold for a subject. Any number of threads may ask.
class KnownLines {
 public:
  /// Takes from a journal those lines that were made with the same options, of files that have not
  /// changed since. A torn last line, as a kill leaves it, is passed over.
  ///
  /// Only the heads of the lines are looked at here.
  /// @throws IoError if the file cannot be read, or is no journal.
  void add(const std::string& file, const JournalSubject& subject);

  // What follows throws InvalidArgument, with journal and line, where the rest of a line is
  // damaged.

  [[nodiscard]] std::optional<Analysis> mesh(Index number) const;
  [[nodiscard]] std::optional<std::string> trouble(Index number) const;
  [[nodiscard]] std::optional<ObjectFindings> findings(Index owner,
                                                       const JournalSubject& subject) const;
  [[nodiscard]] bool has_file(Index number) const;
  [[nodiscard]] bool has_findings(Index owner) const;

  /// The lines anew, as they stand in a journal of the subject.
  void write(const JournalSubject& subject,
             const std::function<void(std::string_view)>& sink) const;

 private:
  struct Line {
    LineHead::Kind kind;
    Index number;
    std::string_view text;
    /// Which of files_ it is in.
    std::size_t file;
  };

  struct File {
    std::string name;
    std::unique_ptr<FileContent> content;
  };

  void add_line(std::string_view text, const JournalSubject& subject);
  [[nodiscard]] const Line* find(LineHead::Kind kind, Index number) const;
  /// What `read` makes of a line.
  template <typename Read>
  [[nodiscard]] auto understood(const Line& line, const Read& read) const;
  /// A line with the head that it has now.
  [[nodiscard]] std::string anew(const Line& line, const JournalSubject& subject) const;
  /// `FILE:LINE` of a line.
  [[nodiscard]] std::string place_of(const Line& line) const;

  std::vector<File> files_;
  /// In order of the journals.
  std::vector<Line> lines_;
  /// The place in lines_ of the last one of its sort.
  std::map<std::pair<LineHead::Kind, Index>, std::size_t> places_;
};

/// Calls `use` for each whole line of a journal. A torn last line, as a kill leaves it, is passed
/// over.
///
/// @throws IoError with the line if `use` throws InvalidArgument, or the last line is none that was
/// torn.
void for_each_line(const FileContent& content, const std::string& file,
                   const std::function<void(std::string_view)>& use);

/// Where lines go as they are found: each is there whole before the next one begins.
class JournalWriter {
 public:
  /// Lines are added to a file, which need not be there.
  /// @throws IoError if it cannot be written.
  explicit JournalWriter(const std::string& file);
  /// Lines go to a stream.
  explicit JournalWriter(std::ostream& out) : out_(&out) {}
  JournalWriter(const JournalWriter&) = delete;
  JournalWriter& operator=(const JournalWriter&) = delete;

  /// @throws IoError if it cannot be written.
  void append(std::string_view line);

 private:
  std::string file_;
  /// One of these is there.
  std::optional<Descriptor> descriptor_;
  std::ostream* out_ = nullptr;
};

}  // namespace meshalyzer
