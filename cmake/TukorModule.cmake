# One static library per folder of src/tukor, and one test program from its *_test.cpp files.
#
#   tukor_module(optics DEPENDS base PUBLIC glm::glm PRIVATE Foo::foo)
#
# Sources are the folder's *.cpp; headers its *.h, installed by their path below src. NATIVE_ONLY names sources that the
# WebAssembly build leaves out, WEB the only ones that it takes: the rest is what a browser does itself, or forbids.
function(tukor_module name)
    cmake_parse_arguments(arg "" "" "DEPENDS;PUBLIC;PRIVATE;TEST_LIBRARIES;NATIVE_ONLY;WEB" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS *.cpp)
    file(GLOB headers CONFIGURE_DEPENDS *.h)
    list(FILTER headers EXCLUDE REGEX "/test_[a-z_]*\\.h$")  # shared by tests, not installed
    file(GLOB tests CONFIGURE_DEPENDS *_test.cpp)
    if(tests)
        list(REMOVE_ITEM sources ${tests})
    endif()
    if(EMSCRIPTEN AND arg_WEB)
        list(TRANSFORM arg_WEB PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
        set(sources ${arg_WEB})
    elseif(EMSCRIPTEN AND arg_NATIVE_ONLY)
        list(TRANSFORM arg_NATIVE_ONLY PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
        list(REMOVE_ITEM sources ${arg_NATIVE_ONLY})
    endif()

    set(target tukor_${name})
    list(TRANSFORM arg_DEPENDS PREPEND tukor_)
    if(sources)
        add_library(${target} STATIC ${sources})
        target_include_directories(${target} PUBLIC
            $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
        target_link_libraries(${target} PUBLIC ${arg_DEPENDS} ${arg_PUBLIC}
                              PRIVATE ${arg_PRIVATE} $<BUILD_INTERFACE:tukor_settings>)
        target_compile_features(${target} PUBLIC cxx_std_20)
        tukor_use_headers(${target})
        target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/src FILES ${headers})
    else()
        add_library(${target} INTERFACE)
        target_include_directories(${target} INTERFACE
            $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
        target_link_libraries(${target} INTERFACE ${arg_DEPENDS} ${arg_PUBLIC})
        target_compile_features(${target} INTERFACE cxx_std_20)
        target_sources(${target} INTERFACE FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/src FILES ${headers})
    endif()
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
    add_library(tukor::${name} ALIAS ${target})
    set_property(GLOBAL APPEND PROPERTY TUKOR_MODULES ${target})

    if(TUKOR_TESTS AND tests)
        tukor_test_program(${target}_test ${tests})
        target_link_libraries(${target}_test PRIVATE ${target} ${arg_TEST_LIBRARIES})
        gtest_discover_tests(${target}_test DISCOVERY_MODE PRE_TEST PROPERTIES LABELS unit TIMEOUT 120)
    endif()
endfunction()
