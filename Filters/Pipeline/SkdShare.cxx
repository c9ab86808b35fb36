// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdShare.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

SkdShare SkdShare::Of(vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  SkdShare share;
  for (int port = 0; port < outputs->GetNumberOfInformationObjects() && share.IsAll(); ++port)
  {
    vtkInformation* output = outputs->GetInformationObject(port);
    if (output->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()) &&
      output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1)
    {
      share.Pieces = output->Get(Pipeline::UPDATE_NUMBER_OF_PIECES());
      share.Piece = output->Get(Pipeline::UPDATE_PIECE_NUMBER());
    }
  }
  return share;
}

void SkdShare::Keep(vtkPolyData* cells) const
{
  const vtkIdType count = cells->GetNumberOfCells();
  if (this->IsAll() || count == 0)
  {
    return;
  }
  vtkNew<vtkPolyData> all;
  all->ShallowCopy(cells);
  all->BuildCells();
  const vtkSmartPointer<vtkFieldData> report = cells->GetFieldData();
  cells->Initialize();
  cells->SetFieldData(report);
  vtkNew<vtkPoints> points;
  points->SetDataType(all->GetPoints()->GetDataType());
  cells->SetPoints(points);
  cells->AllocateProportional(all, 1.0 / static_cast<double>(this->Pieces));
  cells->GetPointData()->CopyAllOn();
  cells->GetPointData()->CopyAllocate(all->GetPointData());
  cells->GetCellData()->CopyAllOn();
  cells->GetCellData()->CopyAllocate(all->GetCellData());
  vtkNew<vtkIdList> kept;
  for (vtkIdType cell = this->FirstOf(count); cell < this->LastOf(count); ++cell)
  {
    kept->InsertNextId(cell);
  }
  cells->CopyCells(all, kept);
}

void SkdShare::Keep(vtkTable* rows) const
{
  if (this->IsAll())
  {
    return;
  }
  const vtkIdType count = rows->GetNumberOfRows();
  const vtkIdType first = this->FirstOf(count);
  vtkNew<vtkTable> kept;
  for (vtkIdType i = 0; i < rows->GetNumberOfColumns(); ++i)
  {
    vtkAbstractArray* column = rows->GetColumn(i);
    auto part = vtkSmartPointer<vtkAbstractArray>::Take(column->NewInstance());
    part->SetName(column->GetName());
    part->SetNumberOfComponents(column->GetNumberOfComponents());
    part->SetNumberOfTuples(this->LastOf(count) - first);
    part->InsertTuples(0, this->LastOf(count) - first, first, column);
    kept->AddColumn(part);
  }
  kept->SetFieldData(rows->GetFieldData());
  rows->ShallowCopy(kept);
}
