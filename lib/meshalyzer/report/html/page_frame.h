#pragma once

#include "meshalyzer/report/html/scene_json.h"
#include "meshalyzer/report/html/writer.h"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace meshalyzer {

/// The verdict, which stands first and large on a page.
struct Verdict {
  enum class Kind { Good, Bad, None };
  Kind kind = Kind::None;
  std::string text;
  /// What is listed below the text: the reasons why it is not good, or what else was found.
  std::vector<std::string> reasons = {};
};

/// The subject of a page.
struct PageHeader {
  /// The path of the page of all meshes; empty if there is none.
  std::string index = {};
  /// The heading.
  std::string name;
  Verdict verdict;
  /// The facts about the subject in one line.
  std::string facts;
};

/// Returns the last part of a path.
[[nodiscard]] std::string file_name(const std::string& path);

/// Returns the size of a mesh in words: "12 faces, 8 vertices".
[[nodiscard]] std::string size_text(std::size_t n_faces, std::size_t n_vertices);

/// Returns the counts of the codes that count, in words: "hole: 2".
[[nodiscard]] std::vector<std::string> counts_of_codes(
    const std::function<std::size_t(DefectCode)>& count, const DefectCodes& requested);

/// Returns a whole page: head, subject, the view, the content, scripts.
/// @param meshes   The meshes that are drawn; without any the page has no view.
/// @param content  Appends the sections after the view.
[[nodiscard]] std::string html_page(const PageHeader& header, std::span<const TitledMesh> meshes,
                                    const std::function<void(HtmlWriter&)>& content);

}  // namespace meshalyzer
