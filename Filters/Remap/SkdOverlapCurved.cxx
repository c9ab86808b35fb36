// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdOverlapReader.h"

#include "Cells/Curved/SkdCurvedSimplices.h"
#include "Cells/Kernels/SkdParametricCell.h"
#include "Cells/Read/SkdCountedPoints.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkIdList.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace skdtree
{
namespace
{
using skd::Vector3;
using Faces = std::vector<std::vector<int>>;
using Edge = std::pair<int, int>;

Edge EdgeOf(const std::vector<int>& face, std::size_t k)
{
  return { face[k], face[(k + 1) % face.size()] };
}

bool HasEdge(const std::vector<int>& face, const Edge& edge)
{
  for (std::size_t k = 0; k < face.size(); ++k)
  {
    if (EdgeOf(face, k) == edge)
    {
      return true;
    }
  }
  return false;
}

/// Turns the faces of a cell so that neighbours go along their edge in opposite directions.
void OrientAlike(Faces& faces)
{
  std::map<Edge, std::vector<std::size_t>> users;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    for (std::size_t k = 0; k < faces[i].size(); ++k)
    {
      const Edge edge = EdgeOf(faces[i], k);
      users[std::minmax(edge.first, edge.second)].push_back(i);
    }
  }
  std::vector<bool> isDone(faces.size());
  std::vector<std::size_t> open;
  const auto orientNeighbour = [&](std::size_t other, const Edge& edge)
  {
    if (!isDone[other] && HasEdge(faces[other], edge))
    {
      std::swap(faces[other][0], faces[other][1]);
      std::reverse(faces[other].begin() + 2, faces[other].end());
    }
    if (!isDone[other])
    {
      isDone[other] = true;
      open.push_back(other);
    }
  };
  for (std::size_t first = 0; first < faces.size(); ++first)
  {
    open.push_back(first);
    isDone[first] = true;
    while (!open.empty())
    {
      const std::size_t at = open.back();
      open.pop_back();
      for (std::size_t k = 0; k < faces[at].size(); ++k)
      {
        const Edge edge = EdgeOf(faces[at], k);
        for (const std::size_t other : users[std::minmax(edge.first, edge.second)])
        {
          orientNeighbour(other, edge);
        }
      }
    }
  }
}

/// The faces of a cell by the numbers of its points, all outward or all inward.
Faces FacesOf(vtkCell* cell)
{
  const SkdCountedPoints counted(cell);
  Faces faces;
  for (int i = 0; i < cell->GetNumberOfFaces(); ++i)
  {
    vtkIdList* ids = cell->GetFace(i)->GetPointIds();
    faces.emplace_back(ids->begin(), ids->end());
  }
  OrientAlike(faces);
  return faces;
}

int DimensionOf(SkdOverlapSpace space)
{
  return space == SkdOverlapSpace::Volume ? 3 : (space == SkdOverlapSpace::Line ? 1 : 2);
}

/// Length or area, of what has a dimension of 1 or 2.
double SizeOf(const Vector3& a, const Vector3& b, const Vector3& c, int dimension)
{
  return dimension == 1 ? Norm(b - a) : 0.5 * Norm(Cross(b - a, c - a));
}

/// A cell of which less than this share of its parts is left, the others being inverted,
/// has no mean of its functions to speak of.
constexpr double LeastWhole = 0.1;
}

//------------------------------------------------------------------------------
void SkdOverlapReader::ReadGeneric(std::uint32_t cell)
{
  vtkCell* loaded = this->Source.Load(this->Tree.Cells().IdOf(cell));
  if (loaded->GetCellDimension() != DimensionOf(this->Surface.GetSpace()))
  {
    return;
  }
  if (SkdParametricCell::DomainOf(loaded->GetCellType()))
  {
    this->AddCurved(cell, loaded);
  }
  else if (loaded->GetCellType() == VTK_QUADRATIC_POLYGON)
  {
    this->AddQuadraticPolygon();
  }
  else
  {
    this->AddPrism(cell, loaded);
  }
}

