#pragma once

#include "meshalyzer/checks/criteria.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// The settings of a check, from the command line or a settings file. Settings that are absent come
/// from the layer below, and finally from the profile.
struct CheckSettings {
  std::optional<std::string> profile;
  /// The names of codes to select: see select_codes().
  std::vector<std::string> selected;
  std::vector<std::string> ignored;
  Limits limits;
  std::optional<std::size_t> max_listed;
};

/// The settings for the files that match a pattern.
struct SettingsSection {
  /// A pattern for paths relative to the folder of the settings file: see matches_glob().
  std::string path;
  CheckSettings settings;
};

/// The content of a settings file.
struct SettingsFile {
  /// The folder of the file, to which patterns are relative.
  std::string folder;
  CheckSettings settings;
  /// The patterns of files to skip.
  std::vector<std::string> excluded;
  std::vector<SettingsSection> sections;
};

/// The name of settings files.
inline constexpr std::string_view kSettingsFileName = ".meshalyzer.toml";

/// Reads a settings file (doc/check.md).
///
/// @throws IoError  with the line of the mistake, and the nearest key or code if one is mistyped.
[[nodiscard]] SettingsFile read_settings_file(const std::string& path);

/// Parses the text of a settings file; `path` appears in messages and determines the folder.
[[nodiscard]] SettingsFile parse_settings(std::string_view text, const std::string& path);

/// Finds the settings file nearest to a file: in its folder or in one above. What has that name but
/// cannot be read, such as a broken link, is found too, so that reading it says why. The result is
/// empty if there is none.
[[nodiscard]] std::string find_settings_file(const std::string& mesh_path);

/// Returns a path relative to the folder of a settings file.
[[nodiscard]] std::string path_within(const SettingsFile& file, const std::string& path);

/// Tells whether a settings file excludes a file, or a folder that it is in.
[[nodiscard]] bool is_excluded(const SettingsFile& file, const std::string& path);

/// Returns the criteria for one file, from the settings file, its sections that match the file, and
/// the command line.
///
/// @param file  The settings file, or null if there is none.
[[nodiscard]] CheckCriteria criteria_for(const std::string& path, const SettingsFile* file,
                                         const CheckSettings& command_line);

}  // namespace meshalyzer
