// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RealMeshes.h
 * @brief finds and reads mesh files, and compares answers with a look at all their cells
 */
#ifndef skdtest_RealMeshes_h
#define skdtest_RealMeshes_h

#include "Support/CellShape.h"

#include "vtkGenericCell.h"
#include "vtkImageData.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkSTLReader.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <filesystem>
#include <string>

namespace skdtest
{

template <typename Reader>
DataSetPointer ReadWith(const std::string& file)
{
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
}

/// nullptr for a file that is no mesh.
inline DataSetPointer ReadMesh(const std::string& file)
{
  const std::string extension = std::filesystem::path(file).extension().string();
  return extension == ".vtp" ? ReadWith<vtkXMLPolyDataReader>(file)
    : extension == ".vtu"    ? ReadWith<vtkXMLUnstructuredGridReader>(file)
    : extension == ".vti"    ? ReadWith<vtkXMLImageDataReader>(file)
    : extension == ".stl"    ? ReadWith<vtkSTLReader>(file)
    : extension == ".ply"    ? ReadWith<vtkPLYReader>(file)
    : extension == ".obj"    ? ReadWith<vtkOBJReader>(file)
                             : DataSetPointer();
}

/// All files of these kinds below a folder, sorted; one empty name if there is none.
inline std::vector<std::string> FilesOf(
  const std::string& folder, const std::vector<std::string>& known)
{
  std::vector<std::string> files;
  std::error_code error;
  for (std::filesystem::recursive_directory_iterator at(folder, error), end; at != end && !error;
       at.increment(error))
  {
    const std::string extension = at->path().extension().string();
    if (std::find(known.begin(), known.end(), extension) != known.end())
    {
      files.push_back(at->path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files.empty() ? std::vector<std::string>{ "" } : files;
}

inline std::vector<std::string> SurfaceFiles(const std::string& folder)
{
  return FilesOf(folder, { ".vtp", ".stl", ".ply", ".obj" });
}

inline std::vector<std::string> VolumeFiles(const std::string& folder)
{
  return FilesOf(folder, { ".vtu" });
}

inline std::vector<std::string> MeshFiles(const std::string& folder)
{
  return FilesOf(folder, { ".vtp", ".stl", ".ply", ".obj", ".vtu", ".vti" });
}

/// Cells whose shape is not sure: polygons and polyhedra's faces need not be planar or convex.
inline bool IsLoose(vtkCell* cell)
{
  return cell->GetCellType() == VTK_POLYGON || cell->GetCellType() == VTK_POLYHEDRON;
}

/// By how much references may differ on what the cell is.
inline double Flatness(vtkCell* cell)
{
  return IsLoose(cell) ? 0.05 * std::sqrt(cell->GetLength2()) : 0.0;
}

/// The distance by the cell's faces, 0 in a volume.
inline double DistanceToRealCell(vtkCell* cell, const Point& x)
{
  const CellShape shape = MakeShape(cell);
  const double distance = BoundaryDistance(shape, x);
  Point closest, pcoords;
  double dist2 = 0.0;
  int subId = 0;
  std::vector<double> weights(cell->GetNumberOfPoints() + 1);
  const bool isInside = shape.IsSolid && Contains(shape.Box, x) &&
    cell->EvaluatePosition(
      x.data(), closest.data(), subId, pcoords.data(), dist2, weights.data()) == 1;
  return isInside ? 0.0 : distance;
}

struct NearerCell
{
  int Query = -1;
  vtkIdType Cell = -1;
  double Distance = 0.0;
};

/// A cell that is nearer to a query than is claimed, if there is one.
inline NearerCell FindNearerCell(vtkDataSet* data, const std::vector<Point>& queries,
  const std::vector<double>& claimed, double slack)
{
  vtkNew<vtkGenericCell> cell;
  Bounds box;
  for (vtkIdType id = 0; id < data->GetNumberOfCells(); ++id)
  {
    data->GetCellBounds(id, box.data());
    for (std::size_t i = 0; i < queries.size(); ++i)
    {
      if (Distance(box, queries[i]) >= claimed[i] - slack)
      {
        continue;
      }
      data->GetCell(id, cell);
      const CellShape shape = MakeShape(cell);
      const double distance = BoundaryDistance(shape, queries[i]); // at least the true one
      if (distance < claimed[i] - slack - Flatness(cell))
      {
        return { int(i), id, distance };
      }
    }
  }
  return {};
}

/// The triangles and quads of polydata, points of equal coordinates made one; empty if it has
/// others.
inline Mesh SurfaceOf(vtkDataSet* data)
{
  Mesh mesh;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoint(i, mesh.Points.emplace_back().data());
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    const int type = data->GetCellType(cell);
    if (type != VTK_TRIANGLE && type != VTK_QUAD)
    {
      return Mesh();
    }
    data->GetCellPoints(cell, ids);
    mesh.Add(type, Ids(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfIds()));
  }
  return Welded(mesh);
}

/// Each edge has exactly two cells.
inline bool IsClosed(const Mesh& mesh)
{
  std::vector<std::pair<vtkIdType, vtkIdType>> edges;
  for (const CellSpec& cell : mesh.Cells)
  {
    for (std::size_t i = 0; i < cell.Points.size(); ++i)
    {
      edges.push_back(std::minmax({ cell.Points[i], cell.Points[(i + 1) % cell.Points.size()] }));
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i + 1 < edges.size(); i += 2)
  {
    const bool isPair = edges[i] == edges[i + 1];
    const bool isMore = i + 2 < edges.size() && edges[i + 1] == edges[i + 2];
    if (!isPair || isMore)
    {
      return false;
    }
  }
  return !edges.empty() && edges.size() % 2 == 0;
}

}

#endif
