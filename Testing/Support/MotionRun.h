// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MotionRun.h
 * @brief vtkSkdTreeBooleanOperation with a Source that is moved by properties
 */
#ifndef skdtest_MotionRun_h
#define skdtest_MotionRun_h

#include "Support/SolidRun.h"

#include "vtkMatrix4x4.h"

namespace skdtest
{

/// What a motion by properties makes of a point, by the same arithmetic.
inline Point Moved(const vtkMatrix4x4* by, const Point& x)
{
  Point to;
  for (int i = 0; i < 3; ++i)
  {
    to[i] = by->Element[i][0] * x[0] + by->Element[i][1] * x[1] + by->Element[i][2] * x[2] +
      by->Element[i][3];
  }
  return to;
}

inline Mesh Moved(const vtkMatrix4x4* by, Mesh mesh)
{
  mesh.Map([by](const Point& x) { return Moved(by, x); });
  return mesh;
}

inline void ExpectEqual(const Mesh& a, const Mesh& b)
{
  EXPECT_EQ(a.Points, b.Points);
  ASSERT_EQ(a.Cells.size(), b.Cells.size());
  for (std::size_t i = 0; i < a.Cells.size(); ++i)
  {
    EXPECT_EQ(a.Cells[i].Points, b.Cells[i].Points);
  }
}

/// Arrays of the same names with the same numbers.
inline void ExpectEqual(vtkFieldData* a, vtkFieldData* b)
{
  ASSERT_EQ(a->GetNumberOfArrays(), b->GetNumberOfArrays());
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const first = a->GetArray(i);
    vtkDataArray* const second = b->GetArray(first->GetName());
    ASSERT_TRUE(second) << first->GetName();
    ASSERT_EQ(first->GetNumberOfTuples(), second->GetNumberOfTuples()) << first->GetName();
    for (vtkIdType tuple = 0; tuple < first->GetNumberOfTuples(); ++tuple)
    {
      ASSERT_EQ(first->GetTuple1(tuple), second->GetTuple1(tuple))
        << first->GetName() << " " << tuple;
    }
  }
}

/// To the last bit, with their data but for the report.
inline void ExpectEqual(vtkPolyData* a, vtkPolyData* b)
{
  ExpectEqual(MeshOf(a), MeshOf(b));
  ExpectEqual(a->GetCellData(), b->GetCellData());
  ExpectEqual(a->GetPointData(), b->GetPointData());
}

}

#endif
