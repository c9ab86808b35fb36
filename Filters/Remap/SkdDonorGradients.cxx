// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdDonorGradients.h"

#include "Bodies/SkdWeld.h"
#include "Cells/Read/SkdCellReader.h"
#include "Cells/Read/SkdForEach.h"
#include "Remap/SkdRemapTolerances.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
namespace
{
skd::Vector3 Times(const std::array<double, 6>& m, const skd::Vector3& v)
{
  return { { m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[1] * v[0] + m[3] * v[1] + m[4] * v[2],
    m[2] * v[0] + m[4] * v[1] + m[5] * v[2] } };
}

/// Two directions across one that are across each other.
std::array<skd::Vector3, 2> AxesAcross(const skd::Vector3& direction)
{
  const int axis = std::abs(direction[0]) < std::abs(direction[1]) ? 0 : 1;
  skd::Vector3 aside{ { 0.0, 0.0, 0.0 } };
  aside[axis] = 1.0;
  const skd::Vector3 first = skd::Cross(aside, direction);
  const skd::Vector3 second = skd::Cross(direction, first);
  return { (1.0 / skd::Norm(first)) * first, (1.0 / skd::Norm(second)) * second };
}

/// The inverse on the space that the matrix spans, 0 across it: cells of a surface, or of a layer
/// one cell thick, have no gradient across.
std::array<double, 6> PseudoInverse(const std::array<double, 6>& m)
{
  double rows[3][3] = { { m[0], m[1], m[2] }, { m[1], m[3], m[4] }, { m[2], m[4], m[5] } };
  double values[3], vectors[3][3];
  double* a[3] = { rows[0], rows[1], rows[2] };
  double* v[3] = { vectors[0], vectors[1], vectors[2] };
  vtkMath::Jacobi(a, values, v); // values descending, vectors in columns
  std::array<double, 6> inverse{};
  for (int k = 0; k < 3; ++k)
  {
    if (values[k] > remap_tolerances::Flatness * values[0])
    {
      int at = 0;
      for (int i = 0; i < 3; ++i)
      {
        for (int j = i; j < 3; ++j)
        {
          inverse[static_cast<std::size_t>(at++)] += vectors[i][k] * vectors[j][k] / values[k];
        }
      }
    }
  }
  return inverse;
}
}

SkdDonorGradients::SkdDonorGradients(
  vtkDataSet* donor, const SkdOverlapCells& cells, const skd::Vector3& normal, bool isOnSphere)
  : Measures(cells.Measures)
  , Centroids(cells.Centroids)
  , Normals(cells.Normals)
  , Normal(normal)
  , IsOnSphere(isOnSphere)
{
  this->ReadCorners(donor);
  this->FindNeighbours(static_cast<vtkIdType>(this->Points.size()));
  if (this->Normals.empty())
  {
    this->InvertAll();
  }
}

void SkdDonorGradients::ReadCorners(vtkDataSet* donor)
{
  const vtkIdType n = donor->GetNumberOfCells();
  const SkdCellReader reader(donor);
  SkdWeld weld;
  vtkNew<vtkIdList> list;
  std::vector<vtkIdType> corners;
  for (vtkIdType cell = 0; cell < n; ++cell)
  {
    corners.clear();
    if (this->Has(cell))
    {
      reader.VisitPoints(cell, list,
        [&](const auto* ids, std::size_t size)
        {
          for (std::size_t i = 0; i < size; ++i)
          {
            skd::Vector3 x;
            donor->GetPoint(ids[i], x.X);
            const vtkIdType id = weld.GetId(x.X);
            if (static_cast<std::size_t>(id) == this->Points.size())
            {
              this->Points.push_back(x);
            }
            corners.push_back(id);
          }
        });
    }
    this->Corners.Add(corners.begin(), corners.end());
  }
}

void SkdDonorGradients::FindNeighbours(vtkIdType numberOfPoints)
{
  const std::size_t n = this->Measures.size();
  std::vector<std::vector<vtkIdType>> cellsAt(static_cast<std::size_t>(numberOfPoints));
  for (std::size_t cell = 0; cell < n; ++cell)
  {
    for (const vtkIdType corner : this->Corners[cell])
    {
      cellsAt[static_cast<std::size_t>(corner)].push_back(static_cast<vtkIdType>(cell));
    }
  }
  std::vector<vtkIdType> around;
  for (std::size_t cell = 0; cell < n; ++cell)
  {
    around.clear();
    for (const vtkIdType corner : this->Corners[cell])
    {
      const std::vector<vtkIdType>& some = cellsAt[static_cast<std::size_t>(corner)];
      around.insert(around.end(), some.begin(), some.end());
    }
    std::sort(around.begin(), around.end());
    auto last = std::unique(around.begin(), around.end());
    last = std::remove(around.begin(), last, static_cast<vtkIdType>(cell));
    this->Neighbours.Add(around.begin(), last);
  }
}

