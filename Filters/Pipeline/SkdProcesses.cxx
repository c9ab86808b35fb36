// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdProcesses.h"

#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <filesystem>

namespace skdtree
{
namespace
{
class ControlledProcesses : public skd::Processes
{
public:
  explicit ControlledProcesses(vtkMultiProcessController* controller)
    : Controller(controller)
  {
  }

  bool IsAny(bool here) const override
  {
    const int own = here ? 1 : 0;
    int any = 0;
    this->Controller->AllReduce(&own, &any, 1, vtkCommunicator::MAX_OP);
    return any != 0;
  }

  std::vector<std::vector<double>> GatherFromOthers(const std::vector<double>& own) const override
  {
    const auto count = static_cast<std::size_t>(this->Controller->GetNumberOfProcesses());
    const auto length = static_cast<vtkIdType>(own.size());
    std::vector<vtkIdType> lengths(count);
    this->Controller->AllGather(&length, lengths.data(), 1);
    std::vector<vtkIdType> offsets(count + 1, 0);
    for (std::size_t i = 0; i < count; ++i)
    {
      offsets[i + 1] = offsets[i] + lengths[i];
    }
    std::vector<double> all(static_cast<std::size_t>(offsets.back()) + 1);
    this->Controller->AllGatherV(own.data(), all.data(), length, lengths.data(), offsets.data());
    std::vector<std::vector<double>> others;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (static_cast<int>(i) != this->Controller->GetLocalProcessId())
      {
        others.emplace_back(all.begin() + offsets[i], all.begin() + offsets[i + 1]);
      }
    }
    return others;
  }

private:
  vtkMultiProcessController* Controller;
};
}

vtkMultiProcessController* SkdControllerOf(vtkInformation* requested)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const int count = controller ? controller->GetNumberOfProcesses() : 1;
  const bool isShared = count > 1 && requested->Has(Pipeline::UPDATE_NUMBER_OF_PIECES()) &&
    requested->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) == count &&
    requested->Get(Pipeline::UPDATE_PIECE_NUMBER()) == controller->GetLocalProcessId();
  return isShared ? controller : nullptr;
}

std::unique_ptr<skd::Processes> SkdProcessesOf(vtkInformation* output)
{
  vtkMultiProcessController* controller = SkdControllerOf(output);
  return controller ? std::make_unique<ControlledProcesses>(controller) : nullptr;
}

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

std::string SkdShare::NameOf(const std::string& fileName) const
{
  if (this->IsAll() || fileName.empty())
  {
    return fileName;
  }
  std::filesystem::path path(fileName);
  const std::string extension = path.extension().string();
  path.replace_extension();
  return path.string() + "_" + std::to_string(this->Piece) + extension;
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
  cells->Initialize(); // its field data, too
  cells->GetFieldData()->ShallowCopy(all->GetFieldData());
  vtkNew<vtkPoints> points;
  points->SetDataType(all->GetPoints()->GetDataType());
  cells->SetPoints(points);
  // A part of a few cells, as of AllocateProportional, would be no place for any.
  constexpr vtkIdType pointsOfCell = 3;
  cells->AllocateEstimate(this->LastOf(count) - this->FirstOf(count), pointsOfCell);
  cells->GetPointData()->CopyAllOn();
  cells->GetPointData()->CopyAllocate(all->GetPointData());
  cells->GetCellData()->CopyAllOn();
  cells->GetCellData()->CopyAllocate(all->GetCellData());
  vtkNew<vtkIdList> selected;
  for (vtkIdType cell = this->FirstOf(count); cell < this->LastOf(count); ++cell)
  {
    selected->InsertNextId(cell);
  }
  cells->CopyCells(all, selected);
}

void SkdShare::Keep(vtkTable* rows) const
{
  if (this->IsAll())
  {
    return;
  }
  const vtkIdType count = rows->GetNumberOfRows();
  const vtkIdType first = this->FirstOf(count);
  vtkNew<vtkTable> selected;
  for (vtkIdType i = 0; i < rows->GetNumberOfColumns(); ++i)
  {
    vtkAbstractArray* column = rows->GetColumn(i);
    auto part = vtkSmartPointer<vtkAbstractArray>::Take(column->NewInstance());
    part->SetName(column->GetName());
    part->SetNumberOfComponents(column->GetNumberOfComponents());
    part->SetNumberOfTuples(this->LastOf(count) - first);
    part->InsertTuples(0, this->LastOf(count) - first, first, column);
    selected->AddColumn(part);
  }
  selected->SetFieldData(rows->GetFieldData());
  rows->ShallowCopy(selected);
}
}
