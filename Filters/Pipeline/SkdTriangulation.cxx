// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdTriangulation.h"

#include "vtkMath.h"

SkdTriangulation::SkdTriangulation(vtkPoints* points)
  : Points(points)
{
  this->Polygon->Points->SetDataTypeToDouble();
}

vtkIdList* SkdTriangulation::Cut(const vtkIdType* corners, int size)
{
  this->Triangles->Reset();
  if (size == 4)
  {
    this->AddFan(corners, size, this->GetFirstOfQuad(corners));
  }
  else if (size < 4 || !this->CutPolygon(corners, size))
  {
    this->AddFan(corners, size, 0); // also of a polygon that crosses itself, say
  }
  return this->Triangles;
}

void SkdTriangulation::AddFan(const vtkIdType* corners, int size, int first)
{
  for (int i = 1; i + 1 < size; ++i)
  {
    for (int corner : { 0, i, i + 1 })
    {
      this->Triangles->InsertNextId(corners[(first + corner) % size]);
    }
  }
}

// The corner 0 or 1 that the cut starts from. A diagonal lies within when the triangles on its
// sides turn the same way.
int SkdTriangulation::GetFirstOfQuad(const vtkIdType* corners) const
{
  double p[4][3];
  for (int i = 0; i < 4; ++i)
  {
    this->Points->GetPoint(corners[i], p[i]);
  }
  const auto isWithin = [&](int a, int b, int c, int d)
  {
    double ab[3], ac[3], ad[3], left[3], right[3];
    vtkMath::Subtract(p[b], p[a], ab);
    vtkMath::Subtract(p[c], p[a], ac);
    vtkMath::Subtract(p[d], p[a], ad);
    vtkMath::Cross(ab, ac, left);
    vtkMath::Cross(ac, ad, right);
    return vtkMath::Dot(left, right) > 0.0;
  };
  const bool is02 = isWithin(0, 1, 2, 3);
  const bool is13 = isWithin(1, 2, 3, 0);
  if (is02 != is13)
  {
    return is02 ? 0 : 1;
  }
  const double diagonal02 = vtkMath::Distance2BetweenPoints(p[0], p[2]);
  return diagonal02 <= vtkMath::Distance2BetweenPoints(p[1], p[3]) ? 0 : 1;
}

bool SkdTriangulation::CutPolygon(const vtkIdType* corners, int size)
{
  this->Polygon->PointIds->SetNumberOfIds(size);
  this->Polygon->Points->SetNumberOfPoints(size);
  for (int i = 0; i < size; ++i)
  {
    double p[3];
    this->Points->GetPoint(corners[i], p);
    this->Polygon->PointIds->SetId(i, corners[i]);
    this->Polygon->Points->SetPoint(i, p);
  }
  const bool isCut = this->Polygon->Triangulate(0, this->Triangles, this->Unused) &&
    this->Triangles->GetNumberOfIds() == 3 * (size - 2);
  if (!isCut)
  {
    this->Triangles->Reset();
  }
  return isCut;
}
