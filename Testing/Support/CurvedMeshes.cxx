// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/CurvedMeshes.h"

#include "Support/SurfaceMeshes.h"

namespace skdtest
{
namespace
{
bool IsCurved(int type)
{
  return (type >= VTK_QUADRATIC_EDGE && type <= VTK_TRIQUADRATIC_PYRAMID) ||
    (type >= VTK_LAGRANGE_CURVE && type <= VTK_BEZIER_PYRAMID);
}

std::vector<int> CurvedTypes(int dimension)
{
  std::vector<int> types;
  for (const int type : AllCellTypes())
  {
    if (IsCurved(type) && DimensionOf(type) == dimension && type != VTK_QUADRATIC_POLYGON)
    {
      types.push_back(type);
    }
  }
  return types;
}

vtkSmartPointer<vtkCell> MakeCell(int type)
{
  return vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
}

/// Of each point of a curved cell the weights of the corners that a linear cell has there.
std::vector<std::vector<double>> StraightWeights(int type, int order)
{
  const std::vector<Point> reference = ReferencePoints(type, order);
  vtkSmartPointer<vtkCell> linear = MakeCell(LinearTypeOf(type));
  const vtkIdType corners = linear->GetNumberOfPoints();
  for (vtkIdType i = 0; i < corners; ++i)
  {
    linear->GetPoints()->SetPoint(i, reference[static_cast<std::size_t>(i)].data());
  }
  std::vector<std::vector<double>> all;
  for (const Point& p : reference)
  {
    std::vector<double> weights(static_cast<std::size_t>(corners));
    double nearest[3], pcoords[3] = { p[0], p[1], p[2] }, dist2;
    int subId;
    if (type == VTK_TRIQUADRATIC_PYRAMID) // whose domain is a pyramid, not a cube drawn together
    {
      linear->EvaluatePosition(p.data(), nearest, subId, pcoords, dist2, weights.data());
    }
    linear->InterpolateFunctions(pcoords, weights.data());
    all.push_back(weights);
  }
  return all;
}

/// Without the rounding of the weights.
double Rounded(double x)
{
  constexpr double grid = 1 << 24;
  return std::round(grid * x) / grid;
}
}

std::vector<int> CurvedVolumeTypes()
{
  return CurvedTypes(3);
}

std::vector<int> CurvedSurfaceTypes()
{
  return CurvedTypes(2);
}

int LinearTypeOf(int type)
{
  switch (type)
  {
    case VTK_QUADRATIC_TETRA:
    case VTK_LAGRANGE_TETRAHEDRON:
    case VTK_BEZIER_TETRAHEDRON:
      return VTK_TETRA;
    case VTK_QUADRATIC_PYRAMID:
    case VTK_TRIQUADRATIC_PYRAMID:
      return VTK_PYRAMID;
    case VTK_QUADRATIC_WEDGE:
    case VTK_QUADRATIC_LINEAR_WEDGE:
    case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
    case VTK_LAGRANGE_WEDGE:
    case VTK_BEZIER_WEDGE:
      return VTK_WEDGE;
    case VTK_QUADRATIC_TRIANGLE:
    case VTK_BIQUADRATIC_TRIANGLE:
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_BEZIER_TRIANGLE:
      return VTK_TRIANGLE;
    default:
      return DimensionOf(type) == 2 ? VTK_QUAD : VTK_HEXAHEDRON;
  }
}

Mesh Elevated(const Mesh& linear, int type, int order)
{
  const std::vector<std::vector<double>> weights = StraightWeights(type, order);
  Mesh mesh;
  std::map<Point, vtkIdType> known;
  for (const CellSpec& cell : linear.Cells)
  {
    Ids ids;
    for (const std::vector<double>& w : weights)
    {
      Point p = { 0, 0, 0 };
      for (std::size_t i = 0; i < w.size(); ++i)
      {
        p = p + w[i] * linear.Points[static_cast<std::size_t>(cell.Points[i])];
      }
      p = { Rounded(p[0]), Rounded(p[1]), Rounded(p[2]) };
      const auto [found, isNew] = known.emplace(p, static_cast<vtkIdType>(mesh.Points.size()));
      if (isNew)
      {
        mesh.Add(p);
      }
      ids.push_back(found->second);
    }
    mesh.Add(type, ids);
  }
  return mesh;
}

Mesh LinearBlock(int linearType, int n)
{
  switch (linearType)
  {
    case VTK_TETRA:
      return Tetrahedra(n);
    case VTK_PYRAMID:
      return Pyramids(n);
    case VTK_WEDGE:
      return Wedges(n);
    case VTK_TRIANGLE:
      return CubeTriangles(n);
    case VTK_QUAD:
      return CubeQuads(n);
    default:
      return Hexahedra(n);
  }
}

Point Bowed(const Point& p)
{
  return { p[0] + 0.11 * std::sin(2.0 * p[1] + 1.0) + 0.07 * p[2] * p[2],
    p[1] + 0.13 * std::sin(1.7 * p[2]) - 0.06 * p[0] * p[0],
    p[2] + 0.12 * std::cos(1.9 * p[0] + 0.5) + 0.05 * p[0] * p[1] };
}

}
