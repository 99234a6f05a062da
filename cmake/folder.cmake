# lancret_folder(NAME [EXCEPT folders...] LINK targets...): the library lancret_NAME of every .cpp
# in this folder and its sub-folders, except those that are libraries of their own.
# Includes are written from the project's root: #include "guides/helix/helix.h".
function(lancret_folder name)
    cmake_parse_arguments(ARG "" "" "LINK;EXCEPT" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS "*.cpp" "*.h")
    foreach(folder IN LISTS ARG_EXCEPT)
        list(FILTER sources EXCLUDE REGEX "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/")
    endforeach()
    add_library(lancret_${name} STATIC ${sources})
    target_include_directories(lancret_${name} PUBLIC "${PROJECT_SOURCE_DIR}")
    target_link_libraries(lancret_${name} PUBLIC ${ARG_LINK} PRIVATE lancret_options)
    lancret_use_precompiled(lancret_${name} lancret_precompiled)
    lancret_compile_together(lancret_${name})
endfunction()

# What loads libraries by name finds them by its own run path, even where a sanitizer's dlopen
# asks on its behalf: that knows the old kind of run path alone.
function(lancret_loads_plugins target)
    target_link_options(${target} PRIVATE LINKER:--disable-new-dtags)
endfunction()
