# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# How a test is added: skdtree_add_gtest for C++, skdtree_add_python_test for pvpython or Python.

include("${CMAKE_CURRENT_LIST_DIR}/../Filters/CMake/SkdTreeUnity.cmake")

# Without its component gl: Open MPI's hwloc looks for graphics cards on all displays, and its daemon
# ends with the display of another test.
set(SKDTREE_TEST_ENVIRONMENT
  "HWLOC_COMPONENTS=-gl"
  "SKDTREE_SOURCE_DIR=${SKDTREE_ROOT}"
  "SKDTREE_DATA_DIR=${SKDTREE_ROOT}/Data"
  "SKDTREE_EXTRA_DATA_DIR=${SKDTREE_EXTRA_DATA_DIR}"
  "SKDTREE_TEMPORARY_DIR=${SKDTREE_TEMPORARY_DIR}")
if (SKDTREE_SANITIZE)
  list(APPEND SKDTREE_TEST_ENVIRONMENT "SKDTREE_FEWER_TESTS=1")
endif ()

# The build tree's plugin and Python package, as build/setup.sh gives them to a shell.
set(SKDTREE_USE_ENVIRONMENT
  "PV_PLUGIN_PATH=${plugin_folder}/SkdTree"
  "PYTHONPATH=${CMAKE_BINARY_DIR}/${SKDTREE_PYTHON_DESTINATION}"
  "LD_LIBRARY_PATH=${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}:$ENV{LD_LIBRARY_PATH}")

# In front of a command that renders: a virtual display, where Xvfb is installed.
find_program(SKDTREE_XVFB Xvfb)
set(SKDTREE_WITH_DISPLAY)
if (SKDTREE_XVFB)
  set(SKDTREE_WITH_DISPLAY bash "${SKDTREE_ROOT}/.ci/with_display.sh")
endif ()

set(SKDTREE_SANITIZER_ENVIRONMENT
  "ASAN_OPTIONS=detect_leaks=1:strict_string_checks=1"
  "TSAN_OPTIONS=halt_on_error=1:second_deadlock_stack=1"
  "UBSAN_OPTIONS=print_stacktrace=1")

# What a C++ test is compiled with: our headers, public and private, as the module itself sees them
# ("Core/...", "Cells/..."), the tests' own ("Support/..."), and the same rounding rules.
add_library(skdtree_testing INTERFACE)
target_compile_features(skdtree_testing INTERFACE cxx_std_17)
target_compile_options(skdtree_testing INTERFACE
  $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-ffp-contract=off -Wall -Wextra>)
target_include_directories(skdtree_testing INTERFACE
  "${SKDTREE_ROOT}/Filters" "${CMAKE_CURRENT_LIST_DIR}")

# Of skdtree_add_gtest. Compiling takes most of the tests' time: headers that nearly all include are
# read once, and templates are optimised only as far as saves more time in the run than it costs.
macro (skdtree_set_test_options name)
  target_precompile_headers("${name}" PRIVATE <gtest/gtest.h> ${test_HEADERS})
  target_compile_options("${name}" PRIVATE
    $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU,Clang,AppleClang>>:-O1>)
  if ("address" IN_LIST SKDTREE_SANITIZE AND test_IN_LIBRARIES)
    target_compile_options("${name}" PRIVATE -fno-sanitize=all)
  endif ()
endmacro ()

# skdtree_use_compiled_tests(<name> <file>)
# The same of objects that another build, which is brought up to date first, has written to the file.
function (skdtree_use_compiled_tests name file)
  file(STRINGS "${file}" objects)
  add_custom_target("${name}Objects"
    COMMAND "${CMAKE_COMMAND}" --build "${SKDTREE_TESTS_OF}" --target "${name}"
    BYPRODUCTS ${objects})
  set_source_files_properties(${objects} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
  add_executable("${name}" ${objects})
  set_target_properties("${name}" PROPERTIES LINKER_LANGUAGE CXX)
  add_dependencies("${name}" "${name}Objects")
endfunction ()

# skdtree_add_gtest(<name> SOURCES <file>... [LIBRARIES <target>...] [HEADERS <header>...]
#   [IN_LIBRARIES] LABEL <label>)
# An executable with GoogleTest's main. Starting one process for each of thousands of short tests
# would take most of the time, so a few processes run a share of them each; failures are named in
# the output. IN_LIBRARIES: the work is in libraries, so that AddressSanitizer, which finds their
# errors whoever calls them, need not look at the tests themselves; a build with it takes them
# compiled from SKDTREE_TESTS_OF, if that is given and configured.
function (skdtree_add_gtest name)
  cmake_parse_arguments(PARSE_ARGV 1 test "IN_LIBRARIES" "LABEL" "SOURCES;LIBRARIES;HEADERS")
  set(objects_file "Testing/${name}.objects")
  if (test_IN_LIBRARIES AND EXISTS "${SKDTREE_TESTS_OF}/${objects_file}")
    skdtree_use_compiled_tests("${name}" "${SKDTREE_TESTS_OF}/${objects_file}")
  else ()
    add_executable("${name}" ${test_SOURCES})
    skdtree_set_test_options("${name}")
    skdtree_compile_in_groups("${name}" 4 ${test_SOURCES})
    file(GENERATE OUTPUT "${CMAKE_BINARY_DIR}/${objects_file}" CONTENT "$<TARGET_OBJECTS:${name}>")
  endif ()
  target_link_libraries("${name}" PRIVATE skdtree_testing ${test_LIBRARIES} GTest::gtest_main)
  set(count 8)
  foreach (share RANGE 1 ${count})
    math(EXPR index "${share} - 1")
    add_test(NAME "${test_LABEL}.Share${share}" COMMAND "${name}" --gtest_brief=1)
    set_tests_properties("${test_LABEL}.Share${share}" PROPERTIES
      LABELS "${test_LABEL}"
      TIMEOUT 1800
      ENVIRONMENT "GTEST_TOTAL_SHARDS=${count};GTEST_SHARD_INDEX=${index};\
${SKDTREE_TEST_ENVIRONMENT};${SKDTREE_SANITIZER_ENVIRONMENT}")
  endforeach ()
endfunction ()

# skdtree_add_python_test(<name> COMMAND <command>... LABEL <label>)
# A run of pvpython, python3, ... that finds the build tree's plugin and Python package. Exit code
# 77 means skipped; errors reported by VTK or ParaView are failures.
function (skdtree_add_python_test name)
  cmake_parse_arguments(PARSE_ARGV 1 test "" "LABEL" "COMMAND")
  add_test(NAME "${test_LABEL}.${name}" COMMAND ${test_COMMAND})
  set_tests_properties("${test_LABEL}.${name}" PROPERTIES
    LABELS "${test_LABEL}"
    TIMEOUT 1800
    SKIP_RETURN_CODE 77
    FAIL_REGULAR_EXPRESSION "ERR\\|;ERROR: In ;Traceback"
    ENVIRONMENT "${SKDTREE_TEST_ENVIRONMENT};${SKDTREE_USE_ENVIRONMENT}")
endfunction ()
