// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdValidInput.h"

#include "Cells/Read/SkdRepairedMesh.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdReport.h"
#include "Pipeline/SkdUnfitArrays.h"
#include "Pipeline/SkdUnusablePoints.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"

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
        points = SkdFindUnusablePoints(block.Mesh, false);
        if (repaired.Mesh == block.Mesh && points.Count == 0)
        {
          wholeMeshes.Add(block.Mesh);
        }
      }
      if (anyMagnitude && points.Count > 0)
      {
        points = SkdFindUnusablePoints(block.Mesh, true);
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
bool SkdRefuseOthers(vtkAlgorithm* filter, vtkInformationVector** inputs)
{
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkDataObject* object = vtkDataObject::GetData(inputs[port], i);
      if (!object || SkdIsComposite(object) || vtkDataSet::SafeDownCast(object))
      {
        continue;
      }
      const bool isTree = object->GetDataObjectType() == VTK_HYPER_TREE_GRID;
      vtkErrorWithObjectMacro(filter,
        "Input port " << port << " is of type " << object->GetClassName()
                      << ", which is neither a mesh nor composite data"
                      << (isTree ? ": convert it by vtkHyperTreeGridToUnstructuredGrid." : "."));
      return true;
    }
  }
  return false;
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
