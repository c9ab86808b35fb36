// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Search/InOut/SkdPartClassifier.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace skdtree
{
SkdQueryRow::SkdQueryRow(const SkdQueryPoints& queryPoints, vtkIdType number)
{
  const vtkIdType length = queryPoints.GetRowLength();
  double last[3];
  queryPoints.GetPoint(number * length, this->From);
  queryPoints.GetPoint(number * length + length - 1, last);
  vtkMath::Subtract(last, this->From, this->Along);
  this->Length = vtkMath::Normalize(this->Along);
}

int SkdQueryRow::FindAround(const double x[3], const std::vector<SkdPassAlong>& passes) const
{
  double away[3];
  vtkMath::Subtract(x, this->From, away);
  const auto next = std::lower_bound(passes.begin(), passes.end(), vtkMath::Dot(away, this->Along),
    [](const SkdPassAlong& pass, double at) { return pass.At < at; });
  return next == passes.begin() ? 0 : std::prev(next)->After;
}

void SkdAddSide(
  const SkdSide& side, int partId, double diagonal, double& smallest, SkdInOut& answer)
{
  answer.Confidence = std::min(answer.Confidence, side.Confidence);
  answer.WindingNumber += side.WindingNumber;
  answer.WindingBound += side.WindingBound;
  answer.IsInside = answer.IsInside || side.IsInside;
  answer.Depth += side.IsInside ? 1 : 0;
  if (side.IsInside && diagonal < smallest)
  {
    smallest = diagonal;
    answer.PartId = partId;
  }
}

bool SkdBegin(const double x[3], SkdInOut& answer)
{
  const bool isFinite = std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
  answer.Confidence = isFinite ? 1.0 : 0.0;
  if (!isFinite)
  {
    answer.WindingNumber = vtkMath::Nan();
    answer.WindingBound = vtkMath::Nan();
  }
  return isFinite;
}

SkdPartClassifier::SkdPartClassifier(const std::vector<SkdPart>& parts, const SkdInsideRules& rules,
  double band, const SkdQueryPoints& queryPoints)
  : Parts(parts)
  , Rules(rules)
  , Band(band)
  , QueryPoints(queryPoints)
  , UsesRows(queryPoints.GetRowLength() > 0 && rules.Method != SkdInsideMethod::WindingNumber &&
      rules.Method != SkdInsideMethod::NearestFeature)
{
  this->TheRow.Passes.resize(this->UsesRows ? parts.size() : 0);
}

bool SkdPartClassifier::HasRowOf(const SkdPart& part) const
{
  return this->UsesRows && part.GetNumberOfOpenEdges() == 0;
}

void SkdPartClassifier::GoToRow(vtkIdType number)
{
  Row& row = this->TheRow;
  row.Number = number;
  row.Line = SkdQueryRow(this->QueryPoints, number);
  for (std::size_t part = 0; part < this->Parts.size(); ++part)
  {
    row.Passes[part].clear();
    if (this->HasRowOf(this->Parts[part]))
    {
      this->Parts[part].FindPasses(
        row.Line.From, row.Line.Along, row.Line.Length, this->Rules.Method, row.Passes[part]);
    }
  }
}

SkdSide SkdPartClassifier::AskRow(
  std::size_t part, const double x[3], std::uint64_t queryPoint) const
{
  if (!this->Parts[part].BoundsHold(x))
  {
    return SkdSide();
  }
  const int around = this->TheRow.Line.FindAround(x, this->TheRow.Passes[part]);
  return std::abs(around) > 1 ? this->Parts[part].AskSide(x, this->Rules, queryPoint)
                              : SkdSide{ around != 0, 1.0 };
}

SkdInOut SkdPartClassifier::Ask(vtkIdType queryPoint)
{
  SkdInOut answer;
  double x[3];
  this->QueryPoints.GetPoint(queryPoint, x);
  if (!SkdBegin(x, answer))
  {
    return answer;
  }
  if (this->UsesRows && queryPoint / this->QueryPoints.GetRowLength() != this->TheRow.Number)
  {
    this->GoToRow(queryPoint / this->QueryPoints.GetRowLength());
  }
  double smallest = VTK_DOUBLE_MAX;
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    const SkdPart& part = this->Parts[i];
    const auto number = static_cast<std::uint64_t>(queryPoint);
    const SkdSide side =
      this->HasRowOf(part) ? this->AskRow(i, x, number) : part.AskSide(x, this->Rules, number);
    answer.IsOnBoundary = answer.IsOnBoundary || (this->Band > 0.0 && part.IsNear(x, this->Band));
    SkdAddSide(side, part.GetId(), part.GetDiagonal(), smallest, answer);
  }
  return answer;
}
}
