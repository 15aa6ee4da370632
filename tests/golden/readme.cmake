# Fails where a report that README.md shows is not what the command before it prints. What a command writes goes to
# build/, which is made for it and is no part of the project.
cmake_minimum_required(VERSION 3.25)
file(READ ${ROOT}/README.md readme)

# check_commands(COMMAND PROGRAM LEAST): runs the lines `    ./dev COMMAND ARGUMENT...`, of which there are LEAST or more.
function(check_commands command program least)
  string(REGEX MATCHALL "    \\./dev ${command} [^\n]+" lines "${readme}")
  list(LENGTH lines n_lines)
  if(n_lines LESS ${least})
    message(SEND_ERROR "README.md: ${n_lines} lines ./dev ${command} with a report, not ${least} or more")
  endif()
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "    \\./dev ${command} (.*)" "\\1" arguments "${line}")
    separate_arguments(arguments)
    execute_process(COMMAND ${program} ${arguments} WORKING_DIRECTORY ${ROOT} OUTPUT_VARIABLE report RESULT_VARIABLE exit)
    if(NOT exit MATCHES "^[01]$")
      message(SEND_ERROR "${line} ends with ${exit}")
    endif()
    string(FIND "${readme}" "```text\n${report}```" place)
    if(line MATCHES "--html ([^ ]+)")
      # It is the page that is to be looked at.
      if(NOT EXISTS ${ROOT}/${CMAKE_MATCH_1})
        message(SEND_ERROR "${line} writes no ${CMAKE_MATCH_1}")
      endif()
    elseif(place EQUAL -1)
      message(SEND_ERROR "README.md does not show what${line} prints:\n${report}")
    endif()
  endforeach()
endfunction()

file(MAKE_DIRECTORY ${ROOT}/build)
check_commands(run ${MESHALYZER} 2)
check_commands(fix ${MESHFIXER} 1)
