// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSkdTreeRepresentation.h"

#include "Pipeline/SkdBlocks.h"
#include "Pipeline/SkdLoop.h"
#include "Pipeline/SkdPorts.h"
#include "Pipeline/SkdPrint.h"
#include "Pipeline/SkdValidInput.h"
#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSkdTreeCellLocator.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <string>
#include <vector>

using namespace skdtree;

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSkdTreeRepresentation);

namespace
{
/// Boxes of several trees in one polydata.
class Boxes
{
public:
  Boxes()
  {
    this->Points->SetDataTypeToDouble();
    this->Levels->SetName("Level");
    this->CellIds->SetName("CellId");
    this->Blocks->SetName("BlockIndex");
  }

  void Add(vtkPolyData* some, int block)
  {
    const vtkIdType first = this->Points->GetNumberOfPoints();
    this->Points->InsertPoints(first, some->GetNumberOfPoints(), 0, some->GetPoints());
    this->Quads->Append(some->GetPolys(), first);
    Append(some->GetCellData()->GetArray("Level"), this->Levels);
    Append(some->GetCellData()->GetArray("CellId"), this->CellIds);
    for (vtkIdType i = 0; i < some->GetNumberOfCells(); ++i)
    {
      this->Blocks->InsertNextValue(block);
    }
  }

  void Store(vtkPolyData* output, bool isComposite)
  {
    output->SetPoints(this->Points);
    output->SetPolys(this->Quads);
    output->GetCellData()->AddArray(this->Levels);
    output->GetCellData()->AddArray(this->CellIds);
    if (isComposite)
    {
      output->GetCellData()->AddArray(this->Blocks);
    }
  }

private:
  static void Append(vtkDataArray* from, vtkDataArray* to)
  {
    to->InsertTuples(to->GetNumberOfTuples(), from->GetNumberOfTuples(), 0, from);
  }

  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Quads;
  vtkNew<vtkIntArray> Levels;
  vtkNew<vtkIdTypeArray> CellIds;
  vtkNew<vtkIntArray> Blocks;
};

/// A table whose columns are made as they are first named.
class Rows
{
public:
  explicit Rows(vtkTable* table)
    : Table(table)
  {
  }

