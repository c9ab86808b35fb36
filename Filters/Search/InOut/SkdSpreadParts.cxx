// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/InOut/SkdSpreadParts.h"

#include "Search/InOut/SkdPartClassifier.h"
#include "vtkBoundingBox.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
int SkdSpreadParts::Update(const SkdSpreadSource& spread, double epsilon)
{
  if (this->Known == spread.GetOwn() && this->Epsilon == epsilon)
  {
    for (Part& part : this->Parts)
    {
      part.RequestsBefore = part.Body.CountRequests();
    }
    return 0;
  }
  this->Parts.clear();
  for (const SkdBlock& block : spread.BringTouching())
  {
    Part part{ block.BlockIndex, SkdSpreadBody(spread, { block }, epsilon), 0.0 };
    const vtkBoundingBox box(part.Body.GetBounds());
    part.Diagonal = box.IsValid() ? box.GetDiagonalLength() : 0.0;
    this->Parts.push_back(std::move(part));
  }
  this->Known = spread.GetOwn();
  this->Epsilon = epsilon;
  return static_cast<int>(this->Parts.size());
}

bool SkdSpreadParts::HaveFaces() const
{
  return std::any_of(this->Parts.begin(), this->Parts.end(),
    [](const Part& part) { return part.Body.GetNumberOfFaces() > 0; });
}

bool SkdSpreadParts::AreFit() const
{
  return std::all_of(
    this->Parts.begin(), this->Parts.end(), [](const Part& part) { return part.Body.IsFit(); });
}

std::uint64_t SkdSpreadParts::CountRequests() const
{
  std::uint64_t requests = 0;
  for (const Part& part : this->Parts)
  {
    requests += part.Body.CountRequests() - part.RequestsBefore;
  }
  return requests;
}

SkdSpreadResult SkdSpreadParts::Ask(
  const SkdQueryPoints& points, SkdLoop& loop, std::vector<SkdInOut>& answers)
{
  const auto n = static_cast<std::size_t>(points.GetNumber());
  answers.assign(n, SkdInOut());
  std::vector<double> smallest(n, VTK_DOUBLE_MAX);
  std::vector<char> isFinite(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    double x[3];
    points.GetPoint(static_cast<vtkIdType>(i), x);
    isFinite[i] = SkdBegin(x, answers[i]) ? 1 : 0;
  }
  for (Part& part : this->Parts)
  {
    std::vector<char> isInside(n, 0);
    const SkdSpreadResult result = AskPart(part, points, loop, isInside);
    if (result != SkdSpreadResult::Done)
    {
      answers.assign(n, SkdInOut());
      return result;
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      if (isFinite[i] != 0)
      {
        SkdAddSide({ isInside[i] != 0, 1.0 }, part.Id, part.Diagonal, smallest[i], answers[i]);
      }
    }
  }
  return SkdSpreadResult::Done;
}

SkdSpreadResult SkdSpreadParts::AskPart(
  Part& part, const SkdQueryPoints& points, SkdLoop& loop, std::vector<char>& isInside)
{
  const std::vector<char> isDue = AskRows(part, points, isInside);
  return part.Body.FindSides(
    isInside.size(),
    [&](std::size_t i)
    {
      skd::Vector3 x;
      points.GetPoint(static_cast<vtkIdType>(i), x.X);
      return x;
    },
    [&](std::size_t i) { return isDue[i] != 0; },
    [&](std::size_t i, bool is) { isInside[i] = is ? 1 : 0; }, loop);
}

// Returns which points remain to be classified one by one.
std::vector<char> SkdSpreadParts::AskRows(
  Part& part, const SkdQueryPoints& points, std::vector<char>& isInside)
{
  const vtkIdType length = points.GetRowLength();
  std::vector<char> isDue(isInside.size(), length > 0 ? 0 : 1);
  const auto rows = static_cast<std::size_t>(length > 0 ? points.GetNumber() / length : 0);
  const auto lineOf = [&](std::size_t number)
  {
    const SkdQueryRow row(points, static_cast<vtkIdType>(number));
    return SkdLineThrough(part.Body.GetBounds(), part.Diagonal, row.From, row.Along, row.Length);
  };
  part.Body.FindPasses(
    rows,
    [&](std::size_t number)
    {
      const SkdLineThrough line = lineOf(number);
      return SkdSpreadBody::Line{ line.From, line.To };
    },
    [&](std::size_t number, std::vector<SkdPassAlong> passes)
    {
      const SkdLineThrough line = lineOf(number);
      const SkdQueryRow row(points, static_cast<vtkIdType>(number));
      for (SkdPassAlong& pass : passes)
      {
        pass.At *= line.Length;
        pass.At += line.Start;
      }
      for (vtkIdType k = 0; k < length; ++k)
      {
        const vtkIdType point = static_cast<vtkIdType>(number) * length + k;
        double x[3];
        points.GetPoint(point, x);
        const int around = part.Body.BoundsHold(x) ? row.FindAround(x, passes) : 0;
        isInside[static_cast<std::size_t>(point)] = around != 0 ? 1 : 0;
        isDue[static_cast<std::size_t>(point)] = std::abs(around) > 1 ? 1 : 0;
      }
    });
  return isDue;
}
}
