// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LocatorStructure.h
 * @brief any vtkAbstractCellLocator as a Structure
 *
 * Every locator is called by the same short forms of vtkAbstractCellLocator, with its own default
 * settings. The one form that VTK's versions declare in different places, all hits of a line, is
 * behind AllHits.
 */
#ifndef skdbench_LocatorStructure_h
#define skdbench_LocatorStructure_h

#include "Structure.h"

#include "vtkAbstractCellLocator.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <vector>

namespace skdbench
{

/// Whether an error came from the object since the last look; such errors are not printed.
class Watch
{
public:
  explicit Watch(vtkObject* watched)
  {
    this->Observer->SetClientData(&this->Complained);
    this->Observer->SetCallback([](vtkObject*, unsigned long, void* complained, void*)
      { *static_cast<bool*>(complained) = true; });
    watched->AddObserver(vtkCommand::ErrorEvent, this->Observer);
  }

  bool WasQuiet()
  {
    const bool quiet = !this->Complained;
    this->Complained = false;
    return quiet;
  }

private:
  vtkNew<vtkCallbackCommand> Observer;
  bool Complained = false;
};

template <class Locator>
class LocatorStructure : public Structure
{
public:
  bool Build(vtkDataSet* data) override
  {
    this->Tolerance = LineTolerance(data);
    this->Tree->SetDataSet(data);
    this->Weights.resize(static_cast<std::size_t>(std::max(data->GetMaxCellSize(), 1)));
    this->BuildNow();
    return this->Complaints.WasQuiet();
  }

  void LoadCells() override { this->Cell = vtkSmartPointer<vtkGenericCell>::New(); }

  bool Ask(QueryKind queryKind, const Query& query, Answer& answer) override
  {
    switch (queryKind)
    {
      case QueryKind::ClosestPoint:
        this->ClosestPoint(query, answer);
        break;
      case QueryKind::ClosestPointWithinRadius:
        this->ClosestPointWithinRadius(query, answer);
        break;
      case QueryKind::FirstHit:
        this->FirstHit(query, answer);
        break;
      case QueryKind::AllHits:
        this->Points->Reset();
        this->Ids->Reset();
        if (!this->AllHits(query))
        {
          return false;
        }
        this->List(answer);
        break;
      case QueryKind::FindCell:
        answer.Cell = this->FindCell(query);
        return this->HasFindCell();
      case QueryKind::FindCellWithHint:
        answer.Cell = this->FindCellWithHint(query, answer.Cell);
        return this->HasFindCell();
      case QueryKind::CellsInBox:
        this->Ids->Reset();
        this->Tree->FindCellsWithinBounds(Bounds(query.Box).data(), this->Ids);
        this->List(answer);
        break;
    }
    return this->Complaints.WasQuiet();
  }

protected:
  virtual void BuildNow() { this->Tree->BuildLocator(); }

  /// False when FindCell silently goes to the data set, past the locator.
  virtual bool HasFindCell() const { return true; }

  /// Fills Points and Ids. False when this VTK declares no such method for the locator.
  virtual bool AllHits(const Query& query) = 0;

  /// `hint` is the last answer.
  virtual vtkIdType FindCellWithHint(const Query& query, vtkIdType)
  {
    return this->FindCell(query);
  }

  vtkNew<Locator> Tree;
  vtkSmartPointer<vtkGenericCell> Cell; // none: the short calls
  std::vector<double> Weights;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkIdList> Ids;
  double Tolerance = 0.0;

private:
  vtkIdType FindCell(const Query& query)
  {
    Point x = query.From;
    double pcoords[3];
    return this->Cell
      ? this->Tree->FindCell(x.data(), 0.0, this->Cell, pcoords, this->Weights.data())
      : this->Tree->FindCell(x.data());
  }

  void ClosestPoint(const Query& query, Answer& answer)
  {
    answer.Cell = -1;
    int subId = 0;
    const auto find = [&](auto... cell)
    {
      this->Tree->FindClosestPoint(
        query.From.data(), answer.Where.data(), cell..., answer.Cell, subId, answer.Value);
    };
    this->Cell ? find(this->Cell.Get()) : find();
  }

  void ClosestPointWithinRadius(const Query& query, Answer& answer)
  {
    answer.Cell = -1;
    int subId = 0;
    const auto find = [&](auto... cell)
    {
      return this->Tree->FindClosestPointWithinRadius(Point(query.From).data(), query.Radius,
        answer.Where.data(), cell..., answer.Cell, subId, answer.Value);
    };
    if (!(this->Cell ? find(this->Cell.Get()) : find()))
    {
      answer.Cell = -1;
    }
  }

  void FirstHit(const Query& query, Answer& answer)
  {
    answer.Cell = -1;
    int subId = 0;
    double pcoords[3];
    const auto find = [&](auto... cell)
    {
      return this->Tree->IntersectWithLine(query.From.data(), query.To.data(), this->Tolerance,
        answer.Value, answer.Where.data(), pcoords, subId, answer.Cell, cell...);
    };
    if (!(this->Cell ? find(this->Cell.Get()) : find()))
    {
      answer.Cell = -1;
    }
  }

  void List(Answer& answer)
  {
    answer.Cells = this->Ids->GetPointer(0);
    answer.NumberOfCells = this->Ids->GetNumberOfIds();
  }

  Watch Complaints{ this->Tree };
};

}

#endif
