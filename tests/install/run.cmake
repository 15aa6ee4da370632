# Installs BUILD into an empty prefix, then configures, builds and runs CONSUMER against it.
cmake_minimum_required(VERSION 3.25)

set(work ${BUILD}/tests/install/work)
file(REMOVE_RECURSE ${work})

function(step)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

step(${CMAKE_COMMAND} --install ${BUILD} --prefix ${work}/prefix)
step(${CMAKE_COMMAND} -S ${CONSUMER} -B ${work}/build -G ${GENERATOR} -D CMAKE_PREFIX_PATH=${work}/prefix
  -D CMAKE_CXX_COMPILER=${CXX} "-DCMAKE_CXX_FLAGS=${FLAGS}" -D CMAKE_BUILD_TYPE=${TYPE} -D README=${README})
step(${CMAKE_COMMAND} --build ${work}/build)

execute_process(COMMAND ${work}/build/consumer OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
if(NOT said STREQUAL "4 vertices, 4 faces, closed\n")
  message(FATAL_ERROR "the consumer said '${said}'")
endif()
