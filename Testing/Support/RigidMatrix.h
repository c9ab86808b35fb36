// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RigidMatrix.h
 * @brief rotated, and moved then
 */
#ifndef skdtest_RigidMatrix_h
#define skdtest_RigidMatrix_h

#include "Support/MeshBuilder.h"

#include "vtkMatrix4x4.h"
#include "vtkSmartPointer.h"

namespace skdtest
{

/// The motion x -> Rotated(x) + shift.
inline vtkSmartPointer<vtkMatrix4x4> RigidMatrix(const Point& shift)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  const Point columns[3] = { Rotated({ 1, 0, 0 }), Rotated({ 0, 1, 0 }), Rotated({ 0, 0, 1 }) };
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      matrix->SetElement(row, column, columns[column][row]);
    }
    matrix->SetElement(row, 3, shift[row]);
  }
  return matrix;
}

}

#endif