  template <class Array, class Value>
  void Add(const char* column, Value value)
  {
    Array* array = Array::SafeDownCast(this->Table->GetColumnByName(column));
    if (array)
    {
      array->InsertNextValue(value);
      return;
    }
    vtkNew<Array> made; // of the first row: a table takes no shorter columns
    made->SetName(column);
    made->InsertNextValue(value);
    this->Table->AddColumn(made);
  }

private:
  vtkTable* Table;
};

double AreaOf(const double box[6])
{
  const double x = std::max(0.0, box[1] - box[0]);
  const double y = std::max(0.0, box[3] - box[2]);
  const double z = std::max(0.0, box[5] - box[4]);
  return 2.0 * (x * y + y * z + z * x);
}

double AreaOfCommon(const double a[6], const double b[6])
{
  double common[6];
  for (int i = 0; i < 6; i += 2)
  {
    common[i] = std::max(a[i], b[i]);
    common[i + 1] = std::min(a[i + 1], b[i + 1]);
    if (common[i] > common[i + 1])
    {
      return 0.0;
    }
  }
  return AreaOf(common);
}

struct Quality
{
  vtkIdType Nodes = 0;
  int Depth = 0; // of the binary tree, in levels below the first
  double Overlap = 0.0;
  double Cost = 0.0;
};

Quality QualityOf(vtkSkdTreeCellLocator* locator)
{
  vtkNew<vtkDoubleArray> S;
  vtkNew<vtkIdTypeArray> L;
  locator->GetSafetyBoxes(S);
  locator->GetLinks(L);
  Quality quality;
  quality.Nodes = L->GetNumberOfTuples();
  const auto boxOf = [&](vtkIdType node) { return S->GetPointer(6 * node); };
  const double whole = quality.Nodes > 0 ? AreaOf(boxOf(0)) : 0.0;
  std::vector<int> levels(quality.Nodes, 0);
  vtkIdType inner = 0;
  // Children come after their parents.
  for (vtkIdType node = 0; node < quality.Nodes; ++node)
  {
    const double area = AreaOf(boxOf(node));
    quality.Cost += whole > 0.0 ? area / whole : 1.0;
    quality.Depth = std::max(quality.Depth, levels[node]);
    const vtkIdType child = L->GetValue(node);
    if (child > 0)
    {
      levels[child] = levels[child + 1] = levels[node] + 1;
      quality.Overlap += area > 0.0 ? AreaOfCommon(boxOf(child), boxOf(child + 1)) / area : 1.0;
      ++inner;
    }
  }
  quality.Overlap = inner > 0 ? quality.Overlap / inner : 0.0;
  return quality;
}

void AddRow(vtkSkdTreeCellLocator* locator, int block, vtkTable* table)
{
  const Quality quality = QualityOf(locator);
  Rows rows(table);
  rows.Add<vtkIntArray>("BlockIndex", block);
  rows.Add<vtkIdTypeArray>("Cells", locator->GetNumberOfCellsInTree());
  rows.Add<vtkIdTypeArray>("CellsLeftOut", locator->GetNumberOfCellsLeftOut());
  rows.Add<vtkIdTypeArray>("Nodes", locator->GetNumberOfNodes());
  rows.Add<vtkIntArray>("Depth", locator->GetDepth());
  rows.Add<vtkIdTypeArray>("PaperNodes", quality.Nodes);
  rows.Add<vtkIntArray>("PaperDepth", quality.Depth);
  rows.Add<vtkDoubleArray>("Overlap", quality.Overlap);
  rows.Add<vtkDoubleArray>("Cost", quality.Cost);
  rows.Add<vtkIdTypeArray>("Bytes", locator->GetMemorySize());
  rows.Add<vtkDoubleArray>("BuildSeconds", locator->GetBuildSeconds());
}
}

vtkSkdTreeRepresentation::vtkSkdTreeRepresentation()
{
  this->SetNumberOfOutputPorts(2);
}

vtkSkdTreeRepresentation::~vtkSkdTreeRepresentation() = default;

vtkTypeBool vtkSkdTreeRepresentation::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return SkdProcessValid(this, request, inputVector, outputVector, nullptr,
    [&](vtkInformationVector** valid)
    { return this->Superclass::ProcessRequest(request, valid, outputVector); });
}

int vtkSkdTreeRepresentation::FillInputPortInformation(int, vtkInformation* info)
{
  SkdAcceptMeshes(info);
  return 1;
}

int vtkSkdTreeRepresentation::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

int vtkSkdTreeRepresentation::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  const std::vector<SkdBlock> blocks = SkdBlocksOf(input);
  Boxes boxes;
  int done = 0;
  for (const SkdBlock& block : blocks)
  {
    if (SkdIsAborted(this))
    {
      break;
    }
    vtkNew<vtkSkdTreeCellLocator> locator;
    locator->SetDataSet(block.Mesh);
    locator->SetEpsilon(this->Epsilon);
    locator->BuildLocator();
    vtkNew<vtkPolyData> level;
    locator->GenerateRepresentation(this->Level, level);
    boxes.Add(level, block.BlockIndex);
    AddRow(locator, block.BlockIndex, vtkTable::GetData(outputVector, 1));
    this->UpdateProgress(static_cast<double>(++done) / static_cast<double>(blocks.size()));
  }
  boxes.Store(vtkPolyData::GetData(outputVector, 0), SkdIsComposite(input));
  return 1;
}

void vtkSkdTreeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SkdPrint(os, indent, "Level", this->Level, "Epsilon", this->Epsilon);
}
VTK_ABI_NAMESPACE_END
