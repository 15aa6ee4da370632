# Fails where a file has grown past the size that one reader can hold in mind.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/public_headers.cmake)

function(check_size source limit)
  file(READ ${ROOT}/${source} text)
  string(REGEX MATCHALL "\n" line_ends "${text}")
  list(LENGTH line_ends n_lines)
  if(n_lines GREATER limit)
    message(SEND_ERROR "${source}: ${n_lines} lines, more than ${limit}")
  endif()
endfunction()

file(GLOB_RECURSE sources RELATIVE ${ROOT}
  ${ROOT}/lib/*.h ${ROOT}/lib/*.cpp ${ROOT}/apps/*.h ${ROOT}/apps/*.cpp
  ${ROOT}/tests/*.h ${ROOT}/tests/*.cpp ${ROOT}/tests/*.cmake ${ROOT}/tests/*.py ${ROOT}/meshes/*.py)
public_headers(public)
foreach(source IN LISTS sources)
  if(source IN_LIST public)
    check_size(${source} 200)
  else()
    check_size(${source} 500)
  endif()
endforeach()
