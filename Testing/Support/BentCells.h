// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BentCells.h
 * @brief single curved cells whose points are displaced at random
 */
#ifndef skdtest_BentCells_h
#define skdtest_BentCells_h

#include "Support/LocatorCalls.h"
#include "Support/ParametricReference.h"

#include "vtkPointData.h"

namespace skdtest
{

struct BentCell
{
  int Type;
  int Order;
  double Displacement;   ///< of each point, at most, along each axis
  double Far = 1;        ///< how far queries are, as a multiple
  double Scale = 1;      ///< of all coordinates
  double Offset = 0;     ///< added to all coordinates
  bool IsFolded = false; ///< points are swapped
  bool IsRational = false;
};

inline void PrintTo(const BentCell& c, std::ostream* os)
{
  *os << NameOfType(c.Type) << "Order" << c.Order << "By" << c.Displacement
      << (c.IsRational ? "Rational" : "") << (c.IsFolded ? "Folded" : "") << "Far" << c.Far
      << "Scale" << c.Scale << "Offset" << c.Offset;
}

inline GridPointer MakeCell(const BentCell& c, Random& random)
{
  int i = 0;
  const auto moved = [&](const Point& p)
  {
    const double d = c.Displacement;
    Point x = p + random.InBox({ -d, d, -d, d, -d, d });
    x[0] = c.IsFolded && i++ % 3 == 0 ? 1 - x[0] : x[0];
    return c.Scale * (x + Point{ c.Offset, c.Offset, c.Offset });
  };
  Mesh mesh = ReferenceCell(c.Type, c.Order).Map(moved);
  GridPointer grid = MakeGrid(mesh);
  if (c.IsRational)
  {
    vtkNew<vtkDoubleArray> rational;
    rational->SetName("RationalWeights");
    for (std::size_t point = 0; point < mesh.Points.size(); ++point)
    {
      rational->InsertNextValue(random.Between(0.4, 2));
    }
    grid->GetPointData()->SetRationalWeights(rational);
  }
  return grid;
}

/// Those that VTK takes very long to evaluate.
inline bool IsSlow(int type)
{
  return type == VTK_BEZIER_TRIANGLE || type == VTK_BEZIER_TETRAHEDRON || type == VTK_BEZIER_WEDGE;
}

}

#endif
