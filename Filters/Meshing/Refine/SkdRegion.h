// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdRegion.h
 * @brief The region of a cell, for refinement criteria.
 */

#ifndef SkdRegion_h
#define SkdRegion_h

#include "Cells/Search/SkdCellTree.h"
#include "Core/Geometry/Simplices/SimplexSet.h"

#include <limits>
#include <vector>

namespace skdtree
{
class SkdRegion
{
public:
  virtual ~SkdRegion() = default;

  /// A box that contains all points for which Contains() is true.
  const skd::Box3& GetBox() const { return this->Box; }

  ///@{
  /// The middle, and a distance from it that all of the cell is within.
  const skd::Vector3& GetMiddle() const { return this->Middle; }
  double GetRadius() const { return this->Radius; }
  ///@}

  /// The cell as simplices; `room` is a buffer for them.
  virtual const skd::SimplexSet& GetSet(skd::SimplexSet& room) const = 0;

  /// The points at which a field is evaluated: the corners and the centre.
  virtual int GetNumberOfSamples() const = 0;
  virtual skd::Vector3 GetSample(int i) const = 0;

  /// The tolerance for finding the field's cell of a sample.
  double GetSampleRadius() const { return this->SampleRadius; }

  /// Whether a field's point belongs to the region.
  virtual bool Contains(const skd::Vector3& x) const = 0;

  /// Whether a cell of a tree and the region's cell have a point in common.
  virtual bool Meets(const SkdCellTree& tree, std::uint32_t cell, SkdOverlapTest test) const = 0;

protected:
  skd::Box3 Box;
  skd::Vector3 Middle;
  double Radius = 0.0;
  double SampleRadius = 0.0;
};

/// A closed box. A box without length along an axis is a rectangle, a line or a point.
class SkdBoxRegion : public SkdRegion
{
public:
  explicit SkdBoxRegion(const skd::Box3& box)
  {
    this->Box = box;
    this->Middle = box.Centroid();
    this->Radius = 0.5 * box.Diagonal();
  }

  const skd::SimplexSet& GetSet(skd::SimplexSet& room) const override
  {
    room = skd::MakeBox(this->Box);
    return room;
  }
  int GetNumberOfSamples() const override { return 9; }
  skd::Vector3 GetSample(int i) const override
  {
    const skd::Box3& box = this->Box;
    return i == 8 ? this->Middle
                  : skd::Vector3{ { i & 1 ? box.Max[0] : box.Min[0],
                      i & 2 ? box.Max[1] : box.Min[1], i & 4 ? box.Max[2] : box.Min[2] } };
  }
  bool Contains(const skd::Vector3& x) const override { return this->Box.Contains(x); }
  bool Meets(const SkdCellTree& tree, std::uint32_t cell, SkdOverlapTest test) const override
  {
    return tree.IsMet(cell, this->Box, test);
  }
};
}

#endif
