// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Rays/SkdRayStarts.h"

#include "Cells/Curved/SkdCurvedFaces.h"
#include "Cells/Read/SkdForEach.h"
#include "Cells/Read/SkdMagnitudes.h"
#include "Pipeline/SkdShownElements.h"
#include "Pipeline/SkdVolumeCells.h"
#include "Search/Rays/SkdCurvedFacePoints.h"
#include "Search/Rays/SkdSurfaceNormals.h"
#include "Search/Rays/SkdUnitVector.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace skdtree
{
namespace
{
using skd::Vector3;

vtkDataSetAttributes* DataOf(vtkDataSet* mesh, SkdQueryPoints::At at)
{
  return at == SkdQueryPoints::At::Points ? static_cast<vtkDataSetAttributes*>(mesh->GetPointData())
                                          : mesh->GetCellData();
}

bool AreVectors(vtkDataArray* array)
{
  return array && array->GetNumberOfComponents() == 3;
}
}

SkdRayStarts::SkdRayStarts(vtkDataSet* mesh, SkdQueryPoints::At at, const SkdRayAim& aim)
{
  this->ReadPoints(mesh, at);
  switch (aim.Mode)
  {
    case SkdRayAim::Along::Normals:
      this->UseNormals(mesh, at, aim);
      break;
    case SkdRayAim::Along::Array:
    case SkdRayAim::Along::ToPositions:
      this->UseArray(mesh, at, aim);
      break;
    case SkdRayAim::Along::Direction:
      this->Directions.assign(this->Points.size(), SkdUnit(aim.Vector));
      break;
    case SkdRayAim::Along::ToPoint:
      this->Face(std::vector<Vector3>(this->Points.size(), aim.Vector));
      break;
    case SkdRayAim::Along::ToNearest:
      this->FaceNearest(*aim.Source);
      break;
  }
  if (aim.IsReversed)
  {
    for (Vector3& direction : this->Directions)
    {
      direction = -1.0 * direction;
    }
  }
  SkdForEach(this->Directions.size(),
    [&](std::size_t i)
    { this->Directions[i] = this->Shown[i] != 0 ? this->Directions[i] : Vector3{}; });
}

vtkIdType SkdRayStarts::CountHidden() const
{
  return std::count(this->Shown.begin(), this->Shown.end(), 0);
}

vtkIdType SkdRayStarts::CountWithoutRay() const
{
  vtkIdType count = 0;
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    const bool hasRay = SkdHasDistances(this->Points[i]) && skd::Norm2(this->Directions[i]) > 0.0;
    count += hasRay || this->Shown[i] == 0 ? 0 : 1;
  }
  return count - this->Inner;
}

void SkdRayStarts::ReadPoints(vtkDataSet* mesh, SkdQueryPoints::At at)
{
  const SkdQueryPoints starts(mesh, at);
  this->Points.resize(static_cast<std::size_t>(starts.GetNumber()));
  this->Shown = SkdFindShown(
    mesh, at == SkdQueryPoints::At::Points ? vtkDataObject::POINT : vtkDataObject::CELL);
  SkdForEach(this->Points.size(),
    [&](std::size_t i) { starts.GetPoint(static_cast<vtkIdType>(i), this->Points[i].X); });
  if (at == SkdQueryPoints::At::Points)
  {
    SkdPutControlPointsOnFaces(mesh, this->Points);
  }
  else if (SkdHasCurvedCells(mesh))
  {
    SkdForEach(this->Points.size(),
      [&](std::size_t i)
      {
        const auto middle = SkdMiddleOfCurvedCell(mesh, static_cast<vtkIdType>(i));
        this->Points[i] = middle ? middle->Point : this->Points[i];
      });
  }
}

void SkdRayStarts::UseNormals(vtkDataSet* mesh, SkdQueryPoints::At at, const SkdRayAim& aim)
{
  vtkDataArray* given = DataOf(mesh, at)->GetNormals();
  if (AreVectors(given))
  {
    this->Read(given, "normals");
    return;
  }
  const bool atPoints = at == SkdQueryPoints::At::Points;
  const bool isPiece = atPoints && !aim.OfPiece.empty();
  this->Directions = isPiece ? aim.OfPiece
    : atPoints               ? SkdNormalsOfPoints(mesh)
                             : SkdNormalsOfCells(mesh);
  if (atPoints && SkdHasVolumeCells(mesh))
  {
    const vtkIdType without = this->CountWithoutRay();
    this->Inner = isPiece || without < this->GetNumber() ? without : 0;
  }
}

