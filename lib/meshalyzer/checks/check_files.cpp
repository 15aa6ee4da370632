#include "meshalyzer/checks/check_files.h"

#include "meshalyzer/base/error.h"
#include "meshalyzer/base/parallel_in_order.h"
#include "meshalyzer/base/require.h"
#include "meshalyzer/checks/check_mesh.h"
#include "meshalyzer/io/file.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/set/files_at_once.h"

#include <algorithm>
#include <iterator>
#include <new>

namespace meshalyzer {
namespace {

FileFindings unreadable(const CheckJob& job, std::string why, FilePlace place = {}) {
  FileFindings file;
  file.path = job.name;
  file.error = std::move(why);
  file.error_place = place;
  return file;
}

FileFindings check_file(const CheckJob& job) {
  try {
    const FileContent content(job.path);
    return check_mesh(parse_mesh(content.bytes(), job.name), job.name, job.criteria);
  } catch (const IoError& error) {
    return unreadable(job, error.reason(), error.place());
  } catch (const std::bad_alloc&) {
    return unreadable(job, "not enough memory");
  }
}

std::vector<std::string> paths_of(const std::vector<CheckJob>& jobs) {
  std::vector<std::string> paths;
  std::transform(jobs.begin(), jobs.end(), std::back_inserter(paths),
                 [](const CheckJob& job) { return job.path; });
  return paths;
}

}  // namespace

bool check_files(const std::vector<CheckJob>& jobs, std::uint64_t memory_limit,
                 const std::function<bool(const FileFindings&)>& on_file) {
  require_function("check_files: on_file", on_file);
  bool is_whole = true;
  parallel_in_order(
      jobs.size(), n_files_at_once(paths_of(jobs), memory_limit),
      [&](std::size_t i) { return check_file(jobs[i]); },
      [&](std::size_t, const FileFindings& file) {
        is_whole = on_file(file);
        return is_whole ? Next::GoOn : Next::Stop;
      });
  return is_whole;
}

}  // namespace meshalyzer
