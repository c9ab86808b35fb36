// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdPackedMesh.h
 * @brief A data set as a list of arrays, to be sent to another process.
 *
 * VTK's own marshalling of data sets uses its legacy file format, which rounds the origin and
 * spacing of images to six digits and loses which arrays are rational weights or degrees of curved
 * cells. That of a table's field data keeps every array exactly, so all is put there.
 */

#ifndef SkdPackedMesh_h
#define SkdPackedMesh_h

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

namespace skdtree
{
/// The geometry, cells, ghost marks and all arrays of a data set of any type, as field data of a
/// table. Types without a form of their own are packed as vtkUnstructuredGrid. Arrays in standard
/// memory layout are shared.
vtkSmartPointer<vtkTable> SkdPack(vtkDataSet* mesh);

/// The data set again, of the same type.
vtkSmartPointer<vtkDataSet> SkdUnpack(vtkTable* packed);
}

#endif
