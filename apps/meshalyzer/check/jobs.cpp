#include "check/jobs.h"

#include "meshalyzer/checks/settings.h"

#include <map>

namespace meshalyzer {
namespace {

/// Finds the settings for files, and reads each settings file once.
class SettingsFiles {
 public:
  explicit SettingsFiles(const CheckCommand& command) : command_(command) {}

  /// Returns the settings for a mesh file, or null if there are none.
  const SettingsFile* of(const std::string& mesh) {
    if (command_.is_isolated) return nullptr;
    const std::string path =
        command_.settings_file ? *command_.settings_file : find_settings_file(mesh);
    if (path.empty()) return nullptr;
    const auto [known, is_new] = files_.try_emplace(path);
    if (is_new) known->second = read_settings_file(path);
    return &known->second;
  }

 private:
  const CheckCommand& command_;
  std::map<std::string, SettingsFile> files_;
};

}  // namespace

std::vector<CheckJob> jobs_of(const CheckCommand& command, const std::vector<std::string>& files) {
  SettingsFiles settings(command);
  std::vector<CheckJob> jobs;
  for (const std::string& file : files) {
    const std::string name = file == "-" ? command.stdin_name.value_or("-") : file;
    const SettingsFile* from_file = settings.of(name);
    if (from_file != nullptr && is_excluded(*from_file, name)) continue;
    jobs.push_back({file, name, criteria_for(name, from_file, command.settings)});
  }
  return jobs;
}

}  // namespace meshalyzer
