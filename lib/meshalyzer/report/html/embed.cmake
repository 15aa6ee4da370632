# What the HTML report is made of besides its content, as object files of the library: style, markup, scripts, three.js.
include_guard()

set(MESHALYZER_THREE_FOLDER /usr/share/javascript/three CACHE PATH
  "Where three.js is: three.min.js, and examples/js/controls/OrbitControls.js")
foreach(asset IN ITEMS three.min.js examples/js/controls/OrbitControls.js)
  if(NOT EXISTS "${MESHALYZER_THREE_FOLDER}/${asset}")
    message(FATAL_ERROR "The HTML report needs ${MESHALYZER_THREE_FOLDER}/${asset}: install libjs-three, or set "
      "MESHALYZER_THREE_FOLDER to where three.js is")
  endif()
endforeach()

add_library(meshalyzer_assets OBJECT)
target_compile_features(meshalyzer_assets PRIVATE cxx_std_20)
target_include_directories(meshalyzer_assets PRIVATE ${PROJECT_SOURCE_DIR}/lib)
set_target_properties(meshalyzer_assets PROPERTIES
  CXX_CLANG_TIDY "" # there is nothing of ours to look at
  UNITY_BUILD OFF)  # nor anything to share
if(BUILD_SHARED_LIBS)
  set_target_properties(meshalyzer_assets PROPERTIES POSITION_INDEPENDENT_CODE ON)
endif()

# meshalyzer_embed(NAME OUT FILE...): the constant NAME of assets.h holds the files, one after the other.
function(meshalyzer_embed name out)
  set(out ${CMAKE_CURRENT_BINARY_DIR}/assets/${out})
  set(script ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/embed_asset.cmake)
  string(REPLACE ";" "|" files "${ARGN}")
  add_custom_command(OUTPUT ${out}
    COMMAND ${CMAKE_COMMAND} -D NAME=${name} -D FILES=${files} -D OUT=${out} -P ${script}
    DEPENDS ${ARGN} ${script} VERBATIM)
  target_sources(meshalyzer_assets PRIVATE ${out})
endfunction()

# meshalyzer_assets_of(OUT NAME...): the paths of our own.
function(meshalyzer_assets_of out)
  list(TRANSFORM ARGN PREPEND ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/assets/)
  set(${out} ${ARGN} PARENT_SCOPE)
endfunction()

meshalyzer_assets_of(style page.css)
meshalyzer_assets_of(view view.html)
meshalyzer_assets_of(licence three_licence.txt)
meshalyzer_assets_of(index_scripts definitions.js paper.js theme.js sort_table.js index.js)
# In the order in which they run: what others use at once stands first, what starts the page last.
meshalyzer_assets_of(view_scripts data.js numbers.js palette.js shaders.js strokes.js normals.js surface.js camera.js
  stage.js highlight.js first_view.js legend.js pick.js picked.js picture.js paper.js theme.js definitions.js defect_list.js
  controls.js viewer.js main.js)

meshalyzer_embed(kPageStyle page_style.cpp ${style})
meshalyzer_embed(kViewMarkup view_markup.cpp ${view})
meshalyzer_embed(kViewScript view_script.cpp ${view_scripts})
meshalyzer_embed(kIndexScript index_script.cpp ${index_scripts})
meshalyzer_embed(kThreeLicence three_licence.cpp ${licence})
meshalyzer_embed(kThree three.cpp ${MESHALYZER_THREE_FOLDER}/three.min.js)
meshalyzer_embed(kOrbitControls orbit_controls.cpp
  ${MESHALYZER_THREE_FOLDER}/examples/js/controls/OrbitControls.js)

target_sources(libmeshalyzer PRIVATE $<TARGET_OBJECTS:meshalyzer_assets>)
