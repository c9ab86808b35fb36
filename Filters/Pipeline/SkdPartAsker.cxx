// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdPartAsker.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

SkdPartAsker::SkdPartAsker(const std::vector<SkdPart>& parts, const SkdInsideRules& rules,
  double band, const SkdQuestions& questions)
  : Parts(parts)
  , Rules(rules)
  , Band(band)
  , Questions(questions)
  , UsesRows(questions.GetRowLength() > 0 && rules.Method != SkdInsideMethod::WindingNumber &&
      rules.Method != SkdInsideMethod::NearestFeature)
{
  this->TheRow.Passes.resize(this->UsesRows ? parts.size() : 0);
}

bool SkdPartAsker::HasRowOf(const SkdPart& part) const
{
  return this->UsesRows && part.GetNumberOfOpenEdges() == 0;
}

void SkdPartAsker::GoToRow(vtkIdType number)
{
  Row& row = this->TheRow;
  const vtkIdType length = this->Questions.GetRowLength();
  double last[3];
  row.Number = number;
  this->Questions.GetPoint(number * length, row.From);
  this->Questions.GetPoint(number * length + length - 1, last);
  vtkMath::Subtract(last, row.From, row.Along);
  const double distance = vtkMath::Normalize(row.Along);
  for (std::size_t part = 0; part < this->Parts.size(); ++part)
  {
    row.Passes[part].clear();
    if (this->HasRowOf(this->Parts[part]))
    {
      this->Parts[part].FindPasses(row.From, row.Along, distance, row.Passes[part]);
    }
  }
}

bool SkdPartAsker::IsInsideByRow(std::size_t part, const double x[3]) const
{
  double away[3];
  vtkMath::Subtract(x, this->TheRow.From, away);
  const std::vector<double>& passes = this->TheRow.Passes[part];
  const auto next =
    std::lower_bound(passes.begin(), passes.end(), vtkMath::Dot(away, this->TheRow.Along));
  return (next - passes.begin()) % 2 == 1;
}

SkdInOut SkdPartAsker::Ask(vtkIdType question)
{
  SkdInOut answer;
  double x[3];
  this->Questions.GetPoint(question, x);
  if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
  {
    answer.WindingNumber = vtkMath::Nan();
    return answer;
  }
  if (this->UsesRows && question / this->Questions.GetRowLength() != this->TheRow.Number)
  {
    this->GoToRow(question / this->Questions.GetRowLength());
  }
  answer.Confidence = 1.0;
  double smallest = VTK_DOUBLE_MAX;
  for (std::size_t i = 0; i < this->Parts.size(); ++i)
  {
    const SkdPart& part = this->Parts[i];
    const SkdSide side = this->HasRowOf(part)
      ? SkdSide{ part.BoundsHold(x) && this->IsInsideByRow(i, x), 1.0 }
      : part.AskSide(x, this->Rules, static_cast<std::uint64_t>(question));
    answer.Confidence = std::min(answer.Confidence, side.Confidence);
    answer.IsOnBoundary = answer.IsOnBoundary || (this->Band > 0.0 && part.IsNear(x, this->Band));
    answer.WindingNumber += part.GetWindingNumber(x);
    answer.IsInside = answer.IsInside || side.IsInside;
    answer.Depth += side.IsInside ? 1 : 0;
    if (side.IsInside && part.GetDiagonal() < smallest)
    {
      smallest = part.GetDiagonal();
      answer.PartId = part.GetId();
    }
  }
  return answer;
}
