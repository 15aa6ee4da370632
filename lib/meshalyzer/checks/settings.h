#pragma once

#include "meshalyzer/checks/criteria.h"

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {

/// What a user says of a check, on the command line or in a settings file. What is not said is left
/// to a layer below, and at last to the profile.
struct CheckSettings {
  std::optional<std::string> profile;
  /// Names of codes: see select_codes().
  std::vector<std::string> selected;
  std::vector<std::string> ignored;
  Limits limits;
  std::optional<std::size_t> max_listed;
};

/// Makes criteria of layers of settings. The last layer that says something counts; the codes that
/// are ignored add up.
///
/// @param layers  From the lowest to the highest; null ones say nothing.
[[nodiscard]] CheckCriteria make_criteria(std::initializer_list<const CheckSettings*> layers);

/// Settings for the files that fit a pattern.
struct SettingsSection {
  /// A pattern for paths relative to the folder of the settings file: see matches_glob().
  std::string path;
  CheckSettings settings;
};

/// What a settings file says.
struct SettingsFile {
  /// Where the file is; patterns are relative to it.
  std::string folder;
  CheckSettings settings;
  /// Patterns of files that are left out.
  std::vector<std::string> excluded;
  std::vector<SettingsSection> sections;
};

/// The name of settings files.
inline constexpr std::string_view kSettingsFileName = ".meshalyzer.toml";

/// Reads a settings file (doc/check.md).
///
/// @throws IoError  with the line of what cannot be understood, and the nearest key or code where
/// one is mistyped.
[[nodiscard]] SettingsFile read_settings_file(const std::string& path);

/// Does the same for text that is in memory; `path` stands in messages and says the folder.
[[nodiscard]] SettingsFile parse_settings(std::string_view text, const std::string& path);

/// Finds the settings file that is nearest to a file: in its folder or in one above. Empty where
/// there is none.
[[nodiscard]] std::string find_settings_file(const std::string& mesh_path);

/// Returns a path relative to the folder of a settings file.
[[nodiscard]] std::string path_within(const SettingsFile& file, const std::string& path);

/// Tells whether a settings file leaves a file out.
[[nodiscard]] bool is_excluded(const SettingsFile& file, const std::string& path);

/// Returns the criteria for one file: those of the settings file, of its sections that the file
/// fits, and of the command line.
///
/// @param file  Null where there is none.
[[nodiscard]] CheckCriteria criteria_for(const std::string& path, const SettingsFile* file,
                                         const CheckSettings& command_line);

}  // namespace meshalyzer
