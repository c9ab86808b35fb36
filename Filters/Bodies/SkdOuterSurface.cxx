// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bodies/SkdOuterSurface.h"

#include "Cells/Curved/SkdBezierCell.h"
#include "Cells/Curved/SkdCurvedFaces.h"
#include "Cells/Read/SkdCellReader.h"
#include "Core/Curves/PatchFacets.h"
#include "Pipeline/SkdMakeArray.h"
#include "Pipeline/SkdMakeMesh.h"
#include "Pipeline/SkdShownElements.h"

#include "vtkAlgorithm.h"
#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkDoubleArray.h"
#include "vtkExplicitStructuredGrid.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace skdtree
{
namespace
{
/// The least chordal deviation, relative to the diagonal: what the properties accept.
constexpr double SmallestChordalDeviation = 1e-7;

constexpr const char* OriginalCells = "vtkOriginalCellIds";
constexpr const char* OriginalPoints = "vtkOriginalPointIds";

// VTK's surface of an explicit structured grid has uninitialized original cell ids.
vtkSmartPointer<vtkUnstructuredGrid> AsUnstructured(vtkExplicitStructuredGrid* explicitGrid)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(explicitGrid->GetPoints());
  grid->SetCells(VTK_HEXAHEDRON, explicitGrid->GetCells());
  grid->GetCellData()->AddArray(explicitGrid->GetCellGhostArray());
  return grid;
}

/// The mesh, but cells that are refined elsewhere (AMR) are hidden: VTK takes them for those of
/// another piece, behind whose faces the body goes on, so that it would be open there.
vtkSmartPointer<vtkDataSet> WithoutRefined(vtkDataSet* mesh)
{
  vtkUnsignedCharArray* ghosts = mesh->GetCellGhostArray();
  if (!ghosts || !ghosts->GetNumberOfValues())
  {
    return mesh;
  }
  const auto isRefined = [](unsigned char mark)
  { return (mark & vtkDataSetAttributes::REFINEDCELL) != 0; };
  vtkNew<vtkUnsignedCharArray> marks;
  marks->DeepCopy(ghosts);
  unsigned char* const begin = marks->GetPointer(0);
  unsigned char* const end = begin + marks->GetNumberOfValues();
  if (std::none_of(begin, end, isRefined))
  {
    return mesh;
  }
  std::replace_if(
    begin, end, isRefined, static_cast<unsigned char>(vtkDataSetAttributes::HIDDENCELL));
  auto copy = vtkSmartPointer<vtkDataSet>::Take(mesh->NewInstance());
  copy->ShallowCopy(mesh);
  copy->GetCellData()->AddArray(marks);
  return copy;
}

/// VTK's faces of structured grids with hidden cells are polygons that end at the point where they
/// begin: that corner would have no angle, and the faces would be no quads.
void DropRepeatedEnds(vtkPolyData* surface)
{
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkIdList> ids;
  bool isAny = false;
  SkdForEachCell(surface->GetPolys(),
    [&](vtkIdType, const auto* corners, std::size_t size)
    {
      const bool isRepeated = size > 3 && corners[0] == corners[size - 1];
      isAny = isAny || isRepeated;
      ids->Reset();
      for (std::size_t i = 0; i + (isRepeated ? 1 : 0) < size; ++i)
      {
        ids->InsertNextId(static_cast<vtkIdType>(corners[i]));
      }
      polygons->InsertNextCell(ids);
    });
  if (isAny)
  {
    surface->SetPolys(polygons);
    surface->DeleteCells(); // of which the types are known
  }
}

/// VTK rounds the points of these faces to float: rays from a point would begin beside the face.
void PutExactPoints(vtkDataSet* mesh, vtkPolyData* surface)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(surface->GetPointData()->GetArray(OriginalPoints));
  if (!ids)
  {
    return;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(ids->GetValue(i), x);
    points->SetPoint(i, x);
  }
  surface->SetPoints(points);
}

