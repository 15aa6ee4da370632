#include "merge.h"

#include "help.h"
#include "interrupt.h"
#include "meshalyzer/base/parallel.h"
#include "usage_error.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <map>
#include <ostream>
#include <sstream>
#include <utility>

namespace meshalyzer {
namespace {

/// The command line of merge; what says how to report stays text for parse_command_line().
struct MergeOptions {
  std::vector<std::string> journals;
  std::vector<std::string> how_to_report;
};

/// @return nothing where help was asked for.
std::optional<MergeOptions> parse(int argc, const char* const* argv) {
  MergeOptions options;
  std::string json, threads, memory_limit;
  bool summary = false, quiet = false, no_progress = false;
  CLI::App app;
  app.add_option("FILE", options.journals);
  app.add_flag("--json{-}", json);
  app.add_flag("--summary", summary);
  app.add_option("--threads", threads);
  app.add_option("--memory-limit", memory_limit);
  app.add_flag("--quiet", quiet);
  app.add_flag("--no-progress", no_progress);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw UsageError(std::string("merge: ") + error.what());
  }
  if (options.journals.empty()) {
    throw UsageError("merge: no FILE: name the journals of all parts");
  }
  const auto pass_on = [&](bool is_there, const std::string& word) {
    if (is_there) {
      options.how_to_report.push_back(word);
    }
  };
  pass_on(!json.empty(), "--json=" + json);
  pass_on(summary, "--summary");
  pass_on(!threads.empty(), "--threads=" + threads);
  pass_on(!memory_limit.empty(), "--memory-limit=" + memory_limit);
  pass_on(quiet || no_progress, "--quiet");
  return options;
}

/// What all lines of all parts agree on, and the files that they name.
struct MergedSubject {
  std::size_t n_files = 0;
  std::string asked;
  std::string set;
  std::map<std::size_t, LineHead> files;
};

void take(const LineHead& head, MergedSubject& merged) {
  if (merged.n_files == 0) {
    merged.n_files = head.of;
    merged.asked = head.asked;
    merged.set = head.set;
  }
  if (head.asked != merged.asked) {
    throw InvalidArgument("was asked '" + head.asked + "', and lines before '" + merged.asked +
                          "'");
  }
  if (head.of != merged.n_files || head.set != merged.set) {
    throw InvalidArgument("is of other files than the lines before, or of files that changed");
  }
  if (head.kind != LineHead::Kind::Between) {
    merged.files.emplace(head.number, head);
  }
}

MergedSubject read_heads(const std::vector<std::string>& journals) {
  MergedSubject merged;
  for (const std::string& journal : journals) {
    const FileContent content(journal);
    for_each_line(content, journal, [&](std::string_view line) { take(read_head(line), merged); });
  }
  if (merged.files.empty()) {
    throw IoError(journals.front(), {}, "holds no line of a file");
  }
  if (merged.files.size() != merged.n_files || merged.files.rbegin()->first >= merged.n_files) {
    throw IoError(journals.front(), {},
                  "and the other journals hold lines of " + std::to_string(merged.files.size()) +
                      " files, and the set has " + std::to_string(merged.n_files) +
                      ": a part is missing, or not complete");
  }
  return merged;
}

/// The files as they were when the lines were written.
JournalSubject subject_of(const MergedSubject& merged) {
  JournalSubject subject;
  for (const auto& [number, head] : merged.files) {
    subject.paths.push_back(head.path);
    subject.stamps.push_back(head.stamp);
  }
  subject.names = set_names(subject.paths);
  subject.asked = merged.asked;
  subject.fingerprint = merged.set;
  return subject;
}

/// The statistics of a set are made of the files anew, so these must be what they were.
void check_files(const JournalSubject& subject) {
  for (std::size_t i = 0; i < subject.paths.size(); ++i) {
    if (readable_stamp_of(subject.paths[i]) != subject.stamps[i]) {
      throw IoError(subject.paths[i], {},
                    "is not there, or has changed since its line was written");
    }
  }
}

/// JournalSubject::asked in its parts.
struct Asked {
  std::string version;
  bool is_set = false;
  std::vector<std::string> options;
};

/// @param text  Holds no quoted blanks.
Asked parse_asked(const std::string& text) {
  std::istringstream stream(text);
  Asked asked;
  std::string kind;
  stream >> asked.version >> kind;
  asked.is_set = kind == "set";
  for (std::string word; stream >> word;) {
    asked.options.push_back(word);
  }
  return asked;
}

Options options_of(const Asked& asked, const JournalSubject& subject,
                   const std::vector<std::string>& how_to_report) {
  std::vector<std::string> words{"meshalyzer"};
  words.insert(words.end(), asked.options.begin(), asked.options.end());
  words.insert(words.end(), how_to_report.begin(), how_to_report.end());
  words.emplace_back("--");
  words.insert(words.end(), subject.paths.begin(), subject.paths.end());
  std::vector<const char*> argv;
  std::transform(words.begin(), words.end(), std::back_inserter(argv),
                 [](const std::string& word) { return word.c_str(); });
  return parse_command_line(static_cast<int>(argv.size()), argv.data()).options;
}

}  // namespace

ExitCode merge(int argc, const char* const* argv, Streams streams) {
  const std::optional<MergeOptions> call = parse(argc, argv);
  if (!call) {
    streams.out << merge_help_text() << std::flush;
    return streams.out ? ExitCode::Done : ExitCode::Trouble;
  }
  JournalSubject subject = subject_of(read_heads(call->journals));
  const Asked asked = parse_asked(subject.asked);
  if (asked.version != MESHALYZER_VERSION) {
    throw IoError(call->journals.front(), {},
                  "was written by version " + asked.version + ", and this is " MESHALYZER_VERSION);
  }
  const Options options = options_of(asked, subject, call->how_to_report);
  subject.offenders = json_offenders(options);
  if (asked.is_set && tells_totals(options)) {
    check_files(subject);
  }
  KnownLines known;
  for (const std::string& journal : call->journals) {
    known.add(journal, subject);
  }
  const ThreadLimit limit(options.threads);
  const InterruptGuard guard;
  Inputs inputs{subject.paths, asked.is_set, {}};
  Session session(
      {options, std::move(inputs), std::move(subject), std::move(known), Task::Unknown::Refuse},
      streams);
  return session.work();
}

}  // namespace meshalyzer
