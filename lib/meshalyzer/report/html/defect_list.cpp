#include "meshalyzer/report/html/defect_list.h"

#include "meshalyzer/base/grouped_digits.h"
#include "meshalyzer/defects/catalogue.h"
#include "meshalyzer/report/html/attribute_tables.h"
#include "meshalyzer/report/html/colour_text.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meshalyzer {
namespace {

/// Appends the description of a defect, with its elements separate from its position and measured
/// value.
void append_parts(HtmlWriter& html, std::string_view text) {
  constexpr std::string_view kSeparator = "; ";
  const std::size_t end = text.find(kSeparator);
  html.element("span", {{"class", "elements"}}, text.substr(0, end));
  if (end == std::string_view::npos) return;
  html.text(" ");
  html.element("span", {{"class", "measured"}}, text.substr(end + kSeparator.size()));
}

/// Opens the button that selects a highlight of a scene.
HtmlElement highlight_button(HtmlWriter& html, std::size_t scene, std::size_t highlight) {
  return {html,
          "button",
          {{"type", "button"},
           {"class", "defect"},
           {"data-scene", std::to_string(scene)},
           {"data-highlight", std::to_string(highlight)}}};
}

/// The defects of one mesh of the page.
class DefectSection {
 public:
  DefectSection(const PageMesh& mesh, std::size_t scene)
      : mesh_(mesh), scene_(scene), highlights_(mesh.defects.defects.size()) {
    for (std::size_t i = 0; i < mesh.scene.highlights.size(); ++i) {
      highlights_[mesh.scene.highlights[i].number] = i;
    }
    outcomes_.resize(mesh.defects.defects.size());
    for (const PagePatch& patch : mesh.patches) outcomes_[patch.defect] = patch.text;
  }

  /// Appends the list, errors first.
  void append(HtmlWriter& html) const {
    if (mesh_.defects.total() == 0) {
      html.element("p", {{"class", "none"}}, "Nothing is wrong.");
      return;
    }
    for (const Severity severity : {Severity::Error, Severity::Warning}) {
      for (const DefectCode code : all_defect_codes()) {
        if (catalogue_entry(code).severity != severity) continue;
        if (mesh_.defects.count(code) != 0) append_code(html, code);
      }
    }
  }

 private:
  void append_code(HtmlWriter& html, DefectCode code) const {
    const HtmlElement details(html, "details",
                              {{"class", "code"}, {"open", ""}, {"data-code", defect_name(code)}});
    append_summary(html, code);
    const std::size_t n = append_defects_of(html, code);
    const std::size_t left_out = mesh_.defects.count(code) - n;
    if (left_out == 0) return;
    html.element("p", {{"class", "cut"}},
                 counted(left_out, "more is not listed.", "more are not listed."));
  }

  void append_summary(HtmlWriter& html, DefectCode code) const {
    const HtmlElement summary(html, "summary");
    html.element("span", {{"class", "swatch"}, {"style", "background:" + colour_text(code)}}, "");
    html.text(" ");
    html.element("code", defect_name(code));
    html.text(" ");
    html.element("span", {{"class", "count"}}, grouped(mesh_.defects.count(code)));
    html.text(" ");
    if (catalogue_entry(code).severity == Severity::Warning) {
      html.element("span", {{"class", "severity"}}, severity_name(Severity::Warning));
      html.text(" ");
    }
    html.element("span", {{"class", "meaning"}}, catalogue_entry(code).summary);
  }

  /// @return The number of listed defects.
  std::size_t append_defects_of(HtmlWriter& html, DefectCode code) const {
    const DefectList& defects = mesh_.defects.defects;
    std::size_t i = 0;
    while (i < defects.size() && defects.code_of(i) != code) ++i;
    if (i == defects.size()) return 0;
    std::size_t n = 0;
    const HtmlElement list(html, "ol");
    for (; i < defects.size() && defects.code_of(i) == code && n < kListedOfACode; ++i, ++n) {
      const HtmlElement item(html, "li");
      append_defect(html, i);
    }
    return n;
  }

  void append_defect(HtmlWriter& html, std::size_t i) const {
    if (!highlights_[i]) return append_description(html, i);
    const HtmlElement button = highlight_button(html, scene_, *highlights_[i]);
    append_description(html, i);
  }

  void append_description(HtmlWriter& html, std::size_t i) const {
    append_parts(html, listed_defect_text(mesh_.defects.defects[i], mesh_.name));
    if (outcomes_[i].empty()) return;
    html.text(" ");
    html.element("span", {{"class", "measured"}}, "A repair: " + outcomes_[i]);
  }

  const PageMesh& mesh_;
  std::size_t scene_;
  /// The position of each defect among the highlights of the scene.
  std::vector<std::optional<std::size_t>> highlights_;
  /// The outcome of a repair for each defect, if one was tried.
  std::vector<std::string> outcomes_;
};

/// Appends the changes of one mesh of the page, by pass.
void append_changes(HtmlWriter& html, const PageMesh& mesh, std::size_t scene) {
  const std::span<const PageChange> changes = mesh.changes;
  for (std::size_t i = 0; i < changes.size();) {
    const auto end = std::find_if(changes.begin() + static_cast<std::ptrdiff_t>(i), changes.end(),
                                  [&](const PageChange& c) { return c.pass != changes[i].pass; });
    const auto n = static_cast<std::size_t>(end - changes.begin()) - i;
    const HtmlElement details(html, "details", {{"class", "code"}, {"open", ""}});
    {
      const HtmlElement summary(html, "summary");
      html.element("code", changes[i].pass);
      html.text(" ");
      html.element("span", {{"class", "count"}}, grouped(n));
    }
    const HtmlElement list(html, "ol");
    for (const std::size_t last = i + n; i < last; ++i) {
      const HtmlElement item(html, "li");
      const HtmlElement button = highlight_button(html, scene, mesh.scene.highlights.size() + i);
      html.element("span", {{"class", "elements"}}, changes[i].text);
    }
  }
}

}  // namespace

void append_changes_section(HtmlWriter& html, std::span<const TitledMesh> meshes) {
  if (std::all_of(meshes.begin(), meshes.end(),
                  [](const TitledMesh& mesh) { return mesh.mesh.changes.empty(); })) {
    return;
  }
  const HtmlSection section(html, "changes", "Changes");
  html.element(
      "p", {{"class", "hint"}},
      "Press one to see where it is: the mesh before shows the faces that were dropped, cut or "
      "changed; the mesh after shows their replacements, and the seams along which separate "
      "faces were joined.");
  for (std::size_t scene = 0; scene < meshes.size(); ++scene) {
    if (meshes[scene].mesh.changes.empty()) continue;
    html.element("h3", meshes[scene].title);
    append_changes(html, meshes[scene].mesh, scene);
  }
}

void append_defects_section(HtmlWriter& html, std::span<const TitledMesh> meshes) {
  const HtmlSection section(html, "defects", "Defects");
  const bool is_any_lit = std::any_of(meshes.begin(), meshes.end(), [](const TitledMesh& mesh) {
    return !mesh.mesh.scene.highlights.empty();
  });
  if (is_any_lit) html.element("p", {{"class", "hint"}}, "Press one to see where it is.");
  for (std::size_t scene = 0; scene < meshes.size(); ++scene) {
    if (meshes.size() > 1) html.element("h3", meshes[scene].title);
    DefectSection(meshes[scene].mesh, scene).append(html);
  }
}

}  // namespace meshalyzer
