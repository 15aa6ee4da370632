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

/// The lines of earlier runs that are still valid for a subject.
///
/// A line is valid if it was made with an equal request and its file has not changed; a line with
/// findings between files, if no file has changed. Several threads may call at a time.
class KnownLines : public EarlierFindings {
 public:
  enum class Missing : std::uint8_t {
    /// Findings that no line has are computed.
    Find,
    /// All findings between meshes must be in a line; otherwise a query throws IoError.
    Refuse,
  };

  /// @param subject  The subject, which must outlive this object.
  explicit KnownLines(const JournalSubject& subject, Missing missing = Missing::Find);
  ~KnownLines() override;
  KnownLines(const KnownLines&) = delete;
  KnownLines& operator=(const KnownLines&) = delete;

  /// Adds the valid lines of a journal. A torn last line, as a killed run leaves it, is skipped.
  ///
  /// Only the heads of the lines are read here.
  /// @throws IoError if the file cannot be read, is no journal, or one of another version of
  /// meshalyzer.
  void add(const std::string& file);

  // The following functions throw InvalidArgument, with journal and line, if the rest of a line is
  // damaged.

  [[nodiscard]] std::optional<Analysis> mesh(Index number) const override;
  [[nodiscard]] std::optional<std::string> error(Index number) const override;
  [[nodiscard]] std::optional<ObjectFindings> findings(Index owner) const override;
  [[nodiscard]] bool has_file(Index number) const;
  [[nodiscard]] bool has_findings(Index owner) const;

  /// Writes the lines again, as in a journal of the subject.
  void write(const std::function<void(std::string_view)>& sink) const;

 private:
  struct Line {
    LineHead::Kind kind;
    Index number;
    std::string_view text;
    /// The index in files_ of its journal.
    std::size_t file;
  };

  struct File {
    std::string name;
    std::unique_ptr<FileContent> content;
  };

  void add_line(std::string_view text);
  [[nodiscard]] const Line* find(LineHead::Kind kind, Index number) const;
  /// Returns the result of `read` for a line.
  template <typename Read>
  [[nodiscard]] auto understood(const Line& line, const Read& read) const;
  /// Returns a line with its current head.
  [[nodiscard]] std::string anew(const Line& line) const;
  /// Returns `FILE:LINE` of a line.
  [[nodiscard]] std::string place_of(const Line& line) const;

  const JournalSubject& subject_;
  Missing missing_;
  std::vector<File> files_;
  /// The lines in order of the journals.
  std::vector<Line> lines_;
  /// The position in lines_ of the last line of each kind and mesh.
  std::map<std::pair<LineHead::Kind, Index>, std::size_t> places_;
};

}  // namespace meshalyzer
