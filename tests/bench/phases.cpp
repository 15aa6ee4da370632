#include "meshalyzer/analysis/analyze.h"
#include "meshalyzer/base/error.h"
#include "meshalyzer/base/numbers.h"
#include "meshalyzer/base/parallel.h"
#include "meshalyzer/io/read.h"
#include "meshalyzer/report/json/report.h"
#include "meshalyzer/report/text/mesh_report.h"

#include <chrono>
#include <fmt/core.h>
#include <iostream>
#include <string>
#include <sys/resource.h>

namespace {

using Clock = std::chrono::steady_clock;

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Peak resident memory so far, in MB.
double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// Prints the time that each phase took, and the peak of memory when it ended.
class Stopwatch {
 public:
  void begin(std::string_view phase) {
    end();
    phase_ = phase;
    wall_ = Clock::now();
    cpu_ = cpu_seconds();
  }
  void end() {
    if (!phase_.empty()) {
      const double wall = std::chrono::duration<double>(Clock::now() - wall_).count();
      fmt::print("| {:<18} | {:8.3f} | {:8.3f} | {:8.0f} |\n", phase_, wall, cpu_seconds() - cpu_,
                 peak_megabytes());
    }
    phase_.clear();
  }

 private:
  std::string phase_;
  Clock::time_point wall_;
  double cpu_ = 0.0;
};

void run(const std::string& path) {
  Stopwatch watch;
  const auto start = Clock::now();
  fmt::print("| phase              |   wall s |    CPU s |  peak MB |\n|---|---:|---:|---:|\n");
  watch.begin("read");
  meshalyzer::Soup soup = meshalyzer::read_mesh(path);
  const std::size_t faces = soup.n_faces();
  meshalyzer::AnalysisOptions options;
  options.on_phase = [&](std::string_view phase) { watch.begin(phase); };
  const meshalyzer::Analysis analysis = meshalyzer::analyze(std::move(soup), path, options);
  watch.begin("report");
  const std::string text = meshalyzer::text_report(analysis, meshalyzer::OffenderStyle::None);
  watch.end();
  fmt::print("| {:<18} | {:8.3f} | {:8.3f} | {:8.0f} |\n", "all",
             std::chrono::duration<double>(Clock::now() - start).count(), cpu_seconds(),
             peak_megabytes());
  fmt::print("\n{} faces, {:.0f} bytes a face at the peak, {} intersecting pairs\n", faces,
             peak_megabytes() * 1024 * 1024 / static_cast<double>(faces),
             analysis.characteristics.intersecting_pairs);
}

}  // namespace

/// phases FILE [THREADS]: analyses a mesh as the command does and prints the time and memory of
/// each phase.
int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::cerr << "usage: phases FILE [THREADS]\n";
    return 2;
  }
  try {
    const meshalyzer::ThreadLimit limit(
        argc == 3 ? static_cast<std::size_t>(meshalyzer::parse_integer(argv[2]).value_or(0)) : 0);
    run(argv[1]);
  } catch (const meshalyzer::Error& e) {
    std::cerr << e.what() << '\n';
    return 3;
  }
  return 0;
}
