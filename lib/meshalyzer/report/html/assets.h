#pragma once

#include <string_view>

namespace meshalyzer {

// The constant parts of pages; embed.cmake makes a .cpp of the files.

/// The style sheet, assets/page.css.
extern const std::string_view kPageStyle;
/// The view and its controls, assets/view.html.
extern const std::string_view kViewMarkup;
/// The scripts of the view, in the order in which they run.
extern const std::string_view kViewScript;
/// The scripts of a page without a view.
extern const std::string_view kIndexScript;
/// The licence of three.js and of its controls, assets/three_licence.txt.
extern const std::string_view kThreeLicence;
/// The file three.min.js of three.js.
extern const std::string_view kThree;
/// The file OrbitControls.js of three.js.
extern const std::string_view kOrbitControls;

}  // namespace meshalyzer
