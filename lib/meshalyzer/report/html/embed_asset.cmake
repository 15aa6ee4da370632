# Writes a .cpp that holds files as a constant: cmake -D NAME=kPageStyle -D FILES=a.js|b.js -D OUT=page_style.cpp -P ...
# Several files follow each other, each ended by a line feed. A raw string literal, for a compiler reads it thirty times
# as fast as a list of bytes.
cmake_minimum_required(VERSION 3.25)

set(text "")
string(REPLACE "|" ";" files "${FILES}")
foreach(file IN LISTS files)
  file(READ "${file}" content)
  foreach(forbidden IN ITEMS "</script" "<!--" ")asset\"")
    string(FIND "${content}" "${forbidden}" place)
    if(NOT place EQUAL -1)
      message(FATAL_ERROR "${file}: has ${forbidden}, which would end the element or the literal that it is put into")
    endif()
  endforeach()
  string(APPEND text "${content}\n")
endforeach()

file(WRITE "${OUT}" "#include \"meshalyzer/report/html/assets.h\"

#ifdef __clang__
#pragma clang diagnostic ignored \"-Woverlength-strings\"
#endif

namespace meshalyzer {
namespace {

constexpr char kText[] = R\"asset(${text})asset\";

}  // namespace

const std::string_view ${NAME}(kText, sizeof kText - 1);

}  // namespace meshalyzer
")