//------------------------------------------------------------------------------
// Straight between its points: corners, then the middles of edges.
void SkdOverlapReader::AddQuadraticPolygon()
{
  const Corners points = this->CellPoints;
  const std::size_t half = points.size() / 2;
  for (std::size_t i = 0; i < 2 * half; ++i)
  {
    this->CellPoints[i] = points[i / 2 + (i % 2 == 0 ? 0 : half)];
  }
  this->AddPolygon(this->CellPoints);
}

//------------------------------------------------------------------------------
// Pentagonal and hexagonal ones. Flat sides are cut as VTK cuts them.
void SkdOverlapReader::AddPrism(std::uint32_t cell, vtkCell* loaded)
{
  Faces faces = FacesOf(loaded);
  if (!this->Reading.IntoSimplices && this->AreFlat(faces))
  {
    this->Tree.GetSimplices(cell, this->Source, this->Simplices);
    this->CellPoints.clear();
    faces.clear();
    for (const Vector3& x : this->Simplices.Points)
    {
      this->CellPoints.push_back({ x, -1 });
    }
    for (const auto& simplex : this->Simplices.Simplices)
    {
      faces.push_back({ simplex[0], simplex[1], simplex[2] });
    }
    OrientAlike(faces);
  }
  this->AddHull(std::move(faces));
}

//------------------------------------------------------------------------------
void SkdOverlapReader::AddCurved(std::uint32_t cell, vtkCell* loaded)
{
  if (this->Reading.IntoSimplices)
  {
    this->TakeOwnPoints();
    this->Functions.Load(this->Source.Data, this->Tree.Cells().IdOf(cell));
  }
  if (this->Surface.GetSpace() == SkdOverlapSpace::Volume)
  {
    this->AddCurvedSolid(loaded);
    return;
  }
  std::vector<Vector3> parameters;
  SkdReadCurved(this->Simplices, loaded, this->Tree.Cells().BoundsOf(cell), &parameters);
  this->CellPoints.clear();
  for (const Vector3& x : this->Simplices.Points)
  {
    this->CellPoints.push_back({ this->Surface.Project(x), -1 });
  }
  if (this->Reading.IntoSimplices)
  {
    this->WeighCorners(loaded->GetCellType(), parameters);
  }
  this->AddSimplices();
}

//------------------------------------------------------------------------------
void SkdOverlapReader::AddCurvedSolid(vtkCell* loaded)
{
  const bool isOfPoints = this->Reading.IntoSimplices;
  this->Sides.Read(loaded);
  if (!isOfPoints && this->Sides.AreStraight())
  {
    const SkdShape shape = SkdCurvedSides::ShapeOf(loaded->GetCellType());
    this->CellPoints.resize(static_cast<std::size_t>(SkdNumberOfPoints(shape)));
    this->AddFixed(shape);
    return;
  }
  this->Sides.Cut(isOfPoints);
  Corners corners;
  for (const SkdCurvedSides::Point& point : this->Sides.GetPoints())
  {
    corners.push_back({ point.X, -1 });
  }
  Corner middle{ this->Sides.GetMiddle().X, -1 };
  double volume = 0.0;
  for (const auto& triangle : this->Sides.GetTriangles())
  {
    const Vector3 a = corners[triangle[0]].X - middle.X;
    volume += Dot(a, Cross(corners[triangle[1]].X - middle.X, corners[triangle[2]].X - middle.X));
  }
  if (isOfPoints)
  {
    this->WeighSides(corners);
    middle.Id = this->WeighMiddle(corners);
  }
  for (const auto& triangle : this->Sides.GetTriangles())
  {
    const int b = volume < 0.0 ? 2 : 1;
    this->AddSigned(middle, corners[triangle[0]], corners[triangle[b]], corners[triangle[3 - b]]);
  }
}

//------------------------------------------------------------------------------
const double* SkdOverlapReader::WeightsAt(const Vector3& pcoords, const Vector3& x)
{
  this->Functions.EvaluateFrom(pcoords.X, x.X);
  return this->Functions.GetWeights();
}

const double* SkdOverlapReader::WeightsOf(const Corner& corner) const
{
  return this->Block.Weights.data() + (-1 - corner.Id);
}

