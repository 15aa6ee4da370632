#include "meshalyzer/report/journal/parts.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/io/file.h"
#include "meshalyzer/report/journal/for_each_line.h"
#include "meshalyzer/report/journal/request.h"

#include <cstddef>
#include <map>
#include <optional>

namespace meshalyzer {
namespace {

/// Collects the common data of all lines of all parts, and the files that they name.
class PartHeads {
 public:
  void add(const LineHead& head);
  /// @param journals  The journals, at least one; errors are told of the first.
  /// @throws IoError if a part is missing.
  [[nodiscard]] JournalSubject subject(const std::vector<std::string>& journals) const;

 private:
  std::optional<LineHead> first_;
  std::map<std::size_t, LineHead> files_;
};

void PartHeads::add(const LineHead& head) {
  if (!first_) {
    first_ = head;
  }
  if (head.request != first_->request) {
    throw InvalidArgument("was asked " + request_text(head.request) + ", and lines before " +
                          request_text(first_->request));
  }
  if (head.of != first_->of || head.set != first_->set) {
    throw InvalidArgument("is of other files than the lines before, or of files that changed");
  }
  if (head.kind != LineHead::Kind::Between) {
    files_.emplace(head.number, head);
  }
}

JournalSubject PartHeads::subject(const std::vector<std::string>& journals) const {
  const std::string& journal = journals.front();
  if (files_.empty()) {
    throw IoError(journal, {}, "holds no line of a file");
  }
  if (files_.size() != first_->of || files_.rbegin()->first >= first_->of) {
    throw IoError(journal, {},
                  (journals.size() == 1 ? "holds" : "this and the other journals hold") +
                      (" lines of " + std::to_string(files_.size())) + " of the " +
                      std::to_string(first_->of) +
                      " files of the set: a part is missing, or not complete");
  }
  JournalSubject subject;
  for (const auto& [number, head] : files_) {
    subject.files.paths.push_back(head.path);
    subject.files.stamps.push_back(head.stamp);
  }
  subject.files.names = set_names(subject.files.paths);
  subject.files.fingerprint = first_->set;
  subject.request = first_->request;
  return subject;
}

}  // namespace

JournalSubject read_subject(const std::vector<std::string>& journals) {
  PartHeads heads;
  for (const std::string& journal : journals) {
    const FileContent content(journal);
    for_each_line(content.bytes(), journal,
                  [&](std::string_view line) { heads.add(read_head(line)); });
  }
  return heads.subject(journals);
}

}  // namespace meshalyzer
