// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkSkdTreeVersion.h
 * @brief Differences between VTK 9.1 to 9.7.
 *
 * All dependencies on VTK's version are here; no other file checks it.
 */

#ifndef vtkSkdTreeVersion_h
#define vtkSkdTreeVersion_h

#include "vtkVersionMacros.h" // For VTK_VERSION_CHECK, VTK_MAJOR_VERSION

#ifndef VTK_VERSION_NUMBER
#define VTK_VERSION_NUMBER                                                                         \
  VTK_VERSION_CHECK(VTK_MAJOR_VERSION, VTK_MINOR_VERSION, VTK_BUILD_VERSION)
#endif

// VTK before 9.3 has no ABI namespace, Debian's 9.2 of January 2023 has.
#ifndef VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

// 9.2 made the thread-safe forms of vtkAbstractCellLocator virtual, and ShallowCopy,
// FindCellsAlongPlane, ForceBuildLocator and BuildLocatorInternal with them.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
#define VTK_SKD_OVERRIDE_SINCE_92 override
#define VTK_SKD_LOCATOR_92 1
#else
#define VTK_SKD_OVERRIDE_SINCE_92
#define VTK_SKD_LOCATOR_92 0
#endif

// 9.7 made the short forms of FindCell and FindCellsAlongLine non-virtual and gave
// InsideCellBounds a tolerance (merged to VTK's master on 2026-05-14).
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 20260514)
#define VTK_SKD_OVERRIDE_UNTIL_97
#define VTK_SKD_LOCATOR_97 1
#else
#define VTK_SKD_OVERRIDE_UNTIL_97 override
#define VTK_SKD_LOCATOR_97 0
#endif

// vtkPolyData::BuildCells takes cells of any number of points since 9.2.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
#define VTK_SKD_BUILDS_ALL_CELLS 1
#else
#define VTK_SKD_BUILDS_ALL_CELLS 0
#endif

// vtkAlgorithm::CheckAbort came during 9.2's development; releases 9.2.x lack it.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20221001)
#define VTK_SKD_HAS_CHECK_ABORT 1
#else
#define VTK_SKD_HAS_CHECK_ABORT 0
#endif

// Since 9.4 a vtkUnstructuredGrid keeps the faces of its polyhedra in two vtkCellArray, not in a
// stream; ParaView 5.13's VTK of June 2024 does so, too.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 20240617)
#define VTK_SKD_FACES_ARE_CELLS 1
#else
#define VTK_SKD_FACES_ARE_CELLS 0
#endif

// 9.6 takes the number of blocks of each level of a vtkOverlappingAMR as a std::vector.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
#define VTK_SKD_AMR_TAKES_VECTOR 1
#else
#define VTK_SKD_AMR_TAKES_VECTOR 0
#endif

// 9.6 returns the types of a vtkUnstructuredGrid's cells as an array of any kind (nullptr where
// there are none yet); vtkUnsignedCharArray* before. And it calls a vtkOverlappingAMR's data sets
// blocks, which are images of any kind.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
#define VTK_SKD_GET_CELL_TYPES GetCellTypes
#define VTK_SKD_AMR_GET_NUMBER_OF_BLOCKS GetNumberOfBlocks
#define VTK_SKD_AMR_GET_BLOCK GetDataSetAsImageData
#else
#define VTK_SKD_GET_CELL_TYPES GetCellTypesArray
#define VTK_SKD_AMR_GET_NUMBER_OF_BLOCKS GetNumberOfDataSets
#define VTK_SKD_AMR_GET_BLOCK GetDataSet
#endif

#endif
