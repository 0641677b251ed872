# Compiler settings and the three ways in which the project makes targets.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR})

add_library(rasterloom_settings INTERFACE)
target_include_directories(rasterloom_settings INTERFACE ${CMAKE_SOURCE_DIR})
# -ffp-contract=off: a fused multiply-add on one machine only would break bit-identical results.
target_compile_options(rasterloom_settings INTERFACE
    -Wall -Wextra -Wpedantic -Wconversion -ffp-contract=off
    $<$<BOOL:${RASTERLOOM_WERROR}>:-Werror>)

# rasterloom_library(NAME SOURCES a.cpp ... [DEPENDS lib ...])
function(rasterloom_library name)
    cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
    add_library(${name} STATIC ${ARG_SOURCES})
    target_link_libraries(${name} PUBLIC rasterloom_settings ${ARG_DEPENDS})
endfunction()

# rasterloom_test(NAME SOURCES a_test.cpp ... [DEPENDS lib ...]): one GoogleTest program a box.
# Tests find the project's files under RASTERLOOM_SOURCE_DIR.
function(rasterloom_test name)
    cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
    add_executable(${name} ${ARG_SOURCES})
    target_link_libraries(${name} PRIVATE rasterloom_settings ${ARG_DEPENDS} GTest::gmock GTest::gtest_main)
    target_compile_definitions(${name} PRIVATE RASTERLOOM_SOURCE_DIR="${CMAKE_SOURCE_DIR}"
                                               RASTERLOOM_BINARY_DIR="${CMAKE_BINARY_DIR}")
    include(GoogleTest)
    gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60
                         PROPERTIES SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")
endfunction()

# rasterloom_benchmark(NAME SOURCES a_bench.cpp ... [DEPENDS lib ...]): a Google Benchmark program.
function(rasterloom_benchmark name)
    cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS" ${ARGN})
    find_package(benchmark REQUIRED)
    add_executable(${name} ${ARG_SOURCES})
    target_link_libraries(${name} PRIVATE rasterloom_settings ${ARG_DEPENDS} benchmark::benchmark_main)
endfunction()