/// For linear cells only: with other cells, VTK 9.2 confuses face and cell numbers.
vtkSmartPointer<vtkPolyData> LinearSurfaceOf(vtkDataSet* mesh)
{
  const vtkSmartPointer<vtkDataSet> shown = WithoutRefined(mesh);
  auto explicitGrid = vtkExplicitStructuredGrid::SafeDownCast(shown);
  vtkNew<vtkDataSetSurfaceFilter> filter;
  filter->SetInputData(shown);
  if (explicitGrid)
  {
    filter->SetInputData(AsUnstructured(explicitGrid));
  }
  filter->PassThroughCellIdsOn();
  filter->PassThroughPointIdsOn();
  filter->Update();
  if (SkdIsStructured(shown) && shown->GetCellGhostArray())
  {
    DropRepeatedEnds(filter->GetOutput());
    PutExactPoints(shown, filter->GetOutput());
  }
  return filter->GetOutput();
}

/// A data set's linear cells, on its own points.
struct LinearPart
{
  vtkNew<vtkUnstructuredGrid> Grid;
  std::vector<vtkIdType> CellIds; // in the data set

  explicit LinearPart(vtkPointSet* mesh)
  {
    auto* polyhedra = vtkUnstructuredGrid::SafeDownCast(mesh);
    vtkUnsignedCharArray* ghosts = mesh->GetCellGhostArray();
    const SkdCellReader reader(mesh);
    vtkNew<vtkIdList> ids;
    vtkNew<vtkUnsignedCharArray> marks;
    marks->SetName(vtkDataSetAttributes::GhostArrayName());
    this->Grid->SetPoints(mesh->GetPoints());
    for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
    {
      const int type = reader.TypeOf(id);
      if (SkdIsCurvedCellType(type))
      {
        continue;
      }
      if (type == VTK_POLYHEDRON && polyhedra)
      {
        polyhedra->GetFaceStream(id, ids);
      }
      else
      {
        mesh->GetCellPoints(id, ids);
      }
      this->Grid->InsertNextCell(type, ids);
      this->CellIds.push_back(id);
      marks->InsertNextValue(ghosts ? ghosts->GetValue(id) : 0);
    }
    if (ghosts)
    {
      this->Grid->GetCellData()->AddArray(marks);
    }
  }
};

/// Of a data set that is no vtkPolyData. Its cells have "vtkOriginalCellIds", its points
/// "vtkOriginalPointIds", -1 of those that are on curved faces. Faces that cannot be cut (a weight
/// that is not positive, a point that is not finite) are there as polygons of two points.
struct OuterSurface
{
  vtkSmartPointer<vtkPolyData> Surface;
  vtkIdType CoarseFaces = 0; ///< see SkdBlockSurface
};

/// Puts polygons, and where they come from, into polydata.
class Builder
{
public:
  Builder(vtkDataSet* mesh, double chordalLength)
    : Mesh(mesh)
    , ChordalLength(chordalLength)
    , Numbers(static_cast<std::size_t>(mesh->GetNumberOfPoints()), -1)
  {
    this->Points->SetDataTypeToDouble();
    this->PointIds->SetName(OriginalPoints);
    this->CellIds->SetName(OriginalCells);
  }

  void AddLinear(const LinearPart& part, std::set<std::vector<vtkIdType>>& shared);
  void AddFace(vtkIdType cellId, vtkCell* face, bool isInward);
  OuterSurface Take() const;

private:
  vtkIdType NumberOf(vtkIdType point)
  {
    vtkIdType& number = this->Numbers[static_cast<std::size_t>(point)];
    if (number < 0)
    {
      double x[3];
      this->Mesh->GetPoint(point, x);
      number = this->Points->InsertNextPoint(x);
      this->PointIds->InsertNextValue(point);
    }
    return number;
  }

  vtkIdType AddPoint(const skd::Vector3& x)
  {
    this->PointIds->InsertNextValue(-1);
    return this->Points->InsertNextPoint(x.X);
  }

  void AddPolygon(vtkIdType cellId, const std::vector<vtkIdType>& corners)
  {
    this->Polygons->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
    this->CellIds->InsertNextValue(cellId);
  }

  void AddQuadraticPolygon(vtkIdType cellId, vtkCell* cell);
  void AddFacets(vtkIdType cellId, vtkCell* face, bool isInward);

  vtkDataSet* Mesh;
  double ChordalLength;
  std::vector<vtkIdType> Numbers; // of the data set's points here
  vtkNew<vtkPoints> Points;
  vtkNew<vtkIdTypeArray> PointIds;
  vtkNew<vtkCellArray> Polygons;
  vtkNew<vtkIdTypeArray> CellIds;
  skd::NodePatch Nodes;
  skd::PatchFacets Facets;
  std::vector<vtkIdType> Corners;
  vtkIdType CoarseFaces = 0;
};

