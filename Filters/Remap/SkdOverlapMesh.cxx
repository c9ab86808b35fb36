// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdOverlapMesh.h"

#include "Pipeline/SkdJoinedIds.h"
#include "Remap/SkdOverlapSearch.h"
#include "Remap/SkdPieceOverlap.h"
#include "Remap/SkdRemapTolerances.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <tuple>

namespace skdtree
{
namespace
{
using skd::Vector3;

struct Shape
{
  vtkIdType Target;
  vtkIdType Donor;
  double Measure;
  std::vector<Vector3> Points;
  std::vector<std::vector<int>> Faces; // of polyhedra
};

/// Keeps the shape of the last overlap.
class Shapes
{
public:
  Shapes(const SkdOverlapSurface& surface, Shape& shape)
    : Surface(surface)
    , TheShape(shape)
  {
  }

  void Take(const skd::Segment<3>& segment) const
  {
    this->Add(segment.A);
    this->Add(segment.B);
  }
  template <class Frame>
  void Take(const Frame& frame, const skd::ConvexPolygon& polygon) const
  {
    for (int i = 0; i < polygon.Size; ++i)
    {
      this->Add(frame.FromFrame(polygon.Corners[i]));
    }
  }
  void Take(const skd::LonLatCell& cell) const
  {
    for (int i = 0; i <= Steps; ++i)
    {
      this->Add(cell.At(cell.West + cell.Width() * i / Steps, cell.South));
    }
    for (int i = Steps; i >= 0; --i)
    {
      this->Add(cell.At(cell.West + cell.Width() * i / Steps, cell.North));
    }
  }
  /// A polygon of great circles, in steps, cut by meridians and then by parallels.
  void Take(const skd::SphericalFrame& frame, const skd::PolygonView& polygon,
    const skd::LonLatCell& cell) const
  {
    skd::ConvexPolygon part;
    skd::ClipToMeridians(frame, polygon, cell, part);
    std::vector<Vector3> outline;
    for (int i = 0; i < part.Size; ++i)
    {
      const skd::Vector<2>& next = part.Corners[i + 1 == part.Size ? 0 : i + 1];
      for (int k = 0; k < Steps; ++k)
      {
        outline.push_back(frame.FromFrame(Lerp(part.Corners[i], next, double(k) / Steps)));
      }
    }
    outline = Cut(outline, 1.0, std::sin(cell.South));
    for (const Vector3& x : Cut(outline, -1.0, -std::sin(cell.North)))
    {
      this->Add(x);
    }
  }
  void Take(const Vector3& origin, const skd::ConvexSolid& solid) const
  {
    for (int i = 0; i < solid.GetSize(); ++i)
    {
      this->Add(origin + solid.GetCorner(i));
    }
    solid.ForEachFace([this](const std::uint8_t* face, int size)
      { this->TheShape.Faces.emplace_back(face, face + size); });
  }

private:
  static constexpr int Steps = 8;

  void Add(const Vector3& x) const { this->TheShape.Points.push_back(this->Surface.Unproject(x)); }

  /// Where sign * z is at least `least`.
  static std::vector<Vector3> Cut(const std::vector<Vector3>& outline, double sign, double least)
  {
    std::vector<Vector3> corners;
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
      const Vector3& a = outline[i];
      const Vector3& b = outline[(i + 1) % outline.size()];
      const double atA = sign * a[2] - least;
      const double atB = sign * b[2] - least;
      if (atA >= 0.0)
      {
        corners.push_back(a);
      }
      if ((atA < 0.0 && atB > 0.0) || (atA > 0.0 && atB < 0.0))
      {
        corners.push_back(Lerp(a, b, atA / (atA - atB)));
      }
    }
    return corners;
  }

