// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/RealMeshes.h"

#include "Support/Folders.h"
#include "Support/TestAmount.h"

#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkSTLReader.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace skdtest
{

namespace
{
constexpr std::uintmax_t LargestOfFewerTests = 50 * 1024; // bytes

bool HasAppendedArrays(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  const std::string text{ std::istreambuf_iterator<char>(stream), {} };
  return text.find("<AppendedData") != std::string::npos;
}

/// The file, or what Plugin/inline_xml.py makes of it if VTK may be unable to read it.
std::string ReadableVersion(const std::string& file)
{
  if (!HasAppendedArrays(file))
  {
    return file;
  }
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(TemporaryFolder()) / "Inline";
  fs::create_directories(folder);
  const std::string made =
    (folder / (std::to_string(std::hash<std::string>()(file)) + fs::path(file).filename().string()))
      .string();
  const std::string command =
    "python3 '" + SourceFolder() + "/Plugin/inline_xml.py' '" + file + "' '" + made + "'";
  const bool isThere = fs::exists(made) && fs::last_write_time(made) > fs::last_write_time(file);
  return isThere || std::system(command.c_str()) == 0 ? made : file;
}

template <typename Reader>
DataSetPointer ReadWith(const std::string& file)
{
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return vtkDataSet::SafeDownCast(reader->GetOutputDataObject(0));
}
}

DataSetPointer ReadMesh(const std::string& name)
{
  const std::string extension = std::filesystem::path(name).extension().string();
  const std::string file = extension.rfind(".vt", 0) == 0 ? ReadableVersion(name) : name;
  return extension == ".vtp" ? ReadWith<vtkXMLPolyDataReader>(file)
    : extension == ".vtu"    ? ReadWith<vtkXMLUnstructuredGridReader>(file)
    : extension == ".vti"    ? ReadWith<vtkXMLImageDataReader>(file)
    : extension == ".stl"    ? ReadWith<vtkSTLReader>(file)
    : extension == ".ply"    ? ReadWith<vtkPLYReader>(file)
    : extension == ".obj"    ? ReadWith<vtkOBJReader>(file)
                             : DataSetPointer();
}

std::vector<std::string> FilesOf(const std::string& folder, const std::vector<std::string>& known)
{
  std::vector<std::string> files;
  std::error_code error;
  for (std::filesystem::recursive_directory_iterator at(folder, error), end; at != end && !error;
       at.increment(error))
  {
    const std::string extension = at->path().extension().string();
    const bool isTooLarge = FewerTests() && at->file_size(error) > LargestOfFewerTests;
    if (std::find(known.begin(), known.end(), extension) != known.end() && !isTooLarge)
    {
      files.push_back(at->path().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files.empty() ? std::vector<std::string>{ "" } : files;
}

std::vector<std::string> SurfaceFiles(const std::string& folder)
{
  return FilesOf(folder, { ".vtp", ".stl", ".ply", ".obj" });
}

std::vector<std::string> VolumeFiles(const std::string& folder)
{
  return FilesOf(folder, { ".vtu" });
}

std::vector<std::string> MeshFiles(const std::string& folder)
{
  return FilesOf(folder, { ".vtp", ".stl", ".ply", ".obj", ".vtu", ".vti" });
}

bool IsLoose(vtkCell* cell)
{
  return cell->GetCellType() == VTK_POLYGON || cell->GetCellType() == VTK_POLYHEDRON;
}

double Flatness(vtkCell* cell)
{
  return IsLoose(cell) ? 0.05 * std::sqrt(cell->GetLength2()) : 0.0;
}

double DistanceToRealCell(vtkCell* cell, const Point& x)
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

NearerCell FindNearerCell(vtkDataSet* data, const std::vector<Point>& queries,
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

Mesh SurfaceOf(vtkDataSet* data)
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

bool IsClosed(const Mesh& mesh)
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
