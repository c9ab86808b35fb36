# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Files for users of the build: the CMake package SkdTree, build/setup.sh, the .deb.

include(CMakePackageConfigHelpers)

# The package, for the install tree and for the build tree.
set(package_folder "${CMAKE_BINARY_DIR}/${SKDTREE_CMAKE_DESTINATION}")
configure_package_config_file(Filters/CMake/SkdTreeConfig.cmake.in "${package_folder}/SkdTreeConfig.cmake"
  INSTALL_DESTINATION "${SKDTREE_CMAKE_DESTINATION}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${package_folder}/SkdTreeConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
configure_file(Filters/CMake/SkdTreePythonModules.cmake "${package_folder}" COPYONLY)
install(
  FILES
    "${package_folder}/SkdTreeConfig.cmake"
    "${package_folder}/SkdTreeConfigVersion.cmake"
    "${package_folder}/SkdTreePythonModules.cmake"
  DESTINATION "${SKDTREE_CMAKE_DESTINATION}" COMPONENT development)

# The script to source in a shell to use the build tree.
set(plugin_folder "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}")
configure_file(Filters/CMake/setup.sh.in "${CMAKE_BINARY_DIR}/setup.sh" @ONLY)

include(SkdTreePackage)
