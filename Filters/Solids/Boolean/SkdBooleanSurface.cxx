// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdBooleanSurface.h"

#include "Cells/Read/SkdForEach.h"
#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdJoinedIds.h"
#include "Pipeline/SkdMakeArray.h"
#include "Pipeline/SkdMakeMesh.h"
#include "Solids/Boolean/SkdBooleanFaces.h"
#include "Solids/Boolean/SkdSectionFaces.h"
#include "Solids/Surfaces/SkdSplitPointData.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstring>

namespace skdtree
{
namespace
{
/// Of each cell of the set, whether it is a polygon of several triangles; empty if none is wanted
/// or each triangle is a cell. Only these are asked for their type: a vtkPolyData has to build a
/// list of types for that.
std::vector<bool> FindPolygons(const SkdTriangleSet& set, const SkdBooleanParts& parts)
{
  if (!parts.KeepsPolygons || set.GetCells().size() == set.GetTriangles().size())
  {
    return {};
  }
  std::vector<bool> isPolygon(set.GetCells().size(), false);
  const auto n = static_cast<std::uint32_t>(set.GetTriangles().size());
  for (std::uint32_t triangle = 1; triangle < n; ++triangle)
  {
    const std::uint32_t cell = set.GetCellOf(triangle);
    if (cell == set.GetCellOf(triangle - 1) && !isPolygon[cell])
    {
      const SkdTriangleSet::Cell& of = set.GetCells()[cell];
      const int type = parts.Blocks.All[of.Block].Mesh->GetCellType(of.Id);
      isPolygon[cell] = type == VTK_QUAD || type == VTK_POLYGON || type == VTK_PIXEL;
    }
  }
  return isPolygon;
}

SkdBooleanFaces MakeFaces(const SkdBooleanParts& parts)
{
  const SkdMovedTriangles& moved = parts.Solids.GetPlacement().First;
  const SkdFacets& facets = parts.Boundary.GetFacets(parts.Solids.GetArrangement());
  if (parts.IsSection && parts.JoinsPieces && parts.KeepsPolygons)
  {
    return SkdMakeSectionFaces(moved, facets, parts.Boundary.GetSigns(), parts.Solids.GetFaces());
  }
  const bool isImprint = parts.Rule.Operation == SkdBooleanOperation::Imprint;
  return SkdMakeBooleanFaces(moved, facets, parts.Boundary.GetSigns(),
    { FindPolygons(parts.Solids.GetTriangles(), parts), parts.MergesPieces && !isImprint });
}

class Output
{
public:
  Output(const SkdBooleanParts& parts, vtkPolyData* output)
    : Parts(parts)
    , Arrangement(parts.Solids.GetArrangement())
    , Moved(parts.Solids.GetPlacement().First)
    , Set(parts.Solids.GetTriangles())
    , Facets(parts.Boundary.GetFacets(this->Arrangement))
    , IsImprint(parts.Rule.Operation == SkdBooleanOperation::Imprint)
    , Faces(MakeFaces(parts))
    , To(output)
  {
    this->NumberPoints();
  }

  void FillShape() const
  {
    const double unscaled = 1.0 / this->Parts.Solids.GetPlacement().Scale;
    const auto pointAt = [&](vtkIdType i)
    { return unscaled * this->Facets.GetPosition(this->Moved, this->Points[i]); };
    const SkdBooleanFaces::Numbers& items = this->Faces.Corners;
    const SkdBooleanFaces::Numbers& offsets = this->Faces.Ends;
    auto starts =
      SkdMakeArray<vtkIdTypeArray>("offsets", 1, static_cast<vtkIdType>(offsets.size()));
    auto corners =
      SkdMakeArray<vtkIdTypeArray>("connectivity", 1, static_cast<vtkIdType>(items.size()));
    std::copy(offsets.begin(), offsets.end(), starts->GetPointer(0));
    const std::uint32_t* const numbers = this->Numbers.data();
    std::transform(items.begin(), items.end(), corners->GetPointer(0),
      [numbers](std::uint32_t corner) { return static_cast<vtkIdType>(numbers[corner]); });
    vtkNew<vtkCellArray> cells;
    cells->SetData(starts, corners);
    this->To->SetPoints(SkdMakePoints(static_cast<vtkIdType>(this->Points.size()), pointAt));
    this->To->SetPolys(cells);
  }

  void FillCellData(std::set<std::string>& refused) const
  {
    const auto n = static_cast<vtkIdType>(this->Faces.Facets.size());
    vtkCellData* data = this->To->GetCellData();
    this->AddIds(n, data);
    if (this->Parts.JoinsPieces)
    {
      data->AddArray(this->NumberFaces(n));
    }
    if (this->IsImprint && this->Parts.Solids.HasWindings())
    {
      this->AddSolidCounts(n, data);
    }
    SkdArrayGather gather =
      SkdGatherInto(data, n, this->Parts.Blocks.All, vtkDataObject::CELL, refused);
    SkdForEach(gather.GetNumberOfArrays() > 0 ? n : 0,
      [&](vtkIdType i)
      {
        const SkdTriangleSet::Cell& cell = this->CellOf(this->ParentOf(i));
        gather.Take(i, cell.Block, cell.Id);
      });
  }

