// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdValidInput.h"

#include "Cells/Read/SkdRepairedMesh.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdReport.h"
#include "Pipeline/SkdUnfitArrays.h"
#include "Pipeline/SkdUnusablePoints.h"

#include "vtkAlgorithm.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkFieldData.h"
#include "vtkHyperTreeGrid.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"

#include <mutex>
#include <sstream>
#include <unordered_map>

namespace skdtree
{
namespace
{
/// Meshes that were found valid, by modification time: modification times are unique, so a new
/// object at the address of a deleted one is recognized.
class WholeMeshes
{
public:
  bool Has(vtkDataSet* mesh)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    const auto found = this->Times.find(mesh);
    return found != this->Times.end() && found->second == mesh->GetMTime();
  }

  void Add(vtkDataSet* mesh)
  {
    constexpr std::size_t most = 4096; // meshes come and go
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (this->Times.size() >= most)
    {
      this->Times.clear();
    }
    this->Times[mesh] = mesh->GetMTime();
  }

private:
  std::mutex Mutex;
  std::unordered_map<const vtkDataSet*, vtkMTimeType> Times;
};

WholeMeshes& KnownWholeMeshes()
{
  static WholeMeshes meshes;
  return meshes;
}

/// The repaired meshes of a data object, in the order of its blocks.
class RepairedBlocks
{
public:
  RepairedBlocks(vtkDataObject* object, bool anyMagnitude)
  {
    WholeMeshes& wholeMeshes = KnownWholeMeshes();
    for (const SkdBlock& block : SkdBlocksOf(object))
    {
      SkdRepairedMesh repaired{ block.Mesh, {} };
      SkdUnusablePoints points;
      std::string arrays;
      if (!wholeMeshes.Has(block.Mesh))
      {
        const SkdFittingMesh fitting = SkdLeaveOutUnfitArrays(block.Mesh);
        arrays = fitting.Fault;
        repaired = SkdRepair(fitting.Mesh);
        points = SkdFindUnusablePoints(repaired.Mesh, false);
        if (repaired.Mesh == block.Mesh && points.Count == 0)
        {
          wholeMeshes.Add(block.Mesh);
        }
      }
      if (anyMagnitude && points.Count > 0)
      {
        points = SkdFindUnusablePoints(repaired.Mesh, true);
      }
      this->Changed = this->Changed || repaired.Mesh != block.Mesh;
      this->NumberOfPoints += points.Count;
      Tell(block, repaired.Fault, this->Faults);
      Tell(block, arrays, this->Arrays);
      Tell(block, points.Count > 0 ? points.Tell(block.Mesh, anyMagnitude) : "", this->Points);
      this->Meshes.push_back(repaired.Mesh);
    }
  }

  /// Whether any differs from the given one, which does not always need a warning.
  bool AreChanged() const { return this->Changed; }

  ///@{
  /// The warnings; empty if there is none.
  std::string GetFaults() const { return this->Faults.str(); }
  std::string GetArrays() const { return this->Arrays.str(); }
  std::string GetPoints() const { return this->Points.str(); }
  ///@}

  /// Of points that cannot be used.
  vtkIdType GetNumberOfPoints() const { return this->NumberOfPoints; }

  vtkSmartPointer<vtkDataObject> PutInto(vtkDataObject* object) const;

private:
  static void Tell(const SkdBlock& block, const std::string& fault, std::ostringstream& text)
  {
    if (!fault.empty())
    {
      text << " "
           << (block.BlockIndex > 0 ? "Block " + std::to_string(block.BlockIndex) + ": " : "")
           << fault;
    }
  }

  std::vector<vtkSmartPointer<vtkDataSet>> Meshes;
  bool Changed = false;
  vtkIdType NumberOfPoints = 0;
  std::ostringstream Faults;
  std::ostringstream Arrays;
  std::ostringstream Points;
};

/// What a data object that came to an input port has.
struct Leaves
{
  Leaves(int port, vtkDataObject* object)
    : Port(port)
    , IsComposite(SkdIsComposite(object))
  {
    if (!this->IsComposite)
    {
      this->Add(object);
      return;
    }
    const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(
      static_cast<vtkCompositeDataSet*>(object)->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      this->Add(iterator->GetCurrentDataObject());
    }
  }

  bool AreOthersOnly() const { return this->HasOthers && !this->HasMeshes; }

  std::string Tell() const;

