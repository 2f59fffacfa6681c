# The installable package: find_package(tukor) gives tukor::<module> targets.
include(CMakePackageConfigHelpers)

# How the package's users find what the modules link to: a pattern for targets, and the commands.
set(TUKOR_FINDERS
    "^glm::"                "find_dependency(glm)"
    "^fmt::"                "find_dependency(fmt)"
    "^TBB::"                "find_dependency(TBB)"
    "^OpenEXR::|^Imath::"   "find_dependency(OpenEXR 3.1)"
    "^PkgConfig::spng$"     "find_dependency(PkgConfig)\npkg_check_modules(spng REQUIRED QUIET IMPORTED_TARGET spng)"
    "^PkgConfig::libdeflate$" "find_dependency(PkgConfig)\npkg_check_modules(libdeflate REQUIRED QUIET IMPORTED_TARGET libdeflate)"
    "^PkgConfig::turbojpeg$" "find_dependency(PkgConfig)\npkg_check_modules(turbojpeg REQUIRED QUIET IMPORTED_TARGET libturbojpeg)"
    "zstd::"                "find_dependency(zstd)"
    "^PNG::"                "find_dependency(PNG)"
    "^JPEG::"               "find_dependency(JPEG)"
    "^ZLIB::"               "find_dependency(ZLIB)"
    "^draco::"              "find_dependency(draco)"
    "^meshoptimizer::"      "find_dependency(meshoptimizer)"
    "^assimp"               "find_dependency(assimp)"
    "^nlohmann_json"        "find_dependency(nlohmann_json)"
    "^embree"               "find_dependency(embree 3)"
    "^GLES3::"              "find_dependency(GLES3)"
    "^Threads::"            "find_dependency(Threads)")

# The commands for everything that the modules link to, each once.
function(tukor_dependencies result)
    set(commands)
    get_property(modules GLOBAL PROPERTY TUKOR_MODULES)
    foreach(module ${modules})
        get_target_property(type ${module} TYPE)
        get_target_property(libraries ${module} INTERFACE_LINK_LIBRARIES)
        if(NOT type STREQUAL "INTERFACE_LIBRARY")
            get_target_property(private ${module} LINK_LIBRARIES)
            list(APPEND libraries ${private})
        endif()
        foreach(library ${libraries})
            if(library MATCHES "^tukor|BUILD_INTERFACE|LINK_ONLY|NOTFOUND|^-|^m$|^dl$")
                continue()
            endif()
            set(found FALSE)
            set(finders ${TUKOR_FINDERS})
            while(finders)
                list(POP_FRONT finders pattern command)
                if(library MATCHES "${pattern}")
                    string(APPEND commands "${command}\n")
                    set(found TRUE)
                    break()
                endif()
            endwhile()
            if(NOT found)
                message(FATAL_ERROR "${module} links to ${library}: add how users of the package find it to "
                                    "TUKOR_FINDERS in cmake/TukorPackage.cmake")
            endif()
        endforeach()
    endforeach()
    string(REPLACE "\n" ";" commands "${commands}")
    list(REMOVE_DUPLICATES commands)
    string(REPLACE ";" "\n" commands "${commands}")
    set(${result} "${commands}" PARENT_SCOPE)
endfunction()

if(NOT EMSCRIPTEN)
    set(TUKOR_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/tukor)
    get_property(modules GLOBAL PROPERTY TUKOR_MODULES)
    install(TARGETS ${modules} EXPORT tukorTargets
            ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    install(EXPORT tukorTargets NAMESPACE tukor:: DESTINATION ${TUKOR_PACKAGE_DIR})

    tukor_dependencies(TUKOR_DEPENDENCIES)
    configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/tukorConfig.cmake.in
        ${PROJECT_BINARY_DIR}/tukorConfig.cmake INSTALL_DESTINATION ${TUKOR_PACKAGE_DIR})
    write_basic_package_version_file(${PROJECT_BINARY_DIR}/tukorConfigVersion.cmake COMPATIBILITY SameMinorVersion)
    install(FILES ${PROJECT_BINARY_DIR}/tukorConfig.cmake ${PROJECT_BINARY_DIR}/tukorConfigVersion.cmake
                  ${PROJECT_SOURCE_DIR}/cmake/FindGLES3.cmake DESTINATION ${TUKOR_PACKAGE_DIR})
    install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
endif()
