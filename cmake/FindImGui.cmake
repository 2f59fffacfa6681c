# Dear ImGui with its GLFW backend, as Debian packages it (pkg-config, no CMake package): ImGui::ImGui.
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
    pkg_check_modules(PC_ImGui QUIET imgui)
endif()
find_path(ImGui_INCLUDE_DIR imgui.h HINTS ${PC_ImGui_INCLUDE_DIRS} PATH_SUFFIXES imgui)
find_path(ImGui_BACKENDS_INCLUDE_DIR imgui_impl_glfw.h
          HINTS ${ImGui_INCLUDE_DIR} PATH_SUFFIXES backends imgui/backends)
find_library(ImGui_LIBRARY imgui HINTS ${PC_ImGui_LIBRARY_DIRS})
find_library(ImGui_STB_LIBRARY stb)  # its font rasteriser, which Debian links from the outside
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(ImGui REQUIRED_VARS ImGui_LIBRARY ImGui_STB_LIBRARY ImGui_INCLUDE_DIR ImGui_BACKENDS_INCLUDE_DIR
                                  VERSION_VAR PC_ImGui_VERSION)
if(ImGui_FOUND AND NOT TARGET ImGui::ImGui)
    add_library(ImGui::ImGui UNKNOWN IMPORTED)
    set_target_properties(ImGui::ImGui PROPERTIES
        IMPORTED_LOCATION ${ImGui_LIBRARY}
        INTERFACE_LINK_LIBRARIES ${ImGui_STB_LIBRARY}
        INTERFACE_INCLUDE_DIRECTORIES "${ImGui_INCLUDE_DIR};${ImGui_BACKENDS_INCLUDE_DIR}")
endif()
mark_as_advanced(ImGui_INCLUDE_DIR ImGui_BACKENDS_INCLUDE_DIR ImGui_LIBRARY ImGui_STB_LIBRARY)
