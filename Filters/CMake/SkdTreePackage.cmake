# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The .deb made by `cpack`. It is installed beside its VTK, and depends on that exact version: VTK's
# and ParaView's binary interfaces change with every release.

set(CPACK_PACKAGE_NAME "paraview-skdtree")
set(CPACK_PACKAGE_VENDOR "the skD-tree authors")
set(CPACK_PACKAGE_CONTACT "the skD-tree authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}, for VTK and ParaView")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGING_INSTALL_PREFIX "${CMAKE_INSTALL_PREFIX}")
set(CPACK_STRIP_FILES ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
if (SKDTREE_VTK_PACKAGE STREQUAL "ParaView")
  set(CPACK_DEBIAN_PACKAGE_DEPENDS
    "paraview (>= ${ParaView_VERSION}), paraview (<< ${ParaView_VERSION}.)")
  if (SKDTREE_WRAP_PYTHON)
    string(APPEND CPACK_DEBIAN_PACKAGE_DEPENDS ", python3-paraview")
  endif ()
  # What draws the icons.
  set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libqt5svg5")
  if (PARAVIEW_QT_MAJOR_VERSION EQUAL 6)
    set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "qt6-svg-plugins")
  endif ()
else ()
  set(CPACK_PACKAGE_NAME "vtk-skdtree")
endif ()

set(CPACK_GENERATOR DEB)
include(CPack)