  void FillPointData(std::set<std::string>& refused) const
  {
    const auto n = static_cast<vtkIdType>(this->Points.size());
    SkdArrayGather gather = SkdGatherInto(
      this->To->GetPointData(), n, this->Parts.Blocks.All, vtkDataObject::POINT, refused);
    if (gather.GetNumberOfArrays() == 0)
    {
      return;
    }
    const SkdSplitPointData data(this->Set, this->Facets.NewPoints);
    const bool areAlike = AreAlike(gather, this->Parts.Blocks.All);
    vtkSMPThreadLocalObject<vtkIdList> ids;
    vtkSMPTools::For(0, n,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end;)
        {
          const vtkIdType last = areAlike ? this->FindEndOfRun(data, i, end) : i + 1;
          if (last > i + 1)
          {
            TakeRun(gather, i, last - i, *data.FindOrigin(this->Points[i]));
          }
          else
          {
            data.Gather(this->Points[i], i, gather, ids.Local());
          }
          i = last;
        }
      });
  }

private:
  /// Whether each data set with points has all arrays, with numbers of the resulting type.
  static bool AreAlike(const SkdArrayGather& gather, const std::vector<SkdBlock>& blocks)
  {
    for (int i = 0; i < gather.GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* const result = gather.GetResult(i);
      for (int block = 0; block < static_cast<int>(blocks.size()); ++block)
      {
        vtkAbstractArray* const source = gather.GetSource(i, block);
        const bool isAlike = source && source->IsNumeric() &&
          source->GetDataType() == result->GetDataType() && source->HasStandardMemoryLayout() &&
          result->HasStandardMemoryLayout();
        if (!isAlike && blocks[block].Mesh->GetNumberOfPoints() > 0)
        {
          return false;
        }
      }
    }
    return true;
  }

  /// Points from one on that follow each other in their data set, too.
  vtkIdType FindEndOfRun(const SkdSplitPointData& data, vtkIdType first, vtkIdType end) const
  {
    const SkdTriangleSet::Origin* const origin = data.FindOrigin(this->Points[first]);
    if (!origin)
    {
      return first + 1;
    }
    const int block = origin->Block;
    vtkIdType last = first + 1;
    for (vtkIdType id = origin->Id + 1; last < end && data.IsFrom(this->Points[last], block, id);
         ++id)
    {
      ++last;
    }
    return last;
  }

  static void TakeRun(const SkdArrayGather& gather, vtkIdType to, vtkIdType count,
    const SkdTriangleSet::Origin& origin)
  {
    for (int i = 0; i < gather.GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* const source = gather.GetSource(i, origin.Block);
      vtkAbstractArray* const result = gather.GetResult(i);
      const auto size = static_cast<std::size_t>(result->GetNumberOfComponents()) *
        static_cast<std::size_t>(result->GetDataTypeSize());
      std::memcpy(
        static_cast<char*>(result->GetVoidPointer(0)) + static_cast<std::size_t>(to) * size,
        static_cast<const char*>(source->GetVoidPointer(0)) +
          static_cast<std::size_t>(origin.Id) * size,
        static_cast<std::size_t>(count) * size);
    }
  }

  std::uint32_t ParentOf(vtkIdType face) const
  {
    return this->Facets.Parents[this->Faces.Facets[face]];
  }

  const SkdTriangleSet::Cell& CellOf(std::uint32_t triangle) const
  {
    return this->Set.GetCells()[this->Set.GetCellOf(triangle)];
  }

  /// The points that faces have, in the order of the arrangement's.
  void NumberPoints()
  {
    constexpr std::uint32_t none = 0xffffffffu;
    this->Numbers.assign(this->Moved.GetPoints().size() + this->Facets.NewPoints.size(), none);
    std::uint32_t* const numbers = this->Numbers.data();
    for (const std::uint32_t corner : this->Faces.Corners)
    {
      numbers[corner] = 0;
    }
    this->Points.resize(this->Numbers.size());
    std::uint32_t* const points = this->Points.data();
    std::uint32_t count = 0;
    const auto n = static_cast<std::uint32_t>(this->Numbers.size());
    for (std::uint32_t point = 0; point < n; ++point)
    {
      const bool isUsed = numbers[point] != none;
      points[count] = point; // without a branch: the next one takes its place
      numbers[point] = isUsed ? count : none;
      count += isUsed;
    }
    this->Points.resize(count);
  }