// In a plane what rounding leaves across it is left out.
skd::Vector3 SkdDonorGradients::StepTo(vtkIdType cell, const skd::Vector3& x) const
{
  const skd::Vector3 step = x - this->Centroids[static_cast<std::size_t>(cell)];
  return step - skd::Dot(step, this->Normal) * this->Normal;
}

template <class Wanted>
SkdDonorGradients::Matrix SkdDonorGradients::Invert(vtkIdType cell, const Wanted& isWanted) const
{
  Matrix sum{};
  const auto at = static_cast<std::size_t>(cell);
  for (const vtkIdType other : this->Neighbours[at])
  {
    const skd::Vector3 d = this->StepTo(cell, this->Centroids[static_cast<std::size_t>(other)]);
    const double length2 = skd::Norm2(d);
    if (isWanted(other) && length2 > 0.0)
    {
      const double w = 1.0 / length2;
      const double products[] = { d[0] * d[0], d[0] * d[1], d[0] * d[2], d[1] * d[1], d[1] * d[2],
        d[2] * d[2] };
      std::transform(sum.begin(), sum.end(), products, sum.begin(),
        [w](double s, double product) { return s + w * product; });
    }
  }
  return PseudoInverse(sum);
}

void SkdDonorGradients::InvertAll()
{
  this->Inverses.resize(this->Measures.size());
  SkdForEach(this->Inverses.size(),
    [this](std::size_t cell)
    {
      this->Inverses[cell] =
        this->Invert(static_cast<vtkIdType>(cell), [](vtkIdType) { return true; });
    });
}

skd::Vector3 SkdDonorGradients::Fit(vtkIdType cell, const SkdDonorField& field, int component) const
{
  const auto at = static_cast<std::size_t>(cell);
  const auto counts = [&](vtkIdType other)
  { return field.Counts[static_cast<std::size_t>(other)] != 0; };
  const double here = field.Get(cell, component);
  skd::Vector3 right{ { 0.0, 0.0, 0.0 } };
  bool isWhole = true;
  for (const vtkIdType other : this->Neighbours[at])
  {
    const skd::Vector3 d = this->StepTo(cell, this->Centroids[static_cast<std::size_t>(other)]);
    const double length2 = skd::Norm2(d);
    isWhole = isWhole && counts(other);
    if (counts(other) && length2 > 0.0)
    {
      right = right + ((field.Get(other, component) - here) / length2) * d;
    }
  }
  return Times(isWhole ? this->Inverses[at] : this->Invert(cell, counts), right);
}

std::array<skd::Vector3, 2> SkdDonorGradients::AxesOf(std::size_t cell) const
{
  return AxesAcross(this->Normals.empty() ? this->Centroids[cell] : this->Normals[cell]);
}

// Of a curved surface as long as it is: around a sharp edge the distance counts.
std::array<double, 2> SkdDonorGradients::FlatStep(
  std::size_t cell, std::size_t other, const std::array<skd::Vector3, 2>& axes) const
{
  const skd::Vector3 step = this->Centroids[other] - this->Centroids[cell];
  const double u = skd::Dot(step, axes[0]), v = skd::Dot(step, axes[1]);
  const double flat2 = u * u + v * v;
  const bool isCurved = !this->Normals.empty() && flat2 > 0.0;
  const double stretch = isCurved ? std::sqrt(skd::Norm2(step) / flat2) : 1.0;
  return { stretch * u, stretch * v };
}

