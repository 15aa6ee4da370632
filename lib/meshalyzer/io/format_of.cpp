#include "meshalyzer/io/format_of.h"

#include "meshalyzer/io/obj.h"
#include "meshalyzer/io/off_keyword.h"
#include "meshalyzer/io/ply_header.h"
#include "meshalyzer/io/stl.h"
#include "meshalyzer/io/text_scanner.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace meshalyzer {
namespace {

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return lower;
}

std::string_view first_word(std::string_view content) {
  TextScanner in(content);
  return in.next_record() ? in.word() : std::string_view{};
}

/// Returns the certain format of a content: its first word begins files of this format and no
/// others.
std::optional<Format> unmistakable_format(std::string_view content) {
  constexpr std::array<std::string_view, 8> kObjBeginnings = {"v", "vn", "vt",     "f",
                                                              "g", "o",  "mtllib", "usemtl"};
  const std::optional<Format> format = format_of_content(content);
  const bool is_weak =
      format == Format::Obj && std::find(kObjBeginnings.begin(), kObjBeginnings.end(),
                                         first_word(content)) == kObjBeginnings.end();
  return is_weak ? std::nullopt : format;
}

}  // namespace

bool has_ending(std::string_view name, std::string_view ending) {
  return name.size() >= ending.size() &&
         lower_case(name.substr(name.size() - ending.size())) == ending;
}

bool is_gzip_name(std::string_view name) {
  return has_ending(name, ".gz");
}

std::optional<Format> format_of_name(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, Format>, 5> kEndings = {{
      {".mesh", Format::Mesh},
      {".obj", Format::Obj},
      {".off", Format::Off},
      {".stl", Format::Stl},
      {".ply", Format::Ply},
  }};
  const std::string_view plain = is_gzip_name(name) ? name.substr(0, name.size() - 3) : name;
  for (const auto& [ending, format] : kEndings) {
    if (has_ending(plain, ending)) {
      return format;
    }
  }
  return std::nullopt;
}

std::optional<Format> format_of_content(std::string_view content) {
  if (is_binary_stl(content)) {
    return Format::Stl;
  }
  const std::string_view word = first_word(content);
  if (word == "ply") {
    return Format::Ply;
  }
  if (word == "MeshVersionFormatted") {
    return Format::Inria;
  }
  if (word == "Vertex" || word == "Face") {
    return Format::Mesh;
  }
  if (is_off_keyword(word)) {
    return Format::Off;
  }
  if (lower_case(word) == "solid") {
    return Format::Stl;
  }
  if (is_obj_keyword(word)) {
    return Format::Obj;
  }
  return std::nullopt;
}

std::optional<Format> format_of(std::string_view content, std::string_view name) {
  const std::optional<Format> by_name = format_of_name(name);
  if (!by_name) {
    return format_of_content(content);
  }
  const bool is_stl = by_name == Format::Stl && is_binary(content, Format::Stl);
  const std::optional<Format> by_content = is_stl ? by_name : unmistakable_format(content);
  return by_content ? by_content : by_name;
}

bool is_binary(std::string_view content, Format format) {
  if (format == Format::Stl) {
    return is_binary_stl(content) || content.find('\0') != std::string_view::npos;
  }
  if (format == Format::Off) {
    return is_binary_off(content);
  }
  return format == Format::Ply && parse_ply_header(content).encoding != PlyEncoding::Ascii;
}

bool is_named_as(std::string_view name, Format format) {
  const std::optional<Format> by_name = format_of_name(name);
  return !by_name || by_name == format || (by_name == Format::Mesh && format == Format::Inria);
}

}  // namespace meshalyzer
