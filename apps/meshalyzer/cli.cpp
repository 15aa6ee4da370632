#include "cli.h"

#include "guarded.h"
#include "inputs.h"
#include "interrupt.h"
#include "merge.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/io/file_replacement.h"
#include "options.h"
#include "session.h"
#include "usage_error.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <ostream>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meshalyzer {
namespace {

/// What speaks against this use of folders, which only looking at the paths can tell.
void check_folders(const Options& options) {
  if (options.show != Show::TotalVolume) {
    return;
  }
  for (const std::string& path : options.paths) {
    if (!is_folder(path)) {
      throw UsageError("-v needs a folder, and " + path + " is none");
    }
  }
}

bool has_stdin(const std::vector<std::string>& paths) {
  return std::find(paths.begin(), paths.end(), "-") != paths.end();
}

/// Several files are a set too where somebody asks for what is between them.
void check_set(const Options& options, Inputs& inputs) {
  if (options.asked.any() && options.paths.size() > 1) {
    inputs.is_set = true;
  }
  if (options.asked.any() && !inputs.is_set) {
    throw UsageError("-i and -s need a folder, or several files");
  }
  const bool shows_separation =
      options.field_export && options.field_export->field == FieldName::Separation;
  if (shows_separation && !inputs.is_set) {
    throw UsageError("--field separation needs a folder, or several files with -s");
  }
  if (has_stdin(inputs.files) && inputs.is_set && questions_of(options).is_between()) {
    throw UsageError("standard input can be read only once, so it cannot be part of a set");
  }
}

/// A journal is of files that are there to be looked at again.
void check_journal(const Options& options) {
  const bool has_journal = options.resume || (options.ndjson && !options.ndjson->is_stdout());
  if (has_stdin(options.paths) && has_journal) {
    throw UsageError("no journal can tell whether standard input (-) is still the same");
  }
}

/// A file named twice is one mesh of a set.
void drop_repeated(std::vector<std::string>& files) {
  std::set<std::string> met;
  std::erase_if(files, [&](const std::string& file) { return !met.insert(file).second; });
}

/// The lines that an earlier run left where this one is to leave its own, or in the journal to be
/// resumed.
KnownLines recall(const Options& options, const JournalSubject& subject) {
  KnownLines known;
  if (options.resume) {
    known.add(*options.resume, subject);
  } else if (options.ndjson && std::filesystem::is_regular_file(options.ndjson->file)) {
    known.add(options.ndjson->file, subject);
  }
  return known;
}

/// The journal, with those lines in it that still hold.
std::unique_ptr<JournalWriter> open_journal(const ReportTarget& target, const Task& task,
                                            std::ostream& out) {
  if (target.is_stdout()) {
    task.known.write(task.subject, [&](std::string_view line) { out << line; });
    return std::make_unique<JournalWriter>(out);
  }
  FileReplacement file(target.file);
  task.known.write(task.subject, [&](std::string_view line) { file.write(line); });
  file.commit();
  return std::make_unique<JournalWriter>(target.file);
}

ExitCode check(const Options& options, Streams streams) {
  check_folders(options);
  check_journal(options);
  Inputs inputs = find_inputs(options.paths);
  check_set(options, inputs);
  if (inputs.is_set) {
    drop_repeated(inputs.files);
  }
  const ThreadLimit limit(options.threads);
  const InterruptGuard guard;
  const std::string asked =
      MESHALYZER_VERSION + std::string(inputs.is_set ? " set " : " files ") + options.asked_text;
  JournalSubject subject = make_subject(inputs.files, asked);
  subject.offenders = json_offenders(options);
  KnownLines known = recall(options, subject);
  PicturePaths pictures = picture_paths(options, inputs);
  Task task{options,          std::move(inputs),   std::move(subject),
            std::move(known), Task::Unknown::Find, std::move(pictures)};
  std::unique_ptr<JournalWriter> journal;
  if (options.ndjson) {
    journal = open_journal(*options.ndjson, task, streams.out);
  }
  Session session(std::move(task), streams);
  session.keep_journal(std::move(journal));
  return session.work();
}

ExitCode run_command(int argc, const char* const* argv, Streams streams) {
  if (argc > 1 && std::string_view(argv[1]) == "merge") {
    return merge(argc - 1, argv + 1, streams);
  }
  const CommandLine command = parse_command_line(argc, argv);
  if (command.answer) {
    streams.out << *command.answer << std::flush;
    return streams.out ? ExitCode::Done : ExitCode::Trouble;
  }
  return check(command.options, streams);
}

}  // namespace

int run(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  const Streams streams{out, err};
  return run_guarded("meshalyzer", streams, [&] { return run_command(argc, argv, streams); });
}

}  // namespace meshalyzer
