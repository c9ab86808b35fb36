# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause

# skdtree_compile_in_groups(<target> <size> <source>...)
# With SKDTREE_UNITY_BUILD, up to <size> sources are compiled as one: they include the same headers and use
# the same templates, and these take most of the time. Sources in which a name means different things are
# kept apart (Testing/Layout/source_groups.py), which CMake's own batches do not do. A source of two targets
# has the group that it got for the first.
function (skdtree_compile_in_groups target size)
  set_target_properties("${target}" PROPERTIES UNITY_BUILD OFF)
  if (NOT SKDTREE_UNITY_BUILD)
    return ()
  endif ()
  find_package(Python3 QUIET COMPONENTS Interpreter)
  if (NOT Python3_Interpreter_FOUND)
    return ()
  endif ()
  set(sources)
  foreach (source IN LISTS ARGN)
    get_source_file_property(group "${source}" UNITY_GROUP)
    if (NOT group)
      list(APPEND sources "${source}")
    endif ()
  endforeach ()
  set(script "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../../Testing/Layout/source_groups.py")
  execute_process(COMMAND "${Python3_EXECUTABLE}" "${script}" "${size}" ${sources}
    WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
    OUTPUT_VARIABLE groups
    COMMAND_ERROR_IS_FATAL ANY)
  set(number 0)
  string(REGEX MATCHALL "[^\n]+" groups "${groups}")
  foreach (group IN LISTS groups)
    string(REPLACE "," ";" group "${group}")
    math(EXPR number "${number} + 1")
    set_source_files_properties(${group} PROPERTIES UNITY_GROUP "${target}${number}")
  endforeach ()
  set_target_properties("${target}" PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction ()
