# What every target is compiled with. No -march=native: one binary runs on every x86-64.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release)
endif()

add_library(lancret_options INTERFACE)
# Contraction off: a fused multiply-add on one machine and not on another would change bits.
target_compile_options(lancret_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wno-psabi -ffp-contract=off -fno-math-errno)
if(LANCRET_WARNINGS_AS_ERRORS)
    target_compile_options(lancret_options INTERFACE -Werror)
endif()
if(LANCRET_SANITIZE_THREADS)
    target_compile_options(lancret_options INTERFACE -fsanitize=thread)
    target_link_options(lancret_options INTERFACE -fsanitize=thread)
endif()
if(LANCRET_SANITIZE)
    target_compile_options(lancret_options INTERFACE
        -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
    target_link_options(lancret_options INTERFACE -fsanitize=address,undefined)
endif()
