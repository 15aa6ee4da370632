#pragma once

#include "meshalyzer/report/journal/subject.h"
#include "meshalyzer/set/earlier_findings.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meshalyzer {

class FileContent;

/// The lines of earlier runs that still hold for a subject.
///
/// A line holds that was made with an equal request, of a file that is what it was; one that tells
/// what is between files, as long as all of them are what they were. Any number of threads may ask.
class KnownLines : public EarlierFindings {
 public:
  enum class Missing : std::uint8_t {
    /// What no line tells about meshes is found out.
    Find,
    /// All there is between meshes must stand in a line: else asking throws IoError.
    Refuse,
  };

  /// @param subject  Must outlive this.
  explicit KnownLines(const JournalSubject& subject, Missing missing = Missing::Find);
  ~KnownLines() override;
  KnownLines(const KnownLines&) = delete;
  KnownLines& operator=(const KnownLines&) = delete;

  /// Takes from a journal those lines that hold. A torn last line, as a kill leaves it, is passed
  /// over.
  ///
  /// Only the heads of the lines are looked at here.
  /// @throws IoError if the file cannot be read, is no journal, or one of another version of
  /// meshalyzer.
  void add(const std::string& file);

  // What follows throws InvalidArgument, with journal and line, where the rest of a line is
  // damaged.

  [[nodiscard]] std::optional<Analysis> mesh(Index number) const override;
  [[nodiscard]] std::optional<std::string> trouble(Index number) const override;
  [[nodiscard]] std::optional<ObjectFindings> findings(Index owner) const override;
  [[nodiscard]] bool has_file(Index number) const;
  [[nodiscard]] bool has_findings(Index owner) const;

  /// The lines anew, as they stand in a journal of the subject.
  void write(const std::function<void(std::string_view)>& sink) const;

 private:
  struct Line {
    LineHead::Kind kind;
    Index number;
    std::string_view text;
    /// The index in files_ of the journal that it is in.
    std::size_t file;
  };

  struct File {
    std::string name;
    std::unique_ptr<FileContent> content;
  };

  void add_line(std::string_view text);
  [[nodiscard]] const Line* find(LineHead::Kind kind, Index number) const;
  /// Returns what `read` makes of a line.
  template <typename Read>
  [[nodiscard]] auto understood(const Line& line, const Read& read) const;
  /// Returns a line with the head that it has now.
  [[nodiscard]] std::string anew(const Line& line) const;
  /// `FILE:LINE` of a line.
  [[nodiscard]] std::string place_of(const Line& line) const;

  const JournalSubject& subject_;
  Missing missing_;
  std::vector<File> files_;
  /// The lines in order of the journals.
  std::vector<Line> lines_;
  /// The place in lines_ of the last one of its sort.
  std::map<std::pair<LineHead::Kind, Index>, std::size_t> places_;
};

}  // namespace meshalyzer
