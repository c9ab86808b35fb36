// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Search/SkdBatch.h"

#include "Cells/Read/SkdEnclose.h"
#include "Core/Geometry/MortonCode.h"

#include <cmath>
#include <limits>

namespace skdtree
{
namespace
{
/// Halves are added, not the sum halved: no overflow near the largest double.
skd::Vector3 CentreOf(SkdBatchOf kind, const double* tuple)
{
  if (kind == SkdBatchOf::Points || kind == SkdBatchOf::Spheres)
  {
    return { { tuple[0], tuple[1], tuple[2] } };
  }
  const int next = kind == SkdBatchOf::Boxes ? 2 : 1;
  const int other = kind == SkdBatchOf::Boxes ? 1 : 3;
  skd::Vector3 centre;
  for (int axis = 0; axis < 3; ++axis)
  {
    centre[axis] = 0.5 * tuple[axis * next] + 0.5 * tuple[axis * next + other];
  }
  return centre;
}

/// Half of it, which does not overflow near the largest double.
double HalfLongestSide(const skd::Box3& box)
{
  double longest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    longest = std::max(longest, 0.5 * box.Max[axis] - 0.5 * box.Min[axis]);
  }
  return longest;
}

/// Where a point is along the Morton curve that fills a box with cubes.
class MortonCurve
{
public:
  MortonCurve(const skd::Box3& box, int bitsPerAxis)
    : Origin(box.Min)
    , CubesPerAxis(1u << bitsPerAxis)
  {
    const double longest = HalfLongestSide(box);
    this->HalfScale = longest > 0.0 ? 0.5 * this->CubesPerAxis / longest : 0.0;
  }

  std::uint32_t NumberOfCubes() const
  {
    return this->CubesPerAxis * this->CubesPerAxis * this->CubesPerAxis;
  }

  /// The number of cubes for a point that is not finite.
  std::uint32_t KeyOf(const skd::Vector3& x) const
  {
    return skd::IsFinite(x) ? skd::MortonCode({ this->CubeAlong(0, x[0]), this->CubeAlong(1, x[1]),
                                this->CubeAlong(2, x[2]) })
                            : this->NumberOfCubes();
  }

private:
  // A box of no size, or too small to divide by it, makes one cube of all.
  std::uint32_t CubeAlong(int axis, double x) const
  {
    const double cube = 2.0 * (0.5 * x - 0.5 * this->Origin[axis]) * this->HalfScale;
    const double last = this->CubesPerAxis - 1.0;
    return cube >= 0.0 && cube <= last ? static_cast<std::uint32_t>(cube)
      : cube > last                    ? this->CubesPerAxis - 1
                                       : 0;
  }

  skd::Vector3 Origin;
  std::uint32_t CubesPerAxis;
  double HalfScale;
};
}

//------------------------------------------------------------------------------
SkdBatch::SkdBatch(vtkDataArray* queries, SkdBatchOf kind, bool isSorted)
  : Queries(queries)
  , Ends(nullptr)
  , Kind(kind)
  , Count(queries->GetNumberOfTuples())
{
  if (isSorted)
  {
    this->Arrange();
  }
}

//------------------------------------------------------------------------------
SkdBatch::SkdBatch(vtkDataArray* starts, vtkDataArray* ends, bool isSorted)
  : Queries(starts)
  , Ends(ends)
  , Kind(SkdBatchOf::Lines)
  , Count(starts->GetNumberOfTuples())
{
  if (isSorted)
  {
    this->Arrange();
  }
}

//------------------------------------------------------------------------------
void SkdBatch::Arrange()
{
  const bool isOnePiece = this->Count <= PieceSize;
  if (isOnePiece || this->Count > std::numeric_limits<std::uint32_t>::max() ||
    (this->Kind == SkdBatchOf::Lines && !this->AreShort()))
  {
    return;
  }
  const skd::Box3 box = SkdEnclose(static_cast<std::size_t>(this->Count),
    [this](std::size_t slot)
    {
      double tuple[6];
      this->ReadWithEnds(static_cast<vtkIdType>(slot), tuple);
      const skd::Vector3 centre = CentreOf(this->Kind, tuple);
      return skd::IsFinite(centre) ? skd::Box3(centre, centre) : skd::Box3();
    });
  if (box.IsEmpty())
  {
    return;
  }
  // About a query a cube, as long as what counts them fits into a cache.
  constexpr int mostBits = 6;
  int bits = 1;
  while (bits < mostBits && (std::int64_t(1) << (3 * bits)) < this->Count)
  {
    ++bits;
  }
  const MortonCurve curve(box, bits);
  std::vector<std::uint32_t> keys(static_cast<std::size_t>(this->Count));
  vtkSMPTools::For(0, this->Count,
    [&](vtkIdType begin, vtkIdType end)
    {
      double tuple[6];
      for (vtkIdType slot = begin; slot < end; ++slot)
      {
        this->ReadWithEnds(slot, tuple);
        keys[static_cast<std::size_t>(slot)] = curve.KeyOf(CentreOf(this->Kind, tuple));
      }
    });
  this->SortByCount(keys, curve.NumberOfCubes());
}

//------------------------------------------------------------------------------
// The centre of a long line says little about the cells that it meets: sorted random chords of a
// sphere of 10^6 triangles took 1.4 times as long as one by one, lines through its surface half as
// long as it is wide, or shorter, 0.6 to 0.9 times.
bool SkdBatch::AreShort() const
{
  const vtkIdType step = (this->Count + PieceSize - 1) / PieceSize;
  skd::Box3 centres;
  double sum = 0.0;
  double number = 0.0;
  for (vtkIdType slot = 0; slot < this->Count; slot += step)
  {
    double ends[6];
    this->ReadWithEnds(slot, ends);
    const double length =
      skd::Norm(skd::Vector3{ { ends[3] - ends[0], ends[4] - ends[1], ends[5] - ends[2] } });
    if (std::isfinite(length))
    {
      centres.Add(CentreOf(this->Kind, ends));
      sum += length;
      number += 1.0;
    }
  }
  return sum <= number * HalfLongestSide(centres);
}

//------------------------------------------------------------------------------
void SkdBatch::SortByCount(const std::vector<std::uint32_t>& keys, std::uint32_t largestKey)
{
  std::vector<std::uint32_t> next(static_cast<std::size_t>(largestKey) + 2, 0);
  for (const std::uint32_t key : keys)
  {
    ++next[key + 1];
  }
  for (std::size_t key = 1; key < next.size(); ++key)
  {
    next[key] += next[key - 1];
  }
  this->Order.resize(keys.size());
  for (std::size_t slot = 0; slot < keys.size(); ++slot)
  {
    this->Order[next[keys[slot]]++] = static_cast<std::uint32_t>(slot);
  }
}
}
