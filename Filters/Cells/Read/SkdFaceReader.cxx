// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Read/SkdFaceReader.h"

#include "Core/Geometry/Polygons/ConvexHull.h"

#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace skdtree
{
namespace
{
// VTK's cell is not used: it would triangulate itself for nothing.
void ReadHull(vtkDataSet* data, vtkIdType cellId, vtkIdList* faces)
{
  data->GetCellPoints(cellId, faces);
  const std::vector<vtkIdType> ids(faces->begin(), faces->end());
  std::vector<skd::Vector3> points(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    data->GetPoint(ids[i], points[i].X);
  }
  const std::vector<std::uint32_t> stream = SkdFacesOfHull(points.data(), points.size());
  faces->Reset();
  faces->InsertNextId(0);
  for (std::size_t at = 0; at < stream.size();)
  {
    const std::uint32_t size = stream[at++];
    faces->SetId(0, faces->GetId(0) + 1);
    faces->InsertNextId(size);
    for (const std::size_t end = at + size; at < end; ++at)
    {
      faces->InsertNextId(ids[stream[at]]);
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> SkdFacesOfHull(const skd::Vector3* points, std::size_t size)
{
  const skd::ConvexHull hull = skd::ConvexHullOf(points, size);
  std::vector<std::uint32_t> stream;
  for (const auto& triangle : hull.Triangles)
  {
    stream.insert(stream.end(), { 3, triangle[0], triangle[1], triangle[2] });
  }
  const auto& outline = hull.Outline;
  if (hull.Dimension == 2)
  {
    stream.push_back(static_cast<std::uint32_t>(outline.size()));
    stream.insert(stream.end(), outline.begin(), outline.end());
    stream.push_back(static_cast<std::uint32_t>(outline.size()));
    stream.insert(stream.end(), outline.rbegin(), outline.rend());
  }
  else if (hull.Dimension == 1)
  {
    stream = { 3, outline.front(), outline.back(), outline.back() };
  }
  return stream;
}

//------------------------------------------------------------------------------
void SkdReadFaces(vtkDataSet* data, vtkIdType cellId, vtkGenericCell* cell, vtkIdList* faces)
{
  if (data->GetCellType(cellId) == VTK_CONVEX_POINT_SET)
  {
    ReadHull(data, cellId, faces);
    return;
  }
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    grid->GetFaceStream(cellId, faces);
    return;
  }
  data->GetCell(cellId, cell);
  faces->Reset();
  faces->InsertNextId(cell->GetNumberOfFaces());
  for (int i = 0; i < cell->GetNumberOfFaces(); ++i)
  {
    vtkIdList* ids = cell->GetFace(i)->GetPointIds();
    faces->InsertNextId(ids->GetNumberOfIds());
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      faces->InsertNextId(ids->GetId(k));
    }
  }
}

//------------------------------------------------------------------------------
std::vector<std::uint32_t> SkdFaceReader::Read(vtkIdList* faces, const std::uint32_t* pointIds,
  std::uint32_t numberOfPoints, const skd::PointArray& points)
{
  this->Stream.clear();
  this->Starts.clear();
  if (!this->Number(faces, pointIds, numberOfPoints))
  {
    return {};
  }
  this->OrientAlike();
  this->Rotate(pointIds, points);
  return this->Stream;
}

//------------------------------------------------------------------------------
bool SkdFaceReader::Number(
  vtkIdList* faces, const std::uint32_t* pointIds, std::uint32_t numberOfPoints)
{
  this->Numbers.clear();
  for (std::uint32_t i = 0; i < numberOfPoints; ++i)
  {
    this->Numbers.emplace_back(static_cast<vtkIdType>(pointIds[i]), i);
  }
  std::sort(this->Numbers.begin(), this->Numbers.end());
  const vtkIdType* at = faces->GetPointer(0);
  const vtkIdType* const end = at + faces->GetNumberOfIds();
  for (vtkIdType face = at < end ? *at++ : 0; face > 0; --face)
  {
    if (at >= end || *at < 1 || *at > end - at - 1)
    {
      return false;
    }
    this->Starts.push_back(static_cast<std::uint32_t>(this->Stream.size()));
    this->Stream.push_back(static_cast<std::uint32_t>(*at));
    for (const vtkIdType* const faceEnd = at + 1 + *at; ++at < faceEnd;)
    {
      const auto found = std::lower_bound(
        this->Numbers.begin(), this->Numbers.end(), std::make_pair(*at, std::uint32_t(0)));
      if (found == this->Numbers.end() || found->first != *at)
      {
        return false;
      }
      this->Stream.push_back(found->second);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// Two faces that share an edge are oriented alike if they walk along it in opposite directions. An
// edge of one face, or of more than two, decides nothing.
void SkdFaceReader::OrientAlike()
{
  this->Parents.resize(this->Starts.size());
  std::iota(this->Parents.begin(), this->Parents.end(), 0u);
  this->Reversals.assign(this->Starts.size(), 0);
  this->CollectEdges();
  const auto isSame = [this](std::size_t i, std::size_t k)
  {
    return k < this->Edges.size() && this->Edges[i].Low == this->Edges[k].Low &&
      this->Edges[i].High == this->Edges[k].High;
  };
  for (std::size_t i = 0; i < this->Edges.size();)
  {
    std::size_t last = i + 1;
    while (isSame(i, last))
    {
      ++last;
    }
    if (last - i == 2)
    {
      this->Join(this->Edges[i], this->Edges[i + 1]);
    }
    i = last;
  }
  for (std::uint32_t face = 0; face < this->Starts.size(); ++face)
  {
    this->RootOf(face);
    if (this->Reversals[face])
    {
      std::uint32_t* size = this->Stream.data() + this->Starts[face];
      std::reverse(size + 1, size + 1 + *size);
    }
  }
}

//------------------------------------------------------------------------------
void SkdFaceReader::CollectEdges()
{
  this->Edges.clear();
  for (std::uint32_t face = 0; face < this->Starts.size(); ++face)
  {
    const std::uint32_t* ids = this->Stream.data() + this->Starts[face] + 1;
    const std::uint32_t size = ids[-1];
    for (std::uint32_t i = 0; i < size; ++i)
    {
      const std::uint32_t a = ids[i];
      const std::uint32_t b = ids[i + 1 == size ? 0 : i + 1];
      this->Edges.push_back({ std::min(a, b), std::max(a, b), face, b < a });
    }
  }
  std::sort(this->Edges.begin(), this->Edges.end(),
    [](const Edge& a, const Edge& b)
    { return std::tie(a.Low, a.High, a.Face) < std::tie(b.Low, b.High, b.Face); });
}

//------------------------------------------------------------------------------
// The face that stands for all that are joined; the face is made its child, its orientation known.
std::uint32_t SkdFaceReader::RootOf(std::uint32_t face)
{
  std::uint32_t root = face;
  char orientation = 0;
  while (this->Parents[root] != root)
  {
    orientation ^= this->Reversals[root];
    root = this->Parents[root];
  }
  if (root != face)
  {
    this->Parents[face] = root;
    this->Reversals[face] = orientation;
  }
  return root;
}

//------------------------------------------------------------------------------
void SkdFaceReader::Join(const Edge& one, const Edge& other)
{
  const std::uint32_t rootOne = this->RootOf(one.Face);
  const std::uint32_t rootOther = this->RootOf(other.Face);
  if (rootOne != rootOther)
  {
    const char against = one.IsReversed == other.IsReversed ? 1 : 0;
    this->Parents[rootOther] = rootOne;
    this->Reversals[rootOther] =
      static_cast<char>(against ^ this->Reversals[one.Face] ^ this->Reversals[other.Face]);
  }
}

//------------------------------------------------------------------------------
// The cell on the other side of a face, whatever ids it has, so starts at the same point.
void SkdFaceReader::Rotate(const std::uint32_t* pointIds, const skd::PointArray& points)
{
  const auto isBefore = [&](std::uint32_t a, std::uint32_t b)
  { return points.At(pointIds[a]) < points.At(pointIds[b]); };
  for (const std::uint32_t start : this->Starts)
  {
    std::uint32_t* ids = this->Stream.data() + start + 1;
    std::uint32_t* end = ids + ids[-1];
    std::rotate(ids, std::min_element(ids, end, isBefore), end);
  }
}
}
