// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RealMeshes.h
 * @brief finds and reads mesh files, and compares results with a look at all their cells
 */
#ifndef skdtest_RealMeshes_h
#define skdtest_RealMeshes_h

#include "Support/CellShape.h"

#include "vtkGenericCell.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace skdtest
{

/// nullptr for a file that is no mesh.
DataSetPointer ReadMesh(const std::string& file);

/// All files of these kinds below a folder, sorted; one empty name if there is none.
std::vector<std::string> FilesOf(const std::string& folder, const std::vector<std::string>& known);

std::vector<std::string> SurfaceFiles(const std::string& folder);

std::vector<std::string> VolumeFiles(const std::string& folder);

std::vector<std::string> MeshFiles(const std::string& folder);

/// For INSTANTIATE_TEST_SUITE_P over files: their names without folders, as letters and digits.
struct NameOfFile
{
  template <typename Info>
  std::string operator()(const Info& info) const
  {
    std::string name = info.param.empty() ? "None" : info.param.substr(info.param.rfind('/') + 1);
    std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
    return name;
  }
};

/// Cells whose shape is not sure: polygons and polyhedra's faces need not be planar or convex.
bool IsLoose(vtkCell* cell);

/// By how much references may differ on what the cell is.
double Flatness(vtkCell* cell);

/// The distance by the cell's faces, 0 in a volume.
double DistanceToRealCell(vtkCell* cell, const Point& x);

struct NearerCell
{
  int Query = -1;
  vtkIdType Cell = -1;
  double Distance = 0.0;
};

/// A cell that is nearer to a query than is claimed, if there is one.
NearerCell FindNearerCell(vtkDataSet* data, const std::vector<Point>& queries,
  const std::vector<double>& claimed, double slack);

/// The triangles and quads of polydata, points of equal coordinates made one; empty if it has
/// others.
Mesh SurfaceOf(vtkDataSet* data);

/// Each edge has exactly two cells.
bool IsClosed(const Mesh& mesh);

}

#endif
