// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/SkdCutCurves.h"

#include "Curves/SkdCurveSpans.h"
#include "Pipeline/SkdJoinedIds.h"
#include "Pipeline/SkdMakeArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace skdtree
{
namespace
{
/// The parts around, the one entered last at the end.
class PartsAround
{
public:
  explicit PartsAround(std::vector<int> parts)
    : Parts(std::move(parts))
  {
    std::reverse(this->Parts.begin(), this->Parts.end()); // what is left first was entered last
  }

  void Pass(int part)
  {
    const auto known = std::find(this->Parts.begin(), this->Parts.end(), part);
    if (known == this->Parts.end())
    {
      this->Parts.push_back(part);
    }
    else
    {
      this->Parts.erase(known);
    }
  }

  int Count() const { return static_cast<int>(this->Parts.size()); }
  int Last() const { return this->Parts.empty() ? -1 : this->Parts.back(); }

private:
  std::vector<int> Parts;
};

class Cutter
{
public:
  Cutter(const SkdCutTask& task, vtkPolyData* output)
    : Task(task)
    , Output(output)
    , JoinedIds(SkdJoinedIdsOf(task.CurveBlocks))
  {
    this->Points->SetDataTypeToDouble();
  }

  void CutCurve(
    std::size_t number, const SkdSurfaceIntersection* first, const SkdSurfaceIntersection* last)
  {
    const SkdCurve& curve = this->Task.Curves.GetCurves()[number];
    const skd::Vector3 start = this->Task.Curves.GetPiece(curve.FirstPiece, {}).Start();
    PartsAround parts(this->Task.Finder.FindPartsAround(start));
    this->Number = 0;
    this->Begin();
    this->AddPoint(curve.FirstPiece, 0.0, start);
    std::size_t piece = curve.FirstPiece;
    double t = 0.0;
    for (; first != last; ++first)
    {
      const SkdSurfaceHit& hit = first->Hit;
      this->AdvanceTo(piece, t, hit.Piece, hit.T);
      this->Finish(number, parts);
      if (first->Sense != 0)
      {
        parts.Pass(this->Task.Elements[hit.Element].Part);
      }
      this->Begin();
      this->AddPoint(piece, t, hit.X);
    }
    this->AdvanceTo(piece, t, curve.LastPiece - 1, 1.0);
    this->Finish(number, parts);
  }

  void Store(bool isComposite)
  {
    this->Output->SetPoints(this->Points);
    this->Output->SetLines(this->Lines);
    this->Output->GetPointData()->AddArray(this->Parameters);
    vtkCellData* cells = this->Output->GetCellData();
    for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{
           this->CurveIds, this->CellIds, this->Numbers, this->PartsInside, this->PartIds })
    {
      cells->AddArray(array);
    }
    if (isComposite)
    {
      cells->AddArray(this->CurveBlocks);
    }
    cells->SetActiveScalars("SkdPartsInside");
  }

private:
  void Begin() { this->Ids.clear(); }

  void AddPoint(std::size_t piece, double t, const skd::Vector3& x)
  {
    this->Ids.push_back(this->Points->InsertNextPoint(x.X));
    this->Parameters->InsertNextValue(this->Task.Curves.GetParameter(piece, t));
  }

  /// All points of the polyline after (piece, t) up to another location.
  void AdvanceTo(std::size_t& piece, double& t, std::size_t lastPiece, double lastT)
  {
    for (; piece < lastPiece; ++piece, t = 0.0)
    {
      this->AddInterval(piece, t, 1.0);
    }
    if (lastT > t)
    {
      this->AddInterval(piece, t, lastT);
      t = lastT;
    }
  }

  void AddInterval(std::size_t piece, double from, double to)
  {
    if (!(to > from))
    {
      return;
    }
    const skd::BezierCurve whole = this->Task.Curves.GetPiece(piece, {});
    SkdVisitSpans(whole.Restricted(from, to), this->Task.Delta,
      [&](const skd::BezierCurve& part, const skd::Interval& range)
      { this->AddPoint(piece, from + range.Max * (to - from), part.End()); });
  }

  /// A piece without length is none.
  void Finish(std::size_t number, const PartsAround& parts)
  {
    if (this->Ids.size() < 2)
    {
      return;
    }
    const SkdCurve& curve = this->Task.Curves.GetCurves()[number];
    this->Lines->InsertNextCell(static_cast<vtkIdType>(this->Ids.size()), this->Ids.data());
    this->CurveIds->InsertNextValue(this->Task.Numbers[number]);
    this->CellIds->InsertNextValue(
      this->JoinedIds[static_cast<std::size_t>(curve.Block)].Of(curve.CellId));
    this->CurveBlocks->InsertNextValue(
      this->Task.CurveBlocks[static_cast<std::size_t>(curve.Block)].BlockIndex);
    this->Numbers->InsertNextValue(this->Number++);
    this->PartsInside->InsertNextValue(parts.Count());
    this->PartIds->InsertNextValue(parts.Last());
  }

  const SkdCutTask& Task;
  vtkPolyData* Output;
  std::vector<SkdJoinedIds> JoinedIds;
  std::vector<vtkIdType> Ids;
  vtkIdType Number = 0;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkSmartPointer<vtkDoubleArray> Parameters =
    SkdMakeArray<vtkDoubleArray>("SkdCurveParameter", 1, 0);
  vtkSmartPointer<vtkIdTypeArray> CurveIds = SkdMakeArray<vtkIdTypeArray>("SkdCurveId", 1, 0);
  vtkSmartPointer<vtkIdTypeArray> CellIds = SkdMakeArray<vtkIdTypeArray>("SkdCurveCellId", 1, 0);
  vtkSmartPointer<vtkIntArray> CurveBlocks = SkdMakeArray<vtkIntArray>("SkdCurveBlockIndex", 1, 0);
  vtkSmartPointer<vtkIdTypeArray> Numbers = SkdMakeArray<vtkIdTypeArray>("SkdPieceNumber", 1, 0);
  vtkSmartPointer<vtkIntArray> PartsInside = SkdMakeArray<vtkIntArray>("SkdPartsInside", 1, 0);
  vtkSmartPointer<vtkIntArray> PartIds = SkdMakeArray<vtkIntArray>("SkdPartId", 1, 0);
};
}

//------------------------------------------------------------------------------
void SkdCutCurves(const SkdCutTask& task, const std::vector<SkdSurfaceIntersection>& intersections,
  vtkPolyData* output)
{
  Cutter cutter(task, output);
  const SkdSurfaceIntersection* next = intersections.data();
  const SkdSurfaceIntersection* end = next + intersections.size();
  for (std::size_t curve = 0; curve < task.Curves.GetCurves().size(); ++curve)
  {
    const SkdSurfaceIntersection* first = next;
    while (next != end && next->Hit.Curve == curve)
    {
      ++next;
    }
    if (task.Numbers[curve] >= 0)
    {
      cutter.CutCurve(curve, first, next);
    }
  }
  cutter.Store(task.IsComposite);
}
}
