// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellZoo.h
 * @brief a few cells of every type that VTK has
 */
#ifndef skdtest_CellZoo_h
#define skdtest_CellZoo_h

#include "Support/TestAmount.h"
#include "Support/VolumeMeshes.h"

#include "vtkCell.h"
#include "vtkCellTypes.h"
#include "vtkGenericCell.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkHigherOrderQuadrilateral.h"
#include "vtkHigherOrderWedge.h"

#include <string>

namespace skdtest
{

bool IsHigherOrder(int type);

/// The highest order of Lagrange and Bezier cells that tests try. VTK's own maps of them are slow.
inline int HighestOrder()
{
  return FewerTests() ? 2 : 4;
}

/// How many points a Lagrange or Bezier cell of uniform order has.
int HigherOrderSize(int type, int order);

/// For cells whose order may differ by direction: states that it does not.
void SetUniformOrder(vtkCell* cell, vtkIdType points);

/// The points of a cell that VTK can place itself: its parametric coordinates. Empty if it cannot.
std::vector<Point> ReferencePoints(int type, int order);

/// The cells whose number of points is free, by hand.
Mesh FreeFormCell(int type);

/// One cell in its reference form; no cell if VTK cannot make one of that type.
Mesh ReferenceCell(int type, int order);

/// A 2 x 2 x 2 block of copies of a mesh, 1.5 apart, each under a map of space.
Mesh Block(const Mesh& one, const std::function<Point(const Point&)>& where);

Point Unmoved(const Point& p);

/// Every type number below VTK_NUMBER_OF_CELL_TYPES that names a cell which VTK can make.
std::vector<int> AllCellTypes();

int DimensionOf(int type);

/// "QuadraticEdge", say, for the name of a test.
std::string NameOfType(int type);

}

#endif
