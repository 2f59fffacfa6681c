#!/usr/bin/env bash
# Stages the header-only libraries that the WebAssembly build uses into a prefix of their own, with CMake packages.
#
# The host's /usr/include would bring its C library along and break em++. Copies are small and made anew only when absent.
#
# usage: tools/stage_web_deps.sh PREFIX
set -euo pipefail
prefix=$1
[ -e "$prefix/done" ] && exit 0
rm -rf "$prefix"
mkdir -p "$prefix/include" "$prefix/lib/cmake"/{glm,nlohmann_json,Imath}
cp -rL /usr/include/{glm,nlohmann,Imath} "$prefix/include/"

package() {  # CMake package, target, definitions
    cat >"$prefix/lib/cmake/$1/$1Config.cmake" <<END
get_filename_component(prefix "\${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
if(NOT TARGET $2)
    add_library($2 INTERFACE IMPORTED)
    target_include_directories($2 INTERFACE "\${prefix}/include")
    target_compile_definitions($2 INTERFACE $3)
endif()
END
}
package glm glm::glm ""
package nlohmann_json nlohmann_json::nlohmann_json ""
package Imath Imath::Imath IMATH_HALF_NO_LOOKUP_TABLE # the table is in its library
touch "$prefix/done"