// In two axes across the centroid's direction, or the normal. Neighbours in one line have no
// gradient aside of it.
skd::Vector3 SkdDonorGradients::FitTangential(
  vtkIdType cell, const SkdDonorField& field, int component) const
{
  const auto at = static_cast<std::size_t>(cell);
  const auto axes = this->AxesOf(at);
  const double here = field.Get(cell, component);
  double xx = 0.0, xy = 0.0, yy = 0.0, x = 0.0, y = 0.0;
  for (const vtkIdType neighbour : this->Neighbours[at])
  {
    const auto other = static_cast<std::size_t>(neighbour);
    const auto [u, v] = this->FlatStep(at, other, axes);
    const double length2 = u * u + v * v;
    if (field.Counts[other] != 0 && length2 > 0.0)
    {
      const double change = (field.Get(neighbour, component) - here) / length2;
      xx += u * u / length2;
      xy += u * v / length2;
      yy += v * v / length2;
      x += change * u;
      y += change * v;
    }
  }
  const double trace = xx + yy, area = xx * yy - xy * xy;
  if (!(area > remap_tolerances::Flatness * trace * trace))
  {
    const double by = trace > 0.0 ? 1.0 / (trace * trace) : 0.0;
    return (by * (xx * x + xy * y)) * axes[0] + (by * (xy * x + yy * y)) * axes[1];
  }
  return ((yy * x - xy * y) / area) * axes[0] + ((xx * y - xy * x) / area) * axes[1];
}

SkdCellRanges SkdDonorGradients::FindRanges(const SkdDonorField& field, int component) const
{
  SkdCellRanges ranges(this->Measures.size());
  SkdForEach(ranges.size(),
    [&](std::size_t at)
    {
      const double here = field.Get(static_cast<vtkIdType>(at), component);
      SkdCellRange range{ here, here };
      for (const vtkIdType other : this->Neighbours[at])
      {
        if (field.Counts[static_cast<std::size_t>(other)] != 0)
        {
          range.Least = std::min(range.Least, field.Get(other, component));
          range.Greatest = std::max(range.Greatest, field.Get(other, component));
        }
      }
      ranges[at] = range;
    });
  return ranges;
}

double SkdDonorGradients::ShareWithin(
  vtkIdType cell, double here, const SkdCellRange& range, const skd::Vector3& gradient) const
{
  const auto at = static_cast<std::size_t>(cell);
  double share = 1.0;
  for (const vtkIdType id : this->Corners[at])
  {
    const skd::Vector3& corner = this->Points[static_cast<std::size_t>(id)];
    const double change = skd::Dot(gradient, this->StepTo(cell, corner));
    const double room = change > 0.0 ? range.Greatest - here : range.Least - here;
    share = change != 0.0 ? std::min(share, room / change) : share;
  }
  return share;
}

void SkdDonorGradients::Limit(const SkdDonorField& field, int component,
  const SkdCellRanges& ranges, std::vector<skd::Vector3>& gradients) const
{
  SkdForEach(gradients.size(),
    [&](std::size_t at)
    {
      const auto cell = static_cast<vtkIdType>(at);
      if (this->Has(cell) && field.Counts[at] != 0)
      {
        const double here = field.Get(cell, component);
        gradients[at] = this->ShareWithin(cell, here, ranges[at], gradients[at]) * gradients[at];
      }
    });
}

template <class Fitting>
std::vector<skd::Vector3> SkdDonorGradients::FitAll(
  const SkdDonorField& field, const Fitting& fit) const
{
  std::vector<skd::Vector3> gradients(this->Measures.size(), skd::Vector3{ { 0.0, 0.0, 0.0 } });
  SkdForEach(gradients.size(),
    [&](std::size_t at)
    {
      const auto cell = static_cast<vtkIdType>(at);
      if (this->Has(cell) && field.Counts[at] != 0)
      {
        gradients[at] = fit(cell);
      }
    });
  return gradients;
}

std::vector<skd::Vector3> SkdDonorGradients::Find(const SkdDonorField& field, int component) const
{
  const bool isCurved = !this->Normals.empty();
  return this->FitAll(field,
    [&](vtkIdType cell)
    {
      return isCurved ? this->FitTangential(cell, field, component)
                      : this->Fit(cell, field, component);
    });
}

std::vector<skd::Vector3> SkdDonorGradients::FindTangential(
  const SkdDonorField& field, int component, const std::vector<char>& wanted) const
{
  const skd::Vector3 none{ { 0.0, 0.0, 0.0 } };
  return this->FitAll(field,
    [&](vtkIdType cell)
    {
      const bool isWanted = wanted[static_cast<std::size_t>(cell)] != 0;
      return isWanted ? this->FitTangential(cell, field, component) : none;
    });
}
}