//------------------------------------------------------------------------------
/// Faces shared with a curved cell are interior: they are removed, and `shared` is set to them.
void Builder::AddLinear(const LinearPart& part, std::set<std::vector<vtkIdType>>& shared)
{
  const vtkSmartPointer<vtkPolyData> surface = LinearSurfaceOf(part.Grid);
  auto* cellIds = vtkIdTypeArray::SafeDownCast(surface->GetCellData()->GetArray(OriginalCells));
  auto* pointIds = vtkIdTypeArray::SafeDownCast(surface->GetPointData()->GetArray(OriginalPoints));
  vtkUnsignedCharArray* ghosts = surface->GetCellGhostArray();
  std::set<std::vector<vtkIdType>> met;
  vtkIdType cell = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  const auto add = [&](const auto* corners, std::size_t size)
  {
    this->Corners.clear();
    std::transform(corners, corners + size, std::back_inserter(this->Corners),
      [&](auto corner) { return pointIds->GetValue(static_cast<vtkIdType>(corner)); });
    const vtkIdType id = part.CellIds[static_cast<std::size_t>(cellIds->GetValue(cell))];
    if (!shared.empty() && SkdDimensionOfCellType(this->Mesh->GetCellType(id)) == 3)
    {
      std::vector<vtkIdType> name = this->Corners;
      std::sort(name.begin(), name.end());
      if (shared.count(name) > 0)
      {
        met.insert(name);
        return;
      }
    }
    std::transform(this->Corners.begin(), this->Corners.end(), this->Corners.begin(),
      [this](vtkIdType point) { return this->NumberOf(point); });
    this->AddPolygon(id, this->Corners);
  };
  for (vtkCellArray* cells : { surface->GetPolys(), surface->GetStrips() })
  {
    const bool isStrip = cells == surface->GetStrips();
    SkdForEachCell(cells,
      [&](vtkIdType, const auto* corners, std::size_t size)
      {
        const bool isShown = !ghosts || ghosts->GetValue(cell) == 0;
        if (isShown && !isStrip)
        {
          add(corners, size);
        }
        for (std::size_t k = 0; isShown && isStrip && k + 2 < size; ++k)
        {
          add(SkdStripTriangle(corners, static_cast<std::ptrdiff_t>(k)).data(), 3);
        }
        ++cell;
      });
  }
  shared = met;
}

//------------------------------------------------------------------------------
/// Straight from corner to middle of a side to corner, as this cell is everywhere.
void Builder::AddQuadraticPolygon(vtkIdType cellId, vtkCell* cell)
{
  const vtkIdType corners = cell->GetNumberOfPoints() / 2;
  this->Corners.clear();
  for (vtkIdType i = 0; i < corners; ++i)
  {
    this->Corners.push_back(this->NumberOf(cell->GetPointId(i)));
    this->Corners.push_back(this->NumberOf(cell->GetPointId(i + corners)));
  }
  this->AddPolygon(cellId, this->Corners);
}

void Builder::AddFace(vtkIdType cellId, vtkCell* face, bool isInward)
{
  if (face->GetCellType() == VTK_QUADRATIC_POLYGON)
  {
    this->AddQuadraticPolygon(cellId, face);
  }
  else if (SkdReadNodePatch(face, this->Nodes) == SkdBezierFault::None)
  {
    this->AddFacets(cellId, face, isInward);
  }
  else
  {
    const vtkIdType some = this->NumberOf(face->GetPointId(0));
    this->AddPolygon(cellId, { some, some });
  }
}

