// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/SkdValidInput.h"

#include "Cells/SkdMendedMesh.h"
#include "Pipeline/SkdBlocks.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"

#include <mutex>
#include <sstream>
#include <unordered_map>

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

/// The mended meshes of a data object, in the order of its blocks.
class MendedBlocks
{
public:
  explicit MendedBlocks(vtkDataObject* object)
  {
    WholeMeshes& wholeMeshes = KnownWholeMeshes();
    for (const SkdBlock& block : SkdBlocksOf(object))
    {
      SkdMendedMesh mended{ block.Mesh, {} };
      if (!wholeMeshes.Has(block.Mesh))
      {
        mended = SkdMend(block.Mesh);
      }
      if (mended.Mesh == block.Mesh)
      {
        wholeMeshes.Add(block.Mesh);
      }
      else
      {
        this->Changed = true;
        this->Tell(block, mended.Fault);
      }
      this->Meshes.push_back(mended.Mesh);
    }
  }

  /// Whether any differs from the given one, which does not always need a warning.
  bool AreChanged() const { return this->Changed; }

  /// The warning; empty if there is none.
  std::string GetFaults() const { return this->Faults.str(); }

  vtkSmartPointer<vtkDataObject> PutInto(vtkDataObject* object) const;

private:
  void Tell(const SkdBlock& block, const std::string& fault)
  {
    this->Faults << (fault.empty() ? "" : " ");
    if (!fault.empty() && block.BlockIndex > 0)
    {
      this->Faults << "Block " << block.BlockIndex << ": ";
    }
    this->Faults << fault;
  }

  std::vector<vtkSmartPointer<vtkDataSet>> Meshes;
  bool Changed = false;
  std::ostringstream Faults;
};

vtkSmartPointer<vtkDataObject> MendedBlocks::PutInto(vtkDataObject* object) const
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
  vtkAlgorithm* filter, vtkInformation* request, vtkInformationVector** inputs)
  : Inputs(inputs)
{
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    return;
  }
  std::string faults;
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    this->Mended.push_back(vtkSmartPointer<vtkInformationVector>::New());
    this->Mended.back()->Copy(inputs[port]);
    this->MendedInputs.push_back(this->Mended.back());
    const std::string fault = Mend(this->Mended.back());
    faults += fault.empty() ? fault : " Input port " + std::to_string(port) + ":" + fault;
  }
  this->Inputs = this->MendedInputs.data();
  if (!faults.empty())
  {
    vtkWarningWithObjectMacro(filter, "Broken cells are ignored; repair the mesh." << faults);
  }
}

//------------------------------------------------------------------------------
// The warning about it.
std::string SkdValidInput::Mend(vtkInformationVector* to)
{
  std::string faults;
  for (int i = 0; i < to->GetNumberOfInformationObjects(); ++i)
  {
    vtkDataObject* object = vtkDataObject::GetData(to, i);
    const MendedBlocks blocks(object);
    faults += blocks.GetFaults();
    if (blocks.AreChanged())
    {
      vtkNew<vtkInformation> mended;
      mended->Copy(to->GetInformationObject(i));
      mended->Set(vtkDataObject::DATA_OBJECT(), blocks.PutInto(object));
      to->SetInformationObject(i, mended);
    }
  }
  return faults;
}
