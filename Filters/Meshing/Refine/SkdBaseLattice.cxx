// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshing/Refine/SkdBaseLattice.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkRectilinearGrid.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
/// A number of cells exceeds a whole number by rounding only, if by less than this.
constexpr double CellRounding = 1e-9;

using Planes = std::array<std::vector<double>, 3>;

constexpr double MostCells = 1 << 20; // along an axis

skd::Box3 WithMargin(skd::Box3 box, double margin)
{
  const double by = margin * box.Length(box.LongestAxis());
  for (int axis = 0; axis < 3; ++axis)
  {
    if (box.Length(axis) > 0.0)
    {
      box.Min[axis] -= by;
      box.Max[axis] += by;
    }
  }
  return box;
}

/// The side of cubes that fill the box, except for the last ones along each axis: about as long as
/// the shortest side, and not too short for the longest. Slightly more than a whole number of cubes
/// gives that number of slightly larger ones.
double SizeOfCubes(const skd::Box3& box)
{
  const double longest = box.Length(box.LongestAxis());
  double shortest = longest;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = box.Length(axis);
    shortest = length > 0.0 ? std::min(shortest, length) : shortest;
  }
  const double size = std::max(shortest, longest / 64.0);
  double grown = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double cells = std::max(1.0, std::ceil(box.Length(axis) / size - 0.05));
    grown = std::max(grown, box.Length(axis) / cells);
  }
  return grown;
}

/// n equal cells from min to max.
std::vector<double> Divided(double min, double max, int n)
{
  std::vector<double> planes;
  for (int i = 0; i < n; ++i)
  {
    planes.push_back(min + (static_cast<double>(i) / n) * (max - min));
  }
  planes.push_back(max);
  return planes;
}

/// As many cells of a size as hold the interval, about its middle.
std::vector<double> Cubes(double min, double max, double size)
{
  const double cells = std::max(1.0, std::ceil((max - min) / size - CellRounding));
  const double middle = 0.5 * min + 0.5 * max;
  const double half = std::max(0.5 * cells * size, 0.5 * (max - min));
  return Divided(middle - half, middle + half, static_cast<int>(cells));
}

std::string ComplaintAbout(const Planes& planes)
{
  for (const std::vector<double>& along : planes)
  {
    for (std::size_t i = 0; i < along.size(); ++i)
    {
      if (!std::isfinite(along[i]) || (i > 0 && !(along[i - 1] < along[i])))
      {
        return "its coordinates are not finite and ascending";
      }
    }
  }
  return "";
}

SkdBaseLattice Checked(const Planes& planes, int branch)
{
  const std::string complaint = ComplaintAbout(planes);
  if (!complaint.empty())
  {
    return { std::nullopt, complaint };
  }
  double cells = 1.0;
  for (const std::vector<double>& along : planes)
  {
    cells *= std::max<double>(1.0, static_cast<double>(along.size()) - 1.0);
  }
  if (!(cells < 4e9))
  {
    return { std::nullopt, "it has more than 4e9 cells" };
  }
  return { skd::Lattice(planes, branch), "" };
}

std::vector<double> CoordinatesOf(vtkDataArray* array)
{
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetTuple1(i));
  }
  return values;
}

std::vector<double> CoordinatesOf(vtkImageData* image, int axis)
{
  const int* extent = image->GetExtent();
  std::vector<double> values;
  for (int i = extent[2 * axis]; i <= extent[2 * axis + 1]; ++i)
  {
    values.push_back(image->GetOrigin()[axis] + i * image->GetSpacing()[axis]);
  }
  return values;
}
}

//------------------------------------------------------------------------------
SkdBaseLattice SkdMakeBaseLattice(
  const SkdBaseSettings& settings, const skd::Box3& parts, int branch)
{
  const bool isGiven = !settings.Bounds.IsEmpty();
  if (!isGiven && parts.IsEmpty())
  {
    return { std::nullopt, "there are no parts to take its bounds from; set BaseBounds" };
  }
  const skd::Box3 box = isGiven ? settings.Bounds : WithMargin(parts, settings.Margin);
  if (!skd::IsFinite(box.Max - box.Min))
  {
    return { std::nullopt, "its bounds are not finite" };
  }
  const double size = settings.CellSize > 0.0 ? settings.CellSize : SizeOfCubes(box);
  Planes planes;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = box.Length(axis);
    const int requested = settings.CellSize > 0.0 ? 0 : settings.Dimensions[axis];
    if (!(length > 0.0))
    {
      planes[axis] = { box.Min[axis] };
    }
    else if (requested > 0 && requested <= MostCells)
    {
      planes[axis] = Divided(box.Min[axis], box.Max[axis], requested);
    }
    else if (requested > 0 || length / size > MostCells)
    {
      return { std::nullopt, "it has more than 2^20 cells along an axis" };
    }
    else
    {
      planes[axis] = Cubes(box.Min[axis], box.Max[axis], size);
    }
  }
  return Checked(planes, branch);
}

//------------------------------------------------------------------------------
SkdBaseLattice SkdTakeBaseLattice(vtkDataObject* grid, int branch)
{
  Planes planes;
  if (auto image = vtkImageData::SafeDownCast(grid))
  {
    if (!image->GetDirectionMatrix()->IsIdentity())
    {
      return { std::nullopt,
        "BaseMesh is an image with a direction matrix, which is not supported" };
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      planes[axis] = CoordinatesOf(image, axis);
    }
  }
  else if (auto rectilinear = vtkRectilinearGrid::SafeDownCast(grid))
  {
    planes = { CoordinatesOf(rectilinear->GetXCoordinates()),
      CoordinatesOf(rectilinear->GetYCoordinates()),
      CoordinatesOf(rectilinear->GetZCoordinates()) };
  }
  if (planes[0].empty() || planes[1].empty() || planes[2].empty())
  {
    return { std::nullopt, "BaseMesh must be an image or rectilinear grid with points" };
  }
  return Checked(planes, branch);
}
}