  void AddIds(vtkIdType n, vtkCellData* data) const
  {
    const bool hasSolids = !this->Parts.Solids.AreSolidsInputs();
    auto inputs = SkdMakeArray<vtkIntArray>(SkdBooleanNames::Input, 1, n);
    auto ids = SkdMakeArray<vtkIdTypeArray>(SkdBooleanNames::Cell, 1, n);
    auto solids = SkdMakeArray<vtkIntArray>(SkdBooleanNames::Solid, 1, hasSolids ? n : 0);
    auto blocks =
      SkdMakeArray<vtkIntArray>(SkdBooleanNames::Block, 1, this->Parts.Blocks.IsComposite ? n : 0);
    int* const inputOf = inputs->GetPointer(0);
    vtkIdType* const idOf = ids->GetPointer(0);
    SkdForEach(n,
      [&](vtkIdType i)
      {
        const SkdTriangleSet::Cell& cell = this->CellOf(this->ParentOf(i));
        inputOf[i] = cell.Block < this->Parts.Blocks.FirstOfSource ? 0 : 1;
        idOf[i] = cell.Id;
      });
    SkdForEach(hasSolids ? n : 0,
      [&](vtkIdType i)
      {
        const std::uint32_t solid = this->Parts.Solids.GetSolids().Of[this->ParentOf(i)];
        solids->SetValue(i, static_cast<int>(solid));
      });
    SkdForEach(this->Parts.Blocks.IsComposite ? n : 0,
      [&](vtkIdType i)
      {
        const SkdTriangleSet::Cell& cell = this->CellOf(this->ParentOf(i));
        blocks->SetValue(i, this->Parts.Blocks.All[cell.Block].BlockIndex);
      });
    this->JoinIds(ids);
    data->AddArray(inputs);
    data->AddArray(ids);
    if (hasSolids)
    {
      data->AddArray(solids);
    }
    if (this->Parts.Blocks.IsComposite)
    {
      data->AddArray(blocks);
    }
  }

  /// Makes ids of cells those in the whole, of which each process may have other cells.
  void JoinIds(vtkIdTypeArray* ids) const
  {
    const std::vector<SkdJoinedIds> joined = SkdJoinedIdsOf(this->Parts.Blocks.All);
    if (std::any_of(
          joined.begin(), joined.end(), [](const SkdJoinedIds& own) { return own.HasOwn(); }))
    {
      SkdForEach(ids->GetNumberOfValues(),
        [&](vtkIdType i)
        {
          const SkdTriangleSet::Cell& cell = this->CellOf(this->ParentOf(i));
          ids->SetValue(i, joined[static_cast<std::size_t>(cell.Block)].Of(cell.Id));
        });
    }
  }

  /// Numbers from 0 on, in the order of the faces that were given.
  vtkSmartPointer<vtkIdTypeArray> NumberFaces(vtkIdType n) const
  {
    auto array = SkdMakeArray<vtkIdTypeArray>(SkdBooleanNames::Face, 1, n);
    SkdFaceSets& faces = this->Parts.Solids.GetFaces();
    std::vector<std::uint32_t> numbers(faces.GetNumberOfTriangles(), 0); // and 1; 0: none yet
    vtkIdType* const to = array->GetPointer(0);
    std::uint32_t count = 0;
    for (vtkIdType i = 0; i < n; ++i)
    {
      std::uint32_t& number = numbers[faces.Find(this->ParentOf(i))];
      number = number == 0 ? ++count : number;
      to[i] = static_cast<vtkIdType>(number) - 1;
    }
    return array;
  }

  void AddSolidCounts(vtkIdType n, vtkCellData* data) const
  {
    auto inFront = SkdMakeArray<vtkIntArray>(SkdBooleanNames::Front, 1, n);
    auto behind = SkdMakeArray<vtkIntArray>(SkdBooleanNames::Back, 1, n);
    std::vector<int> counts;
    for (const SkdRegionWindings& windings : this->Parts.Solids.GetWindings())
    {
      counts.push_back(static_cast<int>(this->Parts.Rule.CountSolids(windings)));
    }
    for (vtkIdType i = 0; i < n; ++i)
    {
      const std::uint32_t facet = this->Faces.Facets[i];
      inFront->SetValue(i, counts[this->Arrangement.GetFront(facet)]);
      behind->SetValue(i, counts[this->Arrangement.GetBack(facet)]);
    }
    data->AddArray(inFront);
    data->AddArray(behind);
  }

  const SkdBooleanParts& Parts;
  const SkdArrangement& Arrangement;
  const SkdMovedTriangles& Moved;
  const SkdTriangleSet& Set;
  const SkdFacets& Facets;
  const bool IsImprint;
  const SkdBooleanFaces Faces;
  std::vector<std::uint32_t> Numbers;   // of the arrangement's points in the output
  skd::RawVector<std::uint32_t> Points; // of the output, in the arrangement
  vtkPolyData* To;
};
}

void SkdFillBooleanSurface(
  const SkdBooleanParts& parts, vtkPolyData* output, std::set<std::string>& refused)
{
  const Output to(parts, output);
  to.FillShape();
  to.FillCellData(refused);
  to.FillPointData(refused);
  for (const char* name : SkdBooleanNames::All)
  {
    refused.erase(name);
  }
}
}
