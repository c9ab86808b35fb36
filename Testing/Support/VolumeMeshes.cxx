// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/VolumeMeshes.h"

#include "vtkDelaunay3D.h"

namespace skdtest
{

Point Bent(const Point& p)
{
  return { p[0] + 0.15 * std::sin(p[1] + 0.7 * p[2]), p[1] + 0.15 * std::sin(p[2] - 0.4 * p[0]),
    p[2] + 0.15 * std::sin(p[0] + p[1]) };
}

Point Rotated(const Point& p)
{
  const Point x = (1.0 / 3.0) * Point{ 2, -1, 2 };
  const Point y = (1.0 / 3.0) * Point{ 2, 2, -1 };
  const Point z = (1.0 / 3.0) * Point{ -1, 2, 2 };
  return p[0] * x + p[1] * y + p[2] * z;
}

Mesh Hexahedra(int n)
{
  const Lattice lattice(n);
  Mesh mesh;
  mesh.Points = lattice.Points();
  for (int cell = 0; cell < lattice.NumberOfCubes(); ++cell)
  {
    mesh.Add(VTK_HEXAHEDRON, lattice.Cube(cell));
  }
  return mesh;
}

Mesh InvertedHexahedra(int n)
{
  Mesh mesh = Hexahedra(n);
  for (CellSpec& cell : mesh.Cells)
  {
    std::rotate(cell.Points.begin(), cell.Points.begin() + 4, cell.Points.end());
  }
  return mesh;
}

Mesh Voxels(int n)
{
  Mesh mesh = Hexahedra(n);
  for (CellSpec& cell : mesh.Cells)
  {
    cell.Type = VTK_VOXEL;
    std::swap(cell.Points[2], cell.Points[3]);
    std::swap(cell.Points[6], cell.Points[7]);
  }
  return mesh;
}

Mesh Tetrahedra(int n)
{
  const int paths[6][2] = { { 1, 2 }, { 2, 3 }, { 3, 7 }, { 7, 4 }, { 4, 5 }, { 5, 1 } };
  const Lattice lattice(n);
  Mesh mesh;
  mesh.Points = lattice.Points();
  for (int cell = 0; cell < lattice.NumberOfCubes(); ++cell)
  {
    const Ids c = lattice.Cube(cell);
    for (const auto& path : paths)
    {
      mesh.Add(VTK_TETRA, { c[0], c[path[0]], c[path[1]], c[6] });
    }
  }
  return mesh;
}

Mesh Wedges(int n)
{
  const Lattice lattice(n);
  Mesh mesh;
  mesh.Points = lattice.Points();
  for (int cell = 0; cell < lattice.NumberOfCubes(); ++cell)
  {
    const Ids c = lattice.Cube(cell);
    mesh.Add(VTK_WEDGE, { c[0], c[1], c[2], c[4], c[5], c[6] });
    mesh.Add(VTK_WEDGE, { c[0], c[2], c[3], c[4], c[6], c[7] });
  }
  return mesh;
}

Mesh Pyramids(int n)
{
  const int bases[6][4] = { { 0, 1, 2, 3 }, { 7, 6, 5, 4 }, { 0, 4, 5, 1 }, { 1, 5, 6, 2 },
    { 2, 6, 7, 3 }, { 3, 7, 4, 0 } };
  const Lattice lattice(n);
  Mesh mesh;
  mesh.Points = lattice.Points();
  for (int cell = 0; cell < lattice.NumberOfCubes(); ++cell)
  {
    const Ids c = lattice.Cube(cell);
    const vtkIdType apex = mesh.Add(0.5 * (mesh.Points[c[0]] + mesh.Points[c[6]]));
    for (const auto& b : bases)
    {
      mesh.Add(VTK_PYRAMID, { c[b[0]], c[b[1]], c[b[2]], c[b[3]], apex });
    }
  }
  return mesh;
}

Ids PolyhedronOf(const Ids& c)
{
  return { 6, 4, c[0], c[3], c[2], c[1], 4, c[4], c[5], c[6], c[7], 4, c[0], c[1], c[5], c[4], 4,
    c[1], c[2], c[6], c[5], 4, c[2], c[3], c[7], c[6], 4, c[3], c[0], c[4], c[7] };
}

Mesh Polyhedra(int n)
{
  Mesh mesh = Hexahedra(n);
  for (CellSpec& cell : mesh.Cells)
  {
    cell = { VTK_POLYHEDRON, PolyhedronOf(cell.Points) };
  }
  return mesh;
}

Mesh MixedCells(int n)
{
  const Mesh kinds[5] = { Hexahedra(n), Tetrahedra(n), Wedges(n), Pyramids(n), Polyhedra(n) };
  Mesh mesh;
  mesh.Points = kinds[3].Points; // the lattice, then the centres of the pyramids
  for (int cube = 0; cube < n * n * n; ++cube)
  {
    const Mesh& kind = kinds[cube % 5];
    const int each = static_cast<int>(kind.Cells.size()) / (n * n * n);
    for (int i = 0; i < each; ++i)
    {
      mesh.Cells.push_back(kind.Cells[cube * each + i]);
    }
  }
  for (vtkIdType i = 0; i < n; ++i)
  {
    const vtkIdType a = mesh.Add(Point{ double(i), 0, n + 1.0 });
    const vtkIdType b = mesh.Add(Point{ i + 0.5, 1, n + 1.5 });
    const vtkIdType c = mesh.Add(Point{ double(i), 2, n + 1.0 });
    mesh.Add(VTK_TRIANGLE, { a, b, c });
    mesh.Add(VTK_LINE, { a, c });
    mesh.Add(VTK_VERTEX, { b });
  }
  return mesh;
}

DataSetPointer DelaunayTetrahedra(int numberOfPoints)
{
  Random random(5);
  std::vector<Point> points;
  for (int i = 0; i < numberOfPoints; ++i)
  {
    points.push_back(random.InBox({ 0, 1, 0, 1, 0, 1 }));
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(MakePoints(points));
  vtkNew<vtkDelaunay3D> delaunay;
  delaunay->SetInputData(cloud);
  delaunay->Update();
  return delaunay->GetOutput();
}

}