void SkdRayStarts::UseArray(vtkDataSet* mesh, SkdQueryPoints::At at, const SkdRayAim& aim)
{
  vtkDataSetAttributes* data = DataOf(mesh, at);
  const std::string& name = aim.Array;
  const bool arePositions = aim.Mode == SkdRayAim::Along::ToPositions;
  vtkDataArray* array =
    name.empty() && !arePositions ? data->GetVectors() : data->GetArray(name.c_str());
  const std::string kind = at == SkdQueryPoints::At::Points ? "point" : "cell";
  if (this->Points.empty())
  {
    return; // a piece without cells may lack any array
  }
  if (!AreVectors(array))
  {
    this->Directions.assign(this->Points.size(), Vector3{ { 0.0, 0.0, 0.0 } });
    this->Fault = name.empty()
      ? "Input has no active vectors in its " + kind + " data; set DirectionArray."
      : "Input has no " + kind + " array \"" + name + "\" of three components; set DirectionArray.";
    this->Fault = name.empty() && arePositions
      ? "Set DirectionArray to the " + kind + " array of the positions that rays go to."
      : this->Fault;
    return;
  }
  if (this->Read(array, kind + " array \"" + name + "\"") && arePositions)
  {
    std::vector<Vector3> targets(this->Points.size());
    SkdForEach(targets.size(),
      [&](std::size_t i) { array->GetTuple(static_cast<vtkIdType>(i), targets[i].X); });
    this->Face(targets);
  }
}

/// Of a point that is not finite, or a Source without cells, there is none.
void SkdRayStarts::FaceNearest(const SkdSourceTrees& source)
{
  std::vector<Vector3> targets(this->Points);
  SkdForEach(targets.size(),
    [&](std::size_t i)
    {
      const double maxDistance = std::numeric_limits<double>::infinity();
      if (const auto nearest = source.FindNearest(this->Points[i].X, maxDistance))
      {
        std::copy_n(nearest->Point, 3, targets[i].X);
      }
    });
  this->Face(targets);
}

void SkdRayStarts::Face(const std::vector<Vector3>& targets)
{
  this->Directions.resize(this->Points.size());
  SkdForEach(this->Directions.size(),
    [&](std::size_t i) { this->Directions[i] = SkdUnit(targets[i] - this->Points[i]); });
}

/// Returns whether there is a vector for each start; otherwise there is none, and a fault.
bool SkdRayStarts::Read(vtkDataArray* vectors, const std::string& what)
{
  this->Directions.assign(this->Points.size(), Vector3{ { 0.0, 0.0, 0.0 } });
  if (vectors->GetNumberOfTuples() != this->GetNumber())
  {
    this->Fault = "Input has " + std::to_string(vectors->GetNumberOfTuples()) + " vectors for " +
      std::to_string(this->GetNumber()) + " places in its " + what + "; there must be as many.";
    return false;
  }
  SkdForEach(this->Directions.size(),
    [&](std::size_t i)
    {
      Vector3 vector;
      vectors->GetTuple(static_cast<vtkIdType>(i), vector.X);
      this->Directions[i] = SkdUnit(vector);
    });
  return true;
}

std::vector<SkdRayStarts> SkdMakeRayStarts(
  const std::vector<SkdBlock>& blocks, SkdQueryPoints::At at, SkdRayAim aim)
{
  std::vector<std::vector<Vector3>> ofPieces(blocks.size());
  if (aim.Mode == SkdRayAim::Along::Normals && at == SkdQueryPoints::At::Points)
  {
    ofPieces = SkdNormalsOfPieces(blocks);
  }
  std::vector<SkdRayStarts> starts;
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    aim.OfPiece = std::move(ofPieces[i]);
    starts.emplace_back(blocks[i].Mesh, at, aim);
  }
  return starts;
}
}
