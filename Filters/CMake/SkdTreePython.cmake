# SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The Python package vtkskdtree: VTK's wrapping of the classes, the layer over it (Filters/Python),
# type stubs, and the wheel that `cmake --build build --target wheel` makes.

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

# Generated sources, of which reading the same headers is most of what it takes to compile them.
set_target_properties(vtkFiltersSkdTreePython PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)

# In a wheel, the library is beside the Python module, and those of VTK may be in vtkmodules.
if (UNIX)
  set(origin "$<IF:$<PLATFORM_ID:Darwin>,@loader_path,$ORIGIN>")
  set_property(TARGET FiltersSkdTree vtkFiltersSkdTreePython APPEND PROPERTY
    INSTALL_RPATH "${origin}" "${origin}/../vtkmodules")
endif ()

set(sources "${CMAKE_CURRENT_SOURCE_DIR}/Filters/Python")
set(python_package "${CMAKE_BINARY_DIR}/${SKDTREE_PYTHON_DESTINATION}/vtkskdtree")
set(layer accessor.py arrays.py filters.py meshes.py operations.py py.typed tree.py)
configure_file("${sources}/__init__.py.in" "${python_package}/__init__.py" @ONLY)
foreach (file IN LISTS layer)
  configure_file("${sources}/${file}" "${python_package}/${file}" COPYONLY)
endforeach ()
list(TRANSFORM layer PREPEND "${python_package}/")
install(FILES "${python_package}/__init__.py" ${layer}
  DESTINATION "${SKDTREE_PYTHON_DESTINATION}/vtkskdtree" COMPONENT python)

# Stubs of the classes, by VTK's generator, which imports the module.
find_package(Python3 COMPONENTS Interpreter)
set(python_path "${CMAKE_BINARY_DIR}/${SKDTREE_PYTHON_DESTINATION}:$ENV{PYTHONPATH}")
set(python "${CMAKE_COMMAND}" -E env "PYTHONPATH=${python_path}" "${Python3_EXECUTABLE}")
execute_process(COMMAND ${python} -m vtkmodules.generate_pyi --help
  RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
if (failed)
  message(STATUS "vtkmodules.generate_pyi does not run: there are no type stubs of the classes")
else ()
  set(stubs "${python_package}/vtkFiltersSkdTree.pyi")
  add_custom_command(OUTPUT "${stubs}"
    COMMAND ${python} "${sources}/stubs.py" vtkskdtree "${python_package}" vtkFiltersSkdTree
    DEPENDS vtkFiltersSkdTreePython "${python_package}/__init__.py" "${sources}/stubs.py"
    COMMENT "Generating type stubs of vtkskdtree"
    VERBATIM)
  add_custom_target(SkdTreePythonStubs ALL DEPENDS "${stubs}")
  install(FILES "${stubs}"
    DESTINATION "${SKDTREE_PYTHON_DESTINATION}/vtkskdtree" COMPONENT python)
endif ()

# The wheel, made from what is installed.
set(wheel "${CMAKE_BINARY_DIR}/wheel")
add_custom_target(wheel
  COMMAND "${CMAKE_COMMAND}" -E rm -rf "${wheel}"
  COMMAND "${CMAKE_COMMAND}" --install "${CMAKE_BINARY_DIR}" --config $<CONFIG>
    --prefix "${wheel}/installed" --component runtime
  COMMAND "${CMAKE_COMMAND}" --install "${CMAKE_BINARY_DIR}" --config $<CONFIG>
    --prefix "${wheel}/installed" --component python
  COMMAND "${Python3_EXECUTABLE}" "${sources}/wheel.py" "${wheel}" "${PROJECT_SOURCE_DIR}/LICENSE"
    $<TARGET_SONAME_FILE_NAME:FiltersSkdTree> "${PROJECT_VERSION}+vtk${VTK_VERSION}"
    "${PROJECT_DESCRIPTION}" ${SKDTREE_WHEEL_REQUIRES}
  COMMENT "Making a wheel in ${wheel}"
  VERBATIM)
add_dependencies(wheel vtkFiltersSkdTreePython)
if (TARGET SkdTreePythonStubs)
  add_dependencies(wheel SkdTreePythonStubs)
endif ()
