# What all programs of tests share: GoogleTest, one precompiled header, and little optimisation: they compile in half the time.
#
#   tukor_test_program(optics_test a_test.cpp b_test.cpp)      then link what it tests, and say gtest_discover_tests
find_package(GTest REQUIRED)
include(GoogleTest)

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

# The header needs a program of its own, for all others to be compiled with its flags.
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/test_headers.cpp CONTENT "// Compiled with the precompiled header of all tests.\n")
add_executable(tukor_test_headers ${PROJECT_BINARY_DIR}/test_headers.cpp)
tukor_test_settings(tukor_test_headers)
target_precompile_headers(tukor_test_headers PRIVATE <gmock/gmock.h> <gtest/gtest.h> <filesystem> <random>)
