#include "meshalyzer/checks/settings.h"

#include "meshalyzer/checks/mesh_files.h"
#include "meshalyzer/checks/profile.h"
#include "meshalyzer/checks/selection.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace meshalyzer {
namespace {

namespace fs = std::filesystem;

const CheckProfile& profile_of(const std::vector<const CheckSettings*>& layers) {
  const CheckProfile* profile = &check_profiles().front();
  for (const CheckSettings* layer : layers) {
    const CheckProfile* named = layer->profile ? find_profile(*layer->profile) : nullptr;
    if (named != nullptr) profile = named;
  }
  return *profile;
}

/// Combines layers of settings to criteria. The last layer that has a setting decides it; ignored
/// codes accumulate.
///
/// @param layers  The layers from the lowest to the highest.
CheckCriteria criteria_of(const std::vector<const CheckSettings*>& layers) {
  CheckCriteria criteria = profile_of(layers).criteria;
  std::vector<std::string> selected;
  std::vector<std::string> ignored;
  for (const CheckSettings* layer : layers) {
    for (const LimitInfo& info : limit_table()) {
      if (layer->limits[info.kind]) criteria.limits[info.kind] = layer->limits[info.kind];
    }
    if (!layer->selected.empty()) selected = layer->selected;
    ignored.insert(ignored.end(), layer->ignored.begin(), layer->ignored.end());
    if (layer->max_listed) {
      criteria.max_listed = *layer->max_listed;
      criteria.max_lines = 0;
    }
  }
  select_codes(selected, ignored, criteria);
  return criteria;
}

}  // namespace

std::string find_settings_file(const std::string& mesh_path) {
  std::error_code error;
  for (fs::path folder = fs::absolute(mesh_path, error).lexically_normal().parent_path();;
       folder = folder.parent_path()) {
    const fs::path file = folder / kSettingsFileName;
    if (fs::exists(fs::symlink_status(file, error))) return file.string();
    if (folder == folder.parent_path()) return {};
  }
}

std::string path_within(const SettingsFile& file, const std::string& path) {
  std::error_code error;
  return fs::absolute(path, error)
      .lexically_normal()
      .lexically_relative(fs::absolute(file.folder, error).lexically_normal())
      .string();
}

bool is_excluded(const SettingsFile& file, const std::string& path) {
  for (fs::path within = path_within(file, path); !within.empty(); within = within.parent_path()) {
    const std::string part = within.string();
    if (std::any_of(file.excluded.begin(), file.excluded.end(),
                    [&](const std::string& pattern) { return matches_glob(pattern, part); })) {
      return true;
    }
  }
  return false;
}

CheckCriteria criteria_for(const std::string& path, const SettingsFile* file,
                           const CheckSettings& command_line) {
  std::vector<const CheckSettings*> layers;
  if (file != nullptr) {
    layers.push_back(&file->settings);
    const std::string within = path_within(*file, path);
    for (const SettingsSection& section : file->sections) {
      if (matches_glob(section.path, within)) layers.push_back(&section.settings);
    }
  }
  layers.push_back(&command_line);
  return criteria_of(layers);
}

}  // namespace meshalyzer
