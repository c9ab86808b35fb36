// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/Rays/SkdBodyExit.h"

#include "Bodies/SkdBoundary.h"
#include "Bodies/SkdSolid.h"
#include "Cells/Curved/SkdCurvedFaces.h"
#include "Search/Rays/SkdSurfaceNormals.h"
#include "vtkBoundingBox.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace skdtree
{
namespace
{
using skd::Vector3;
}

//------------------------------------------------------------------------------
SkdBodyExit::SkdBodyExit(const SkdSourceTrees& trees, int blocks, double start, double own)
  : Trees(trees)
  , Start(start)
  , Own(own)
{
  vtkBoundingBox box;
  for (int block = 0; block < blocks; ++block)
  {
    vtkDataSet* mesh = trees.GetMesh(block);
    double bounds[6];
    mesh->GetBounds(bounds);
    box.AddBounds(bounds);
    this->Surfaces.push_back({ mesh, block });
    this->IsCurved = this->IsCurved || SkdHasCurvedCells(mesh);
  }
  if (box.IsValid())
  {
    box.GetBounds(this->Bounds);
    this->Length = 1.01 * box.GetDiagonalLength();
  }
}

SkdRayHit SkdBodyExit::Find(const Vector3& from, const Vector3& along, const SkdRayHit& first) const
{
  const SkdRayHit none{ 0.0, -1, -1 };
  if (first.Block < 0)
  {
    return none;
  }
  const Vector3 begin = from + this->Start * along;
  if (this->IsSimple())
  {
    const vtkIdType number = this->CountAround(begin);
    const Vector3 normal = SkdNormalOfCell(
      this->Trees.GetMesh(first.Block), first.CellId, from + first.Distance * along);
    const bool isOut = skd::Dot(normal, along) >= 0.0;
    if (number == (isOut ? 1 : 0))
    {
      return isOut ? first : none;
    }
    return this->FindLast(begin, this->FindPasses(begin, along), number, first);
  }
  const std::vector<Pass>& passes = this->FindPasses(begin, along);
  vtkIdType number = 0;
  for (const Pass& pass : passes)
  {
    number += pass.Direction;
  }
  return this->FindLast(begin, passes, number, first);
}

SkdRayHit SkdBodyExit::FindLast(const Vector3& begin, const std::vector<Pass>& passes,
  vtkIdType number, const SkdRayHit& first) const
{
  const bool isKnown = !passes.empty() && number == (passes.front().Direction > 0 ? 1 : 0);
  number = isKnown ? number : this->Corrected(number, begin);
  for (const Pass& pass : passes)
  {
    if (number <= 0)
    {
      break;
    }
    const bool isEnd = pass.Direction > 0 && number == 1;
    number -= pass.Direction;
    if (isEnd)
    {
      const bool isFirst = pass.Block == first.Block && pass.CellId == first.CellId;
      return isFirst ? first : SkdRayHit{ this->Start + pass.Distance, pass.CellId, pass.Block };
    }
  }
  return { 0.0, -1, -1 };
}

// All lines to the outside say the same of a closed surface: the shortest costs least.
vtkIdType SkdBodyExit::CountAround(const Vector3& x) const
{
  const SkdRayEnd ray = SkdRayEndsAlongAxes(this->Bounds, x.X)[0];
  const Vector3 end = x + Vector3{ { ray[0], ray[1], ray[2] } };
  vtkIdType number = 0;
  for (std::size_t block = 0; block < this->Surfaces.size(); ++block)
  {
    vtkIdType sum;
    this->Trees.GetLocator(static_cast<int>(block))->CountPasses(x.X, end.X, nullptr, sum);
    number += sum;
  }
  return number;
}

// On a surface with open edges a count along a line says little.
vtkIdType SkdBodyExit::Corrected(vtkIdType number, const Vector3& x) const
{
  std::call_once(this->OpenFlag,
    [this]
    {
      const SkdBoundary boundary =
        SkdBoundaryOf(this->Surfaces, SkdChordalLength(this->Surfaces, SkdDefaultChordalDeviation));
      if (boundary.OpenEdges > 0)
      {
        this->Winding = std::make_unique<SkdWinding>(boundary.Surface);
      }
    });
  return this->Winding
    ? std::max(vtkIdType(1), static_cast<vtkIdType>(std::llround(this->Winding->At(x.X))))
    : number;
}

// Ascending, of several at one point those that leave first: bodies that touch end there. In a
// vector of the calling thread.
const std::vector<SkdBodyExit::Pass>& SkdBodyExit::FindPasses(
  const Vector3& from, const Vector3& along) const
{
  thread_local vtkNew<vtkDoubleArray> parameters;
  thread_local vtkNew<vtkIdTypeArray> cells;
  thread_local vtkNew<vtkIdTypeArray> directions;
  thread_local std::vector<Pass> passes;
  passes.clear();
  const Vector3 end = from + this->Length * along;
  for (std::size_t i = 0; i < this->Surfaces.size(); ++i)
  {
    const int block = static_cast<int>(i);
    const vtkIdType n =
      this->Trees.GetLocator(block)->FindPasses(from.X, end.X, parameters, cells, directions);
    for (vtkIdType k = 0; k < n; ++k)
    {
      Pass pass{ parameters->GetValue(k) * this->Length, block, cells->GetValue(k),
        static_cast<int>(directions->GetValue(k)) };
      if (pass.Direction == 0)
      {
        const Vector3 normal =
          SkdNormalOfCell(this->Trees.GetMesh(block), pass.CellId, from + pass.Distance * along);
        pass.Direction = skd::Dot(normal, along) >= 0.0 ? 1 : -1;
      }
      if (pass.Direction > 0 || pass.Distance > this->Own)
      {
        passes.push_back(pass);
      }
    }
  }
  const auto isBefore = [](const Pass& a, const Pass& b)
  { return std::tie(a.Distance, a.Block, a.CellId) < std::tie(b.Distance, b.Block, b.CellId); };
  std::sort(passes.begin(), passes.end(), isBefore);
  for (auto first = passes.begin(); first != passes.end();)
  {
    const auto last = std::find_if(first, passes.end(),
      [&](const Pass& pass) { return pass.Distance > first->Distance + this->Start; });
    std::stable_partition(first, last, [](const Pass& pass) { return pass.Direction > 0; });
    first = last;
  }
  return passes;
}
}
