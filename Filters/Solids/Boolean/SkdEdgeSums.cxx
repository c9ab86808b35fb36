// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Solids/Boolean/SkdEdgeSums.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstring>

namespace skdtree
{
namespace
{
/// The finalizer of SplitMix64 (Steele, Lea, Flood, OOPSLA 2014).
std::uint64_t Mixed(std::uint64_t x)
{
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

std::uint64_t HashOf(std::uint64_t seed, const skd::Vector3& x)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double value = x[axis] + 0.0; // -0 is 0
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    seed = Mixed(seed ^ bits);
  }
  return seed;
}

bool IsLess(const skd::Vector3& a, const skd::Vector3& b)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    if (a[axis] != b[axis])
    {
      return a[axis] < b[axis];
    }
  }
  return a[2] < b[2];
}
}

void SkdEdgeSums::Add(const skd::Vector3& from, const skd::Vector3& to)
{
  const bool isForward = IsLess(from, to);
  if (!isForward && !IsLess(to, from))
  {
    return;
  }
  const skd::Vector3& low = isForward ? from : to;
  const skd::Vector3& high = isForward ? to : from;
  const std::uint64_t first = HashOf(HashOf(1, low), high);
  const std::uint64_t second = HashOf(HashOf(2, low), high);
  this->First += isForward ? first : 0 - first;
  this->Second += isForward ? second : 0 - second;
}

SkdEdgeSums SkdSumEdges(vtkPolyData* surface)
{
  SkdEdgeSums sums;
  auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i < size; ++i)
    {
      skd::Vector3 from;
      skd::Vector3 to;
      surface->GetPoint(ids[i], from.X);
      surface->GetPoint(ids[i + 1 == size ? 0 : i + 1], to.X);
      sums.Add(from, to);
    }
  }
  return sums;
}
}