void Builder::AddFacets(vtkIdType cellId, vtkCell* face, bool isInward)
{
  this->Facets.Cut(this->Nodes, this->ChordalLength);
  this->CoarseFaces += this->Facets.IsKept() ? 0 : 1;
  std::vector<vtkIdType> numbers(this->Facets.GetPoints().size(), -1);
  for (int k = 0; k < this->Nodes.NumberOfSides(); ++k)
  {
    const auto at = static_cast<std::size_t>(this->Facets.GetCorner(k));
    for (int i = 0; i < this->Nodes.NumberOfSides() && numbers[at] < 0; ++i)
    {
      skd::Vector3 corner;
      face->GetPoints()->GetPoint(i, corner.X);
      numbers[at] =
        corner == this->Facets.GetPoints()[at] ? this->NumberOf(face->GetPointId(i)) : -1;
    }
  }
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    numbers[i] = numbers[i] < 0 ? this->AddPoint(this->Facets.GetPoints()[i]) : numbers[i];
  }
  const auto add = [&](std::vector<vtkIdType>& corners)
  {
    if (this->Facets.IsFlipped() != isInward)
    {
      std::reverse(corners.begin(), corners.end());
    }
    this->AddPolygon(cellId, corners);
  };
  if (this->Facets.IsPolygon())
  {
    add(numbers);
  }
  for (const std::array<int, 3>& triangle : this->Facets.GetTriangles())
  {
    this->Corners.clear();
    for (const int corner : triangle)
    {
      this->Corners.push_back(numbers[static_cast<std::size_t>(corner)]);
    }
    add(this->Corners);
  }
}

OuterSurface Builder::Take() const
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(this->Points);
  surface->SetPolys(this->Polygons);
  surface->GetCellData()->AddArray(this->CellIds);
  surface->GetPointData()->AddArray(this->PointIds);
  return { surface, this->CoarseFaces };
}

//------------------------------------------------------------------------------
/// Faces without points but their corners, as those of linear cells are: of cells of degree 1.
std::set<std::vector<vtkIdType>> StraightFaces(
  vtkDataSet* mesh, const std::vector<SkdCellFace>& faces)
{
  std::set<std::vector<vtkIdType>> names;
  SkdVisitFaces(mesh, faces,
    [&](const SkdCellFace& face, vtkCell* cell, bool)
    {
      vtkIdList* ids = cell->GetPointIds();
      if (face.Face >= 0 && ids->GetNumberOfIds() <= 4)
      {
        std::vector<vtkIdType> name(ids->begin(), ids->end());
        std::sort(name.begin(), name.end());
        names.insert(name);
      }
    });
  return names;
}

OuterSurface FacetedSurfaceOf(vtkPointSet* mesh, double chordalLength)
{
  const std::vector<SkdCellFace> faces = SkdFindCurvedFaces(mesh);
  Builder builder(mesh, chordalLength);
  const LinearPart linear(mesh);
  std::set<std::vector<vtkIdType>> shared;
  if (!linear.CellIds.empty())
  {
    shared = StraightFaces(mesh, faces);
    builder.AddLinear(linear, shared);
  }
  SkdVisitFaces(mesh, faces,
    [&](const SkdCellFace& face, vtkCell* cell, bool isInward)
    {
      vtkIdList* ids = cell->GetPointIds();
      std::vector<vtkIdType> name;
      if (!shared.empty() && face.Face >= 0)
      {
        name.assign(ids->begin(), ids->end());
        std::sort(name.begin(), name.end());
      }
      if (name.empty() || shared.count(name) == 0)
      {
        builder.AddFace(face.CellId, cell, isInward);
      }
    });
  return builder.Take();
}

OuterSurface SurfaceOf(vtkDataSet* mesh, double chordalLength)
{
  if (auto* surface = vtkPolyData::SafeDownCast(mesh))
  {
    return { surface };
  }
  auto* set = vtkPointSet::SafeDownCast(mesh);
  return set && SkdHasCurvedCells(mesh) ? FacetedSurfaceOf(set, chordalLength)
                                        : OuterSurface{ LinearSurfaceOf(mesh) };
}
}

//------------------------------------------------------------------------------
double SkdChordalLength(
  const std::vector<SkdBlock>& blocks, double share, const skd::Processes* processes)
{
  const bool isHere = std::any_of(blocks.begin(), blocks.end(),
    [](const SkdBlock& block) { return SkdHasCurvedCells(block.Mesh); });
  if (!(processes ? processes->IsAny(isHere) : isHere))
  {
    return 0.0;
  }
  skd::Box3 box;
  for (const SkdBlock& block : blocks)
  {
    box.Add(SkdShownBounds(block.Mesh));
  }
  if (processes)
  {
    std::vector<double> own(box.Min.X, box.Min.X + 3);
    own.insert(own.end(), box.Max.X, box.Max.X + 3);
    for (const std::vector<double>& other : processes->GatherFromOthers(own))
    {
      box.Add(
        skd::Box3({ { other[0], other[1], other[2] } }, { { other[3], other[4], other[5] } }));
    }
  }
  const skd::Vector3 size = box.Max - box.Min;
  const double used =
    share >= SmallestChordalDeviation ? std::min(share, 1.0) : SkdDefaultChordalDeviation; // of NaN
  return size[0] >= 0.0 ? used * std::hypot(size[0], size[1], size[2]) : 0.0;
}

