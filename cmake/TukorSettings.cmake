# Compiler, warnings, sanitizers, ccache: what every target of the project shares.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(NOT EMSCRIPTEN)
    set(CMAKE_POSITION_INDEPENDENT_CODE ON)
endif()
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

find_program(TUKOR_CCACHE ccache)
if(TUKOR_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    # Paths below the checkout count relative to it, so that checkouts and builds of equal depth share results.
    set(TUKOR_LAUNCHER env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
                      CCACHE_SLOPPINESS=pch_defines,time_macros ${TUKOR_CCACHE})
    set(CMAKE_CXX_COMPILER_LAUNCHER ${TUKOR_LAUNCHER})
    set(CMAKE_C_COMPILER_LAUNCHER ${TUKOR_LAUNCHER})
endif()

# Private to the project's own targets: warnings and code generation.
add_library(tukor_settings INTERFACE)
target_compile_options(tukor_settings INTERFACE -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion)
if(TUKOR_WERROR)
    target_compile_options(tukor_settings INTERFACE -Werror)
endif()
# No fused multiply-add behind our back: C++ and GLSL must round alike.
target_compile_options(tukor_settings INTERFACE -ffp-contract=off -fno-math-errno)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND NOT EMSCRIPTEN)
    include(CheckCXXSourceRuns)
    check_cxx_source_runs("int main() { return __builtin_cpu_supports(\"avx2\") && __builtin_cpu_supports(\"fma\") ? 0 : 1; }"
                          TUKOR_HAS_AVX2)
    if(TUKOR_HAS_AVX2)
        target_compile_options(tukor_settings INTERFACE -march=x86-64-v3)
    endif()
endif()

if(TUKOR_SANITIZE)
    add_compile_options(-fsanitize=${TUKOR_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    add_link_options(-fsanitize=${TUKOR_SANITIZE})
    add_compile_definitions(TUKOR_ASSERTIONS)
elseif(CMAKE_BUILD_TYPE STREQUAL "Debug")
    add_compile_definitions(TUKOR_ASSERTIONS)
endif()
if(TUKOR_FUZZ)
    add_compile_options(-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=address,undefined)
    add_compile_definitions(TUKOR_ASSERTIONS)
endif()

if(EMSCRIPTEN)
    # Everything a page fetches counts, so code is made small; hot loops ask for speed by themselves (tukor_hot).
    set(CMAKE_CXX_FLAGS_MINSIZEREL "-Oz -DNDEBUG")
    # No run-time types: none is used, and they would bring their names along.
    add_compile_options(-fwasm-exceptions -fno-rtti)
    add_link_options(-fwasm-exceptions)
    if(TUKOR_WEB_THREADS)
        add_compile_options(-pthread)
        add_link_options(-pthread)
    endif()
endif()

# Sources that are compiled for speed where others are compiled for size.
function(tukor_hot)
    if(EMSCRIPTEN)
        set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS -O3)
    endif()
endfunction()
