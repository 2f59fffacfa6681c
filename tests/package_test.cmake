# Installs the build to a fresh prefix, moves it, and builds and runs the examples against it as a stranger would.
#
#   cmake -DBUILD=... -DSOURCE=... -DWORK=... -P package_test.cmake
function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT status EQUAL 0)
        string(JOIN " " command ${ARGN})
        message(FATAL_ERROR "${command}\n${output}")
    endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/first)
file(RENAME ${WORK}/first ${WORK}/prefix)  # nothing may remember where it was installed
# A copy outside the source tree, so that no header can be found by accident.
file(COPY ${SOURCE}/examples DESTINATION ${WORK})
run(${CMAKE_COMMAND} -S ${WORK}/examples -B ${WORK}/build -G Ninja -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_PREFIX_PATH=${WORK}/prefix)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/minimal sphere studio ${WORK}/minimal.png)
file(SIZE ${WORK}/minimal.png size)
if(size LESS 10000)
    message(FATAL_ERROR "minimal.png has ${size} bytes")
endif()
file(READ ${WORK}/build/CMakeCache.txt cache)
if(cache MATCHES "${SOURCE}/src")
    message(FATAL_ERROR "the package leads back to ${SOURCE}/src")
endif()
file(REMOVE_RECURSE ${WORK})
