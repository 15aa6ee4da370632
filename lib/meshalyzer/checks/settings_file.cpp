#include "meshalyzer/base/error.h"
#include "meshalyzer/base/nearest_name.h"
#include "meshalyzer/checks/profile.h"
#include "meshalyzer/checks/selection.h"
#include "meshalyzer/checks/settings.h"
#include "meshalyzer/io/file.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <toml++/toml.h>
#include <utility>

namespace meshalyzer {
namespace {

/// The keys that a table of a settings file may have in addition to limits.
constexpr std::array<std::string_view, 4> kCommonKeys{"profile", "select", "ignore", "max"};

/// Reads the values of a settings file, and reports the line of a wrong one.
class SettingsReader {
 public:
  explicit SettingsReader(std::string path) : path_(std::move(path)) {}

  SettingsFile read(std::string_view text) {
    SettingsFile file;
    file.folder = std::filesystem::path(path_).parent_path().string();
    try {
      const toml::table table = toml::parse(text);
      for (const auto& [key, node] : table) {
        if (key.str() == "exclude") {
          file.excluded = texts(node);
        } else if (key.str() == "files") {
          read_sections(node, file);
        } else if (!read_common(key, node, file.settings)) {
          refuse_key(key, {"exclude", "files"});
        }
      }
    } catch (const toml::parse_error& error) {
      throw IoError(path_, {.line = error.source().begin.line}, std::string(error.description()));
    }
    return file;
  }

 private:
  void read_sections(const toml::node& node, SettingsFile& file) {
    const toml::array* const sections = node.as_array();
    if (sections == nullptr) refuse(node, "files are sections: [[files]]");
    for (const toml::node& each : *sections) {
      const toml::table* const table = each.as_table();
      if (table == nullptr) refuse(each, "files are sections: [[files]]");
      file.sections.push_back(read_section(*table));
    }
  }

  SettingsSection read_section(const toml::table& table) {
    SettingsSection section;
    for (const auto& [key, node] : table) {
      if (key.str() == "path") {
        section.path = text(node);
      } else if (!read_common(key, node, section.settings)) {
        refuse_key(key, {"path"});
      }
    }
    if (section.path.empty()) refuse(table, "a section [[files]] needs a path");
    return section;
  }

  /// @return True if the key is one that every table may have.
  bool read_common(const toml::key& key, const toml::node& node, CheckSettings& settings) {
    if (key.str() == "profile") {
      settings.profile = profile(node);
    } else if (key.str() == "select") {
      settings.selected = codes(node);
    } else if (key.str() == "ignore") {
      settings.ignored = codes(node);
    } else if (key.str() == "max") {
      settings.max_listed = count(node);
    } else if (const std::optional<LimitKind> limit = limit_kind(key.str())) {
      settings.limits[*limit] = number(node);
    } else {
      return false;
    }
    return true;
  }

  [[nodiscard]] std::string profile(const toml::node& node) const {
    std::string name = text(node);
    if (const std::string why = why_no_profile(name); !why.empty()) refuse(node, why);
    return name;
  }

  [[nodiscard]] std::vector<std::string> codes(const toml::node& node) const {
    std::vector<std::string> names = texts(node);
    for (const std::string& name : names) {
      if (const std::string why = why_no_check_code(name); !why.empty()) refuse(node, why);
    }
    return names;
  }

  [[nodiscard]] std::string text(const toml::node& node) const {
    const auto value = node.value<std::string>();
    if (!value) refuse(node, "a text should stand here");
    return *value;
  }

  [[nodiscard]] std::vector<std::string> texts(const toml::node& node) const {
    const toml::array* const array = node.as_array();
    if (array == nullptr) refuse(node, "a list of texts should stand here: [\"...\"]");
    std::vector<std::string> values;
    for (const toml::node& each : *array) values.push_back(text(each));
    return values;
  }

  [[nodiscard]] double number(const toml::node& node) const {
    const auto value = node.value<double>();
    if (!value || std::isnan(*value)) refuse(node, "a number should stand here");
    return *value;
  }

  [[nodiscard]] std::size_t count(const toml::node& node) const {
    const auto value = node.value<std::int64_t>();
    if (!value || *value < 0) refuse(node, "a whole number, 0 or more, should stand here");
    return static_cast<std::size_t>(*value);
  }

  [[noreturn]] void refuse(const toml::node& node, const std::string& what) const {
    throw IoError(path_, {.line = node.source().begin.line}, what);
  }

  /// @param more  The keys that the table may have in addition to the common ones.
  [[noreturn]] void refuse_key(const toml::key& key,
                               std::initializer_list<std::string_view> more) const {
    std::vector<std::string_view> names(more);
    names.insert(names.end(), kCommonKeys.begin(), kCommonKeys.end());
    for (const LimitInfo& info : limit_table()) names.push_back(info.name);
    throw IoError(path_, {.line = key.source().begin.line},
                  fmt::format("unknown key '{}'{}", key.str(), did_you_mean(key.str(), names)));
  }

  std::string path_;
};

}  // namespace

SettingsFile parse_settings(std::string_view text, const std::string& path) {
  return SettingsReader(path).read(text);
}

SettingsFile read_settings_file(const std::string& path) {
  const FileContent content(path);
  return parse_settings(content.bytes(), path);
}

}  // namespace meshalyzer
