# The headers that most sources include and that take longest to read are read once: by every target of the product,
# and once more, with GoogleTest, by the tests, which are compiled with less optimisation.
option(LANCRET_PRECOMPILED "Read the headers of third parties once for all sources" ON)

set(lancret_common_headers
    <algorithm> <array> <atomic> <cmath> <cstdint> <filesystem> <fstream> <functional> <limits> <map> <memory>
    <optional> <random> <regex> <set> <span> <sstream> <string> <string_view> <tuple> <variant> <vector>
    <Eigen/Core> <Eigen/Geometry> <Eigen/Dense> <fmt/format.h> <nlohmann/json.hpp>
    <oneapi/tbb/blocked_range.h> <oneapi/tbb/parallel_for.h> <oneapi/tbb/parallel_reduce.h>)

# lancret_precompile(NAME SOURCE headers...): a target whose headers others reuse.
function(lancret_precompile name source)
    add_library(${name} OBJECT "${source}")
    target_link_libraries(${name} PRIVATE
        lancret_options Eigen3::Eigen TBB::tbb fmt::fmt nlohmann_json::nlohmann_json)
    target_precompile_headers(${name} PRIVATE ${ARGN})
endfunction()

# lancret_use_precompiled(TARGET NAME): reuses the headers of NAME, unless the option is off.
function(lancret_use_precompiled target name)
    if(LANCRET_PRECOMPILED)
        target_precompile_headers(${target} REUSE_FROM ${name})
    endif()
endfunction()

if(LANCRET_PRECOMPILED)
    lancret_precompile(lancret_precompiled "${CMAKE_CURRENT_LIST_DIR}/precompiled.cpp" ${lancret_common_headers})
endif()

# Sources of a folder are compiled several at a time: most of the time goes into templates that they share.
option(LANCRET_UNITY "Compile several sources at a time" ON)
function(lancret_compile_together target)
    if(LANCRET_UNITY)
        set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
        # A private implementation may well hold types of its own file.
        target_compile_options(${target} PRIVATE
            $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>)
    endif()
endfunction()
