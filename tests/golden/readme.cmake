# Fails where the report that README.md shows is not what its first command prints.
cmake_minimum_required(VERSION 3.25)
file(READ ${ROOT}/README.md readme)
string(REGEX MATCH "\\./dev run ([^\n ]+)" command "${readme}")
execute_process(COMMAND ${PROGRAM} ${CMAKE_MATCH_1} WORKING_DIRECTORY ${ROOT}
  OUTPUT_VARIABLE report COMMAND_ERROR_IS_FATAL ANY)
string(FIND "${readme}" "```text\n${report}```" place)
if(place EQUAL -1)
  message(FATAL_ERROR "README.md does not show what ./dev run ${CMAKE_MATCH_1} prints:\n${report}")
endif()
