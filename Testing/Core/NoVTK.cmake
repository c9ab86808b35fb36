# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Fails where a file of the core includes anything of VTK, the bridge or the faces. (A VTK in the
# compiler's default folders would go unnoticed by compiling alone.)

if (NOT FOLDER)
  message(FATAL_ERROR "Say -DFOLDER=<folder> before -P")
endif ()
file(GLOB_RECURSE files "${FOLDER}/*.h")
if (NOT files)
  message(FATAL_ERROR "No headers in ${FOLDER}")
endif ()
foreach (file IN LISTS files)
  file(STRINGS "${file}" lines REGEX "#[ \t]*include[ \t]*[<\"](vtk|Cells/|[A-Za-z/]*/Skd|Skd)")
  if (lines)
    message(SEND_ERROR "${file} points up: ${lines}")
  endif ()
endforeach ()
