#include "meshalyzer/report/journal/parts.h"

#include "meshalyzer/base/error.h"
#include "small_journal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace meshalyzer {
namespace {

using test::SmallJournal;
using testing::HasSubstr;
using testing::ThrowsMessage;

Request some_request() {
  Request request;
  request.is_set = true;
  request.mesh.curvature = VertexArea::Voronoi;
  return request;
}

/// A journal in two parts.
class TwoParts : public SmallJournal {
 public:
  explicit TwoParts(const JournalSubject& subject) : all_(lines(subject)) { write_parts(); }
  TwoParts() : TwoParts(SmallJournal().subject(some_request())) {}

  [[nodiscard]] std::vector<std::string> files() const { return {file("1"), file("2")}; }
  [[nodiscard]] const std::vector<std::string>& all() const { return all_; }

 private:
  void write_parts() const {
    write("1", {all_[0], all_[2], all_[3]});
    write("2", {all_[1], all_[4]});
  }

  std::vector<std::string> all_;
};

TEST(ReadSubject, IsThatOfTheRun) {
  const SmallJournal run;
  const JournalSubject subject = run.subject(some_request());
  const TwoParts parts(subject);
  const JournalSubject read = read_subject(parts.files());
  EXPECT_EQ(read.files.paths, subject.files.paths);
  EXPECT_EQ(read.files.names, subject.files.names);
  EXPECT_EQ(read.files.stamps, subject.files.stamps);
  EXPECT_EQ(read.files.fingerprint, subject.files.fingerprint);
  EXPECT_EQ(read.request, subject.request);
}

TEST(ReadSubject, MissingPartIsAnError) {
  const TwoParts parts;
  for (const std::string& file : parts.files()) {
    EXPECT_THAT([&] { static_cast<void>(read_subject({file})); },
                ThrowsMessage<IoError>(testing::AllOf(
                    HasSubstr(": holds lines of "),
                    HasSubstr(" of the 3 files of the set: a part is missing, or not complete"))));
  }
}

TEST(ReadSubject, EmptyJournalsAreAnError) {
  const TwoParts parts;
  parts.write("1", {});
  EXPECT_THAT([&] { static_cast<void>(read_subject({parts.file("1")})); },
              ThrowsMessage<IoError>(HasSubstr("holds no line of a file")));
}

TEST(ReadSubject, PartThatWasAskedOtherwiseIsAnError) {
  const SmallJournal run;
  const TwoParts parts(run.subject(some_request()));
  parts.write("2", {SmallJournal::lines(run.subject())[1]});
  EXPECT_THAT(
      [&] { static_cast<void>(read_subject(parts.files())); },
      ThrowsMessage<IoError>(testing::AllOf(
          HasSubstr("2:1: was asked {"), HasSubstr(", and lines before {"), HasSubstr("voronoi"))));
}

TEST(ReadSubject, PartOfOtherFilesIsAnError) {
  const TwoParts parts;
  const SmallJournal other;
  parts.write("2", {SmallJournal::lines(other.subject(some_request()))[1]});
  EXPECT_THAT([&] { static_cast<void>(read_subject(parts.files())); },
              ThrowsMessage<IoError>(HasSubstr("2:1: is of other files than the lines before")));
}

}  // namespace
}  // namespace meshalyzer