//------------------------------------------------------------------------------
// Those of the cell's own functions. In simplices whose corners are on the curve or surface a field
// that is bent would lose what it departs from straight ones: the mean of that is given back. It is
// found at the middle of each simplex, for (d + 1) / (d + 2) of what a quadratic field is there
// more than the mean of its corners is the mean over a simplex of d dimensions.
void SkdOverlapReader::WeighCorners(int cellType, const std::vector<Vector3>& parameters)
{
  const skd::SimplexSet& set = this->Simplices;
  const std::size_t first = this->Block.Weights.size();
  for (std::size_t i = 0; i < set.Points.size(); ++i)
  {
    this->CellPoints[i].Id = this->AddWeights(
      this->WeightsAt(SkdParametricCell::ToVTK(cellType, parameters[i]), set.Points[i]));
  }
  const int corners = set.Dimension + 1;
  std::vector<double> missing(this->NumberOfOwnPoints(), 0.0);
  double whole = 0.0;
  for (const auto& simplex : set.Simplices)
  {
    const double size =
      SizeOf(set.Points[simplex[0]], set.Points[simplex[1]], set.Points[simplex[2]], set.Dimension);
    Vector3 x{}, p{};
    for (int k = 0; k < corners; ++k)
    {
      x = x + (1.0 / corners) * set.Points[simplex[k]];
      p = p + (1.0 / corners) * parameters[simplex[k]];
    }
    const double* weights = this->WeightsAt(SkdParametricCell::ToVTK(cellType, p), x);
    for (std::size_t i = 0; i < missing.size(); ++i)
    {
      double mean = 0.0;
      for (int k = 0; k < corners; ++k)
      {
        mean += this->WeightsOf(this->CellPoints[simplex[k]])[i] / corners;
      }
      missing[i] += size * (weights[i] - mean);
    }
    whole += size;
  }
  const double factor = whole > 0.0 ? corners / (corners + 1.0) / whole : 0.0;
  for (std::size_t i = 0; first + i < this->Block.Weights.size(); ++i)
  {
    this->Block.Weights[first + i] += factor * missing[i % missing.size()];
  }
}

//------------------------------------------------------------------------------
void SkdOverlapReader::WeighSides(Corners& corners)
{
  const std::vector<SkdCurvedSides::Point>& points = this->Sides.GetPoints();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    corners[i].Id =
      this->AddWeights(this->WeightsAt(this->Sides.ToVTK(points[i].Reference), points[i].X));
  }
}

// As WeighCorners, but all that is missing is given to the one corner within the cell, which has a
// quarter of the cell's volume.
vtkIdType SkdOverlapReader::WeighMiddle(const Corners& corners)
{
  const SkdCurvedSides::Point& middle = this->Sides.GetMiddle();
  const std::vector<SkdCurvedSides::Point>& points = this->Sides.GetPoints();
  const double* own = this->WeightsAt(this->Sides.ToVTK(middle.Reference), middle.X);
  std::vector<double> weights(own, own + this->NumberOfOwnPoints());
  std::vector<double> missing(weights.size(), 0.0);
  double whole = 0.0;
  double parts = 0.0;
  for (const auto& t : this->Sides.GetTriangles())
  {
    const auto &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    const double volume = Dot(a.X - middle.X, Cross(b.X - middle.X, c.X - middle.X));
    const Vector3 x = 0.25 * (middle.X + (a.X + (b.X + c.X)));
    const Vector3 p = 0.25 * (middle.Reference + (a.Reference + (b.Reference + c.Reference)));
    const double* there = this->WeightsAt(this->Sides.ToVTK(p), x);
    const double* of[3] = { this->WeightsOf(corners[t[0]]), this->WeightsOf(corners[t[1]]),
      this->WeightsOf(corners[t[2]]) };
    for (std::size_t i = 0; i < missing.size(); ++i)
    {
      const double mean = 0.25 * (weights[i] + (of[0][i] + (of[1][i] + of[2][i])));
      missing[i] += volume * (there[i] - mean);
    }
    whole += volume;
    parts += std::abs(volume);
  }
  const double factor = std::abs(whole) > LeastWhole * parts ? 4.0 * 0.8 / whole : 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    weights[i] += factor * missing[i];
  }
  return this->AddWeights(weights.data());
}
}
