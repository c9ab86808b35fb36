// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Read/SkdHigherOrderFunctions.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkHigherOrderTetra.h"
#include "vtkHigherOrderTriangle.h"
#include "vtkHigherOrderWedge.h"

#include <algorithm>

namespace skdtree
{
namespace
{
/// How many points a triangle or a tetrahedron of a degree has.
int NumberOfPoints(int simplexAxes, int degree)
{
  const int ofTriangle = (degree + 1) * (degree + 2) / 2;
  return simplexAxes == 2 ? ofTriangle : ofTriangle * (degree + 3) / 3;
}

/// The least degree of a triangle or a tetrahedron of at least so many points.
int DegreeOf(int simplexAxes, int points)
{
  int degree = 1;
  while (NumberOfPoints(simplexAxes, degree) < points)
  {
    ++degree;
  }
  return degree;
}

bool IsTriangle(int type)
{
  return type == VTK_LAGRANGE_TRIANGLE || type == VTK_BEZIER_TRIANGLE;
}

bool IsTetrahedron(int type)
{
  return type == VTK_LAGRANGE_TETRAHEDRON || type == VTK_BEZIER_TETRAHEDRON;
}

bool IsWedge(int type)
{
  return type == VTK_LAGRANGE_WEDGE || type == VTK_BEZIER_WEDGE;
}

double Factorial(int n)
{
  return n < 2 ? 1.0 : n * Factorial(n - 1);
}

/// Calls visit(i, j, k) for each point of the lattice of a triangle, a tetrahedron or a wedge.
template <class Visit>
void ForEachLatticePoint(int type, int degree, int along, const Visit& visit)
{
  const int last = IsTriangle(type) ? 0 : IsWedge(type) ? along : degree;
  for (int k = 0; k <= last; ++k)
  {
    const int ofTriangle = IsWedge(type) ? degree : degree - k;
    for (int j = 0; j <= ofTriangle; ++j)
    {
      for (int i = 0; i <= ofTriangle - j; ++i)
      {
        visit(i, j, k);
      }
    }
  }
}

/// The number that VTK gives to the point of the lattice with these powers.
vtkIdType PointAt(int type, int degree, int along, const int* powers)
{
  if (IsWedge(type))
  {
    const int order[4] = { degree, degree, along, NumberOfPoints(2, degree) * (along + 1) };
    return vtkHigherOrderWedge::PointIndexFromIJK(powers[0], powers[1], powers[4], order);
  }
  if (IsTriangle(type))
  {
    const vtkIdType barycentric[3] = { powers[0], powers[1], powers[3] };
    return vtkHigherOrderTriangle::Index(barycentric, degree);
  }
  const vtkIdType barycentric[4] = { powers[0], powers[1], powers[2], powers[3] };
  return vtkHigherOrderTetra::Index(barycentric, degree);
}
}

//------------------------------------------------------------------------------
bool SkdHigherOrderFunctions::Key::operator==(const Key& other) const
{
  return this->Type == other.Type && this->Degree == other.Degree && this->Along == other.Along &&
    this->Size == other.Size;
}

//------------------------------------------------------------------------------
const SkdHigherOrderFunctions* SkdHigherOrderFunctions::Of(vtkCell* cell)
{
  thread_local SkdHigherOrderFunctions last;
  const Key key = KeyOf(cell);
  if (!(key == last.TheKey))
  {
    last.Set(key);
  }
  return last.IsUsable ? &last : nullptr;
}

//------------------------------------------------------------------------------
SkdHigherOrderFunctions::Key SkdHigherOrderFunctions::KeyOf(vtkCell* cell)
{
  Key key;
  key.Type = cell->GetCellType();
  key.Size = static_cast<int>(cell->GetNumberOfPoints());
  if (IsWedge(key.Type))
  {
    const int* order = static_cast<vtkHigherOrderWedge*>(cell)->GetOrder();
    key.Degree = order[0];
    key.Along = order[2];
  }
  else if (IsTriangle(key.Type) || IsTetrahedron(key.Type))
  {
    key.Degree = DegreeOf(IsTriangle(key.Type) ? 2 : 3, key.Size);
  }
  return key;
}

//------------------------------------------------------------------------------
bool SkdHigherOrderFunctions::IsBezier() const
{
  return this->TheKey.Type >= VTK_BEZIER_CURVE;
}

//------------------------------------------------------------------------------
void SkdHigherOrderFunctions::Set(const Key& key)
{
  this->TheKey = key;
  this->SimplexAxes = IsTetrahedron(key.Type) ? 3 : 2;
  const int expected = NumberOfPoints(this->SimplexAxes, key.Degree) * (key.Along + 1);
  this->IsUsable =
    key.Degree > 0 && key.Size == expected && std::max(key.Degree, key.Along) <= HighestDegree;
  if (!this->IsUsable)
  {
    return;
  }
  this->Scale = this->IsBezier() ? Factorial(key.Degree) * Factorial(key.Along) : 1.0;
  this->PowersOf.resize(static_cast<std::size_t>(key.Size));
  ForEachLatticePoint(key.Type, key.Degree, key.Along,
    [&](int i, int j, int k)
    {
      const int inTetrahedron = IsTetrahedron(key.Type) ? k : 0;
      const int along = IsWedge(key.Type) ? k : 0;
      const int powers[Coordinates] = { i, j, inTetrahedron, key.Degree - i - j - inTetrahedron,
        along, key.Along - along };
      const vtkIdType point = PointAt(key.Type, key.Degree, key.Along, powers);
      std::copy_n(powers, Coordinates, this->PowersOf[static_cast<std::size_t>(point)].begin());
    });
}

//------------------------------------------------------------------------------
void SkdHigherOrderFunctions::Fill(double x, int degree, double (&factors)[HighestDegree + 1]) const
{
  const bool isBezier = this->IsBezier();
  factors[0] = 1.0;
  for (int k = 0; k < degree; ++k)
  {
    factors[k + 1] = factors[k] * (isBezier ? x : degree * x - k) / (k + 1);
  }
}

//------------------------------------------------------------------------------
void SkdHigherOrderFunctions::Evaluate(const double pcoords[3], double* values) const
{
  const Key& key = this->TheKey;
  const double third = this->SimplexAxes == 3 ? pcoords[2] : 0.0;
  const double along = IsWedge(key.Type) ? pcoords[2] : 0.0;
  const double rest = 1.0 - pcoords[0] - pcoords[1] - third;
  double factors[Coordinates][HighestDegree + 1];
  this->Fill(pcoords[0], key.Degree, factors[0]);
  this->Fill(pcoords[1], key.Degree, factors[1]);
  this->Fill(third, key.Degree, factors[2]);
  this->Fill(rest, key.Degree, factors[3]);
  this->Fill(along, key.Along, factors[4]);
  this->Fill(1.0 - along, key.Along, factors[5]);
  for (const Powers& powers : this->PowersOf)
  {
    double value = this->Scale;
    for (std::size_t i = 0; i < Coordinates; ++i)
    {
      value *= factors[i][powers[i]];
    }
    *values++ = value;
  }
}
}