  int Port;
  bool IsComposite;
  bool HasMeshes = false;         // on any process
  bool HasOthers = false;         // likewise
  vtkDataObject* Other = nullptr; // the first of this process that is no mesh

private:
  void Add(vtkDataObject* leaf)
  {
    const bool isMesh = vtkDataSet::SafeDownCast(leaf) != nullptr;
    this->Other = isMesh || this->Other ? this->Other : leaf;
    this->HasMeshes = this->HasMeshes || isMesh;
    this->HasOthers = this->Other != nullptr;
  }
};

std::string Leaves::Tell() const
{
  std::ostringstream text;
  text << "Input port " << this->Port
       << (this->IsComposite ? " has no mesh among its blocks, the first of which is of type "
                             : " is of type ")
       << this->Other->GetClassName()
       << (this->IsComposite ? "" : ", which is neither a mesh nor composite data");
  const bool isTree = vtkHyperTreeGrid::SafeDownCast(this->Other) != nullptr;
  text << (isTree ? ": convert it by vtkHyperTreeGridToUnstructuredGrid." : ".");
  return text.str();
}

/// The pieces of some processes may be empty.
void ShareMeshes(std::vector<Leaves>& all, vtkMultiProcessController& controller)
{
  std::vector<int> here;
  for (const Leaves& leaves : all)
  {
    here.push_back(leaves.HasMeshes ? 1 : 0);
    here.push_back(leaves.HasOthers ? 1 : 0);
  }
  std::vector<int> anywhere(here.size());
  controller.AllReduce(
    here.data(), anywhere.data(), static_cast<vtkIdType>(here.size()), vtkCommunicator::MAX_OP);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    all[i].HasMeshes = anywhere[2 * i] != 0;
    all[i].HasOthers = anywhere[2 * i + 1] != 0;
  }
}

vtkSmartPointer<vtkDataObject> RepairedBlocks::PutInto(vtkDataObject* object) const
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(object);
  if (!composite)
  {
    return this->Meshes.front();
  }
  const auto copy = vtkSmartPointer<vtkCompositeDataSet>::Take(composite->NewInstance());
  copy->CopyStructure(composite);
  copy->GetFieldData()->PassData(composite->GetFieldData());
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  std::size_t next = 0;
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkDataObject* block = iterator->GetCurrentDataObject();
    copy->SetDataSet(
      iterator, vtkDataSet::SafeDownCast(block) ? this->Meshes[next++].Get() : block);
  }
  return copy;
}
}

//------------------------------------------------------------------------------
SkdValidInput::SkdValidInput(
  vtkAlgorithm* filter, vtkInformation* request, vtkInformationVector** inputs, bool anyMagnitude)
  : Inputs(inputs)
{
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    return;
  }
  Findings all;
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    this->Repaired.push_back(vtkSmartPointer<vtkInformationVector>::New());
    this->Repaired.back()->Copy(inputs[port]);
    this->RepairedInputs.push_back(this->Repaired.back());
    const Findings found = Repair(this->Repaired.back(), anyMagnitude);
    const std::string where = " Input port " + std::to_string(port) + ":";
    all.BrokenCells += found.BrokenCells.empty() ? "" : where + found.BrokenCells;
    all.Arrays += found.Arrays.empty() ? "" : where + found.Arrays;
    all.Points += found.Points.empty() ? "" : where + found.Points;
    all.NumberOfPoints += found.NumberOfPoints;
    this->PointCounts.push_back(found.NumberOfPoints);
  }
  this->Inputs = this->RepairedInputs.data();
  if (!all.BrokenCells.empty())
  {
    vtkWarningWithObjectMacro(
      filter, "Broken cells are ignored; repair the mesh." << all.BrokenCells);
  }
  if (!all.Arrays.empty())
  {
    vtkWarningWithObjectMacro(filter,
      "Arrays that have not one tuple for each point or cell are left out; correct them."
        << all.Arrays);
  }
  if (all.NumberOfPoints == 0)
  {
    this->PointCounts.clear();
    return;
  }
  vtkWarningWithObjectMacro(filter,
    "Points that are not finite get no answer, and cells that have them are ignored; repair or "
    "scale the mesh."
      << all.Points);
}

//------------------------------------------------------------------------------
bool SkdRefuseOthers(
  vtkAlgorithm* filter, vtkInformationVector** inputs, vtkMultiProcessController* controller)
{
  std::vector<Leaves> all;
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      all.emplace_back(port, vtkDataObject::GetData(inputs[port], i));
    }
  }
  if (controller)
  {
    ShareMeshes(all, *controller);
  }
  bool isAny = false;
  for (const Leaves& leaves : all)
  {
    if (leaves.AreOthersOnly() && leaves.Other && !isAny)
    {
      vtkErrorWithObjectMacro(filter, << leaves.Tell());
    }
    isAny = isAny || leaves.AreOthersOnly();
  }
  return isAny;
}

//------------------------------------------------------------------------------
void SkdValidInput::Report(vtkInformationVector* outputs) const
{
  vtkDataObject* output = vtkDataObject::GetData(outputs);
  if (output && !this->PointCounts.empty())
  {
    SkdReport(output).AddCounts("PointsNotFinite", this->PointCounts);
  }
}

//------------------------------------------------------------------------------
SkdValidInput::Findings SkdValidInput::Repair(vtkInformationVector* to, bool anyMagnitude)
{
  Findings found;
  for (int i = 0; i < to->GetNumberOfInformationObjects(); ++i)
  {
    vtkDataObject* object = vtkDataObject::GetData(to, i);
    const RepairedBlocks blocks(object, anyMagnitude);
    found.BrokenCells += blocks.GetFaults();
    found.Arrays += blocks.GetArrays();
    found.Points += blocks.GetPoints();
    found.NumberOfPoints += blocks.GetNumberOfPoints();
    if (blocks.AreChanged())
    {
      vtkNew<vtkInformation> repaired;
      repaired->Copy(to->GetInformationObject(i));
      repaired->Set(vtkDataObject::DATA_OBJECT(), blocks.PutInto(object));
      to->SetInformationObject(i, repaired);
    }
  }
  return found;
}
}
