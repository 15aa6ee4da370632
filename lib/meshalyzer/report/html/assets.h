#pragma once

#include <string_view>

namespace meshalyzer {

// What a page is made of besides its content; embed.cmake makes a .cpp of the files.

/// assets/page.css
extern const std::string_view kPageStyle;
/// assets/view.html: the view and its controls.
extern const std::string_view kViewMarkup;
/// The scripts of the view, in the order in which they run.
extern const std::string_view kViewScript;
/// The scripts of a page without a view.
extern const std::string_view kIndexScript;
/// assets/three_licence.txt: the licence of three.js and of its controls.
extern const std::string_view kThreeLicence;
/// three.min.js of three.js
extern const std::string_view kThree;
/// OrbitControls.js of three.js
extern const std::string_view kOrbitControls;

}  // namespace meshalyzer
