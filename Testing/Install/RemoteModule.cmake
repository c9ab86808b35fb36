# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Puts what a VTK build would fetch from SOURCE into WORK/source/Remote/SkdTree, and builds the small
# super-project around it with GENERATOR and OPTIONS: without precompiled headers, so that each file
# shows that it includes what it needs; or, if the environment variable SKDTREE_REMOTE_IN_GROUPS is
# set, with them and in large groups (SKDTREE_UNITY_BUILD), which takes much less time.

set(super "${WORK}/source")
file(COPY "${CMAKE_CURRENT_LIST_DIR}/RemoteModule/" "${CMAKE_CURRENT_LIST_DIR}/Outside/Outside.cxx"
  DESTINATION "${super}")
# Files that were renamed since would be built, too.
file(REMOVE_RECURSE "${super}/Remote")
foreach (part IN ITEMS CMakeLists.txt vtk.module LICENSE Filters Testing Data)
  file(COPY "${SOURCE}/${part}" DESTINATION "${super}/Remote/SkdTree")
endforeach ()

set(in_groups OFF)
set(alone ON)
if (NOT "$ENV{SKDTREE_REMOTE_IN_GROUPS}" STREQUAL "")
  set(in_groups ON)
  set(alone OFF)
endif ()
execute_process(
  COMMAND "${CMAKE_COMMAND}" -S "${super}" -B "${WORK}/build" -G "${GENERATOR}"
    -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0
    -DCMAKE_DISABLE_PRECOMPILE_HEADERS=${alone} -DSKDTREE_UNITY_BUILD=${in_groups}
    -DSKDTREE_UNITY_SIZE=18 ${OPTIONS}
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(
  COMMAND "${CMAKE_COMMAND}" --build "${WORK}/build" --target RemoteModule
  COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE program "${WORK}/build/RemoteModule")
execute_process(COMMAND ${program} COMMAND_ERROR_IS_FATAL ANY)

# Its name must be one that VTK gave it.
file(GLOB_RECURSE library "${WORK}/build/libvtkFiltersSkdTree-9.9*")
if (NOT library)
  message(FATAL_ERROR "The library has not the name that the super-project wants")
endif ()
