// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/SkdSurfaceSet.h"

#include "Cells/Read/SkdForEach.h"
#include "Cells/Search/SkdBuildTree.h"
#include "Curves/SkdSurfaceReader.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
//------------------------------------------------------------------------------
bool SkdSurfaceSet::Update(const std::vector<SkdBlock>& blocks, bool withVolumes, double epsilon)
{
  if (this->WithVolumes == withVolumes && this->Epsilon == epsilon &&
    this->Meshes.AreSameAs(blocks))
  {
    return false;
  }
  *this = SkdSurfaceSet();
  this->Epsilon = epsilon;
  this->WithVolumes = withVolumes;
  SkdSurfaceReader reader(withVolumes);
  const std::vector<SkdBlock> structures = this->Meshes.Keep(blocks);
  if (withVolumes)
  {
    reader.FindOuterFaces(structures);
  }
  int block = 0;
  for (const SkdBlock& structure : structures)
  {
    reader.Read(structure.Mesh, block++);
  }
  this->Elements.swap(reader.Elements);
  this->Corners.swap(reader.Corners);
  this->Controls.swap(reader.Controls);
  this->Faults = reader.GetFaults();
  this->Build(epsilon);
  return true;
}

//------------------------------------------------------------------------------
void SkdSurfaceSet::Build(double epsilon)
{
  std::vector<skd::Box3> boxes(this->Elements.size());
  SkdForEach(boxes.size(), [&](std::size_t i) { boxes[i] = this->BoundsOf(this->Elements[i]); });
  for (const skd::Box3& box : boxes)
  {
    this->Bounds.Add(box);
  }
  const double rounding =
    8.0 * std::numeric_limits<double>::epsilon() * skd::LargestCoordinate(this->Bounds);
  this->AbsoluteEpsilon = std::max(rounding, epsilon * this->Bounds.Diagonal()); // also of NaN
  this->Tree = SkdBuildTree(skd::MakeTreeInput<3>(boxes, this->AbsoluteEpsilon));
}

//------------------------------------------------------------------------------
void SkdSurfaceSet::GetTriangle(const SkdSurfaceElement& element, skd::Vector3 (&corners)[3]) const
{
  std::copy_n(this->Corners.begin() + static_cast<std::ptrdiff_t>(element.FirstPoint), 3, corners);
}

//------------------------------------------------------------------------------
skd::BezierPatch SkdSurfaceSet::GetPatch(
  const SkdSurfaceElement& element, const skd::Vector3& origin) const
{
  skd::BezierPatch patch;
  if (!element.IsPatch)
  {
    skd::Vector3 p[3];
    this->GetTriangle(element, p);
    patch.IsTriangle = true;
    patch.Point(0, 0) = skd::Weighted(p[0] - origin, 1.0);
    patch.Point(1, 0) = skd::Weighted(p[1] - origin, 1.0);
    patch.Point(0, 1) = skd::Weighted(p[2] - origin, 1.0);
    patch.Point(1, 1) = skd::Weighted((p[1] - origin) + (p[2] - p[0]), 1.0);
    return patch;
  }
  patch.DegreeR = element.DegreeR;
  patch.DegreeS = element.DegreeS;
  patch.IsTriangle = element.IsTriangle;
  const skd::Homogeneous* stored = this->Controls.data() + element.FirstPoint;
  const skd::Vector3 shift = skd::Space(stored[0]) - origin;
  for (int i = 0; i < patch.Size(); ++i)
  {
    patch.Points[i] = skd::Shifted(stored[i + 1], shift);
  }
  return patch;
}

//------------------------------------------------------------------------------
// A triangle's control points beyond its long side need not be near it: those of its three quarters
// of the square that hold it are.
skd::Box3 SkdSurfaceSet::BoundsOf(const SkdSurfaceElement& element) const
{
  skd::Box3 bounds;
  if (!element.IsPatch)
  {
    skd::Vector3 corners[3];
    this->GetTriangle(element, corners);
    for (const skd::Vector3& corner : corners)
    {
      bounds.Add(corner);
    }
    return bounds;
  }
  const skd::Vector3 origin = skd::Space(this->Controls[element.FirstPoint]);
  bounds = skd::BoundsOnDomain(this->GetPatch(element, origin));
  return { bounds.Min + origin, bounds.Max + origin };
}

//------------------------------------------------------------------------------
void SkdSurfaceSet::AssignParts(
  const std::vector<SkdBlock>& blocks, const std::vector<std::vector<int>>& idsOfCells)
{
  for (SkdSurfaceElement& element : this->Elements)
  {
    const auto block = static_cast<std::size_t>(element.Block);
    const int first = blocks[block].FirstPiece;
    element.Part = !idsOfCells.empty() ? idsOfCells[block][static_cast<std::size_t>(element.CellId)]
                                       : (first >= 0 ? first : blocks[block].BlockIndex);
  }
}
}
