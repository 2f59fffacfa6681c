# What most sources include, precompiled: one header for the modules, and (TukorTests) one for their tests.
#
# A source includes what it uses all the same: the presets dev and web compile without these headers.
set(TUKOR_COMMON_HEADERS <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <numbers>
                         <optional> <span> <string> <string_view> <utility> <vector> <fmt/format.h> <glm/glm.hpp>)

# Headers need a target of their own, for all others to be compiled with its flags.
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/headers.cpp CONTENT "// Compiled with a precompiled header that others share.\n")
if(NOT EMSCRIPTEN)
    add_library(tukor_headers STATIC EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/headers.cpp)
    target_link_libraries(tukor_headers PRIVATE tukor_settings fmt::fmt glm::glm)
    target_precompile_headers(tukor_headers PRIVATE ${TUKOR_COMMON_HEADERS})
endif()

function(tukor_use_headers library)
    if(NOT EMSCRIPTEN)
        target_precompile_headers(${library} REUSE_FROM tukor_headers)
    endif()
endfunction()

# Sources with flags of their own cannot share what was compiled with others.
function(tukor_compile_with options)
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS ${options} SKIP_PRECOMPILE_HEADERS ON)
endfunction()
