# Turns shaders into C++ constants `tukor::gl::shaders::<stem><Stage>` of type ShaderSource: `background.frag` becomes
# backgroundFrag. `#include "tukor/..."` lines are inlined with `#line`, so that a driver's error can name the real file.
#
#   tukor_embed_shaders(tukor_gl FILES tukor/gl/shaders/a.vert ...)      paths below src, or below the project root
#
# In pages, branches of names that are NEVER defined are left out.
find_package(Python3 REQUIRED COMPONENTS Interpreter)

function(tukor_embed_shaders target)
    cmake_parse_arguments(arg "" "" "FILES;NEVER" ${ARGN})
    set(compact "")
    if(EMSCRIPTEN)
        set(compact --compact)  # pages fetch it
        foreach(name ${arg_NEVER})
            list(APPEND compact --never ${name})
        endforeach()
    endif()
    foreach(file ${arg_FILES})
        get_filename_component(stem ${file} NAME_WE)
        get_filename_component(stage ${file} LAST_EXT)
        string(SUBSTRING ${stage} 1 1 initial)
        string(SUBSTRING ${stage} 2 -1 rest)
        string(TOUPPER ${initial} initial)
        string(REGEX REPLACE "_([a-z])" ";\\1" words ${stem})
        set(name "")
        foreach(word ${words})
            string(SUBSTRING ${word} 0 1 first)
            string(SUBSTRING ${word} 1 -1 tail)
            if(name)
                string(TOUPPER ${first} first)
            endif()
            string(APPEND name ${first}${tail})
        endforeach()
        string(APPEND name ${initial}${rest})
        set(root ${PROJECT_SOURCE_DIR}/src)
        if(NOT EXISTS ${root}/${file})
            set(root ${PROJECT_SOURCE_DIR})
        endif()
        set(output ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
        add_custom_command(
            OUTPUT ${output}
            COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/embed_shader.py
                    ${PROJECT_SOURCE_DIR}/src ${file} ${output} ${name} --depfile ${output}.d ${compact}
            DEPENDS ${PROJECT_SOURCE_DIR}/tools/embed_shader.py ${PROJECT_SOURCE_DIR}/tools/compact_glsl.py ${root}/${file}
            DEPFILE ${output}.d
            COMMENT "Embedding ${file}")
        target_sources(${target} PRIVATE ${output})
    endforeach()
endfunction()
