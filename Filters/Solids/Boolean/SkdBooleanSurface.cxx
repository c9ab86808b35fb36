// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdBooleanSurface.h"

#include "Cells/Read/SkdForEach.h"
#include "Pipeline/SkdArrayGather.h"
#include "Pipeline/SkdJoinedIds.h"
#include "Pipeline/SkdMakeArray.h"
#include "Solids/Boolean/SkdBooleanFaces.h"
#include "Solids/Boolean/SkdSectionFaces.h"
#include "Solids/Surfaces/SkdSplitPointData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstring>
#include <numeric>

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
    this->FindRunsOfFaces();
  }

  void FillShape() const
  {
    this->FillPoints();
    const auto n = static_cast<vtkIdType>(this->Faces.Facets.size());
    const SkdBooleanFaces::Numbers& items = this->Faces.Corners;
    const auto size = this->Faces.AreFacets() ? 3 * n : static_cast<vtkIdType>(items.size());
    auto starts = SkdMakeArray<vtkIdTypeArray>("offsets", 1, n + 1);
    auto corners = SkdMakeArray<vtkIdTypeArray>("connectivity", 1, size);
    vtkIdType* const offsets = starts->GetPointer(0);
    vtkIdType* to = corners->GetPointer(0);
    const std::uint32_t* const numbers = this->Numbers.data();
    if (this->Faces.AreFacets())
    {
      for (vtkIdType i = 0; i <= n; ++i)
      {
        offsets[i] = 3 * i;
      }
      SkdBooleanFaces::ForEachFacet(this->Facets, this->Parts.Boundary.GetSigns(),
        [numbers, next = to](std::uint32_t a, std::uint32_t b, std::uint32_t c) mutable
        {
          next[0] = numbers[a];
          next[1] = numbers[b];
          next[2] = numbers[c];
          next += 3;
        });
    }
    else
    {
      std::copy(this->Faces.Ends.begin(), this->Faces.Ends.end(), offsets);
      std::transform(items.begin(), items.end(), to,
        [numbers](std::uint32_t corner) { return static_cast<vtkIdType>(numbers[corner]); });
    }
    vtkNew<vtkCellArray> cells;
    cells->SetData(starts, corners);
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
      SkdGatherUnfilled(data, n, this->Parts.Blocks.All, vtkDataObject::CELL, refused);
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
    SkdArrayGather gather = SkdGatherUnfilled(
      this->To->GetPointData(), n, this->Parts.Blocks.All, vtkDataObject::POINT, refused);
    if (gather.GetNumberOfArrays() == 0)
    {
      return;
    }
    const SkdSplitPointData data(this->Set, this->Facets.NewPoints.Get());
    const bool areAlike = AreAlike(gather, this->Parts.Blocks.All);
    vtkSMPThreadLocalObject<vtkIdList> ids;
    ForEachRun(n, this->RunsOfPoints,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end;)
        {
          const std::uint32_t point = this->Points[i];
          const vtkIdType last =
            areAlike ? std::min<vtkIdType>(end, i + data.CountAlike(point)) : i + 1;
          if (last > i + 1)
          {
            TakeRun(gather, i, last - i, *data.FindOrigin(point));
          }
          else
          {
            data.Gather(point, i, gather, ids.Local());
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

  /// Points that follow each other in the arrangement are copied at once.
  void FillPoints() const
  {
    const auto n = static_cast<vtkIdType>(this->Points.size());
    const double unscaled = 1.0 / this->Parts.Solids.GetPlacement().Scale;
    vtkNew<vtkDoubleArray> coordinates;
    coordinates->SetNumberOfComponents(3);
    coordinates->SetNumberOfTuples(n);
    double* const values = coordinates->GetPointer(0);
    const SkdTriangleSet::PointList& given = this->Moved.GetPoints();
    ForEachRun(n, this->RunsOfPoints,
      [&](vtkIdType begin, vtkIdType end)
      {
        const std::size_t first = this->Points[begin];
        if (unscaled == 1.0 && first + static_cast<std::size_t>(end - begin) <= given.size())
        {
          std::memcpy(values + 3 * begin, given[first].X,
            static_cast<std::size_t>(end - begin) * sizeof(skd::Vector3));
          return;
        }
        for (vtkIdType i = begin; i < end; ++i)
        {
          const skd::Vector3 x = unscaled * this->Facets.GetPosition(this->Moved, this->Points[i]);
          std::copy_n(x.X, 3, values + 3 * i);
        }
      });
    vtkNew<vtkPoints> points;
    points->SetData(coordinates);
    this->To->SetPoints(points);
  }

  /// Calls visit(begin, end), maybe in parallel, for numbers up to n of one run. `runs` are the
  /// first ones of each.
  template <class Visit>
  static void ForEachRun(vtkIdType n, const std::vector<std::uint32_t>& runs, const Visit& visit)
  {
    vtkSMPTools::For(0, n,
      [&](vtkIdType begin, vtkIdType end)
      {
        auto next = std::upper_bound(runs.begin(), runs.end(), begin);
        for (vtkIdType first = begin; first < end;)
        {
          const vtkIdType last = next == runs.end() ? end : std::min<vtkIdType>(end, *next++);
          visit(first, last);
          first = last;
        }
      });
  }

  /// Mostly the triangles that faces are of follow each other, as they did in the inputs.
  void FindRunsOfFaces()
  {
    const auto n = static_cast<std::uint32_t>(this->Faces.Facets.size());
    const std::uint32_t* const facets = this->Faces.Facets.data();
    const std::uint32_t* const parents = this->Facets.Parents.data();
    for (std::uint32_t i = 0; i < n;)
    {
      this->RunsOfFaces.push_back(i);
      std::uint32_t next = parents[facets[i]] + 1;
      for (++i; i < n && parents[facets[i]] == next; ++i)
      {
        ++next;
      }
    }
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
    if (this->Faces.AreFacets())
    {
      SkdBooleanFaces::ForEachFacet(this->Facets, this->Parts.Boundary.GetSigns(),
        [numbers](std::uint32_t a, std::uint32_t b, std::uint32_t c)
        { numbers[a] = numbers[b] = numbers[c] = 0; });
    }
    this->Points.resize(this->Numbers.size());
    std::uint32_t* const points = this->Points.data();
    std::uint32_t count = 0;
    const auto n = static_cast<std::uint32_t>(this->Numbers.size());
    const auto given = static_cast<std::uint32_t>(this->Moved.GetPoints().size());
    for (std::uint32_t point = 0; point < n;)
    {
      if (numbers[point] == none)
      {
        ++point;
        continue;
      }
      this->RunsOfPoints.push_back(count);
      const std::uint32_t end = point < given ? given : n;
      for (; point < end && numbers[point] != none; ++point)
      {
        points[count] = point;
        numbers[point] = count++;
      }
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
    const int firstOfSource = this->Parts.Blocks.FirstOfSource;
    const bool areCells = this->Set.GetCells().size() == this->Set.GetTriangles().size();
    ForEachRun(n, this->RunsOfFaces,
      [&](vtkIdType begin, vtkIdType end)
      {
        const std::uint32_t parent = this->ParentOf(begin);
        const SkdTriangleSet::Cell* const cells = this->Set.GetCells().data();
        for (vtkIdType i = begin; i < end; ++i)
        {
          const auto triangle = parent + static_cast<std::uint32_t>(i - begin);
          const SkdTriangleSet::Cell& cell =
            cells[areCells ? triangle : this->Set.GetCellOf(triangle)];
          inputOf[i] = cell.Block < firstOfSource ? 0 : 1;
          idOf[i] = cell.Id;
        }
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
    constexpr std::uint32_t none = 0xffffffffu;
    auto array = SkdMakeArray<vtkIdTypeArray>(SkdBooleanNames::Face, 1, n);
    vtkIdType* const to = array->GetPointer(0);
    SkdFaceSets& faces = this->Parts.Solids.GetFaces();
    skd::RawVector<std::uint32_t> numbers(faces.GetNumberOfTriangles());
    // Pieces of one triangle follow each other there.
    const bool areInOrder = this->Faces.AreFacets() && !this->Parts.Solids.GetCombined();
    if (areInOrder)
    {
      faces.GetUnited().ForEach([&numbers](std::uint32_t triangle) { numbers[triangle] = none; });
    }
    else
    {
      std::fill(numbers.begin(), numbers.end(), none);
    }
    std::uint32_t count = 0;
    std::uint32_t last = none; // triangle that is a face
    for (std::size_t run = 0; run < this->RunsOfFaces.size(); ++run)
    {
      const std::uint32_t begin = this->RunsOfFaces[run];
      const vtkIdType end = run + 1 < this->RunsOfFaces.size() ? this->RunsOfFaces[run + 1] : n;
      std::uint32_t triangle = this->ParentOf(begin);
      for (vtkIdType i = begin; i < end;)
      {
        const auto left = static_cast<std::uint32_t>(end - i);
        const std::uint32_t next =
          areInOrder ? faces.GetUnited().FindNext(triangle, triangle + left) : triangle;
        if (next > triangle)
        {
          count -= triangle == last;
          std::iota(to + i, to + i + (next - triangle), static_cast<vtkIdType>(count));
          count += next - triangle;
          i += next - triangle;
          triangle = next;
          last = next - 1;
          continue;
        }
        std::uint32_t& number = numbers[faces.Find(triangle++)];
        number = number == none ? count++ : number;
        to[i++] = static_cast<vtkIdType>(number);
      }
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
  std::vector<std::uint32_t> Numbers;      // of the arrangement's points in the output
  skd::RawVector<std::uint32_t> Points;    // of the output, in the arrangement
  std::vector<std::uint32_t> RunsOfPoints; // that follow each other there: the first ones
  std::vector<std::uint32_t> RunsOfFaces;  // of triangles that follow each other: the first ones
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