  const SkdOverlapSurface& Surface;
  Shape& TheShape;
};

void AddShape(const SkdOverlapSurface& surface, const SkdOverlapSettings& settings,
  const SkdPieceView& one, const SkdPieceView& other, Shape shape, std::vector<Shape>& found)
{
  const Shapes shapes(surface, shape);
  const Vector3* reference = nullptr;
  const double measure =
    SkdPieceOverlap<Shapes>(settings, shapes).Find(one, other, reference).Measure;
  const double smaller = std::min(one.Piece.Own.Measure, other.Piece.Own.Measure);
  if (measure > remap_tolerances::PieceOverlap * smaller)
  {
    shape.Measure = surface.Measure(measure) * one.Piece.Sign * other.Piece.Sign;
    found.push_back(std::move(shape));
  }
}

void AddCell(const Shape& shape, SkdOverlapSpace space, vtkPoints* points,
  vtkUnstructuredGrid* mesh, vtkIdList* ids)
{
  ids->Reset();
  const vtkIdType first = points->GetNumberOfPoints();
  for (const Vector3& x : shape.Points)
  {
    points->InsertNextPoint(x.X);
  }
  if (space != SkdOverlapSpace::Volume)
  {
    for (vtkIdType id = first; id < points->GetNumberOfPoints(); ++id)
    {
      ids->InsertNextId(id);
    }
    mesh->InsertNextCell(space == SkdOverlapSpace::Line ? VTK_LINE : VTK_POLYGON, ids);
    return;
  }
  ids->InsertNextId(static_cast<vtkIdType>(shape.Faces.size()));
  for (const std::vector<int>& face : shape.Faces)
  {
    ids->InsertNextId(static_cast<vtkIdType>(face.size()));
    for (const int corner : face)
    {
      ids->InsertNextId(first + corner);
    }
  }
  mesh->InsertNextCell(VTK_POLYHEDRON, ids);
}

vtkSmartPointer<vtkUnstructuredGrid> MakeMesh(
  const std::vector<Shape>& shapes, SkdOverlapSpace space, const SkdJoinedIds& joined)
{
  auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  mesh->SetPoints(points);
  mesh->Allocate(static_cast<vtkIdType>(shapes.size()));
  vtkNew<vtkIdTypeArray> targets;
  vtkNew<vtkIdTypeArray> donors;
  vtkNew<vtkDoubleArray> measures;
  targets->SetName("TargetCell");
  donors->SetName("DonorCell");
  measures->SetName("Measure");
  vtkNew<vtkIdList> ids;
  for (const Shape& shape : shapes)
  {
    AddCell(shape, space, points, mesh, ids);
    targets->InsertNextValue(shape.Target);
    donors->InsertNextValue(joined.Of(shape.Donor));
    measures->InsertNextValue(shape.Measure);
  }
  mesh->GetCellData()->AddArray(targets);
  mesh->GetCellData()->AddArray(donors);
  mesh->GetCellData()->AddArray(measures);
  return mesh;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnstructuredGrid> SkdMakeOverlapMesh(vtkDataSet* donor, vtkDataSet* target,
  const SkdOverlapSettings& settings, vtkAlgorithm* algorithm,
  const std::vector<unsigned char>& listed)
{
  const SkdOverlapSurface surface(donor, target, settings);
  SkdOverlapPair pair;
  if (!pair.Read(donor, target, surface, settings, false, algorithm, 0.0, 0.2))
  {
    return nullptr;
  }
  SkdLoop ofPairs(algorithm, 0, 0.2, 0.9, 8);
  std::vector<std::vector<Shape>> found;
  const auto visit = [&](std::size_t part, std::uint32_t a, std::uint32_t b)
  {
    SkdForEachPiecePair(pair.Target, a, pair.Donor, b,
      [&](const SkdPieceView& one, const SkdPieceView& other)
      {
        AddShape(surface, settings, one, other,
          { pair.Target.IdOf(a), pair.Donor.IdOf(b), 0.0, {}, {} }, found[part]);
      });
  };
  if (!SkdForEachCandidatePair(
        SkdOverlapTree(pair.Target), SkdOverlapTree(pair.Donor), ofPairs,
        [&](std::size_t parts) { found.resize(parts); }, visit))
  {
    return nullptr;
  }
  std::vector<Shape> all;
  for (std::vector<Shape>& part : found)
  {
    std::copy_if(std::make_move_iterator(part.begin()), std::make_move_iterator(part.end()),
      std::back_inserter(all),
      [&](const Shape& shape)
      { return listed.empty() || listed[static_cast<std::size_t>(shape.Target)] != 0; });
  }
  std::stable_sort(all.begin(), all.end(),
    [](const Shape& a, const Shape& b)
    { return std::tie(a.Target, a.Donor) < std::tie(b.Target, b.Donor); });
  return MakeMesh(all, settings.Space, SkdJoinedIds(donor));
}
}
