# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Finds the VTK that everything is built with: ParaView's own if the plugin is built, else a
# separate VTK, else ParaView's. Sets
#   SKDTREE_VTK_PACKAGE, SKDTREE_VTK_PACKAGE_VERSION  what was found: ParaView or VTK
#   SKDTREE_VTK_PREFIX                                the folder it is installed in

include(SkdTreePythonModules)

set(vtk_components
  CommonComputationalGeometry CommonCore CommonDataModel CommonExecutionModel CommonMath CommonSystem
  FiltersGeometry ParallelCore)
set(vtk_test_components
  CommonTransforms FiltersCore FiltersExtraction FiltersFlowPaths FiltersGeneral FiltersGeometry
  FiltersModeling FiltersSources IOGeometry IOLegacy IOPLY IOXML)
if (SKDTREE_BUILD_TESTING OR SKDTREE_BUILD_BENCHMARK)
  list(APPEND vtk_components ${vtk_test_components})
endif ()
set(python_components)
if (SKDTREE_WRAP_PYTHON)
  set(python_components Python WrappingPythonCore)
endif ()

# Files of weights need netCDF; VTK's packages do not always come with its headers. Meshes that stay
# spread over processes need DIY.
set(vtk_optional_components OPTIONAL_COMPONENTS ParallelDIY netcdf)

# Imported targets of a ParaView with MPI name MPI's, which its own configuration does not look for.
find_package(MPI QUIET COMPONENTS C CXX)

if (NOT SKDTREE_BUILD_PLUGIN)
  find_package(VTK 9.1 QUIET COMPONENTS ${vtk_components} ${python_components}
    ${vtk_optional_components})
  if (VTK_DIR AND NOT VTK_FOUND)
    message(WARNING "The VTK in ${VTK_DIR} does not do: ${VTK_NOT_FOUND_MESSAGE}")
  endif ()
endif ()
if (VTK_FOUND)
  set(SKDTREE_VTK_PACKAGE VTK)
  set(SKDTREE_VTK_PREFIX "${VTK_PREFIX_PATH}")
else ()
  # The location of ParaView: only its version file is read.
  find_package(ParaView QUIET CONFIGS paraview-config-version.cmake)
  skdtree_accept_python_modules("${ParaView_DIR}" "${ParaView_DIR}/vtk")
  find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingServerManager)
  find_package(VTK REQUIRED COMPONENTS ${vtk_components} ${python_components}
    ${vtk_optional_components} PATHS "${VTK_DIR}" NO_DEFAULT_PATH)
  set(SKDTREE_VTK_PACKAGE ParaView)
  set(SKDTREE_VTK_PREFIX "${ParaView_PREFIX_PATH}")
endif ()
set(SKDTREE_VTK_PACKAGE_VERSION "${${SKDTREE_VTK_PACKAGE}_VERSION}")
message(STATUS "skD-tree: VTK ${VTK_VERSION} of ${SKDTREE_VTK_PACKAGE} "
  "${SKDTREE_VTK_PACKAGE_VERSION} in ${SKDTREE_VTK_PREFIX}")

# A module, a plugin and a Python package are found without further settings beside their VTK.
if (CMAKE_INSTALL_PREFIX_INITIALIZED_TO_DEFAULT)
  set(CMAKE_INSTALL_PREFIX "${SKDTREE_VTK_PREFIX}" CACHE PATH "Where to install" FORCE)
endif ()
