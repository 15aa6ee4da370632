#include "meshalyzer/report/journal/recorder.h"

#include "meshalyzer/base/error.h"
#include "small_journal.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace meshalyzer {
namespace {

using test::SmallJournal;

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) {
    text += line;
  }
  return text;
}

TEST(JournalRecorder, LeavesOutWhatIsKnown) {
  const SmallJournal journal;
  const JournalSubject subject = journal.subject();
  const std::vector<std::string> all = SmallJournal::lines(subject);
  journal.write("journal.ndjson", {all[1], all[2], all[3]});
  KnownLines known(subject);
  known.add(journal.file());
  std::vector<std::string> added;
  JournalRecorder recorder(subject, known,
                           [&](std::string_view line) { added.emplace_back(line); });
  SmallJournal::run(subject, recorder);
  EXPECT_EQ(added, (std::vector<std::string>{all[0], all[4]}));
}

TEST(JournalFile, KeepsTheLinesThatHoldAndTakesMore) {
  const SmallJournal journal;
  const JournalSubject before = journal.subject();
  const std::vector<std::string> old = SmallJournal::lines(before);
  journal.write(before);
  write_bytes(journal.path(1), "something longer");
  const JournalSubject subject = journal.subject();
  KnownLines known(subject);
  known.add(journal.file());
  JournalFile file(journal.file(), known);
  JournalRecorder recorder(subject, known, [&](std::string_view line) { file.append(line); });
  SmallJournal::run(subject, recorder);
  const std::vector<std::string> all = SmallJournal::lines(subject);
  // Kept lines come first, with the head that they have now.
  EXPECT_EQ(read_bytes(journal.file()), joined({all[0], all[2], all[1], all[3], all[4]}));
}

TEST(JournalFile, GoesOnBehindATornLine) {
  const SmallJournal journal;
  const JournalSubject subject = journal.subject();
  const std::vector<std::string> all = SmallJournal::lines(subject);
  write_bytes(journal.file(), all[0] + all[1].substr(0, all[1].size() / 2));
  KnownLines known(subject);
  known.add(journal.file());
  JournalFile file(journal.file(), known);
  JournalRecorder recorder(subject, known, [&](std::string_view line) { file.append(line); });
  SmallJournal::run(subject, recorder);
  EXPECT_EQ(read_bytes(journal.file()), joined(all));
}

TEST(JournalFile, MayBeAnotherThanTheOneThatIsKnown) {
  const SmallJournal journal;
  const JournalSubject subject = journal.subject();
  journal.write(subject);
  KnownLines known(subject);
  known.add(journal.file());
  const JournalFile other(journal.file("other.ndjson"), known);
  EXPECT_EQ(read_bytes(journal.file("other.ndjson")), read_bytes(journal.file()));
}

TEST(JournalFile, ThatCannotBeWrittenIsAnError) {
  const SmallJournal journal;
  const JournalSubject subject = journal.subject();
  const KnownLines nothing(subject);
  EXPECT_THROW(JournalFile(journal.file("nowhere/journal"), nothing), IoError);
}

}  // namespace
}  // namespace meshalyzer
