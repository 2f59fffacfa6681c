# What all programs of tests share: GoogleTest, one precompiled header, and little optimisation.
#
#   tukor_test_program(optics_test a_test.cpp b_test.cpp)      then link what it tests, and say gtest_discover_tests
find_package(GTest REQUIRED)
include(GoogleTest)

# Tests wait for pictures, not for themselves: little optimisation halves the time to compile them.
function(tukor_test_settings target)
    target_link_libraries(${target} PRIVATE tukor_settings GTest::gtest GTest::gmock GTest::gtest_main)
    if(NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
        target_compile_options(${target} PRIVATE -O1)
    endif()
endfunction()

function(tukor_test_program target)
    add_executable(${target} ${ARGN})
    tukor_test_settings(${target})
    target_precompile_headers(${target} REUSE_FROM tukor_test_headers)
endfunction()

add_executable(tukor_test_headers EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/headers.cpp)
tukor_test_settings(tukor_test_headers)
target_link_libraries(tukor_test_headers PRIVATE fmt::fmt glm::glm)
target_precompile_headers(tukor_test_headers PRIVATE <gmock/gmock.h> <gtest/gtest.h> <random> ${TUKOR_COMMON_HEADERS})
