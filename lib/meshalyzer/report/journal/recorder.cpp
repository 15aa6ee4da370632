#include "meshalyzer/report/journal/recorder.h"

#include "meshalyzer/base/descriptor.h"
#include "meshalyzer/io/file_replacement.h"

#include <fcntl.h>
#include <utility>

namespace meshalyzer {
namespace {

void rewrite(const std::string& path, const KnownLines& known) {
  FileReplacement file(path);
  known.write([&](std::string_view line) { file.write(line); });
  file.commit();
}

}  // namespace

JournalFile::JournalFile(const std::string& path, const KnownLines& known) : path_(path) {
  rewrite(path, known);
  descriptor_ = std::make_unique<Descriptor>(
      open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
  if (!descriptor_->is_open()) {
    throw_errno(path, "cannot be written");
  }
}

JournalFile::~JournalFile() = default;

void JournalFile::append(std::string_view line) {
  if (!write_all(*descriptor_, line)) {
    throw_errno(path_, "cannot be written");
  }
}

JournalRecorder::JournalRecorder(const JournalSubject& subject, const KnownLines& known,
                                 std::function<void(std::string_view)> append)
    : subject_(subject), known_(known), append_(std::move(append)) {}

void JournalRecorder::on_mesh(Index number, const Analysis& mesh) {
  if (!known_.has_file(number)) {
    append_(mesh_line(subject_.head(LineHead::Kind::Mesh, number), mesh, subject_.offenders()));
  }
}

void JournalRecorder::on_unreadable(Index number, const std::string& why) {
  if (!known_.has_file(number)) {
    append_(unreadable_line(subject_.head(LineHead::Kind::Unreadable, number), why));
  }
}

void JournalRecorder::on_findings(const ObjectFindings& findings) {
  if (!known_.has_findings(findings.owner)) {
    append_(between_line(subject_.head(LineHead::Kind::Between, findings.owner), findings,
                         subject_.files.names));
  }
}

}  // namespace meshalyzer
