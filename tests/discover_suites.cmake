# Writes to FILE a test of ctest, NAME.SUITE with LABEL, for each suite of PROGRAM, without the tests LEFT_OUT.
cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND ${PROGRAM} --gtest_list_tests --gtest_filter=-${LEFT_OUT} OUTPUT_VARIABLE list COMMAND_ERROR_IS_FATAL ANY)
# A line with a suite ends with a dot; its tests stand below it, indented.
string(REGEX MATCHALL "[A-Za-z0-9_]+\\.\n" suites "${list}")
set(tests "")
foreach(suite IN LISTS suites)
  string(REPLACE ".\n" "" suite "${suite}")
  string(APPEND tests "add_test(\"${NAME}.${suite}\" \"${PROGRAM}\" \"--gtest_filter=${suite}.*-${LEFT_OUT}\")\n"
    "set_tests_properties(\"${NAME}.${suite}\" PROPERTIES LABELS ${LABEL})\n")
endforeach()
file(WRITE ${FILE} "${tests}")
