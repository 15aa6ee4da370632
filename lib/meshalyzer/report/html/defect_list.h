#pragma once

#include "meshalyzer/picture/scene.h"
#include "meshalyzer/report/html/scene_json.h"
#include "meshalyzer/report/html/writer.h"

#include <cstddef>
#include <span>

namespace meshalyzer {

/// The number of defects of each code that are listed: those that the view can highlight; the
/// others are only counted.
inline constexpr std::size_t kListedOfACode = SceneLimits{}.max_defects_of_a_code;

/// Appends the section of the changes of all meshes of the page, by pass, each as a button; nothing
/// if there are none.
void append_changes_section(HtmlWriter& html, std::span<const TitledMesh> meshes);

/// Appends the section of the defects of all meshes of the page, by code. A defect that the scene
/// highlights is a button for the view.
void append_defects_section(HtmlWriter& html, std::span<const TitledMesh> meshes);

}  // namespace meshalyzer
