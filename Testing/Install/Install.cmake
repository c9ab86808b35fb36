# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs BUILD (configuration CONFIG) to an empty PREFIX and checks that everything is there.

file(REMOVE_RECURSE "${PREFIX}")
execute_process(
  COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --config "${CONFIG}" --prefix "${PREFIX}"
  COMMAND_ERROR_IS_FATAL ANY)

foreach (wanted IN ITEMS
    "/vtkSkdTreeCellLocator.h" "/vtkSkdTreeClosestPoint.h" "/vtkSkdTreeVersion.h"
    "/vtkFiltersSkdTreeModule.h" "/SkdTreeConfig.cmake" "/SkdTreeConfigVersion.cmake"
    "/SkdTree-targets.cmake" "/LICENSE")
  file(GLOB_RECURSE found "${PREFIX}/*")
  list(FILTER found INCLUDE REGEX "${wanted}$")
  if (NOT found)
    message(SEND_ERROR "${wanted} is not installed")
  endif ()
endforeach ()

# No private header may be installed, because it would become part of the interface.
file(GLOB_RECURSE private "${PREFIX}/*/Skd*.h" "${PREFIX}/*/Core/*.h")
if (private)
  message(SEND_ERROR "Private headers are installed: ${private}")
endif ()
