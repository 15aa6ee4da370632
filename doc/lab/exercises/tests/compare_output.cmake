# Fails where PROGRAM does not print what the file SAID holds.
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE got COMMAND_ERROR_IS_FATAL ANY)
file(READ ${SAID} want)
if(NOT got STREQUAL want)
  message(FATAL_ERROR "it prints\n${got}but the chapter says\n${want}")
endif()
