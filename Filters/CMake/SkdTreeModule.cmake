# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds the module VTK::FiltersSkdTree and, optionally, its Python package (SkdTreePython.cmake).

set(SKDTREE_CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/SkdTree")

# A folder of the module's own. The repository's root is where a remote module's vtk.module has to be,
# but taken from there our project would be a subdirectory of itself, and Qt 6 looks for targets in all
# subdirectories of these.
set(module_folder "${CMAKE_CURRENT_BINARY_DIR}/Module")
# VTK's packages name VTK::netcdf even where netCDF itself was not found: it is no target to use then.
set(SKDTREE_HAS_NETCDF OFF)
if (TARGET VTK::netcdf)
  get_target_property(netcdf_libraries VTK::netcdf INTERFACE_LINK_LIBRARIES)
  if (TARGET NetCDF::NetCDF OR NOT "NetCDF::NetCDF" IN_LIST netcdf_libraries)
    set(SKDTREE_HAS_NETCDF ON)
  endif ()
endif ()
file(READ vtk.module module_text)
if (NOT SKDTREE_HAS_NETCDF)
  string(REPLACE "  VTK::netcdf\n" "" module_text "${module_text}")
endif ()
set(SKDTREE_HAS_DIY OFF)
if (TARGET VTK::ParallelDIY AND TARGET VTK::diy2)
  set(SKDTREE_HAS_DIY ON)
endif ()
if (NOT SKDTREE_HAS_DIY)
  string(REPLACE "  VTK::ParallelDIY\n" "" module_text "${module_text}")
endif ()
file(CONFIGURE OUTPUT "${module_folder}/vtk.module" CONTENT "${module_text}" @ONLY)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS vtk.module)
configure_file(LICENSE "${module_folder}/LICENSE" COPYONLY)
file(CONFIGURE OUTPUT "${module_folder}/CMakeLists.txt" @ONLY
  CONTENT "add_subdirectory([[@CMAKE_CURRENT_SOURCE_DIR@/Filters]] Filters)\n")

vtk_module_scan(
  MODULE_FILES "${module_folder}/vtk.module"
  REQUEST_MODULES VTK::FiltersSkdTree
  PROVIDES_MODULES modules
  HIDE_MODULES_FROM_CACHE ON
  ENABLE_TESTS OFF)

# vtk_module_build puts a module's binary folder at its path below CMAKE_SOURCE_DIR: here this is the
# folder itself.
function (skdtree_build_module)
  set(CMAKE_SOURCE_DIR "${CMAKE_CURRENT_BINARY_DIR}")
  vtk_module_build(
    MODULES ${modules}
    PACKAGE SkdTree
    VERSION "${PROJECT_VERSION}"
    SOVERSION "${PROJECT_VERSION_MAJOR}"
    INSTALL_EXPORT SkdTree
    CMAKE_DESTINATION "${SKDTREE_CMAKE_DESTINATION}"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/skdtree")
endfunction ()
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)
skdtree_build_module()

if (SKDTREE_WRAP_PYTHON)
  include(SkdTreePython)
endif ()
