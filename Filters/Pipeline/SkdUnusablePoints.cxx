// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdUnusablePoints.h"

#include "Cells/Read/SkdMagnitudes.h"
#include "Pipeline/SkdShownElements.h"
#include "vtkAOSDataArrayTemplate.h"
#include "vtkImageData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

namespace skdtree
{
namespace
{
constexpr vtkIdType BlockSize = 16384; // points that a thread looks at in one go

/// Whether each of some coordinates is usable, without a branch for each.
template <typename Value>
bool AreUsable(const Value* x, vtkIdType n, double largest)
{
  bool areUsable = true;
  for (vtkIdType i = 0; i < n; ++i)
  {
    areUsable &= std::abs(static_cast<double>(x[i])) <= largest;
  }
  return areUsable;
}

bool AreUsable(vtkDataArray* array, vtkIdType begin, vtkIdType end, double largest)
{
  if (auto* doubles = vtkAOSDataArrayTemplate<double>::FastDownCast(array))
  {
    return AreUsable(doubles->GetPointer(3 * begin), 3 * (end - begin), largest);
  }
  if (auto* floats = vtkAOSDataArrayTemplate<float>::FastDownCast(array))
  {
    return AreUsable(floats->GetPointer(3 * begin), 3 * (end - begin), largest);
  }
  return false; // not known
}

void Add(const SkdUnusablePoints& next, SkdUnusablePoints& sum)
{
  sum.First = sum.Count > 0 ? sum.First : next.First;
  sum.Count += next.Count;
}

SkdUnusablePoints FindIn(vtkDataArray* array, vtkIdType begin, vtkIdType end, double largest)
{
  SkdUnusablePoints found;
  for (vtkIdType i = begin; i < end; ++i)
  {
    skd::Vector3 x;
    array->GetTuple(i, x.X);
    if (!SkdIsWithin(x, largest))
    {
      Add({ 1, i }, found);
    }
  }
  return found;
}

SkdUnusablePoints Find(vtkDataArray* array, double largest)
{
  const vtkIdType n = array->GetNumberOfTuples();
  std::vector<SkdUnusablePoints> blocks(static_cast<std::size_t>((n + BlockSize - 1) / BlockSize));
  vtkSMPTools::For(0, static_cast<vtkIdType>(blocks.size()), 4,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType block = first; block < last; ++block)
      {
        const vtkIdType begin = block * BlockSize;
        const vtkIdType end = std::min(n, begin + BlockSize);
        if (!AreUsable(array, begin, end, largest))
        {
          blocks[static_cast<std::size_t>(block)] = FindIn(array, begin, end, largest);
        }
      }
    });
  SkdUnusablePoints all;
  for (const SkdUnusablePoints& block : blocks)
  {
    Add(block, all);
  }
  return all;
}

bool IsUsable(vtkDataSet* mesh, vtkIdType point, double largest)
{
  skd::Vector3 x;
  mesh->GetPoint(point, x.X);
  return SkdIsWithin(x, largest);
}

/// A coordinate is that of a whole plane of points.
SkdUnusablePoints Find(vtkRectilinearGrid* grid, double largest)
{
  SkdUnusablePoints found;
  vtkDataArray* const axes[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
    grid->GetZCoordinates() };
  vtkIdType usable = 1;
  for (vtkDataArray* axis : axes)
  {
    vtkIdType count = 0;
    for (vtkIdType i = 0; axis && i < axis->GetNumberOfTuples(); ++i)
    {
      count += std::abs(axis->GetComponent(i, 0)) <= largest ? 1 : 0;
    }
    usable *= count;
  }
  found.Count = grid->GetNumberOfPoints() - usable;
  for (vtkIdType i = 0; found.Count > 0 && found.First < 0; ++i)
  {
    found.First = IsUsable(grid, i, largest) ? -1 : i;
  }
  return found;
}

/// Points of a lattice are usable if those at its corners are. If not, each is looked at.
SkdUnusablePoints Find(vtkImageData* image, double largest)
{
  const int* n = image->GetDimensions();
  bool areUsable = true;
  for (int corner = 0; corner < 8; ++corner)
  {
    const vtkIdType i = corner & 1 ? n[0] - 1 : 0;
    const vtkIdType j = corner & 2 ? n[1] - 1 : 0;
    const vtkIdType k = corner & 4 ? n[2] - 1 : 0;
    areUsable = areUsable && IsUsable(image, i + n[0] * (j + n[1] * k), largest);
  }
  SkdUnusablePoints found;
  for (vtkIdType i = 0; !areUsable && i < image->GetNumberOfPoints(); ++i)
  {
    if (!IsUsable(image, i, largest))
    {
      Add({ 1, i }, found);
    }
  }
  return found;
}

SkdUnusablePoints FindAll(vtkDataSet* mesh, double largest)
{
  auto* set = vtkPointSet::SafeDownCast(mesh);
  if (set && set->GetPoints())
  {
    return Find(set->GetPoints()->GetData(), largest);
  }
  if (mesh->GetNumberOfPoints() == 0)
  {
    return {};
  }
  if (auto* image = vtkImageData::SafeDownCast(mesh))
  {
    return Find(image, largest);
  }
  auto* grid = vtkRectilinearGrid::SafeDownCast(mesh);
  return grid ? Find(grid, largest) : SkdUnusablePoints();
}

SkdUnusablePoints FindShown(vtkDataSet* mesh, double largest)
{
  const std::vector<unsigned char> shown = SkdFindShown(mesh, vtkDataObject::POINT);
  SkdUnusablePoints found;
  for (std::size_t i = 0; i < shown.size(); ++i)
  {
    const auto point = static_cast<vtkIdType>(i);
    if (shown[i] != 0 && !IsUsable(mesh, point, largest))
    {
      Add({ 1, point }, found);
    }
  }
  return found;
}
}

//------------------------------------------------------------------------------
SkdUnusablePoints SkdFindUnusablePoints(vtkDataSet* mesh, bool anyMagnitude)
{
  const double largest = anyMagnitude ? std::numeric_limits<double>::max() : SkdComparable.Largest;
  const SkdUnusablePoints all = FindAll(mesh, largest);
  const bool mayBeHidden = mesh->GetCellGhostArray() || mesh->GetPointGhostArray();
  return all.Count > 0 && mayBeHidden ? FindShown(mesh, largest) : all;
}

//------------------------------------------------------------------------------
std::string SkdUnusablePoints::Tell(vtkDataSet* mesh, bool anyMagnitude) const
{
  std::ostringstream text;
  text << this->Count << " of " << mesh->GetNumberOfPoints() << " points are NaN";
  if (anyMagnitude)
  {
    text << " or infinite";
  }
  else
  {
    text << ", infinite or beyond " << SkdComparable.Largest;
  }
  text << "; the first is point " << this->First << ".";
  return text.str();
}
}
