# Fails where a condition or loop of the repair module has its body on the next line without braces: a body stands on the
# same line, or in braces.
cmake_minimum_required(VERSION 3.25)

file(GLOB_RECURSE sources RELATIVE ${ROOT} ${ROOT}/lib/meshalyzer/repair/*.h ${ROOT}/lib/meshalyzer/repair/*.cpp)
if(NOT sources)
  message(FATAL_ERROR "no sources found")
endif()
foreach(source IN LISTS sources)
  file(READ ${ROOT}/${source} text)
  string(REPLACE ";" "," text "${text}")
  string(REGEX MATCHALL "\n *(if|for|while) [(][^\n]*[)]\n" bare "${text}")
  foreach(line IN LISTS bare)
    string(STRIP "${line}" line)
    message(SEND_ERROR "${source}: a body without braces on a line of its own after '${line}'")
  endforeach()
endforeach()
