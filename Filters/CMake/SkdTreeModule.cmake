# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds the module VTK::FiltersSkdTree and, by choice, its Python package.

set(SKDTREE_CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/SkdTree")

vtk_module_scan(
  MODULE_FILES "${CMAKE_CURRENT_SOURCE_DIR}/vtk.module"
  REQUEST_MODULES VTK::FiltersSkdTree
  PROVIDES_MODULES modules
  HIDE_MODULES_FROM_CACHE ON
  ENABLE_TESTS OFF)

# vtk_module_build puts a module's binary folder at its path below CMAKE_SOURCE_DIR. For a module
# that is the source folder itself this would be the build folder: look from one folder higher.
function (skdtree_build_module)
  get_filename_component(CMAKE_SOURCE_DIR "${CMAKE_SOURCE_DIR}" DIRECTORY)
  vtk_module_build(
    MODULES ${modules}
    PACKAGE SkdTree
    VERSION "${PROJECT_VERSION}"
    SOVERSION "${PROJECT_VERSION_MAJOR}"
    INSTALL_EXPORT SkdTree
    CMAKE_DESTINATION "${SKDTREE_CMAKE_DESTINATION}"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/skdtree"
    ENABLE_WRAPPING ON)
endfunction ()
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)
skdtree_build_module()

if (SKDTREE_WRAP_PYTHON)
  # Beside vtkmodules when we are installed beside VTK, else where CMake's prefix has such packages.
  vtk_module_python_default_destination(SKDTREE_PYTHON_DESTINATION)
  if (CMAKE_INSTALL_PREFIX STREQUAL SKDTREE_VTK_PREFIX AND VTK_PYTHONPATH)
    set(SKDTREE_PYTHON_DESTINATION "${VTK_PYTHONPATH}")
  endif ()
  vtk_module_wrap_python(
    MODULES ${modules}
    TARGET SkdTreePython
    PYTHON_PACKAGE vtkskdtree
    MODULE_DESTINATION "${SKDTREE_PYTHON_DESTINATION}"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    CMAKE_DESTINATION "${SKDTREE_CMAKE_DESTINATION}"
    BUILD_STATIC OFF
    INSTALL_HEADERS OFF)
  set(python_package "${CMAKE_BINARY_DIR}/${SKDTREE_PYTHON_DESTINATION}/vtkskdtree")
  configure_file(Filters/CMake/vtkskdtree.py.in "${python_package}/__init__.py" @ONLY)
  install(FILES "${python_package}/__init__.py"
    DESTINATION "${SKDTREE_PYTHON_DESTINATION}/vtkskdtree" COMPONENT python)
endif ()