//------------------------------------------------------------------------------
void SkdWarnAboutCoarseFaces(vtkAlgorithm* self, vtkIdType coarseFaces, double chordalDeviation)
{
  if (coarseFaces > 0)
  {
    vtkWarningWithObjectMacro(self,
      "ChordalDeviation "
        << chordalDeviation << " is not kept on " << coarseFaces
        << " curved faces, for they are cut into at most " << skd::PatchFacets::MostPieces
        << " facets along a side. Increase ChordalDeviation or refine the cells.");
  }
}

//------------------------------------------------------------------------------
SkdBlockSurface::SkdBlockSurface(vtkDataSet* mesh, double chordalLength)
  : Mesh(mesh)
{
  const OuterSurface outer = SurfaceOf(mesh, chordalLength);
  this->Surface = outer.Surface;
  this->CoarseFaces = outer.CoarseFaces;
  if (mesh != this->Surface.Get())
  {
    this->FindIds();
  }
  else if (this->Surface->GetPoints())
  {
    vtkDataArray* points = this->Surface->GetPoints()->GetData();
    auto doubles = vtkDoubleArray::SafeDownCast(points);
    auto floats = vtkFloatArray::SafeDownCast(points);
    this->Doubles = doubles ? doubles->GetPointer(0) : nullptr;
    this->Floats = floats ? floats->GetPointer(0) : nullptr;
  }
}

void SkdBlockSurface::FindIds()
{
  this->CellIds =
    vtkIdTypeArray::SafeDownCast(this->Surface->GetCellData()->GetArray(OriginalCells));
  this->PointIds =
    vtkIdTypeArray::SafeDownCast(this->Surface->GetPointData()->GetArray(OriginalPoints));
}

void SkdBlockSurface::SetFaces(const std::vector<vtkIdType>& cells, vtkCellArray* polygons,
  const std::vector<skd::Vector3>& points)
{
  const auto number = static_cast<vtkIdType>(points.size());
  const vtkIdType others = this->Surface->GetNumberOfVerts() + this->Surface->GetNumberOfLines();
  const auto size = others + static_cast<vtkIdType>(cells.size());
  const auto cellIds = SkdMakeArray<vtkIdTypeArray>(OriginalCells, 1, size);
  const auto pointIds = SkdMakeArray<vtkIdTypeArray>(OriginalPoints, 1, number);
  for (vtkIdType i = 0; i < size; ++i)
  {
    cellIds->SetValue(
      i, this->GetCellId(i < others ? i : cells[static_cast<std::size_t>(i - others)]));
  }
  for (vtkIdType i = 0; i < number; ++i)
  {
    pointIds->SetValue(i, i < this->Surface->GetNumberOfPoints() ? this->GetPointId(i) : -1);
  }
  const auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(
    SkdMakePoints(number, [&](vtkIdType i) { return points[static_cast<std::size_t>(i)]; }));
  surface->SetVerts(this->Surface->GetVerts());
  surface->SetLines(this->Surface->GetLines());
  surface->SetPolys(polygons);
  surface->GetCellData()->AddArray(cellIds);
  surface->GetPointData()->AddArray(pointIds);
  this->Surface = surface;
  this->FindIds();
  this->Floats = nullptr;
  this->Doubles = vtkDoubleArray::SafeDownCast(surface->GetPoints()->GetData())->GetPointer(0);
}

bool SkdBlockSurface::IsOfVolume(vtkIdType cell) const
{
  return this->CellIds &&
    SkdDimensionOfCellType(this->Mesh->GetCellType(this->CellIds->GetValue(cell))) == 3;
}

// VTK's surface of a structured grid has its points rounded to float: look at the original's.
void SkdBlockSurface::FindPoint(vtkIdType point, double x[3]) const
{
  const vtkIdType original = this->PointIds ? this->PointIds->GetValue(point) : -1;
  vtkDataSet* from = original >= 0 ? this->Mesh : this->Surface.Get();
  from->GetPoint(original >= 0 ? original : point, x);
}
}
