# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Debian 13 and later tell CMake of ParaView's Python modules by names that they do not have on disk
# (vtkCommonCore.so, not vtkCommonCore.cpython-313-x86_64-linux-gnu.so), and find_package refuses
# what names a file that is missing. Python modules are not linked, so they are accepted here.

# skdtree_accept_python_modules(<folder>...)
# To be called before find_package, in its scope, with the folders of its *Python*-targets.cmake.
# What CMake 3.28 and later write there does not look for the file of a target that comes as a
# framework, that is for which such a variable names a folder.
macro (skdtree_accept_python_modules)
  foreach (_skdtree_folder IN ITEMS ${ARGN})
    file(GLOB _skdtree_files "${_skdtree_folder}/*Python*-targets-*.cmake")
    foreach (_skdtree_file IN LISTS _skdtree_files)
      file(STRINGS "${_skdtree_file}" _skdtree_lines REGEX "^list\\(APPEND _cmake_import_check_targets ")
      foreach (_skdtree_line IN LISTS _skdtree_lines)
        string(REGEX REPLACE "^.*_cmake_import_check_targets ([^ ]+).*$" "\\1"
          _skdtree_target "${_skdtree_line}")
        set("_cmake_import_check_xcframework_for_${_skdtree_target}" "${_skdtree_folder}")
      endforeach ()
    endforeach ()
  endforeach ()
endmacro ()
