# Runs PROGRAM as the folder CASE says, and compares what it does with what stands there, byte for byte:
#
#   args       one argument a line; @SCRATCH@ is an empty folder, made anew
#   stdin      optional: standard input
#   stdout_to  optional: the file that standard output goes to instead of being compared
#   files/     optional: where the program runs; otherwise in MESHES
#   exit, stdout, stderr   what is expected; a stream without a file is empty
#   written/   optional: the files that must then be in @SCRATCH@, and no others
#
# In all that is compared, @SCRATCH@ stands for the folder, and @TIME@ and @STATE@ for what a journal says of the times
# of files; in written/ only *.json and *.ndjson have such places.
#
# UPDATE=1 in the environment rewrites exit, stdout, stderr and written/; review them with git diff.
cmake_minimum_required(VERSION 3.25)

function(read_if_exists file variable)
  set(content "")
  if(EXISTS ${file})
    file(READ ${file} content)
  endif()
  set(${variable} "${content}" PARENT_SCOPE)
endfunction()

# Compares `got` with the file of that name in CASE, or rewrites it; an empty one needs no file.
function(check name got)
  if("$ENV{UPDATE}")
    if(got STREQUAL "")
      file(REMOVE ${CASE}/${name})
    else()
      file(WRITE ${CASE}/${name} "${got}")
    endif()
    return()
  endif()
  read_if_exists(${CASE}/${name} expected)
  if(NOT got STREQUAL expected)
    message(SEND_ERROR "${CASE}: ${name} differs\n--- expected\n${expected}\n--- got\n${got}")
  endif()
endfunction()

# Replaces in `text` what differs from one place or day to another.
function(mask text variable)
  string(REPLACE "${SCRATCH}" "@SCRATCH@" text "${text}")
  string(REGEX REPLACE "\"modified\": -?[0-9]+" "\"modified\": @TIME@" text "${text}")
  string(REGEX REPLACE "\"set\": \"[0-9a-f]+\"" "\"set\": \"@STATE@\"" text "${text}")
  set(${variable} "${text}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH})
file(STRINGS ${CASE}/args args)
list(TRANSFORM args REPLACE "@SCRATCH@" "${SCRATCH}")

set(redirections INPUT_FILE /dev/null OUTPUT_VARIABLE stdout)
if(EXISTS ${CASE}/stdin)
  list(TRANSFORM redirections REPLACE "/dev/null" "${CASE}/stdin")
endif()
if(EXISTS ${CASE}/stdout_to)
  file(STRINGS ${CASE}/stdout_to target)
  list(TRANSFORM redirections REPLACE "OUTPUT_VARIABLE" "OUTPUT_FILE")
  list(TRANSFORM redirections REPLACE "^stdout$" "${target}")
endif()
set(folder ${MESHES})
if(EXISTS ${CASE}/files)
  set(folder ${CASE}/files)
endif()
execute_process(COMMAND ${PROGRAM} ${args} WORKING_DIRECTORY ${folder} ${redirections}
  RESULT_VARIABLE exit ERROR_VARIABLE stderr)

foreach(stream IN ITEMS stdout stderr)
  mask("${${stream}}" ${stream})
  check(${stream} "${${stream}}")
endforeach()
check(exit "${exit}\n")

# Compares a file of @SCRATCH@ with that of written/, or takes its place.
function(check_written name)
  set(got ${SCRATCH}/${name})
  set(expected ${CASE}/written/${name})
  if(name MATCHES "json$")
    read_if_exists(${got} content)
    mask("${content}" content)
    check(written/${name} "${content}")
  elseif("$ENV{UPDATE}")
    file(REMOVE ${expected})
    if(EXISTS ${got})
      cmake_path(GET expected PARENT_PATH folder)
      file(COPY ${got} DESTINATION ${folder})
    endif()
  elseif(NOT EXISTS ${got} OR NOT EXISTS ${expected})
    message(SEND_ERROR "${CASE}: written/${name} is not there, or should not be")
  else()
    # Byte for byte: CMake cannot hold the zero bytes of binary files in a variable.
    file(SHA256 ${got} got_hash)
    file(SHA256 ${expected} expected_hash)
    if(NOT got_hash STREQUAL expected_hash)
      message(SEND_ERROR "${CASE}: written/${name} differs from ${got}")
    endif()
  endif()
endfunction()

file(GLOB_RECURSE written RELATIVE ${SCRATCH} ${SCRATCH}/*)
file(GLOB_RECURSE expected RELATIVE ${CASE}/written ${CASE}/written/*)
list(APPEND written ${expected})
list(REMOVE_DUPLICATES written)
foreach(name IN LISTS written)
  check_written(${name})
endforeach()
