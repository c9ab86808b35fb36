// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Remap/SkdRemapProbe.h"

#include "Pipeline/SkdLoop.h"
#include "Remap/SkdMeshPoints.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSkdTreeProbe.h"

namespace skdtree
{
namespace
{
/// The part of an algorithm's progress that another one's is, its abort, and warnings: those of the
/// algorithm itself are said once for all processes.
struct Passing
{
  vtkAlgorithm* To;
  double First;
  double Last;

  static void Pass(vtkObject* caller, unsigned long, void* self, void*)
  {
    const auto* passing = static_cast<Passing*>(self);
    auto* from = vtkAlgorithm::SafeDownCast(caller);
    passing->To->UpdateProgress(
      passing->First + from->GetProgress() * (passing->Last - passing->First));
    if (SkdIsAborted(passing->To))
    {
      from->SetAbortExecute(1);
    }
  }

  static void Warn(vtkObject*, unsigned long, void* self, void* given)
  {
    std::string text = given ? static_cast<const char*>(given) : "";
    const std::string end = "): "; // of whose it is
    const std::size_t at = text.find(end);
    text.erase(0, at == std::string::npos ? 0 : at + end.size());
    text.erase(text.find_last_not_of('\n') + 1);
    if (text.rfind("Points that are not finite", 0) != 0) // of which the algorithm has warned
    {
      vtkWarningWithObjectMacro(static_cast<const Passing*>(self)->To, << text);
    }
  }
};

/// The donor with or without its cells' data, but for ghost marks.
vtkSmartPointer<vtkDataSet> ProbedSource(
  vtkDataSet* donor, bool withCellData, const SkdFieldRules& rules)
{
  auto source = vtkSmartPointer<vtkDataSet>::Take(donor->NewInstance());
  source->ShallowCopy(donor);
  if (!withCellData)
  {
    vtkCellData* data = source->GetCellData();
    vtkSmartPointer<vtkDataArray> ghosts = data->GetArray(vtkDataSetAttributes::GhostArrayName());
    data->Initialize();
    data->AddArray(ghosts);
  }
  SkdBlankValues(source, vtkDataObject::CELL, rules);
  SkdBlankValues(source, vtkDataObject::POINT, rules);
  return source;
}
}

SkdRemapProbe::SkdRemapProbe() = default;
SkdRemapProbe::~SkdRemapProbe() = default;

//------------------------------------------------------------------------------
void SkdRemapProbe::AddTo(
  vtkDataSet* block, const SkdProbeSettings& settings, std::set<std::string>& refused) const
{
  vtkDataSet* probed = vtkDataSet::SafeDownCast(this->Prober->GetOutputDataObject(0));
  vtkDataSetAttributes* to =
    block->GetAttributes(settings.ToCells ? vtkDataObject::CELL : vtkDataObject::POINT);
  vtkPointData* data = probed->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    const std::string name = array->GetName();
    const bool isOwn = name.compare(0, 3, "Skd") == 0; // about the points, and not of the source
    const std::string free = SkdResultName(to, name, settings.Fields.RenamesTaken && !isOwn);
    if (free.empty())
    {
      refused.insert(name);
      continue;
    }
    if (free == name)
    {
      to->AddArray(array);
      continue;
    }
    auto renamed = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
    renamed->DeepCopy(array);
    renamed->SetName(free.c_str());
    to->AddArray(renamed);
  }
}

//------------------------------------------------------------------------------
// The flat cells of a sphere are below it, by up to a twentieth of the radius for cells of 35
// degrees: points on it are not outside.
void SkdRemapProbe::SetUp(const SkdProbeSettings& settings)
{
  this->Prober->ClearGradientArrays();
  for (const std::string& name : settings.Gradients)
  {
    this->Prober->AddGradientArray(name.c_str());
  }
  if (settings.IsOnSphere)
  {
    this->Prober->SetMaximumDistance(0.05 * settings.Radius);
  }
  this->Prober->SetOutsidePoints(settings.TakesNearest ? vtkSkdTreeProbe::NEAREST_CELL
      : settings.IsOnSphere ? vtkSkdTreeProbe::NEAREST_CELL_WITHIN_DISTANCE
                            : vtkSkdTreeProbe::LEAVE);
  this->Prober->SetAbortExecute(0);
}

//------------------------------------------------------------------------------
// Asked as points of their own, so that nothing of the block's data is in the way.
void SkdRemapProbe::Map(vtkDataSet* block, vtkDataSet* donor, bool withCellData,
  const SkdProbeSettings& settings, vtkAlgorithm* algorithm, double first, double last,
  std::set<std::string>& refused)
{
  this->SetUp(settings);
  this->Prober->SetInputDataObject(
    SkdCloudOf(settings.ToCells ? SkdMiddlesOf(block) : SkdPointsOf(block)));
  this->Prober->SetSourceData(ProbedSource(donor, withCellData, settings.Fields));
  Passing passing{ algorithm, first, last };
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&passing);
  command->SetCallback(&Passing::Pass);
  this->Prober->AddObserver(vtkCommand::ProgressEvent, command);
  vtkNew<vtkCallbackCommand> warning;
  warning->SetClientData(&passing);
  warning->SetCallback(&Passing::Warn);
  this->Prober->AddObserver(vtkCommand::WarningEvent, warning);
  this->Prober->Update();
  this->Prober->RemoveObserver(command);
  this->Prober->RemoveObserver(warning);
  this->AddTo(block, settings, refused);
}
}
