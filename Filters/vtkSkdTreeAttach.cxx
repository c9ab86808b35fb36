// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeAttach.h"

#include "Cells/Read/SkdMeshSnapshot.h"
#include "Exchange/SkdSharedMessages.h"
#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdLoop.h"
#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdProcesses.h"
#include "Pipeline/SkdSourceTrees.h"
#include "Pipeline/SkdValidInput.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeAttach);

class vtkSkdTreeAttach::Internals
{
public:
  struct Tree
  {
    SkdMeshSnapshot Mesh;
    vtkSmartPointer<vtkSkdTreeCellLocator> Locator;
  };
  std::vector<Tree> Trees; // one a block
  int Built = 0;

  void Update(Tree& tree, vtkPointSet* mesh, vtkSkdTreeAttach* self);
};

vtkSkdTreeAttach::vtkSkdTreeAttach()
  : Impl(new Internals)
{
}

vtkSkdTreeAttach::~vtkSkdTreeAttach() = default;

int vtkSkdTreeAttach::GetTreesBuilt() const
{
  return this->Impl->Built;
}

vtkTypeBool vtkSkdTreeAttach::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto process = [&](vtkInformationVector** inputs)
  { return this->Superclass::ProcessRequest(request, inputs, outputVector); };
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    return process(inputVector);
  }
  SkdSharedMessages messages(this, outputVector);
  vtkMultiProcessController* controller = SkdControllerOf(outputVector->GetInformationObject(0));
  const auto result =
    SkdProcessValid(this, request, inputVector, outputVector, controller, process);
  messages.SayOnce(true);
  return result;
}

int vtkSkdTreeAttach::FillInputPortInformation(int, vtkInformation* info)
{
  SkdAcceptMeshes(info);
  return 1;
}

// Builds a block's tree unless the kept one serves.
void vtkSkdTreeAttach::Internals::Update(Tree& tree, vtkPointSet* mesh, vtkSkdTreeAttach* self)
{
  const bool isSame = tree.Mesh.IsSameAs(mesh) &&
    tree.Locator->GetLazyBuild() == self->GetLazyBuild() &&
    tree.Locator->GetSkipGhostCells() == self->GetSkipGhostCells();
  if (!isSame)
  {
    tree.Mesh.Keep(mesh);
    tree.Locator = SkdMakeLocator(tree.Mesh.Get());
    tree.Locator->SetLazyBuild(self->GetLazyBuild());
    tree.Locator->SetSkipGhostCells(self->GetSkipGhostCells());
  }
  this->Built += SkdBuildLocator(tree.Locator, self->GetEpsilon(), !isSame);
  tree.Locator->BuildLocator(); // which makes it note what mesh it was built on
}

// Trees are kept on a data set of their own; each output gets a locator that shares the tree.
int vtkSkdTreeAttach::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  Internals& internals = *this->Impl;
  const std::vector<SkdBlock> blocks =
    SkdMirror(vtkDataObject::GetData(inputVector[0]), vtkDataObject::GetData(outputVector, 0));
  internals.Built = 0;
  internals.Trees.resize(blocks.size());
  for (std::size_t i = 0; i < blocks.size() && !SkdIsAborted(this); ++i)
  {
    Internals::Tree& tree = internals.Trees[i];
    vtkPointSet* mesh = vtkPointSet::SafeDownCast(blocks[i].Mesh);
    if (!mesh)
    {
      tree = Internals::Tree();
      continue;
    }
    internals.Update(tree, mesh, this);
    vtkNew<vtkSkdTreeCellLocator> locator;
    locator->ShallowCopy(tree.Locator);
    locator->SetDataSet(mesh);
    mesh->SetCellLocator(locator);
    locator->BuildLocator(); // which finds that the mesh is that of the tree, until it changes
    this->UpdateProgress(static_cast<double>(i + 1) / static_cast<double>(blocks.size()));
  }
  return 1;
}

void vtkSkdTreeAttach::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "Epsilon", this->Epsilon, "LazyBuild", this->LazyBuild, "SkipGhostCells",
    this->SkipGhostCells);
}
VTK_ABI_NAMESPACE_END
