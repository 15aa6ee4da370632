# PART exercises: installs BUILD into an empty prefix, builds the exercises of LAB with their solutions and the programs of the
# chapters against it, and runs their tests. PART skeleton_fails: the same with what a student is given; no test may pass.
cmake_minimum_required(VERSION 3.25)

set(work ${BUILD}/tests/lab/work)
set(exercises half_edge one_ring normals area_volume curvature genus)

function(step)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# Debug, as a student has it, but for the symbols, which nobody reads here and which take a quarter of the time.
function(build_exercises)
  step(${CMAKE_COMMAND} -S ${LAB}/exercises -B ${work}/build -G ${GENERATOR} -D CMAKE_PREFIX_PATH=${work}/prefix
    -D CMAKE_CXX_COMPILER=${CXX} "-DCMAKE_CXX_FLAGS=${FLAGS}" -D CMAKE_CXX_FLAGS_DEBUG=-O0 ${ARGN})
  step(${CMAKE_COMMAND} --build ${work}/build)
endfunction()

if(PART STREQUAL "exercises")
  file(REMOVE_RECURSE ${work})
  step(${CMAKE_COMMAND} --install ${BUILD} --prefix ${work}/prefix)
  build_exercises(-D LAB_SOLUTIONS=ON -D LAB_CHAPTERS=ON)
  step(${CMAKE_CTEST_COMMAND} --test-dir ${work}/build --output-on-failure --no-tests=error)
else()
  build_exercises(-D LAB_SOLUTIONS=OFF -D LAB_CHAPTERS=OFF)
  foreach(exercise IN LISTS exercises)
    execute_process(COMMAND ${work}/build/${exercise}_test OUTPUT_VARIABLE said RESULT_VARIABLE status)
    if(status EQUAL 0 OR NOT said MATCHES "\\[  PASSED  \\] 0 tests\\.")
      message(SEND_ERROR "${exercise}: a test passes before a student has done anything, or they do not end:\n${said}")
    endif()
  endforeach()
endif()
