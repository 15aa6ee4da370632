#include "meshalyzer/report/journal/known_lines.h"

#include "changed_requests.h"
#include "meshalyzer/base/error.h"
#include "small_journal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace meshalyzer {
namespace {

using test::SmallJournal;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// Returns how many lines of a journal are valid for a subject.
std::size_t n_holding(const std::string& file, const JournalSubject& subject) {
  KnownLines known(subject);
  known.add(file);
  std::size_t n = 0;
  known.write([&](std::string_view) { ++n; });
  return n;
}

TEST(KnownLines, TellWhatTheRunFound) {
  const SmallJournal journal;
  const JournalSubject subject = journal.subject();
  journal.write(subject);
  KnownLines known(subject);
  known.add(journal.file());
  EXPECT_EQ(known.mesh(1)->path, journal.path(1));
  EXPECT_EQ(known.error(2), journal.path(2) + ": torn");
  EXPECT_EQ(known.findings(1)->owner, 1U);
  EXPECT_FALSE(known.mesh(2).has_value());
  EXPECT_FALSE(known.error(0).has_value());
  EXPECT_FALSE(known.findings(2).has_value());
  EXPECT_TRUE(known.has_file(2));
  EXPECT_FALSE(known.has_findings(2));
}

TEST(KnownLines, HoldForAnEqualRequestOnly) {
  const SmallJournal journal;
  journal.write(journal.subject());
  EXPECT_EQ(n_holding(journal.file(), journal.subject()), 5U);
  for (const auto& [name, request] : test::changed_requests()) {
    EXPECT_EQ(n_holding(journal.file(), journal.subject(request)), 0U) << name;
    journal.write(journal.subject(request));
    EXPECT_EQ(n_holding(journal.file(), journal.subject(request)), 5U) << name;
    EXPECT_EQ(n_holding(journal.file(), journal.subject()), 0U) << name;
    journal.write(journal.subject());
  }
}

TEST(KnownLines, OfAFileThatChangedDoNotHoldNorDoesWhatIsBetween) {
  const SmallJournal journal;
  journal.write(journal.subject());
  write_bytes(journal.path(1), "something longer");
  const JournalSubject subject = journal.subject();
  EXPECT_EQ(n_holding(journal.file(), subject), 2U);
  KnownLines known(subject);
  known.add(journal.file());
  EXPECT_TRUE(known.has_file(0));
  EXPECT_FALSE(known.has_file(1));
  EXPECT_FALSE(known.has_findings(0));
}

TEST(KnownLines, FollowAFileToItsNewNumber) {
  const SmallJournal journal;
  journal.write(journal.subject());
  const JournalSubject subject{stamped({journal.path(1)}), {}};
  KnownLines known(subject);
  known.add(journal.file());
  EXPECT_EQ(known.mesh(0)->path, journal.path(1));
}

TEST(KnownLines, LastLineOfAFileIsTheOneThatHolds) {
  const SmallJournal journal;
  const JournalSubject subject = journal.subject();
  std::vector<std::string> lines = SmallJournal::lines(subject);
  lines.push_back(unreadable_line(subject.head(LineHead::Kind::Unreadable, 2), "later"));
  journal.write("journal.ndjson", lines);
  KnownLines known(subject);
  known.add(journal.file());
  EXPECT_EQ(known.error(2), "later");
}

TEST(KnownLines, TornLastLineIsPassedOver) {
  const SmallJournal journal;
  const JournalSubject subject = journal.subject();
  journal.write(subject);
  const std::string whole = read_bytes(journal.file());
  const std::size_t last = whole.rfind('\n', whole.size() - 2) + 1;
  for (std::size_t length = last; length < whole.size(); ++length) {
    write_bytes(journal.file(), whole.substr(0, length));
    EXPECT_EQ(n_holding(journal.file(), subject), 4U) << length - last << " bytes of the line";
  }
}

TEST(KnownLines, WhatIsNoJournalIsRefusedWithItsLine) {
  const SmallJournal journal;
  const JournalSubject subject = journal.subject();
  journal.write(subject);
  const std::string whole = read_bytes(journal.file());
  for (const std::string text : {"Dear diary.\n", "Dear diary.", "{\"name\": 1}\n"}) {
    write_bytes(journal.file(), whole + text);
    KnownLines known(subject);
    EXPECT_THAT([&] { known.add(journal.file()); },
                ThrowsMessage<IoError>(HasSubstr(":6: not the beginning of a line")));
  }
}

TEST(KnownLines, DamageBehindTheHeadIsToldWithItsLine) {
  const SmallJournal journal;
  const JournalSubject subject = journal.subject();
  std::vector<std::string> lines = SmallJournal::lines(subject);
  lines[1].replace(lines[1].find("\"faces\": "), 9, "\"faces\": twelve");
  journal.write("journal.ndjson", lines);
  KnownLines known(subject);
  known.add(journal.file());
  EXPECT_THAT([&] { static_cast<void>(known.mesh(1)); },
              ThrowsMessage<InvalidArgument>(HasSubstr("journal.ndjson:2: ")));
}

TEST(KnownLines, OfACompleteRunRefuseWhatIsMissingBetween) {
  const SmallJournal journal;
  const JournalSubject subject = journal.subject();
  journal.write(subject);
  KnownLines known(subject, KnownLines::Missing::Refuse);
  known.add(journal.file());
  EXPECT_TRUE(known.findings(1).has_value());
  EXPECT_THAT([&] { static_cast<void>(known.findings(2)); },
              ThrowsMessage<IoError>(HasSubstr("is a part missing?")));
}

}  // namespace
}  // namespace meshalyzer
