#include "meshalyzer/report/html/page_frame.h"

#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/report/html/assets.h"

#include <cctype>
#include <fmt/format.h>
#include <string_view>
#include <utility>

namespace meshalyzer {
namespace {

/// The content security policy, which forbids loading anything from outside the page.
constexpr std::string_view kPolicy =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data: "
    "blob:";

/// Returns the title of a page: "cube.obj: good".
std::string title_of(const PageHeader& header) {
  std::string title = header.name;
  if (header.verdict.text.empty()) return title;
  title += ": ";
  const std::size_t begin = title.size();
  title += header.verdict.text;
  const auto first = static_cast<unsigned char>(title[begin]);
  title[begin] = static_cast<char>(std::tolower(first));
  return title;
}

void append_head(HtmlWriter& html, const PageHeader& header) {
  const HtmlElement head(html, "head");
  html.void_element("meta", {{"charset", "utf-8"}});
  html.void_element("meta",
                    {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
  html.void_element("meta", {{"http-equiv", "Content-Security-Policy"}, {"content", kPolicy}});
  html.element("title", title_of(header));
  const HtmlElement style(html, "style");
  html.markup(kPageStyle);
}

void append_verdict(HtmlWriter& html, const Verdict& verdict) {
  const std::string_view kind = verdict.kind == Verdict::Kind::Good  ? "verdict good"
                                : verdict.kind == Verdict::Kind::Bad ? "verdict bad"
                                                                     : "verdict";
  html.element("p", {{"class", kind}, {"role", "status"}}, verdict.text);
  if (verdict.reasons.empty()) return;
  const HtmlElement list(html, "ul", {{"class", "reasons"}});
  for (const std::string& reason : verdict.reasons) html.element("li", reason);
}

void append_header(HtmlWriter& html, const PageHeader& header) {
  const HtmlElement element(html, "header");
  if (!header.index.empty()) {
    const HtmlElement nav(html, "nav");
    html.element("a", {{"href", address_of(header.index)}}, "All meshes");
  }
  html.element("h1", header.name);
  if (!header.verdict.text.empty()) append_verdict(html, header.verdict);
  html.element("p", {{"class", "facts"}}, header.facts);
}

void append_view(HtmlWriter& html) {
  const HtmlElement section(html, "section", {{"id", "view"}, {"aria-labelledby", "view-title"}});
  html.element("h2", {{"id", "view-title"}}, "View");
  html.markup("\n");
  html.markup(kViewMarkup);
}

void append_script(HtmlWriter& html, std::string_view script) {
  const HtmlElement element(html, "script");
  html.markup("\n");
  html.markup(script);
}

void append_view_scripts(HtmlWriter& html, std::span<const TitledMesh> meshes) {
  {
    const HtmlElement data(html, "script", {{"type", "application/json"}, {"id", "scene-data"}});
    append_scene_json(html.html(), meshes);
  }
  {
    const HtmlElement three(html, "script");
    html.markup("\n/*\n");
    html.markup(kThreeLicence);
    html.markup("*/\n");
    html.markup(kThree);
  }
  append_script(html, kOrbitControls);
  append_script(html, kViewScript);
}

void append_body(HtmlWriter& html, const PageHeader& header, std::span<const TitledMesh> meshes,
                 const std::function<void(HtmlWriter&)>& content) {
  const HtmlElement body(html, "body");
  const bool has_view = !meshes.empty();
  if (has_view) {
    html.markup("\n");
    html.element("a", {{"class", "skip"}, {"href", "#defects"}}, "Skip the view");
  }
  append_header(html, header);
  {
    const HtmlElement main(html, "main");
    if (has_view) append_view(html);
    content(html);
  }
  html.element("footer", "Made by meshalyzer " MESHALYZER_VERSION);
  if (has_view) {
    append_view_scripts(html, meshes);
  } else {
    append_script(html, kIndexScript);
  }
}

}  // namespace

std::string file_name(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  const bool is_last = slash == std::string::npos || slash + 1 == path.size();
  return is_last ? path : path.substr(slash + 1);
}

std::string size_text(std::size_t n_faces, std::size_t n_vertices) {
  return counted(n_faces, "face", "faces") + ", " + counted(n_vertices, "vertex", "vertices");
}

std::vector<std::string> counts_of_codes(const std::function<std::size_t(DefectCode)>& count,
                                         const DefectCodes& requested) {
  std::vector<std::string> counts;
  for (const DefectCode code : all_defect_codes()) {
    const std::size_t n = requested.contains(code) ? count(code) : 0;
    if (n != 0) counts.push_back(fmt::format("{}: {}", defect_name(code), grouped(n)));
  }
  return counts;
}

std::string html_page(const PageHeader& header, std::span<const TitledMesh> meshes,
                      const std::function<void(HtmlWriter&)>& content) {
  HtmlWriter html;
  html.markup("<!doctype html>\n");
  {
    const HtmlElement document(html, "html", {{"lang", "en"}});
    append_head(html, header);
    append_body(html, header, meshes, content);
  }
  html.markup("\n");
  return std::move(html.html());
}

}  // namespace meshalyzer
