#include "meshalyzer/io/format_of.h"

#include "meshalyzer/io/obj.h"
#include "meshalyzer/io/off.h"
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

}  // namespace

bool has_ending(std::string_view name, std::string_view ending) {
  return name.size() >= ending.size() &&
         lower_case(name.substr(name.size() - ending.size())) == ending;
}

std::optional<Format> format_of_name(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, Format>, 5> kEndings = {{
      {".mesh", Format::Mesh},
      {".obj", Format::Obj},
      {".off", Format::Off},
      {".stl", Format::Stl},
      {".ply", Format::Ply},
  }};
  for (const auto& [ending, format] : kEndings) {
    if (has_ending(name, ending)) {
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

bool is_binary(std::string_view content, Format format) {
  if (format == Format::Stl) {
    return is_binary_stl(content) || content.find('\0') != std::string_view::npos;
  }
  return format == Format::Ply && parse_ply_header(content).encoding != PlyEncoding::Ascii;
}

bool is_inria(std::string_view content) {
  return first_word(content) == "MeshVersionFormatted";
}

}  // namespace meshalyzer
